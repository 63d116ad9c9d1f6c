// A run: every scene through our renderer and the oracle, several at a time, each on its own: what goes wrong in one
// scene is a line in the report.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <semaphore>
#include <thread>

#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/oracle/working_copy.h"
#include "compare/regression/baseline.h"
#include "compare/regression/judge.h"
#include "compare/regression/renders.h"
#include "compare/regression/result_store.h"
#include "compare/regression/run_folder.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

// A scene that computes; those that wait for POV-Ray, which sleeps when it starts, are beside these.
class Slot {
 public:
  explicit Slot(std::counting_semaphore<>& slots) : slots_(slots) { slots_.acquire(); }
  ~Slot() { slots_.release(); }
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;

 private:
  std::counting_semaphore<>& slots_;
};

class Runner {
 public:
  Runner(const Suite& suite, const RunOptions& options) : suite_(suite), options_(options) {}

  Run run() {
    const int jobs = std::clamp(options_.jobs, 1, std::max<int>(1, static_cast<int>(suite_.scenes.size())));
    prepare(jobs);
    run_.scenes.resize(suite_.scenes.size());
    started_.assign(suite_.scenes.size(), false);
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
    if (!run_.cancelled) add_removed();
    run_.summary = summarise(run_.scenes);
    if (!options_.work.empty()) save_run(run_, renders_->work(), options_.baseline);
    return std::move(run_);
  }

 private:
  bool cancelled() const { return options_.cancel && *options_.cancel; }

