// The comparison library's front door: which scenes, against what, and what came of it. The program (cli/) plugs its
// own renderer in as a function.
//
//   compare::Suite suite = compare::load_suite({"scenes"});
//   compare::RunOptions options;
//   options.native = my_renderer;                       // or compare::native_program("/usr/bin/verisim")
//   compare::Run run = compare::run_suite(suite, options);
//   compare::write_report(compare::html_report(run), "report.html");
//   return run.summary.failed() ? 1 : 0;
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/metrics/blame.h"
#include "compare/causes/diagnose.h"
#include "compare/photographs/fit.h"
#include "compare/layers/layers.h"
#include "compare/verdict/limits.h"
#include "compare/metrics/metrics.h"
#include "compare/verdict/truth.h"
#include "compare/verdict/verdict.h"
#include "compare/verdict/welch.h"

namespace verisim::compare {

// ---- what to compare
// ---------------------------------------------------------------------------------------------------------------------

// One of several renders of a scene whose weighted sum is the picture: a band of wavelengths, say.
struct Pass {
  std::vector<std::string> switches;              // beside those of the scene
  std::array<std::array<double, 3>, 3> matrix{};  // linear values of the render's channels to linear sRGB
};

// Pixels that are not compared.
struct Ignored {
  std::vector<Crop> rectangles;
  std::filesystem::path mask;        // a picture of the render's size: what is brighter than half of white is ignored
  std::vector<std::string> objects;  // parts of the names that `verisim explain` gives them
  bool any() const { return !rectangles.empty() || !mask.empty() || !objects.empty(); }
};

struct SceneRequest {
  std::string name;             // unique in a run, shown in reports: "lights/shadow.pov"
  std::filesystem::path scene;  // absolute
  int width = 160, height = 120;
  std::vector<std::string> switches;  // POV-Ray's, passed to both: "+A0.3", "Declare=x=1"; size, input, output, display
                                      // and threads are added by us
  bool antialiased() const;           // what the switches say (+A, Antialias=on)
  bool alpha() const;                 // +UA
  std::optional<SceneClass> scene_class;    // empty: by the features the native side reports
  Thresholds thresholds;                    // empty: the rules of docs/comparison.md
  std::string known_failure;                // why it is known to fail: reported, and no failure of the run
  Allowance allowed;                        // of errors that lie together
  std::optional<PixelLimits> pixel_limits;  // with thresholds, or without: in place of the rules
  Limits warnings;                          // what breaks these is said, and no failure
  Ignored ignored;
  std::vector<LayerRule> layers;  // limits of the layers of OpenEXR files
  std::vector<Pass> passes;  // empty: one render is the picture. Else they are rendered with linear values (OpenEXR)
                             // and summed to a picture of 16 bits
  std::vector<std::string> tags;
  std::optional<std::filesystem::path> reference;   // a stored picture in the place of the oracle
  std::vector<std::filesystem::path> alternatives;  // pictures as good as the reference (other platforms): the nearest
                                                    // one counts
  FitOptions fit;                                   // of a stored picture: a photograph
  const char* reference_name() const { return fit.any() ? "photograph" : "stored picture"; }
  std::vector<std::string> beside;  // who else is held against the photograph: "povray", "path", or a command
  std::optional<Truth> truth;       // values that mathematics gives
  double flip_pixels_per_degree = 67.0206;
};

struct Suite {
  std::vector<SceneRequest> scenes;
  std::vector<std::string> warnings;  // files of a folder that were passed over, ...
};

struct SuiteDefaults {
  int width = 160, height = 120;
  std::vector<std::string> switches = {"-A"};
};

// Scenes (.pov), manifests (verisim.toml) and folders, searched for verisim.toml or else for .pov files. Throws
// std::runtime_error with file, line and reason.
Suite load_suite(const std::vector<std::filesystem::path>& what, const SuiteDefaults& defaults = {});

struct Filter {
  std::vector<std::string> names;  // shell patterns or parts of the name; any of them
  std::vector<std::string> tags;   // any of them
  bool failed_last_time = false;   // with the JSON report of an earlier run
  std::filesystem::path last_report;
};
Suite filter(const Suite& suite, const Filter& filter);

// ---- our renderer
// ---------------------------------------------------------------------------------------------------------------------

struct NativeRequest {
  std::filesystem::path folder;  // a private working copy of the scene's folder; the scene may write here and only here
  std::filesystem::path scene;   // inside it, absolute
  std::filesystem::path output;  // write the picture here (PNG of 8 bits; EXR when its extension says so)
  int width = 160, height = 120;
  std::vector<std::string> switches;
  int threads = 0;  // 0: all
  bool replay = false;
  std::optional<std::uint64_t> seed;
  int run = 0;                                       // of several runs of one scene, whose random numbers shall differ
  double time_limit = 0;                             // seconds; 0: none
  std::vector<std::filesystem::path> library_paths;  // the oracle's, in its order; empty without an oracle
  std::atomic<bool>* cancel = nullptr;
};

struct NativeResult {
  enum class Outcome : std::uint8_t { rendered, unsupported, error };
  Outcome outcome = Outcome::error;
  std::string message;  // what is not supported or wrong, with its place
  std::string console;  // of a process that rendered: its standard error
  enum class Ending : std::uint8_t { by_itself, by_signal, out_of_time };
  Ending ending = Ending::by_itself;  // of a process; by_signal: it crashed
  double seconds = 0, cpu_seconds = 0;
  std::uint64_t peak_bytes = 0;
  std::map<std::string, std::uint64_t> rays;  // camera, reflected, refracted, shadow, ...
  std::vector<std::string>
      stochastic_features;  // "area_light jitter", "radiosity", ...: not empty makes the scene stochastic
  std::vector<std::filesystem::path> files_read;  // ParseResult::files_read, also when rendering was not possible
};
// Called from several threads at a time when RunOptions::jobs > 1.
using NativeRenderer = std::function<NativeResult(const NativeRequest&)>;

// Runs `program render ...` as a process of its own: a crash or a hang costs one scene, not the run. The program is
// called in the request's folder with `render SCENE +WN +HN [switches] +OOUTPUT [+WTN] [+LPATH...] [--replay] [--seed
// N] --allow-write FOLDER --stats FILE`, and FILE is JSON: {"rays":{...}, "stochastic_features":[...],
// "files_read":[...]} (all optional). Seconds are those of the whole process. Its exit status says the outcome: 0
// rendered, 4 unsupported, anything else an error; the line of stderr that has "error:" or "unsupported:" is the
// message, else the last one. From the second run on, the number of the run is the seed.
NativeRenderer native_program(const std::filesystem::path& program,
                              const std::vector<std::string>& extra_arguments = {});

// What the pixels of a scene show, and the ray trees of some of them: `step` as in PixelTags. Throws
// std::runtime_error.
using TagSource =
    std::function<PixelTags(const NativeRequest&, int step, const std::vector<std::pair<int, int>>& trees)>;
// From `program explain SCENE --tags FILE`.
TagSource tags_of_program(const std::filesystem::path& program);
std::string tags_json(const PixelTags& tags);
PixelTags tags_from_json(const std::string& text);  // throws std::runtime_error

// ---- the oracle
// ---------------------------------------------------------------------------------------------------------------------

struct OracleOptions {
  std::filesystem::path program;  // empty: `povray` in PATH
  std::filesystem::path cache;    // empty: $XDG_CACHE_HOME/verisim/oracle or ~/.cache/verisim/oracle
  bool use_cache = true;
  std::vector<std::filesystem::path> library_paths;  // empty: discovered (the system's povray.ini, known prefixes)
  int threads = 1;                                   // +WT of the first run; others of a stochastic scene take more
  double time_limit = 600;                           // seconds of wall time for one render
};

// The Debian package to install, as a message for users; thrown when there is no POV-Ray.
struct OracleMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct OracleProgram {
  std::filesystem::path path;
  std::string name = "POV-Ray";  // or "verisim": another build of ours
  std::string version;           // "3.7.0.10.unofficial"
  std::string version_text;      // all that `povray --version` says about the build
  std::vector<std::filesystem::path> library_paths;
};
// POV-Ray of any version, or a verisim, which is called alike. Throws OracleMissing.
OracleProgram find_oracle(const OracleOptions& options);

struct OracleRender {
  bool ok = false;
  std::string message;  // when not ok: what happened, and POV-Ray's own words
  Picture picture;
  double seconds = 0, cpu_seconds = 0;
  std::uint64_t peak_bytes = 0;
  bool from_cache = false;
};
// POV-Ray in the place of our renderer: another version of it, or itself, to measure how often the verdict is wrong.
// Run i is variant 2 i + 1, which no run of the reference is.
NativeRenderer povray_renderer(const OracleProgram& program, const OracleOptions& options);

// Never throws. files_read: what the native side read, as paths of the original files; empty: every file of the scene's
// folder counts. variant: 0 is the reference. Each other one takes a thread more than the one before (up to eight, then
// from the beginning), and another order of the blocks (+RP, +RS) and, without anti-aliasing, which it would
// change, another size (+BS), so that random numbers fall on other pixels; nothing else changes in the picture. Run i
// of several is variant 2 i.
OracleRender run_oracle(const OracleProgram& program, const OracleOptions& options, const SceneRequest& scene,
                        int variant, const std::vector<std::filesystem::path>& files_read,
                        std::atomic<bool>* cancel = nullptr);

// ---- a run
// ---------------------------------------------------------------------------------------------------------------------

// How far a renderer's picture, fitted by itself, is from a photograph.
struct Likeness {
  std::string renderer;
  double ciede2000_mean = 0, flip_mean = 0, rmse = 0;
  std::string failed = {};  // why there are no figures
};

struct SceneResult {
  SceneRequest request;
  SceneClass scene_class = SceneClass::deterministic;
  std::vector<std::string> stochastic_features;
  Status status = Status::error;
  std::string reason;  // why it is not exact: the figure that broke, the unsupported feature, the oracle's message
  std::optional<Metrics> metrics;
  std::vector<LayerResult> layers;                         // beside the picture, of OpenEXR files
  std::optional<LowPass> native_low_pass, noise_low_pass;  // of a stochastic scene
  std::optional<WelchResult> welch;                        // of a stochastic scene, with several runs
  std::vector<Suspicion> suspicions;                       // of a scene that differs: what kind of fault it looks like
  std::optional<Blame> blame;                              // and what its wrong pixels have in common
  std::vector<PixelTags::Tree> trees;                      // ray trees of the worst pixels
  std::string blame_failed;                                // why there is no blame
  std::optional<Fit> fit;                                  // of a photograph
  std::vector<Likeness> verisimilitude;                    // of all renderers that are held against it, ours first
  std::optional<TruthError> oracle_truth, native_truth;    // of a scene with a known answer
  double oracle_seconds = 0, native_seconds = 0, oracle_cpu_seconds = 0, native_cpu_seconds = 0;
  bool oracle_cached = false;
  std::map<std::string, std::uint64_t> rays;
  std::filesystem::path oracle_picture, native_picture;  // files of this run; empty when there is none
  std::filesystem::path judged_picture;                  // ours as it was compared, where that is not native_picture
  std::filesystem::path p_map;                           // a PNG file: -log10 of each pixel's p-value, 10 is white
  std::optional<Status> previous;                        // of the earlier run, for the trend
  std::optional<double> previous_rmse;
  struct Earlier {
    std::string started;
    Status status = Status::error;
    std::optional<double> rmse;
  };
  std::vector<Earlier> history;  // of all earlier runs, oldest first
  bool passed() const { return status == Status::exact || status == Status::match; }
  bool failed() const { return !passed() && request.known_failure.empty(); }
};

struct Summary {
  std::map<Status, int> count;
  int scenes = 0, known_failures = 0;
  double oracle_seconds = 0, native_seconds = 0;  // wall time
  double oracle_cpu_seconds = 0,
         native_cpu_seconds = 0;  // user and system time: about 0.6 s of POV-Ray's wall time is sleeping
  bool failed() const;            // any scene that is neither exact nor a match, nor known to fail
};

struct Run {
  std::vector<SceneResult> scenes;  // in the order of the suite
  Summary summary;
  std::string oracle_version, native_version, started;            // started: ISO 8601, UTC
  std::string reference_name = "POV-Ray", test_name = "verisim";  // what reports call the two sides
  bool cancelled = false;
  std::shared_ptr<const void> keep;  // owns the pictures' folder when it is a temporary one
};

struct Progress {
  int done = 0, total = 0, running = 0, failed = 0;
  double seconds_left = 0;                // estimate; negative while unknown
  const SceneResult* finished = nullptr;  // the scene that has just ended
};

struct RunOptions {
  NativeRenderer native;
  TagSource tags;             // empty: no blame
  TagSource reference_tags;   // of the reference's renderer, which knows what the judged one lost; empty: not known
  bool always_blame = false;  // also for scenes that do not differ
  OracleOptions oracle;
  int jobs = 1;            // scenes at a time
  int native_threads = 0;  // 0: the cores divided by jobs
  double native_time_limit = 0;
  bool replay = false;  // both serial: stochastic scenes are judged like any other
  int runs = 4;         // of a stochastic scene on each side, for Welch's test, which asks twice as many others before
                        // it refuses, and where one pair fails the low-pass comparison; 1: that comparison alone
  std::filesystem::path work;  // results and pictures, kept: a run that was broken off goes on here. Empty: a temporary
                               // folder, removed with the Run
  bool resume = false;
  bool whole_suite =
      false;  // nothing was left out of the suite: a stored picture without a scene is one that was removed
  std::filesystem::path baseline;                      // stored pictures in the place of the oracle
  std::map<std::string, NativeRenderer> beside;        // renderers of SceneRequest::beside by their names
  NativeRenderer reference;                            // any renderer in the place of the oracle; empty: none
  std::string reference_identity;                      // changes whenever that one does
  std::string reference_name;                          // what reports call it
  std::filesystem::path previous_report;               // JSON of an earlier run, for the trend
  std::vector<std::filesystem::path> earlier_reports;  // of all earlier runs, for the course of figures
  std::string native_version;
  std::string native_identity;     // changes whenever our renderer does (a hash of the program); a run is resumed only
                                   // with the same
  std::uint64_t memory_limit = 0;  // bytes that one comparison may take; 0: what the machine has available
  std::function<void(const Progress&)> progress;  // from one thread at a time
  std::atomic<bool>* cancel = nullptr;
};

// Never throws for what goes wrong in one scene. Throws OracleMissing when a scene needs POV-Ray and there is none,
// std::runtime_error when `work` cannot be written.
Run run_suite(const Suite& suite, const RunOptions& options);

// Regression without an oracle: run_suite with RunOptions::baseline compares with the pictures stored there (NAME.png,
// 16 bits, and baseline.json, which names the version that made them); then this stores the run's own pictures in their
// place. `dry_run` only says what would change: one line a scene. Notes, by the names of scenes, are kept with them.
std::vector<std::string> update_baseline(const Run& run, const std::filesystem::path& folder, bool dry_run,
                                         const std::map<std::string, std::string>& notes = {});

// ---- reports: files are written as by tracer/base/output_file.h; std::runtime_error names the file and the reason
// ---------------------------------------------------------

std::string terminal_table(const Run& run, bool color = false, int columns = 120);  // columns 0: names are never cut
std::string terminal_metrics(const Metrics& metrics, bool color = false);           // for `verisim diff`
std::string terminal_layers(const std::vector<LayerResult>& layers);                // a line each
std::string terminal_blame(
    const SceneResult& scene);  // for `verisim explain`: objects, and what bad pixels have in common
std::string metrics_json(const Metrics& metrics);
std::string json_report(const Run& run);
std::string markdown_report(const Run& run);
std::string github_annotations(const Run& run);
std::string junit_report(const Run& run);
std::string html_report(const Run& run);
// A pair of pictures that has been measured and judged, for `verisim diff`.
struct Pair {
  std::filesystem::path reference, test;
  Metrics metrics;
  Verdict verdict;
  std::vector<LayerResult> layers = {};  // whose verdict is part of `verdict`
  std::optional<FittedPair> fitted;      // what was measured, when it is not the files as they are
};
// As a run of one scene. Of more than 16 million pixels no suspects are looked for, and the report shows them reduced.
// Throws std::runtime_error when a picture cannot be read.
Run run_of_pair(const Pair& pair);
Run run_of_pair(const std::filesystem::path& reference, const std::filesystem::path& test,
                const MetricOptions& options = {});  // measures them. Throws PictureMismatch, too
std::string pair_json(const Run& run_of_pair);       // the figures, status, reason, suspects and fit
void write_report(const std::string& text, const std::filesystem::path& path);
// 8-bit PNG: absolute differences times `gain` as a heat map.
void write_heat_map(const Picture& reference, const Picture& test, const std::filesystem::path& path, double gain = 16);
void write_heat_map(const std::filesystem::path& reference, const std::filesystem::path& test,
                    const std::filesystem::path& path, double gain = 16);  // row by row

// ---- bench: both programs as whole processes, in turn
// ----------------------------------------------------------------------------------------------------------------

struct BenchSample {
  double wall = 0, cpu = 0;  // seconds; cpu: user + system
  std::uint64_t peak_bytes = 0;
};
struct BenchScene {
  std::string name;
  std::vector<BenchSample> oracle, native;  // in the order they ran
  BenchSample oracle_median, native_median;
  double wall_ratio = 0, cpu_ratio = 0, memory_ratio = 0;  // oracle / native; above 1: verisim is better
  std::string error;                                       // one of the two failed; no ratios then
};
struct Bench {
  std::vector<BenchScene> scenes;
  double wall_ratio = 0, cpu_ratio = 0, memory_ratio = 0;  // geometric means
  std::string oracle_version;
};
struct BenchOptions {
  OracleOptions oracle;
  std::filesystem::path native_program;  // the verisim executable
  int runs = 3, threads = 2;
  double time_limit = 600;
  std::function<void(const std::string& scene, int run)> progress;
};
Bench run_bench(const Suite& suite, const BenchOptions& options);
std::string bench_table(const Bench& bench, bool color = false);
std::string bench_json(const Bench& bench);

}  // namespace verisim::compare
