#include "compare/regression/renders.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/oracle/content_hash.h"
#include "compare/oracle/switches.h"
#include "compare/regression/passes.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

// A private copy's path as the original's. The neighbours of the scene's folder are links in the copy.
std::vector<fs::path> original_paths(const std::vector<fs::path>& files, const WorkingCopy& copy,
                                     const fs::path& scene) {
  std::vector<fs::path> out;
  const fs::path original = fs::canonical(scene).parent_path();
  for (const fs::path& file : files) {
    const fs::path absolute = (file.is_absolute() ? file : copy.folder() / file).lexically_normal();
    const fs::path relative = absolute.lexically_relative(copy.folder());
    const bool inside = !relative.empty() && *relative.begin() != "..";
    std::error_code ignored;
    out.push_back(inside ? original / relative : fs::weakly_canonical(absolute, ignored));
  }
  return out;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}
// Messages name the original, not the copy that goes away.
std::string original_names(std::string message, const WorkingCopy& copy, const fs::path& scene) {
  return replaced(std::move(message), copy.folder().string(), scene.parent_path().string());
}
std::string picture_extension(const SceneRequest& request) {
  return request.passes.empty() ? output_extension(request.switches) : ".png";
}

}  // namespace

std::string file_stem(const std::string& name) {
  std::string out;
  bool changed = name.find("__") != std::string::npos;
  for (char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
    out += plain ? c : '_';
    changed |= !plain && c != '/';
    if (c == '/') out += '_';
  }
  if (out.size() > 100) out.resize(100), changed = true;
  if (!changed && !out.starts_with(".")) return out;
  ContentHash hash;
  hash.add(name);
  return "scene" + out + "-" + hash.hex().substr(0, 12);
}

std::string short_names(std::string text, const WorkingCopy& copy, const std::vector<fs::path>& library) {
  text = replaced(std::move(text), copy.folder().string() + "/", "");
  for (auto path = library.rbegin(); path != library.rend(); ++path)
    text = replaced(std::move(text), path->string() + "/", "");  // the longest is last
  return text;
}

fs::path Renders::native_output(const SceneRequest& request, const std::string& stem, int run) const {
  return work_ / (stem + (run ? fmt::format(".run{}", run + 1) : "") + ".native" + picture_extension(request));
}

NativeRequest Renders::native_request(const SceneRequest& request, const WorkingCopy& copy) const {
  NativeRequest ask;
  ask.folder = copy.folder(), ask.scene = copy.scene();
  ask.width = request.width, ask.height = request.height, ask.switches = request.switches;
  if (!output_type(request.switches)) ask.switches.push_back(request.reference ? "+FN8" : kFinePicture);
  ask.threads = options_.replay ? 1 : threads_each_;
  ask.replay = options_.replay;
  ask.time_limit = options_.native_time_limit;
  ask.cancel = options_.cancel;
  ask.library_paths = library_paths();
  return ask;
}

NativeResult Renders::native(const SceneRequest& request, const fs::path& output, int run,
                             std::vector<fs::path>& files_read) const {
  if (!request.passes.empty()) return native_passes(request, output, run, files_read);
  return rendered(options_.native, request, output, run, files_read);
}

NativeResult Renders::rendered(const NativeRenderer& renderer, const SceneRequest& request, const fs::path& output,
                               int run, std::vector<fs::path>& files_read) const {
  const WorkingCopy copy(request.scene);
  NativeRequest ask = native_request(request, copy);
  ask.output = output, ask.run = run;
  std::error_code ignored;
  fs::remove(ask.output, ignored);
  NativeResult out;
  try {
    out = renderer(ask);
  } catch (const std::exception& error) {
    out.message = error.what();
  }
  out.message = original_names(out.message, copy, request.scene);
  if (out.outcome == NativeResult::Outcome::rendered && !fs::exists(ask.output))
    out.outcome = NativeResult::Outcome::error, out.message = "no picture was written";
  files_read = original_paths(out.files_read, copy, request.scene);
  return out;
}

Picture Renders::by(const NativeRenderer& renderer, const SceneRequest& request, const fs::path& output) const {
  std::vector<fs::path> files_read;
  const NativeResult result = rendered(renderer, request, output, 0, files_read);
  if (result.outcome != NativeResult::Outcome::rendered) throw std::runtime_error(result.message);
  return image::read_picture(output);
}

