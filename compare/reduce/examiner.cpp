#include "compare/reduce/examiner.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "compare/metrics/values.h"
#include "compare/oracle/povray.h"
#include "compare/oracle/switches.h"
#include "compare/oracle/working_copy.h"
#include "compare/reduce/messages.h"
#include "compare/regression/renders.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

using Kind = Difference::Kind;

// A message without what changes when a scene does: places, names and numbers.
std::string kernel_of(const std::string& message) {
  std::size_t begin = 0;
  for (const char* mark : {"error: ", "unsupported: ", "Error: "})
    if (const std::size_t at = message.find(mark); at != std::string::npos)
      begin = std::max(begin, at + std::string(mark).size());
  std::string out;
  bool quoted = false;
  for (const char c : message.substr(begin)) {
    if (c == '\'' || c == '"') quoted = !quoted;
    if (!quoted && !std::isdigit(static_cast<unsigned char>(c))) out += c;
  }
  constexpr std::size_t kLong = 60;
  return out.substr(0, kLong);
}

// The candidate takes the scene's place. What is there may be a link to the scene itself.
void put(const std::string& text, const fs::path& file) {
  fs::remove(file);
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(fmt::format("{}: cannot write", file.string()));
}

NativeRequest request_of(const WorkingCopy& copy, const SceneRequest& scene, const Frame& frame, double time_limit,
                         std::atomic<bool>* cancel) {
  NativeRequest out;
  out.folder = copy.folder(), out.scene = copy.scene();
  out.width = frame.width, out.height = frame.height;
  out.switches = scene.switches;
  out.switches.insert(out.switches.end(), frame.switches.begin(), frame.switches.end());
  if (!output_type(out.switches)) out.switches.emplace_back(kFinePicture);
  out.output = copy.out() / ("picture" + output_extension(out.switches));
  out.threads = 1, out.time_limit = time_limit, out.cancel = cancel;
  return out;
}

// Of a program that said it had rendered.
void read_result(const NativeRequest& request, NativeResult& result, Picture& picture) {
  if (result.outcome != NativeResult::Outcome::rendered) return;
  try {
    picture = image::read_picture(request.output);
  } catch (const std::exception& error) {
    result.outcome = NativeResult::Outcome::error, result.message = error.what();
  }
}

// What verisim alone says; nothing: that hangs on POV-Ray.
std::optional<Difference> decided_by(const NativeResult& native) {
  Difference out;
  out.message = native.message;
  if (native.ending == NativeResult::Ending::by_signal) return out.kind = Kind::verisim_crashes, out;
  if (native.ending == NativeResult::Ending::out_of_time) return out.kind = Kind::undecided, out;
  return std::nullopt;
}

// Whether a scene that verisim takes so can still show what is wanted.
bool possible(const Difference& wanted, const NativeResult& native) {
  const bool draws = native.outcome == NativeResult::Outcome::rendered;
  if (wanted.kind == Kind::only_povray || wanted.kind == Kind::unsupported)
    return !draws && kernel_of(native.message) == kernel_of(wanted.message) &&
           (native.outcome == NativeResult::Outcome::unsupported) == (wanted.kind == Kind::unsupported);
  if (wanted.kind == Kind::verisim_warns && draws)
    return std::ranges::any_of(messages_of(native.console).warnings,
                               [&](const std::string& warning) { return same_warning(warning, wanted.message); });
  return draws || wanted.kind == Kind::povray_crashes;
}

Difference difference_of(const NativeResult& native, const NativeResult& oracle, const Picture& ours,
                         const Picture& theirs) {
  Difference out;
  if (oracle.ending == NativeResult::Ending::out_of_time) return out.kind = Kind::undecided, out;
  out.message = oracle.message;
  if (oracle.ending == NativeResult::Ending::by_signal) return out.kind = Kind::povray_crashes, out;
  const bool draws = native.outcome == NativeResult::Outcome::rendered;
  if (oracle.outcome != NativeResult::Outcome::rendered) return out.kind = draws ? Kind::only_verisim : Kind::none, out;
  out.message = native.message;
  if (native.outcome == NativeResult::Outcome::unsupported) return out.kind = Kind::unsupported, out;
  if (!draws) return out.kind = Kind::only_povray, out;
  return picture_difference(theirs, ours);
}

