// A run: every scene through our renderer and the oracle, several at a time, each on its own: what goes wrong in one
// scene is a line in the report.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <semaphore>
#include <thread>

#include "compare/compare.h"
#include "compare/bounded_json.h"
#include "compare/oracle/working_copy.h"
#include "compare/regression/baseline.h"
#include "compare/regression/ignored.h"
#include "compare/regression/passes.h"
#include "compare/regression/renders.h"
#include "compare/regression/result_store.h"
#include "compare/regression/run_folder.h"
#include "compare/regression/stored_variance.h"
#include "compare/regression/verisimilitude.h"
#include "compare/report/display.h"
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
    const auto json = bounded_json(in);
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
        if (!judge_stored_noise(request, stem, native_picture, files_read, result, ignored)) return;
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
      keep_picture(oracle.picture, stem, "oracle", result.oracle_picture);
      return;
    }
    if (!options_.baseline.empty() && !request.reference &&
        (oracle.picture.width != request.width || oracle.picture.height != request.height)) {
      result.status = Status::differ;
      result.reason = fmt::format("the stored picture has {}x{} pixels, this one {}x{}{}", oracle.picture.width,
                                  oracle.picture.height, request.width, request.height,
                                  stored_call(options_.baseline, request.name));
      keep_picture(oracle.picture, stem, "oracle", result.oracle_picture);
      return;
    }
    const Slot slot(cores_);
    judge(request, stem, oracle.picture, files_read, result);
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

  void keep_picture(const Picture& picture, const std::string& stem, const char* side, fs::path& kept) const {
    kept = keep_exactly(picture, renders_->work() / fmt::format("{}.{}", stem, side));
  }

  void judge(const SceneRequest& request, const std::string& stem, const Picture& reference,
             const std::vector<fs::path>& files_read, SceneResult& result) {
    const fs::path rendered = result.native_picture;
    Picture native = image::read_picture(rendered), fitted;
    const Picture* oracle = &reference;
    if (request.reference && request.fit.any()) {
      FittedPair pair = fit_to_reference(reference, native, request.fit);
      native = std::move(pair.test), fitted = std::move(pair.reference), oracle = &fitted;
      result.fit = pair.fit;
      keep_picture(native, stem, "fitted", result.native_picture);
    }
    if (const std::vector<fs::path> others = renders_->alternatives(request); !others.empty()) {
      fitted = nearest(*oracle, others, native);
      oracle = &fitted;
    }
    if (request.ignored.any()) {
      fitted = *oracle, oracle = &fitted;
      leave_out(request, fitted, native);
      keep_picture(native, stem, "judged", result.judged_picture);
    }
    keep_picture(*oracle, stem, "oracle", result.oracle_picture);
    result.metrics = measure(*oracle, native, metric_options(request));
    if (!request.beside.empty() && request.reference)
      result.verisimilitude = likenesses(request, reference, *result.metrics, options_, *renders_);
    const bool rules = request.thresholds.empty() && !request.pixel_limits;
    Verdict verdict = !rules ? judge_limits(request, *oracle, native, *result.metrics)
                      : options_.baseline.empty() || request.reference
                          ? judge_deterministic(*result.metrics, request.antialiased(), request.allowed)
                          : judge_baseline(*result.metrics, request.antialiased(), request.allowed);
    if (result.scene_class == SceneClass::stochastic && rules && verdict.status != Status::exact) {
      if (!request.reference && !options_.baseline.empty()) {
        if (!judge_stored_noise(request, stem, native, files_read, result, verdict)) return;
      } else if (request.reference) {
        verdict.reason += "; a stored picture says nothing about noise";
      } else if (!judge_noise(request, stem, *oracle, native, files_read, result, verdict)) {
        return;
      }
    }
    if (rules && result.scene_class == SceneClass::deterministic && verdict.status != Status::differ)
      verdict = judge_leaning(request, *oracle, native, verdict, result);
    if (const fs::path file = renders_->reference_file(request); !file.empty() && !request.fit.any()) {
      const Layers layers = compare_layers(file, rendered, request.layers, request.antialiased());
      result.layers = layers.all;
      verdict = with_layers(verdict, layers);
    }
    if (request.truth) verdict = judge_truth(*request.truth, *oracle, native, verdict, result);
    result.status = verdict.status, result.reason = verdict.reason;
    if (const std::string warning = broken_limit(request.warnings, *result.metrics, *oracle, native);
        !warning.empty() && result.status != Status::differ)
      result.reason += (result.reason.empty() ? "" : "; ") + ("warning: " + warning);
    bool differs = result.status == Status::differ;
    if (const std::string drift = systematic_drift(*result.metrics);
        !differs && !drift.empty() && result.scene_class == SceneClass::deterministic) {
      differs = true;
      result.reason += (result.reason.empty() ? "" : "; ") + drift;
    }
    if (differs || options_.always_blame) find_causes(request, *oracle, native, result);
  }

  static Verdict judge_limits(const SceneRequest& request, const Picture& oracle, const Picture& native,
                              const Metrics& metrics) {
    const std::string broken = broken_limit({request.thresholds, request.pixel_limits}, metrics, oracle, native);
    if (!broken.empty()) return {Status::differ, broken};
    const bool exact = judge_deterministic(metrics, false).status == Status::exact;
    return {exact ? Status::exact : Status::match, ""};
  }

  // Of pictures that are all as good, the one that is nearest.
  static Picture nearest(const Picture& first, const std::vector<fs::path>& others, const Picture& native) {
    Picture best = first;
    const auto distance = [&](const Picture& picture) {
      return picture.width == native.width && picture.height == native.height ? low_pass(picture, native, 0.5).rmse
                                                                              : std::numeric_limits<double>::infinity();
    };
    double least = distance(best);
    for (const fs::path& other : others)
      if (Picture picture = image::read_picture(other); distance(picture) < least)
        least = distance(picture), best = std::move(picture);
    return best;
  }

  void leave_out(const SceneRequest& request, Picture& oracle, Picture& native) const {
    std::optional<PixelTags> tags;
    if (!request.ignored.objects.empty() && options_.tags) {
      const WorkingCopy copy(request.scene);
      tags = options_.tags(renders_->native_request(request, copy), 1, {});
    }
    ignore_pixels(request.ignored, tags ? &*tags : nullptr, oracle, native);
  }

  // Against the mean and the deviation that were stored of several runs: one render is enough, unless it is refused;
  // then, and where none are stored yet, they are made anew, for an update. False when ours failed.
  bool judge_stored_noise(const SceneRequest& request, const std::string& stem, const Picture& native,
                          const std::vector<fs::path>&, SceneResult& result, Verdict& verdict) {
    if (const auto stored = read_stored_variance(renders_->stored_picture(request))) {
      const ZTest test = z_test(*stored, native);
      write_p_map(test.p, native, stem, result);
      verdict = test.rejected ? Verdict{Status::differ, test.text()} : Verdict{Status::match, test.text()};
      if (!test.rejected) return true;
    }
    if (options_.runs < 2) return true;
    std::vector<Picture> tests{native};
    if (!more_tests(request, stem, options_.runs, tests, result, verdict)) {
      result.status = verdict.status, result.reason = verdict.reason;
      return false;
    }
    write_stored_variance(tests, result.native_picture);
    return true;
  }

  // What passes is asked object by object: a small one shows in no figure of the whole picture.
  Verdict judge_leaning(const SceneRequest& request, const Picture& oracle, const Picture& native,
                        const Verdict& verdict, SceneResult& result) {
    const TagSource& source = options_.tags ? options_.tags : options_.reference_tags;
    if (!worth_asking_objects(*result.metrics)) return verdict;
    const std::optional<PixelTags> tags = tags_by(source, request, {}, result);
    if (!tags) return verdict;
    return judge_objects(oracle, native, *tags, request.allowed).value_or(verdict);
  }

  // False when the oracle failed.
  bool judge_noise(const SceneRequest& request, const std::string& stem, const Picture& oracle, const Picture& native,
                   const std::vector<fs::path>& files_read, SceneResult& result, Verdict& verdict) {
    std::vector<Picture> references{oracle}, tests{native};
    if (!more_references(request, files_read, 2, references, result)) return false;
    const auto judge_low_pass = [&](const LowPass& ours, const LowPass& noise) {
      result.native_low_pass = ours, result.noise_low_pass = noise;
      verdict = judge_stochastic(*result.metrics, request.antialiased(), ours, noise, request.allowed);
    };
    judge_low_pass(low_pass(oracle, native), low_pass(oracle, references[1]));
    if (options_.runs < 2) return true;
    // One pair of pictures tells little of the noise that whole pictures have: what is refused must be refused again by
    // means of several.
    if (verdict.status == Status::differ && result.metrics->nan_pixels == 0) {
      if (!more_references(request, files_read, options_.runs, references, result)) return false;
      if (!more_tests(request, stem, options_.runs, tests, result, verdict)) return true;
      const std::span<const Picture> all(references);
      const std::size_t half = all.size() / 2;
      judge_low_pass(low_pass(mean_of(all), mean_of(tests)),
                     low_pass(mean_of(all.first(half)), mean_of(all.subspan(half))));
      if (verdict.status == Status::differ) verdict.reason += fmt::format(" in the means of {} runs", tests.size());
    }
    if (verdict.status == Status::differ) return true;
    // What the first runs refuse must be refused again by twice as many others: a renderer whose runs repeat each other
    // here and there passes for one without noise.
    int first = 0;
    for (const int runs : {options_.runs, 2 * options_.runs}) {
      if (!more_references(request, files_read, first + runs, references, result)) return false;
      if (!more_tests(request, stem, first + runs, tests, result, verdict)) return true;
      const std::vector<Picture> theirs(references.begin() + first, references.end()),
          ours(tests.begin() + first, tests.end());
      result.welch = welch_test(theirs, ours);
      write_p_map(pixel_p_values(theirs, ours), native, stem, result);
      if (!result.welch->rejected) return true;
      first += runs;
    }
    verdict = {Status::differ, fmt::format("Welch's test over {} runs on each side, and over {} others: {}",
                                           options_.runs, 2 * options_.runs, result.welch->text())};
    return true;
  }

  void write_p_map(const std::vector<float>& p, const Picture& shape, const std::string& stem,
                   SceneResult& result) const {
    constexpr float kWhite = 10;  // -log10
    Picture map;
    map.width = shape.width, map.height = shape.height, map.channels = 1;
    for (const float value : p) map.samples.push_back(std::min(1.0f, -std::log10(std::max(value, 1e-30f)) / kWhite));
    const fs::path path = renders_->work() / (stem + ".p.png");
    image::write_picture(map, path);
    result.p_map = path;
  }

  bool more_references(const SceneRequest& request, const std::vector<fs::path>& files_read, int runs,
                       std::vector<Picture>& references, SceneResult& result) {
    while (static_cast<int>(references.size()) < runs) {
      OracleRender again = renders_->reference(request, files_read, 2 * static_cast<int>(references.size()));
      result.oracle_seconds += again.seconds, result.oracle_cpu_seconds += again.cpu_seconds;
      if (!again.ok) {
        result.status = Status::oracle_failed, result.reason = "another run for the noise: " + again.message;
        return false;
      }
      references.push_back(std::move(again.picture));
    }
    return true;
  }

  bool more_tests(const SceneRequest& request, const std::string& stem, int runs, std::vector<Picture>& tests,
                  SceneResult& result, Verdict& verdict) {
    while (static_cast<int>(tests.size()) < runs) {
      const int run = static_cast<int>(tests.size());
      std::vector<fs::path> ignored;
      const fs::path output = renders_->native_output(request, stem, run);
      const NativeResult again = renders_->native(request, output, run, ignored);
      if (again.outcome != NativeResult::Outcome::rendered) {
        verdict = {Status::error, fmt::format("run {}: {}", run + 1, again.message)};
        return false;
      }
      result.native_seconds += again.seconds, result.native_cpu_seconds += again.cpu_seconds;
      tests.push_back(image::read_picture(output));
    }
    return true;
  }

  // A known answer has the last word: who keeps it is right, whatever the other one says.
  static Verdict judge_truth(const Truth& truth, const Picture& oracle, const Picture& native, const Verdict& verdict,
                             SceneResult& result) {
    result.oracle_truth = truth_error(oracle, truth), result.native_truth = truth_error(native, truth);
    const TruthError& error = *result.native_truth;
    if (error.max > truth.tolerance)
      return {
          Status::differ,
          fmt::format("the known answer is missed by {:.5f} > {} at pixel {}, {} (the reference misses it by {:.5f})",
                      error.max, truth.tolerance, error.worst_x, error.worst_y, result.oracle_truth->max)};
    if (verdict.status == Status::differ && result.oracle_truth->max > truth.tolerance)
      return {Status::match, fmt::format("keeps the known answer, which the reference misses by {:.5f} ({})",
                                         result.oracle_truth->max, verdict.reason)};
    return verdict;
  }

  // What the pixels of a scene show, by one of the two programs.
  std::optional<PixelTags> tags_by(const TagSource& source, const SceneRequest& request,
                                   const std::vector<std::pair<int, int>>& trees, SceneResult& result) {
    constexpr double kMaxPixels = 300000;
    if (!source || request.scene.extension() != ".pov") return std::nullopt;  // another renderer's scenes
    try {
      const WorkingCopy copy(request.scene);
      const double pixels = static_cast<double>(request.width) * request.height;
      PixelTags tags = source(renders_->native_request(
                                  request.passes.empty() ? request : request_of_pass(request, request.passes[0]), copy),
                              std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMaxPixels)))), trees);
      const std::vector<fs::path> library = renders_->library_paths();
      for (PixelTags::Tag& tag : tags.tags) tag.name = short_names(std::move(tag.name), copy, library);
      for (PixelTags::Tree& tree : tags.trees) tree.text = short_names(std::move(tree.text), copy, library);
      return tags;
    } catch (const std::exception& error) {
      result.blame_failed = error.what();
      return std::nullopt;
    }
  }

  void find_causes(const SceneRequest& request, const Picture& oracle, const Picture& native, SceneResult& result) {
    constexpr std::size_t kTrees = 6;
    std::vector<std::pair<int, int>> trees;
    for (const WorstPixel& pixel : result.metrics->worst)
      if (trees.size() < kTrees) trees.emplace_back(pixel.x, pixel.y);
    const std::optional<PixelTags> ours = tags_by(options_.tags, request, trees, result),
                                   theirs = tags_by(options_.reference_tags, request, trees, result);
    try {
      if (const auto& known = ours ? ours : theirs) {
        result.blame = blame(oracle, native, *known, request.antialiased() ? 2 : 1);
        result.trees = known->trees;
      }
      result.suspicions = diagnose(oracle, native, theirs ? &*theirs : nullptr, ours ? &*ours : nullptr);
    } catch (const std::exception& error) {
      result.blame_failed = error.what();
    }
  }

  const Suite& suite_;
  const RunOptions& options_;
  Run run_;
  std::optional<Renders> renders_;
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