NativeResult Renders::native_passes(const SceneRequest& request, const fs::path& output, int run,
                                    std::vector<fs::path>& files_read) const {
  NativeResult out;
  PassSum sum;
  const TemporaryFolder folder;
  const fs::path picture = folder.path() / "pass.exr";
  for (const Pass& pass : request.passes) {
    NativeResult one = native(request_of_pass(request, pass), picture, run, files_read);
    one.seconds += out.seconds, one.cpu_seconds += out.cpu_seconds,
        one.peak_bytes = std::max(one.peak_bytes, out.peak_bytes);
    for (const auto& [kind, count] : out.rays) one.rays[kind] += count;
    out = std::move(one);
    if (out.outcome != NativeResult::Outcome::rendered) return out;
    sum.add(image::read_picture(picture), pass);
  }
  write_16_bits(sum.picture(), output);
  return out;
}

OracleRender Renders::oracle_picture(const SceneRequest& request, const OracleOptions& options, int variant,
                                     const std::vector<fs::path>& files_read) const {
  if (request.passes.empty()) return run_oracle(*oracle_, options, request, variant, files_read, options_.cancel);
  OracleRender out;
  PassSum sum;
  bool from_cache = true;
  for (const Pass& pass : request.passes) {
    OracleRender one =
        run_oracle(*oracle_, options, request_of_pass(request, pass), variant, files_read, options_.cancel);
    if (!one.ok) return one;
    out.seconds += one.seconds, out.cpu_seconds += one.cpu_seconds,
        out.peak_bytes = std::max(out.peak_bytes, one.peak_bytes), from_cache = from_cache && one.from_cache;
    sum.add(one.picture, pass);
  }
  out.picture = sum.picture(), out.ok = true, out.from_cache = from_cache;
  return out;
}

fs::path Renders::command_output(const SceneRequest& request, int variant) const {
  return work_ / fmt::format("{}.reference{}{}", file_stem(request.name), variant, output_extension(request.switches));
}

fs::path Renders::reference_file(const SceneRequest& request) const {
  if (!request.passes.empty()) return {};
  const fs::path stored = stored_picture(request);
  return stored.empty() && options_.reference ? command_output(request, 0) : stored;
}

// Another renderer in the oracle's place. Its seeds are none of the judged one's.
OracleRender Renders::by_command(const SceneRequest& request, int variant) const {
  constexpr int kFirstSeed = 1000;
  OracleRender out;
  if (!request.passes.empty()) {
    out.message = "a scene of several passes needs POV-Ray as its reference";
    return out;
  }
  const fs::path file = command_output(request, variant);
  std::vector<fs::path> files_read;
  const NativeResult result = rendered(options_.reference, request, file, kFirstSeed + variant, files_read);
  out.seconds = result.seconds, out.cpu_seconds = result.cpu_seconds, out.peak_bytes = result.peak_bytes;
  if (result.outcome != NativeResult::Outcome::rendered) {
    out.message = result.message;
    return out;
  }
  try {
    out.picture = image::read_picture(file), out.ok = true;
  } catch (const std::exception& error) {
    out.message = error.what();
  }
  return out;
}

std::vector<fs::path> Renders::alternatives(const SceneRequest& request) const {
  if (request.reference || options_.baseline.empty()) return request.alternatives;
  std::vector<fs::path> out;
  const std::string start = file_stem(request.name) + "@", extension = picture_extension(request);
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(options_.baseline, ignored))
    if (entry.path().extension() == extension && entry.path().filename().string().starts_with(start))
      out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

fs::path Renders::stored_picture(const SceneRequest& request) const {
  if (request.reference) return *request.reference;
  return options_.baseline.empty() ? fs::path()
                                   : options_.baseline / (file_stem(request.name) + picture_extension(request));
}

OracleRender Renders::reference(const SceneRequest& request, const std::vector<fs::path>& files_read,
                                int variant) const {
  const fs::path stored = stored_picture(request);
  if (stored.empty() && options_.reference) return by_command(request, variant);
  if (stored.empty()) {
    OracleOptions options = options_.oracle;
    if (options_.replay) options.threads = 1;
    return oracle_picture(request, options, variant, files_read);
  }
  OracleRender out;
  if (!fs::exists(stored)) {
    out.message = fmt::format("there is no stored picture {}", stored.string());
    return out;
  }
  try {
    out.picture = image::read_picture(stored);
    out.ok = true;
  } catch (const std::exception& error) {
    out.message = error.what();
  }
  return out;
}

}  // namespace verisim::compare
