#include "compare/reduce/reduce.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <thread>

#include "compare/reduce/messages.h"
#include "compare/reduce/reducer.h"
#include "tracer/base/whole_file.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

using Kind = Difference::Kind;
using Clock = std::chrono::steady_clock;

constexpr std::uintmax_t kMaxText = 16u << 20, kMaxInclude = 256u << 10;
constexpr int kAtATime = 12;  // POV-Ray sleeps for 0.8 s of a small scene

std::optional<std::string> text_of_file(const fs::path& file, std::uintmax_t limit) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed) || fs::file_size(file, failed) > limit || failed) return std::nullopt;
  return whole_file(file);
}

bool chooses_part(const std::vector<std::string>& switches) {
  return std::any_of(switches.begin(), switches.end(), [](const std::string& s) {
    const std::string head = s.substr(0, 3);
    return head == "+SC" || head == "+EC" || head == "+SR" || head == "+ER" || s.find("_Column") != std::string::npos ||
           s.find("_Row") != std::string::npos;
  });
}

class Reduce {
 public:
  Reduce(const SceneRequest& scene, const ReduceOptions& options)
      : scene_(scene), options_(options), examiner_(scene, options.native, options.oracle, options.cancel) {
    out_.frame = {scene.width, scene.height, {}};
    out_.replay = options.replay;
    const auto text = text_of_file(scene.scene, kMaxText);
    if (!text) throw std::runtime_error(fmt::format("{}: cannot be read, or is too large", scene.scene.string()));
    out_.text = *text;
    out_.lines_before = out_.lines = lines_of_code(*text);
  }

  Reduction run() {
    examine_whole();
    if (out_.difference.kind != Kind::none && out_.difference.kind != Kind::undecided && !cancelled()) {
      choose_frame();
      reduce();
      check_whole_picture();
    }
    out_.seconds = elapsed();
    out_.lines = lines_of_code(out_.text);
    return std::move(out_);
  }

 private:
  bool cancelled() const { return options_.cancel && *options_.cancel; }
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  double left() const { return options_.seconds - elapsed(); }
  bool late() const { return cancelled() || left() < reserve_; }

  void examine_whole() {
    Examination whole = examiner_.examine(out_.text, out_.frame, out_.replay, options_.seconds / 3);
    if (whole.random && !out_.replay) {  // what differs with the same random numbers can be told
      out_.random = out_.replay = true;
      whole = examiner_.examine(out_.text, out_.frame, true, std::max(1.0, options_.seconds / 2 - elapsed()));
    }
    out_.difference = out_.left = target_ = whole.difference;
    cost_ = whole.native_seconds + whole.oracle_seconds;
    // For the last look at the whole picture, and for who looks for suspects in it.
    reserve_ = std::min(options_.seconds / 3, 7 + 4 * cost_);
  }