  void prepare(int jobs) {
    run_.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                               fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
    run_.native_version = options_.native_version;
    fs::path work;
    if (options_.work.empty()) {
      auto temporary = std::make_shared<TemporaryFolder>();
      work = temporary->path();
      run_.keep = temporary;
    } else {
      std::error_code failed;
      fs::create_directories(options_.work, failed);
      if (failed)
        throw std::runtime_error(
            fmt::format("{}: cannot make the folder: {}", options_.work.string(), failed.message()));
      work = fs::canonical(options_.work);
    }
    if (!options_.baseline.empty()) run_.reference_name = "baseline";
    if (!suite_.scenes.empty() && std::all_of(suite_.scenes.begin(), suite_.scenes.end(),
                                              [](const SceneRequest& s) { return s.reference.has_value(); }))
      run_.reference_name = suite_.scenes[0].reference_name();
    const bool needs_oracle =
        options_.baseline.empty() && !options_.reference &&
        std::any_of(suite_.scenes.begin(), suite_.scenes.end(), [](const SceneRequest& s) { return !s.reference; });
    std::optional<OracleProgram> oracle;
    if (needs_oracle) {
      oracle = find_oracle(options_.oracle);
      run_.oracle_version = oracle->version;
      run_.reference_name = oracle->name;
    }
    if (options_.reference && options_.baseline.empty()) run_.reference_name = options_.reference_name;
    const int threads_each = options_.native_threads > 0
                                 ? options_.native_threads
                                 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / jobs);
    renders_.emplace(options_, work, std::move(oracle), threads_each);
    judge_.emplace(options_, *renders_);
    store_.emplace(options_, *renders_);
    read_previous();
  }

  void read_previous() {
    for (const fs::path& report : options_.earlier_reports) read_report(report, true);
    if (!options_.previous_report.empty()) read_report(options_.previous_report, false);
  }
  void read_report(const fs::path& report, bool of_history) {
    std::ifstream in(report);
    if (!in) return;
    const auto json = parse_json(in);
    if (!json.is_object() || !json.contains("scenes") || !json["scenes"].is_array())
      throw std::runtime_error(report.string() + ": not a report of verisim compare");
    for (const auto& scene : json["scenes"]) {
      try {
        SceneResult result = scene_result_from_json(scene);
        const std::string name = result.request.name;
        if (of_history)
          history_[name].push_back({json.value("started", ""), result.status,
                                    result.metrics ? std::optional(result.metrics->rmse) : std::nullopt});
        else
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
      if (cancelled() && !result.passed()) return;  // broken off, not failed
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
      if (!options_.resume || !store_->resumed(stem, result)) {
        std::vector<fs::path> files_read;
        compare_one(request, stem, result, files_read);
        if (!cancelled()) store_->remember(stem, files_read, result);
      }
    } catch (const std::exception& error) {
      result.status = Status::error, result.reason = error.what();
    }
    if (const auto it = previous_.find(request.name); it != previous_.end()) {
      result.previous = it->second.status;
      if (it->second.metrics) result.previous_rmse = it->second.metrics->rmse;
    }
    if (const auto it = history_.find(request.name); it != history_.end()) result.history = it->second;
    return result;
  }

  void compare_one(const SceneRequest& request, const std::string& stem, SceneResult& result,
                   std::vector<fs::path>& files_read) {
    if (!fs::is_regular_file(request.scene)) {
      result.reason = request.scene.string() + ": no such scene file";
      return;
    }
    require_memory(static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height),
                   request.alpha() ? 4 : 3, options_.memory_limit);
    const NativeResult native = [&] {
      const Slot slot(cores_);
      return renders_->native(request, renders_->native_output(request, stem, 0), 0, files_read);
    }();
    result.native_seconds = native.seconds, result.native_cpu_seconds = native.cpu_seconds, result.rays = native.rays;
    result.stochastic_features = native.stochastic_features;
    const bool noisy = !native.stochastic_features.empty() && !options_.replay && options_.baseline.empty();
    result.scene_class = request.scene_class.value_or(noisy ? SceneClass::stochastic : SceneClass::deterministic);
    if (native.outcome == NativeResult::Outcome::unsupported) {
      result.status = Status::unsupported, result.reason = native.message;
      return;
    }
    const bool rendered = native.outcome == NativeResult::Outcome::rendered;
    if (rendered) result.native_picture = renders_->native_output(request, stem, 0);
    const OracleRender oracle = renders_->reference(request, rendered ? files_read : std::vector<fs::path>(), 0);
    result.oracle_seconds = oracle.seconds, result.oracle_cpu_seconds = oracle.cpu_seconds,
    result.oracle_cached = oracle.from_cache;
    if (!oracle.ok && rendered && !options_.baseline.empty() && !fs::exists(renders_->stored_picture(request))) {
      if (result.scene_class == SceneClass::stochastic) {
        Verdict ignored;
        const Picture native_picture = image::read_picture(result.native_picture);
        if (!judge_->stored_noise(request, stem, native_picture, result, ignored)) return;
      }
      result.status = Status::added,
      result.reason = fmt::format("there is no stored picture yet ({}); --update stores this one", oracle.message);
      return;
    }
    if (!oracle.ok) {
      result.status = Status::oracle_failed;
      result.reason = rendered ? oracle.message
                               : fmt::format("{} (verisim refuses the scene, too: {})", oracle.message, native.message);
      return;
    }
    if (!rendered) {
      result.status = Status::error, result.reason = native.message;
      judge_->keep_picture(oracle.picture, stem, "oracle", result.oracle_picture);
      return;
    }
    if (!options_.baseline.empty() && !request.reference &&
        (oracle.picture.width != request.width || oracle.picture.height != request.height)) {
      result.status = Status::differ;
      result.reason = fmt::format("the stored picture has {}x{} pixels, this one {}x{}{}", oracle.picture.width,
                                  oracle.picture.height, request.width, request.height,
                                  stored_call(options_.baseline, request.name));
      judge_->keep_picture(oracle.picture, stem, "oracle", result.oracle_picture);
      return;
    }
    const Slot slot(cores_);
    judge_->judge(request, stem, oracle.picture, files_read, result);
  }

  // Stored pictures whose scene is gone; of a suite from which nothing was left out.
  void add_removed() {
    if (options_.baseline.empty() || !options_.whole_suite) return;
    for (const std::string& name : stored_scenes(options_.baseline)) {
      if (std::any_of(suite_.scenes.begin(), suite_.scenes.end(),
                      [&](const SceneRequest& s) { return s.name == name; }))
        continue;
      SceneResult& gone = run_.scenes.emplace_back();
      gone.request.name = name;
      gone.status = Status::removed,
      gone.reason = "there is a stored picture, but no such scene any more; --update removes it";
    }
  }

  const Suite& suite_;
  const RunOptions& options_;
  Run run_;
  std::optional<Renders> renders_;
  std::optional<Judge> judge_;
  std::optional<ResultStore> store_;
  std::map<std::string, SceneResult> previous_;
  std::map<std::string, std::vector<SceneResult::Earlier>> history_;
  std::mutex mutex_;
  std::atomic<std::size_t> next_{0};
  std::vector<bool> started_;
  std::counting_semaphore<> cores_{std::max(1, static_cast<int>(std::thread::hardware_concurrency()))};
  int done_ = 0, running_ = 0, failed_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace

Run run_suite(const Suite& suite, const RunOptions& options) {
  if (!options.native) throw std::invalid_argument("run_suite: no native renderer");
  return Runner(suite, options).run();
}

}  // namespace verisim::compare
