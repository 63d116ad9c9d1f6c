// A run: every scene through our renderer and the oracle, several at a time, each on its own: what goes wrong in one scene is a line in the report.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "compare/compare.h"
#include "compare/oracle/content_hash.h"
#include "compare/oracle/switches.h"
#include "compare/oracle/working_copy.h"
#include "compare/regression/passes.h"
#include "compare/report/display.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

// "lights/shadow.pov" as a file name that no other scene has.
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

// A private copy's path as the original's. The neighbours of the scene's folder are links in the copy.
std::vector<fs::path> original_paths(const std::vector<fs::path>& files, const WorkingCopy& copy, const fs::path& scene) {
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
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}
// Messages name the original, not the copy that goes away.
std::string original_names(std::string message, const WorkingCopy& copy, const fs::path& scene) {
  return replaced(std::move(message), copy.folder().string(), scene.parent_path().string());
}
// Files of the scene's own folder and of the library by their names alone.
std::string short_names(std::string text, const WorkingCopy& copy, const std::vector<fs::path>& library) {
  text = replaced(std::move(text), copy.folder().string() + "/", "");
  for (auto path = library.rbegin(); path != library.rend(); ++path) text = replaced(std::move(text), path->string() + "/", "");  // the longest is last
  return text;
}

class Runner {
 public:
  Runner(const Suite& suite, const RunOptions& options) : suite_(suite), options_(options) {}