// The wrong pixel with the largest difference in the cell of 16x16 that has most of them.
void find_worst(const std::vector<float>& error, int width, int height, Difference& out) {
  constexpr int kCell = 16;
  const int columns = (width + kCell - 1) / kCell;
  std::vector<int> wrong(static_cast<std::size_t>(columns) * static_cast<std::size_t>((height + kCell - 1) / kCell));
  const auto cell_of = [&](std::size_t i) {
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    return static_cast<std::size_t>(y / kCell * columns + x / kCell);
  };
  for (std::size_t i = 0; i < error.size(); ++i) wrong[cell_of(i)] += error[i] > out.limit;
  const auto cell = static_cast<std::size_t>(std::max_element(wrong.begin(), wrong.end()) - wrong.begin());
  float worst = -1;
  for (std::size_t i = 0; i < error.size(); ++i)
    if (cell_of(i) == cell && error[i] > worst)
      worst = error[i], out.x = static_cast<int>(i) % width, out.y = static_cast<int>(i) / width;
}

}  // namespace

Difference picture_difference(const Picture& reference, const Picture& test) {
  // Last bits may be rounded otherwise; where they lie together they are a difference, too (docs/comparison.md).
  constexpr double kSmall = 0.05;
  constexpr std::size_t kMany = 20;
  const Values p(reference), q(test);
  require_same_size(reference, test);
  std::vector<float> error;
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) {
      const Rgb d = difference(p, q, x, y);
      double most = std::abs(p.alpha(x, y) - q.alpha(x, y));
      for (const double v : d) most = std::max(most, std::abs(v));
      if (p.finite(x, y) != q.finite(x, y)) most = 255;
      error.push_back(static_cast<float>(most));
    }
  Difference out;
  for (const auto& [limit, least] : {std::pair(1.0, std::size_t{1}), std::pair(kSmall, kMany)}) {
    out.limit = limit;
    out.pixels = static_cast<std::size_t>(
        std::count_if(error.begin(), error.end(), [limit = limit](float e) { return e > limit; }));
    if (out.pixels < least) continue;
    out.kind = Kind::picture;
    out.largest = *std::max_element(error.begin(), error.end());
    find_worst(error, p.width(), p.height(), out);
    return out;
  }
  out.pixels = 0;
  return out;
}

bool same_difference(const Difference& whole, const Difference& candidate) {
  constexpr std::size_t kEnough = 60;
  constexpr double kLastBits = 8;
  if (whole.kind != candidate.kind) return false;
  if (whole.kind == Kind::picture)
    return candidate.limit == whole.limit && candidate.pixels * 4 >= std::min(whole.pixels, kEnough) &&
           (candidate.largest > kLastBits) == (whole.largest > kLastBits);
  if (whole.kind == Kind::debug_text) return true;
  if (is_of_messages(whole.kind)) return same_warning(whole.message, candidate.message);
  return whole.kind != Kind::none && whole.kind != Kind::undecided &&
         kernel_of(whole.message) == kernel_of(candidate.message);
}

std::string in_words(const Difference& d) {
  switch (d.kind) {
    case Kind::none:
      return "verisim and POV-Ray agree";
    case Kind::undecided:
      return "a program came to no end";
    case Kind::picture:
      return fmt::format("{} pixel{} differ{} by more than {} code value{}, by up to {:.4g}", d.pixels,
                         d.pixels == 1 ? "" : "s", d.pixels == 1 ? "s" : "", d.limit, d.limit == 1 ? "" : "s",
                         d.largest);
    case Kind::only_verisim:
      return "only verisim draws it; " + d.message;
    case Kind::only_povray:
      return "only POV-Ray draws it; verisim: " + d.message;
    case Kind::unsupported:
      return "verisim does not support it: " + d.message;
    case Kind::verisim_crashes:
      return "verisim crashes: " + d.message;
    case Kind::povray_crashes:
      return "POV-Ray crashes; " + d.message;
    case Kind::verisim_warns:
      return "only verisim warns: " + d.message;
    case Kind::povray_warns:
      return "only POV-Ray warns: " + d.message;
    case Kind::debug_text:
      return "#debug writes " + d.message;
  }
  return {};
}

