// A run: every scene through our renderer and the oracle, several at a time, each on its own: what goes wrong in one scene is a line in the report.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "compare/compare.h"
#include "compare/oracle/content_hash.h"
#include "compare/oracle/switches.h"
#include "compare/oracle/working_copy.h"
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

// Messages name the original, not the copy that goes away.
std::string original_names(std::string message, const WorkingCopy& copy, const fs::path& scene) {
  const std::string from = copy.folder().string(), to = scene.parent_path().string();
  for (std::size_t at = message.find(from); at != std::string::npos; at = message.find(from, at + to.size())) message.replace(at, from.size(), to);
  return message;
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
    const bool needs_oracle = options_.baseline.empty() && std::any_of(suite_.scenes.begin(), suite_.scenes.end(), [](const SceneRequest& s) { return !s.reference; });
    if (needs_oracle) {
      oracle_ = find_oracle(options_.oracle);
      run_.oracle_version = oracle_->version;
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
      const std::string key = resume_key(request);
      if (!options_.resume || !resumed(stem, key, result)) {
        compare_one(request, stem, result);
        if (!cancelled()) remember(stem, key, result);
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

  // Our own picture goes on where it was broken off only if nothing that decides it has changed.
  std::string resume_key(const SceneRequest& r) const {
    ContentHash hash;
    hash.add(options_.native_version), hash.add(run_.oracle_version), hash.add_file(r.scene);
    hash.add(fmt::format("{}x{} {} {}", r.width, r.height, options_.replay, options_.baseline.string()));
    for (const std::string& s : r.switches) hash.add(s);
    return hash.hex();
  }

  bool resumed(const std::string& stem, const std::string& key, SceneResult& result) const {
    std::ifstream in(work_ / (stem + ".result.json"));
    if (!in) return false;
    const auto json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object() || json.value("key", "") != key) return false;
    try {
      SceneResult read = scene_result_from_json(json.at("result"));
      read.request = result.request;
      for (auto [path, name] : {std::pair(&read.oracle_picture, "oracle_picture"), std::pair(&read.native_picture, "native_picture")})
        if (const std::string file = json.value(name, ""); !file.empty()) *path = work_ / file;
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
    m.ssim_mean = kept.ssim_mean, m.ssim_block_min = kept.ssim_block_min, m.flip_mean = kept.flip_mean;
    return m;
  }

  void remember(const std::string& stem, const std::string& key, const SceneResult& result) const {
    nlohmann::json json;
    json["key"] = key;
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

  void compare_one(const SceneRequest& request, const std::string& stem, SceneResult& result) {
    if (!fs::is_regular_file(request.scene)) {
      result.reason = request.scene.string() + ": no such scene file";
      return;
    }
    std::vector<fs::path> files_read;
    const NativeResult native = render_native(request, stem, result, files_read);
    if (native.outcome == NativeResult::Outcome::unsupported) {
      result.status = Status::unsupported, result.reason = native.message;
      return;
    }
    const bool rendered = native.outcome == NativeResult::Outcome::rendered;
    const OracleRender oracle = reference_picture(request, rendered ? files_read : std::vector<fs::path>(), oracle_threads());
    result.oracle_seconds = oracle.seconds, result.oracle_cpu_seconds = oracle.cpu_seconds, result.oracle_cached = oracle.from_cache;
    if (!oracle.ok) {
      result.status = Status::oracle_failed;
      result.reason = rendered ? oracle.message : fmt::format("{} (verisim refuses the scene, too: {})", oracle.message, native.message);
      return;
    }
    result.oracle_picture = work_ / (stem + ".oracle.png");
    image::write_picture(displayable(oracle.picture), result.oracle_picture);
    if (!rendered) {
      result.status = Status::error, result.reason = native.message;
      return;
    }
    judge(request, oracle.picture, files_read, result);
  }

  NativeResult render_native(const SceneRequest& request, const std::string& stem, SceneResult& result, std::vector<fs::path>& files_read) {
    const WorkingCopy copy(request.scene);
    NativeRequest ask;
    ask.folder = copy.folder(), ask.scene = copy.scene();
    ask.width = request.width, ask.height = request.height, ask.switches = request.switches;
    if (!output_type(request.switches)) ask.switches.push_back(options_.baseline.empty() ? "+FN8" : "+FN16");
    ask.output = work_ / (stem + ".native" + output_extension(request.switches));
    ask.threads = options_.replay ? 1 : threads_each_;
    ask.replay = options_.replay;
    ask.time_limit = options_.native_time_limit;
    ask.cancel = options_.cancel;
    if (oracle_) ask.library_paths = oracle_->library_paths;
    std::error_code ignored;
    fs::remove(ask.output, ignored);
    NativeResult native;
    try {
      native = options_.native(ask);
    } catch (const std::exception& error) {
      native.message = error.what();
    }
    native.message = original_names(native.message, copy, request.scene);
    if (native.outcome == NativeResult::Outcome::rendered) {
      if (fs::exists(ask.output)) result.native_picture = ask.output;
      else native.outcome = NativeResult::Outcome::error, native.message = "no picture was written";
    }
    result.native_seconds = native.seconds, result.native_cpu_seconds = native.cpu_seconds, result.rays = native.rays;
    result.stochastic_features = native.stochastic_features;
    const bool stochastic = !native.stochastic_features.empty() && !options_.replay && options_.baseline.empty();
    result.scene_class = request.scene_class.value_or(stochastic ? SceneClass::stochastic : SceneClass::deterministic);
    files_read = original_paths(native.files_read, copy, request.scene);
    return native;
  }

  int oracle_threads() const { return options_.replay ? 1 : std::max(1, options_.oracle.threads); }

  OracleRender reference_picture(const SceneRequest& request, const std::vector<fs::path>& files_read, int threads) {
    fs::path stored;
    if (request.reference) stored = *request.reference;
    else if (!options_.baseline.empty()) stored = options_.baseline / (file_stem(request.name) + output_extension(request.switches));
    if (stored.empty()) return run_oracle(*oracle_, options_.oracle, request, threads, files_read, options_.cancel);
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

  void judge(const SceneRequest& request, const Picture& oracle, const std::vector<fs::path>& files_read, SceneResult& result) {
    const Picture native = image::read_picture(result.native_picture);
    result.metrics = measure(oracle, native, metric_options(request));
    Verdict verdict = request.thresholds.empty() ? judge_deterministic(*result.metrics, request.antialiased()) : judge_thresholds(*result.metrics, request.thresholds);
    if (result.scene_class == SceneClass::stochastic && request.thresholds.empty() && verdict.status != Status::exact) {
      if (request.reference) {
        verdict.reason += "; a stored picture says nothing about noise";
      } else {
        const OracleRender second = reference_picture(request, files_read, oracle_threads() + 1);
        if (!second.ok) {
          result.status = Status::oracle_failed, result.reason = "second run for the noise: " + second.message;
          return;
        }
        result.oracle_seconds += second.seconds;
        result.native_low_pass = low_pass(oracle, native);
        result.noise_low_pass = low_pass(oracle, second.picture);
        verdict = judge_stochastic(*result.metrics, request.antialiased(), *result.native_low_pass, *result.noise_low_pass);
      }
    }
    result.status = verdict.status, result.reason = verdict.reason;
    if (result.status == Status::differ) result.suspicions = diagnose(oracle, native);
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