  Run run() {
    prepare();
    run_.scenes.resize(suite_.scenes.size());
    started_.assign(suite_.scenes.size(), false);
    const int jobs = std::clamp(options_.jobs, 1, std::max<int>(1, static_cast<int>(suite_.scenes.size())));
    threads_each_ = options_.native_threads > 0 ? options_.native_threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / jobs);
    begin_ = std::chrono::steady_clock::now();
    {
      std::vector<std::jthread> workers;
      for (int i = 1; i < jobs; ++i) workers.emplace_back([this] { work(); });
      work();
    }
    run_.cancelled = cancelled();
    if (run_.cancelled) {
      std::vector<SceneResult> done;
      for (std::size_t i = 0; i < run_.scenes.size(); ++i)
        if (started_[i]) done.push_back(std::move(run_.scenes[i]));
      run_.scenes = std::move(done);
    }
    run_.summary = summarise(run_.scenes);
    return std::move(run_);
  }

 private:
  bool cancelled() const { return options_.cancel && *options_.cancel; }

  void prepare() {
    run_.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
    run_.native_version = options_.native_version;
    if (options_.work.empty()) {
      auto temporary = std::make_shared<TemporaryFolder>();
      work_ = temporary->path();
      run_.keep = temporary;
    } else {
      std::error_code failed;
      fs::create_directories(options_.work, failed);
      if (failed) throw std::runtime_error(fmt::format("{}: cannot make the folder: {}", options_.work.string(), failed.message()));
      work_ = fs::canonical(options_.work);
    }
    if (!options_.baseline.empty()) run_.reference_name = "baseline";
    const bool needs_oracle = options_.baseline.empty() && std::any_of(suite_.scenes.begin(), suite_.scenes.end(), [](const SceneRequest& s) { return !s.reference; });
    if (needs_oracle) {
      oracle_ = find_oracle(options_.oracle);
      run_.oracle_version = oracle_->version;
      run_.reference_name = oracle_->name;
    }
    read_previous();
  }

  void read_previous() {
    if (options_.previous_report.empty()) return;
    std::ifstream in(options_.previous_report);
    if (!in) return;
    const auto json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object() || !json.contains("scenes") || !json["scenes"].is_array()) throw std::runtime_error(options_.previous_report.string() + ": not a report of verisim compare");
    for (const auto& scene : json["scenes"]) {
      try {
        SceneResult result = scene_result_from_json(scene);
        const std::string name = result.request.name;
        previous_.insert_or_assign(name, std::move(result));
      } catch (const nlohmann::json::exception&) {
        // A line of another version: no trend for this scene.
      }
    }
  }

  void work() {
    for (;;) {
      const std::size_t i = next_++;
      if (i >= suite_.scenes.size() || cancelled()) return;
      {
        const std::lock_guard lock(mutex_);
        ++running_;
      }
      SceneResult result = one(suite_.scenes[i]);
      const std::lock_guard lock(mutex_);
      --running_;
      if (cancelled() && result.failed()) return;  // broken off, not failed
      started_[i] = true;
      ++done_, failed_ += result.failed();
      run_.scenes[i] = std::move(result);
      report_progress(run_.scenes[i]);
    }
  }

  void report_progress(const SceneResult& scene) {
    if (!options_.progress) return;
    Progress p;
    p.done = done_, p.total = static_cast<int>(suite_.scenes.size()), p.running = running_, p.failed = failed_;
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    p.seconds_left = elapsed / done_ * (p.total - done_);
    p.finished = &scene;
    options_.progress(p);
  }

  SceneResult one(const SceneRequest& request) {
    SceneResult result;
    result.request = request;
    try {
      const std::string stem = file_stem(request.name);
      if (!options_.resume || !resumed(stem, result)) {
        std::vector<fs::path> files_read;
        compare_one(request, stem, result, files_read);
        if (!cancelled()) remember(stem, files_read, result);
      }
    } catch (const std::exception& error) {
      result.status = Status::error, result.reason = error.what();
    }
    if (const auto it = previous_.find(request.name); it != previous_.end()) {
      result.previous = it->second.status;
      if (it->second.metrics) result.previous_rmse = it->second.metrics->rmse;
    }
    return result;
  }

  // A result is kept only while nothing has changed that decides it: the content of every file the scene reads, the settings, and both programs.
  std::string resume_key(const SceneRequest& r, std::vector<fs::path> files_read) const {
    ContentHash hash;
    hash.add("verisim result 2");
    hash.add(options_.native_version), hash.add(options_.native_identity), hash.add(oracle_ ? oracle_->version_text : "");
    hash.add(fmt::format("{}x{} {} {} {} {} {}", r.width, r.height, options_.replay, options_.runs, options_.baseline.string(), options_.always_blame, static_cast<bool>(options_.tags)));
    for (const std::string& s : r.switches) hash.add(s);
    for (const Pass& pass : r.passes) {
      for (const std::string& s : pass.switches) hash.add(s);
      for (const auto& row : pass.matrix) hash.add(fmt::format("{} {} {}", row[0], row[1], row[2]));
    }
    hash.add(r.scene_class ? to_string(*r.scene_class) : "auto");
    for (const auto& [name, limit] : r.thresholds) hash.add(fmt::format("{} {}", name, limit));
    hash.add(fmt::format("{} {} {} {}", r.fit.exposure, r.fit.white_balance, r.fit.crop ? fmt::format("{} {} {} {}", r.fit.crop->x, r.fit.crop->y, r.fit.crop->width, r.fit.crop->height) : "",
                         r.flip_pixels_per_degree));
    if (r.truth)
      for (const TruthPoint& point : r.truth->points) hash.add(fmt::format("{} {} {} {} {} {}", point.x, point.y, point.value[0], point.value[1], point.value[2], r.truth->tolerance));
    files_read.push_back(r.scene);
    if (const fs::path stored = stored_picture(r); !stored.empty()) files_read.push_back(stored);
    std::sort(files_read.begin(), files_read.end());
    for (const fs::path& file : files_read) hash.add(file.string()), hash.add_file(file);
    return hash.hex();
  }

  bool resumed(const std::string& stem, SceneResult& result) const {
    std::ifstream in(work_ / (stem + ".result.json"));
    if (!in) return false;
    const auto json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object()) return false;
    try {
      std::vector<fs::path> files;
      for (const std::string& file : json.at("files_read").get<std::vector<std::string>>()) files.emplace_back(file);
      if (json.at("key") != resume_key(result.request, files)) return false;
      SceneResult read = scene_result_from_json(json.at("result"));
      read.request = result.request;
      for (auto [path, name] : {std::pair(&read.oracle_picture, "oracle_picture"), std::pair(&read.native_picture, "native_picture")})
        if (const std::string file = json.value(name, ""); !file.empty()) *path = work_ / file;
      for (const auto& tree : json.value("trees", nlohmann::json::array())) read.trees.push_back({tree.at("x"), tree.at("y"), tree.at("text")});
      if (!read.oracle_picture.empty() && !read.native_picture.empty() && read.metrics)
        read.metrics = measured_again(*read.metrics, measure(image::read_picture(read.oracle_picture), image::read_picture(read.native_picture), metric_options(result.request)));
      result = std::move(read);
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }

  // The report keeps the figures, but neither the histogram nor the worst pixels; the pictures are kept in 8 bits only.
  static Metrics measured_again(const Metrics& kept, Metrics m) {
    m.max_abs = kept.max_abs, m.mae = kept.mae, m.rmse = kept.rmse, m.psnr = kept.psnr, m.bias = kept.bias;
    m.within_1_pct = kept.within_1_pct, m.within_2_pct = kept.within_2_pct;
    m.ssim_mean = kept.ssim_mean, m.ssim_block_min = kept.ssim_block_min, m.flip_mean = kept.flip_mean, m.hdr_flip_mean = kept.hdr_flip_mean;
    m.ciede2000_mean = kept.ciede2000_mean, m.ciede2000_p95 = kept.ciede2000_p95, m.edge_rmse = kept.edge_rmse, m.interior_rmse = kept.interior_rmse;
    m.alpha_max_abs = kept.alpha_max_abs, m.alpha_rmse = kept.alpha_rmse, m.nan_pixels = kept.nan_pixels;
    return m;
  }

  void remember(const std::string& stem, const std::vector<fs::path>& files_read, const SceneResult& result) const {
    nlohmann::json json;
    json["key"] = resume_key(result.request, files_read);
    json["files_read"] = nlohmann::json::array();
    for (const fs::path& file : files_read) json["files_read"].push_back(file.string());
    for (const PixelTags::Tree& tree : result.trees) json["trees"].push_back({{"x", tree.x}, {"y", tree.y}, {"text", tree.text}});
    json["result"] = to_json(result);
    json["oracle_picture"] = result.oracle_picture.filename().string();
    json["native_picture"] = result.native_picture.filename().string();
    write_report(json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace), work_ / (stem + ".result.json"));
  }

  static MetricOptions metric_options(const SceneRequest& request) {
    MetricOptions out;
    out.flip_pixels_per_degree = request.flip_pixels_per_degree;
    out.alpha = request.alpha();
    return out;
  }

  void compare_one(const SceneRequest& request, const std::string& stem, SceneResult& result, std::vector<fs::path>& files_read) {
    if (!fs::is_regular_file(request.scene)) {
      result.reason = request.scene.string() + ": no such scene file";
      return;
    }
    require_memory(static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height), request.alpha() ? 4 : 3, options_.memory_limit);
    const NativeResult native = render_native(request, native_output(request, stem, 0), 0, result, files_read);
    result.native_seconds = native.seconds, result.native_cpu_seconds = native.cpu_seconds, result.rays = native.rays;
    result.stochastic_features = native.stochastic_features;
    const bool noisy = !native.stochastic_features.empty() && !options_.replay && options_.baseline.empty();
    result.scene_class = request.scene_class.value_or(noisy ? SceneClass::stochastic : SceneClass::deterministic);
    if (native.outcome == NativeResult::Outcome::unsupported) {
      result.status = Status::unsupported, result.reason = native.message;
      return;
    }
    const bool rendered = native.outcome == NativeResult::Outcome::rendered;
    if (rendered) result.native_picture = native_output(request, stem, 0);
    const OracleRender oracle = reference_picture(request, rendered ? files_read : std::vector<fs::path>(), 0);
    result.oracle_seconds = oracle.seconds, result.oracle_cpu_seconds = oracle.cpu_seconds, result.oracle_cached = oracle.from_cache;
    if (!oracle.ok) {
      result.status = Status::oracle_failed;
      result.reason = rendered ? oracle.message : fmt::format("{} (verisim refuses the scene, too: {})", oracle.message, native.message);
      return;
    }
    if (!rendered) {
      result.status = Status::error, result.reason = native.message;
      keep_picture(oracle.picture, stem, "oracle", result.oracle_picture);
      return;
    }
    judge(request, stem, oracle.picture, files_read, result);
  }

  static std::string picture_extension(const SceneRequest& request) { return request.passes.empty() ? output_extension(request.switches) : ".png"; }

  fs::path native_output(const SceneRequest& request, const std::string& stem, int run) const {
    return work_ / (stem + (run ? fmt::format(".run{}", run + 1) : "") + ".native" + picture_extension(request));
  }

  void keep_picture(const Picture& picture, const std::string& stem, const char* side, fs::path& kept) const {
    const fs::path path = work_ / fmt::format("{}.{}.png", stem, side);
    image::write_picture(displayable(picture), path);
    kept = path;
  }

  NativeRequest native_request(const SceneRequest& request, const WorkingCopy& copy) const {
    NativeRequest ask;
    ask.folder = copy.folder(), ask.scene = copy.scene();
    ask.width = request.width, ask.height = request.height, ask.switches = request.switches;
    if (!output_type(request.switches)) ask.switches.push_back(options_.baseline.empty() ? "+FN8" : "+FN16");
    ask.threads = options_.replay ? 1 : threads_each_;
    ask.replay = options_.replay;
    ask.time_limit = options_.native_time_limit;
    ask.cancel = options_.cancel;
    if (oracle_) ask.library_paths = oracle_->library_paths;
    return ask;
  }

  NativeResult render_native(const SceneRequest& request, const fs::path& output, int run, const SceneResult& result, std::vector<fs::path>& files_read) {
    if (!request.passes.empty()) return render_passes(request, output, run, result, files_read);
    const WorkingCopy copy(request.scene);
    NativeRequest ask = native_request(request, copy);
    ask.output = output, ask.run = run;
    std::error_code ignored;
    fs::remove(ask.output, ignored);
    NativeResult native;
    try {
      native = options_.native(ask);
    } catch (const std::exception& error) {
      native.message = error.what();
    }
    native.message = original_names(native.message, copy, result.request.scene);
    if (native.outcome == NativeResult::Outcome::rendered && !fs::exists(ask.output)) native.outcome = NativeResult::Outcome::error, native.message = "no picture was written";
    files_read = original_paths(native.files_read, copy, request.scene);
    return native;
  }

  NativeResult render_passes(const SceneRequest& request, const fs::path& output, int run, const SceneResult& result, std::vector<fs::path>& files_read) {
    NativeResult out;
    PassSum sum;
    const TemporaryFolder folder;
    const fs::path picture = folder.path() / "pass.exr";
    for (const Pass& pass : request.passes) {
      NativeResult one = render_native(request_of_pass(request, pass), picture, run, result, files_read);
      one.seconds += out.seconds, one.cpu_seconds += out.cpu_seconds, one.peak_bytes = std::max(one.peak_bytes, out.peak_bytes);
      for (const auto& [kind, count] : out.rays) one.rays[kind] += count;
      out = std::move(one);
      if (out.outcome != NativeResult::Outcome::rendered) return out;
      sum.add(image::read_picture(picture), pass);
    }
    write_16_bits(sum.picture(), output);
    return out;
  }

  OracleRender oracle_picture(const SceneRequest& request, const OracleOptions& options, int variant, const std::vector<fs::path>& files_read) {
    if (request.passes.empty()) return run_oracle(*oracle_, options, request, variant, files_read, options_.cancel);
    OracleRender out;
    PassSum sum;
    bool from_cache = true;
    for (const Pass& pass : request.passes) {
      OracleRender one = run_oracle(*oracle_, options, request_of_pass(request, pass), variant, files_read, options_.cancel);
      if (!one.ok) return one;
      out.seconds += one.seconds, out.cpu_seconds += one.cpu_seconds, out.peak_bytes = std::max(out.peak_bytes, one.peak_bytes), from_cache = from_cache && one.from_cache;
      sum.add(one.picture, pass);
    }
    out.picture = sum.picture(), out.ok = true, out.from_cache = from_cache;
    return out;
  }

  // What takes the oracle's place; empty: nothing.
  fs::path stored_picture(const SceneRequest& request) const {
    if (request.reference) return *request.reference;
    return options_.baseline.empty() ? fs::path() : options_.baseline / (file_stem(request.name) + picture_extension(request));
  }

  OracleRender reference_picture(const SceneRequest& request, const std::vector<fs::path>& files_read, int variant) {
    const fs::path stored = stored_picture(request);
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

  void judge(const SceneRequest& request, const std::string& stem, const Picture& reference, const std::vector<fs::path>& files_read, SceneResult& result) {
    Picture native = image::read_picture(result.native_picture), fitted;
    const Picture* oracle = &reference;
    if (request.reference && request.fit.any()) {
      FittedPair pair = fit_to_reference(reference, native, request.fit);
      native = std::move(pair.test), fitted = std::move(pair.reference), oracle = &fitted;
      result.fit = pair.fit;
      keep_picture(native, stem, "fitted", result.native_picture);
    }
    keep_picture(*oracle, stem, "oracle", result.oracle_picture);
    result.metrics = measure(*oracle, native, metric_options(request));
    const bool rules = request.thresholds.empty();
    Verdict verdict = !rules ? judge_thresholds(*result.metrics, request.thresholds)
                      : options_.baseline.empty() || request.reference ? judge_deterministic(*result.metrics, request.antialiased())
                                                                       : judge_baseline(*result.metrics, request.antialiased());
    if (result.scene_class == SceneClass::stochastic && rules && verdict.status != Status::exact) {
      if (request.reference) {
        verdict.reason += "; a stored picture says nothing about noise";
      } else if (!judge_noise(request, stem, *oracle, native, files_read, result, verdict)) {
        return;
      }
    }
    if (request.truth) verdict = judge_truth(*request.truth, *oracle, native, verdict, result);
    result.status = verdict.status, result.reason = verdict.reason;
    if (result.status == Status::differ) {
      result.suspicions = diagnose(*oracle, native);
    } else if (const std::string drift = systematic_drift(*result.metrics); !drift.empty() && result.scene_class == SceneClass::deterministic) {
      result.suspicions = diagnose(*oracle, native);
      result.reason += (result.reason.empty() ? "" : "; ") + drift;
    }
    if (options_.tags && (result.status == Status::differ || options_.always_blame)) find_blame(request, *oracle, native, result);
  }

  // False when the oracle failed. The low-pass comparison comes first: what it refuses needs no more renders.
  bool judge_noise(const SceneRequest& request, const std::string& stem, const Picture& oracle, const Picture& native, const std::vector<fs::path>& files_read, SceneResult& result,
                   Verdict& verdict) {
    std::vector<Picture> references{oracle}, tests{native};
    const auto another_reference = [&] {
      OracleRender again = reference_picture(request, files_read, 2 * static_cast<int>(references.size()));
      result.oracle_seconds += again.seconds, result.oracle_cpu_seconds += again.cpu_seconds;
      if (!again.ok) result.status = Status::oracle_failed, result.reason = "another run for the noise: " + again.message;
      else references.push_back(std::move(again.picture));
      return again.ok;
    };
    if (!another_reference()) return false;
    result.native_low_pass = low_pass(oracle, native);
    result.noise_low_pass = low_pass(oracle, references[1]);
    verdict = judge_stochastic(*result.metrics, request.antialiased(), *result.native_low_pass, *result.noise_low_pass);
    if (options_.runs < 2 || verdict.status == Status::differ) return true;
    while (static_cast<int>(references.size()) < options_.runs)
      if (!another_reference()) return false;
    for (int run = 1; run < options_.runs; ++run) {
      std::vector<fs::path> ignored;
      const fs::path output = native_output(request, stem, run);
      const NativeResult again = render_native(request, output, run, result, ignored);
      if (again.outcome != NativeResult::Outcome::rendered) {
        verdict = {Status::error, fmt::format("run {}: {}", run + 1, again.message)};
        return true;
      }
      result.native_seconds += again.seconds, result.native_cpu_seconds += again.cpu_seconds;
      tests.push_back(image::read_picture(output));
    }
    result.welch = welch_test(references, tests);
    if (result.welch->rejected) verdict = {Status::differ, fmt::format("Welch's test over {} runs on each side: {}", options_.runs, result.welch->text())};
    return true;
  }

  // A known answer has the last word: who keeps it is right, whatever the other one says.
  static Verdict judge_truth(const Truth& truth, const Picture& oracle, const Picture& native, const Verdict& verdict, SceneResult& result) {
    result.oracle_truth = truth_error(oracle, truth), result.native_truth = truth_error(native, truth);
    const TruthError& error = *result.native_truth;
    if (error.max > truth.tolerance)
      return {Status::differ, fmt::format("the known answer is missed by {:.5f} > {} at pixel {}, {} (the reference misses it by {:.5f})", error.max, truth.tolerance, error.worst_x, error.worst_y,
                                          result.oracle_truth->max)};
    if (verdict.status == Status::differ && result.oracle_truth->max > truth.tolerance)
      return {Status::match, fmt::format("keeps the known answer, which the reference misses by {:.5f} ({})", result.oracle_truth->max, verdict.reason)};
    return verdict;
  }

  void find_blame(const SceneRequest& request, const Picture& oracle, const Picture& native, SceneResult& result) {
    constexpr double kMostPixels = 300000;
    constexpr std::size_t kTrees = 6;
    try {
      const WorkingCopy copy(request.scene);
      std::vector<std::pair<int, int>> trees;
      for (const WorstPixel& pixel : result.metrics->worst)
        if (trees.size() < kTrees) trees.emplace_back(pixel.x, pixel.y);
      const double pixels = static_cast<double>(request.width) * request.height;
      PixelTags tags = options_.tags(native_request(request.passes.empty() ? request : request_of_pass(request, request.passes[0]), copy), std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostPixels)))), trees);
      const std::vector<fs::path> library = oracle_ ? oracle_->library_paths : std::vector<fs::path>();
      for (PixelTags::Tag& tag : tags.tags) tag.name = short_names(std::move(tag.name), copy, library);
      for (PixelTags::Tree& tree : tags.trees) tree.text = short_names(std::move(tree.text), copy, library);
      result.blame = blame(oracle, native, tags, request.antialiased() ? 2 : 1);
      diagnose_worst_object(oracle, native, tags, result);
      result.trees = tags.trees;
    } catch (const std::exception& error) {
      result.blame_failed = error.what();
    }
  }

  // What is wrong with the object that wrong pixels have in common, if there is one.
  static void diagnose_worst_object(const Picture& oracle, const Picture& native, const PixelTags& tags, SceneResult& result) {
    constexpr double kClear = 0.4;
    const auto& common = result.blame->common;
    const auto object = std::find_if(common.begin(), common.end(), [](const CommonTag& tag) { return tag.kind == "object" && tag.correlation > kClear; });
    if (object == common.end() || tags.step != 1) return;
    const auto tag = std::find_if(tags.tags.begin(), tags.tags.end(), [&](const PixelTags::Tag& t) { return t.kind == "object" && t.name == object->name; }) - tags.tags.begin();
    std::vector<unsigned char> mask;
    for (int set : tags.set_of) {
      const auto& members = tags.sets.at(static_cast<std::size_t>(set));
      mask.push_back(std::find(members.begin(), members.end(), static_cast<int>(tag)) != members.end());
    }
    for (Suspicion& part : diagnose_part(oracle, native, mask)) {
      part.detail = fmt::format("{}: {}", object->name, part.detail);
      result.suspicions.push_back(std::move(part));
    }
  }

  const Suite& suite_;
  const RunOptions& options_;
  Run run_;
  fs::path work_;
  std::optional<OracleProgram> oracle_;
  std::map<std::string, SceneResult> previous_;
  std::mutex mutex_;
  std::atomic<std::size_t> next_{0};
  std::vector<bool> started_;
  int threads_each_ = 1, done_ = 0, running_ = 0, failed_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace

Run run_suite(const Suite& suite, const RunOptions& options) {
  if (!options.native) throw std::invalid_argument("run_suite: no native renderer");
  return Runner(suite, options).run();
}

}  // namespace verisim::compare