Examiner::Examiner(SceneRequest scene, NativeRenderer native, OracleOptions oracle, std::atomic<bool>* cancel)
    : scene_(std::move(scene)),
      native_(std::move(native)),
      oracle_(std::move(oracle)),
      oracle_program_(find_oracle(oracle_)),
      cancel_(cancel),
      cores_(std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

NativeResult Examiner::native(const std::string& text, const Frame& frame, bool replay, double time_limit,
                              Picture& picture) {
  cores_.acquire();
  const std::shared_ptr<void> slot(nullptr, [this](void*) { cores_.release(); });
  const WorkingCopy copy(scene_.scene);
  put(text, copy.scene());
  NativeRequest request = request_of(copy, scene_, frame, time_limit, cancel_);
  request.replay = replay;
  request.library_paths = oracle_program_.library_paths;
  NativeResult out = native_(request);
  out.message = short_names(out.message, copy, oracle_program_.library_paths);
  read_result(request, out, picture);
  return out;
}

NativeResult Examiner::povray(const std::string& text, const Frame& frame, double time_limit, Picture& picture) {
  const WorkingCopy copy(scene_.scene);
  put(text, copy.scene());
  const NativeRequest request = request_of(copy, scene_, frame, time_limit, cancel_);
  NativeResult out = render_with_povray(oracle_program_, oracle_, request, 0);
  read_result(request, out, picture);
  return out;
}

Examination Examiner::examine(const std::string& text, const Frame& frame, bool replay, double time_limit,
                              const Difference* wanted) {
  Examination out;
  Picture ours, theirs;
  const NativeResult native = this->native(text, frame, replay, time_limit, ours);
  out.native_seconds = native.cpu_seconds;
  out.random = !native.stochastic_features.empty();
  if (const auto decided = decided_by(native)) return out.difference = *decided, out;
  if ((wanted && !possible(*wanted, native)) || (cancel_ && *cancel_)) return out;
  const NativeResult oracle = povray(text, frame, time_limit, theirs);
  out.oracle_seconds = oracle.cpu_seconds;
  if (cancel_ && *cancel_) return out;
  out.difference = difference_of(native, oracle, ours, theirs);
  const bool messages_matter = wanted && is_of_messages(wanted->kind),
             both_draw = out.difference.kind == Kind::none || out.difference.kind == Kind::picture;
  if (both_draw && oracle.outcome == NativeResult::Outcome::rendered &&
      (messages_matter || (!wanted && out.difference.kind == Kind::none)))
    out.difference = said(text, frame, time_limit, native, oracle, wanted);
  return out;
}

// POV-Ray loses a message now and then: what it does not say is asked for again.
Difference Examiner::said(const std::string& text, const Frame& frame, double time_limit, const NativeResult& native,
                          NativeResult oracle, const Difference* wanted) {
  constexpr int kTimes = 3;
  const Messages ours = messages_of(native.console);
  Difference out;
  for (int i = 0; i < kTimes; ++i) {
    Picture unused;
    if (i > 0) oracle = povray(text, frame, time_limit, unused);
    if (oracle.outcome != NativeResult::Outcome::rendered || (cancel_ && *cancel_)) return {};
    out = message_difference(ours, messages_of(oracle.console), wanted);
    if (out.kind == Kind::none || out.kind == Kind::povray_warns) break;
  }
  return out;
}

}  // namespace verisim::compare