  // A part of the picture, or a small one, costs less.
  void choose_frame() {
    constexpr double kCheap = 0.3;  // seconds
    if (is_of_messages(target_.kind)) return choose_small_frame();
    if (cost_ <= kCheap || target_.kind != Kind::picture || chooses_part(scene_.switches)) return;
    std::vector<Frame> frames;
    for (const int radius : {4, 16, 64}) frames.push_back(part_around(radius));
    for (const int factor : {8, 4, 2})
      frames.push_back({std::max(16, scene_.width / factor), std::max(16, scene_.height / factor), {}});
    std::vector<Examination> seen(frames.size());
    for_each(frames.size(), [&](std::size_t i) {
      const double limit = std::min(candidate_limit(), options_.seconds / 4);
      seen[i] = examiner_.examine(out_.text, frames[i], out_.replay, limit, &target_);
    });
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Difference& d = seen[i].difference;
      const double cost = seen[i].native_seconds + seen[i].oracle_seconds;
      Difference least = target_;
      least.pixels = std::min<std::size_t>(target_.pixels, 4);
      if (!same_difference(least, d) || cost >= 0.8 * cost_) continue;
      cost_ = cost, target_ = d, out_.frame = frames[i];
    }
  }

  // What the parser says hangs on the picture's size only where the scene asks for it.
  void choose_small_frame() {
    constexpr int kWidth = 16, kHeight = 12;
    const Frame small{kWidth, kHeight, {}};
    if (chooses_part(scene_.switches) || scene_.width * scene_.height <= kWidth * kHeight) return;
    const Examination seen = examiner_.examine(out_.text, small, out_.replay, candidate_limit(), &target_);
    if (same_difference(target_, seen.difference)) out_.frame = small;
  }

  Frame part_around(int radius) const {
    Frame out{scene_.width, scene_.height, {}};
    const int left = std::max(0, target_.x - radius), right = std::min(scene_.width - 1, target_.x + radius),
              top = std::max(0, target_.y - radius), bottom = std::min(scene_.height - 1, target_.y + radius);
    // A start of 1 would be the whole width: the first column is where the picture starts anyway.
    if (left > 0) out.switches.push_back(fmt::format("+SC{}", left + 1));
    if (top > 0) out.switches.push_back(fmt::format("+SR{}", top + 1));
    out.switches.push_back(fmt::format("+EC{}", right + 1));
    out.switches.push_back(fmt::format("+ER{}", bottom + 1));
    return out;
  }

  double candidate_limit() const { return std::clamp(2 + 4 * cost_, 0.5, std::max(0.5, left() - reserve_)); }

  void for_each(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failed;
    std::mutex mutex;
    {
      std::vector<std::jthread> workers;
      for (std::size_t w = 0; w < std::min<std::size_t>(count, kAtATime); ++w)
        workers.emplace_back([&] {
          for (std::size_t i; (i = next++) < count && !late();) try {
              work(i);
            } catch (...) {
              const std::lock_guard lock(mutex);
              failed = std::current_exception();
            }
        });
    }
    if (failed) std::rethrow_exception(failed);
  }

  void reduce() {
    Reducer::Options options;
    options.stop = [this] { return late(); };
    options.judge = [this](const std::vector<std::string>& texts) {
      std::vector<unsigned char> same(texts.size());  // bits of a vector<bool> share bytes
      for_each(texts.size(), [&](std::size_t i) {
        const Difference d =
            examiner_.examine(texts[i], out_.frame, out_.replay, candidate_limit(), &target_).difference;
        same[i] = same_difference(target_, d) && d.pixels <= most_pixels_;
      });
      out_.tried += texts.size();
      tell();
      return std::vector<bool>(same.begin(), same.end());
    };
    options.include = [this](const std::string& name) -> std::optional<std::string> {
      const fs::path file = (scene_.scene.parent_path() / name).lexically_normal();
      const std::string relative = file.lexically_relative(scene_.scene.parent_path()).string();
      return relative.empty() || relative.starts_with("..") ? std::nullopt : text_of_file(file, kMaxInclude);
    };
    options.better = [this](const std::string& best) {
      out_.lines = lines_of_code(best);
      tell();
    };
    options.before_rounding = [this](const std::string& best) {
      const Difference now = examiner_.examine(best, out_.frame, out_.replay, candidate_limit(), &target_).difference;
      if (!same_difference(target_, now)) return;
      target_ = now;
      most_pixels_ = 4 * now.pixels + 8;
    };
    constexpr double kRound = 3;  // seconds that judging a batch may take
    const double cores = std::max(1u, std::thread::hardware_concurrency());
    options.batch = static_cast<std::size_t>(std::clamp(kRound * cores / std::max(cost_, 0.01), 4.0, 24.0));
    out_.text = Reducer(std::move(options)).reduced(out_.text);
    out_.complete = !late();
  }

  void tell() const {
    if (options_.progress) options_.progress({out_.lines_before, out_.lines, out_.tried, elapsed()});
  }

  // The whole picture in the size that was asked for shows it, too, unless it hangs on the part.
  void check_whole_picture() {
    const Frame whole{scene_.width, scene_.height, {}};
    if (cancelled()) return;
    const auto limit = [this] { return std::max(1.0, left() / 3); };
    Examination last = examiner_.examine(out_.text, whole, out_.replay, limit(), &out_.difference);
    if (last.difference.kind == out_.difference.kind) {
      out_.frame = whole, out_.left = last.difference;
      return;
    }
    last = examiner_.examine(out_.text, out_.frame, out_.replay, limit(), &target_);
    out_.left = last.difference;
  }

  const SceneRequest& scene_;
  const ReduceOptions& options_;
  Examiner examiner_;
  Reduction out_;
  Difference target_;                                                  // what a candidate must show in the frame
  std::size_t most_pixels_ = std::numeric_limits<std::size_t>::max();  // of a candidate with rounder numbers
  double cost_ = 0;  // CPU seconds of a candidate as large as the scene
  double reserve_ = 0;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::size_t lines_of_code(const std::string& text) {
  const std::string plain = laid_out(text);
  return static_cast<std::size_t>(std::count(plain.begin(), plain.end(), '\n'));
}

Reduction reduce_scene(const SceneRequest& scene, const ReduceOptions& options) { return Reduce(scene, options).run(); }

}  // namespace verisim::compare
