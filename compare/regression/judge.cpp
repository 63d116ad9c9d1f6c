#include "compare/regression/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/regression/ignored.h"
#include "compare/regression/passes.h"
#include "compare/regression/result_store.h"
#include "compare/regression/stored_variance.h"
#include "compare/regression/verisimilitude.h"
#include "compare/report/display.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

Verdict judge_limits(const SceneRequest& request, const Picture& oracle, const Picture& native,
                     const Metrics& metrics) {
  const std::string broken = broken_limit({request.thresholds, request.pixel_limits}, metrics, oracle, native);
  if (!broken.empty()) return {Status::differ, broken};
  const bool exact = judge_deterministic(metrics, false).status == Status::exact;
  return {exact ? Status::exact : Status::match, ""};
}

// Of pictures that are all as good, the one that is nearest.
Picture nearest(const Picture& first, const std::vector<fs::path>& others, const Picture& native) {
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

// A known answer has the last word: who keeps it is right, whatever the other one says.
Verdict judge_truth(const Truth& truth, const Picture& oracle, const Picture& native, const Verdict& verdict,
                    SceneResult& result) {
  result.oracle_truth = truth_error(oracle, truth), result.native_truth = truth_error(native, truth);
  const TruthError& error = *result.native_truth;
  if (error.max > truth.tolerance)
    return {Status::differ,
            fmt::format("the known answer is missed by {:.5f} > {} at pixel {}, {} (the reference misses it by {:.5f})",
                        error.max, truth.tolerance, error.worst_x, error.worst_y, result.oracle_truth->max)};
  if (verdict.status == Status::differ && result.oracle_truth->max > truth.tolerance)
    return {Status::match, fmt::format("keeps the known answer, which the reference misses by {:.5f} ({})",
                                       result.oracle_truth->max, verdict.reason)};
  return verdict;
}

}  // namespace

void Judge::keep_picture(const Picture& picture, const std::string& stem, const char* side, fs::path& kept) const {
  kept = keep_exactly(picture, renders_.work() / fmt::format("{}.{}", stem, side));
}

void Judge::judge(const SceneRequest& request, const std::string& stem, const Picture& reference,
                  const std::vector<fs::path>& files_read, SceneResult& result) const {
  const fs::path rendered = result.native_picture;
  Picture native = image::read_picture(rendered), fitted;
  const Picture* oracle = &reference;
  if (request.reference && request.fit.any()) {
    FittedPair pair = fit_to_reference(reference, native, request.fit);
    native = std::move(pair.test), fitted = std::move(pair.reference), oracle = &fitted;
    result.fit = pair.fit;
    keep_picture(native, stem, "fitted", result.native_picture);
  }
  if (const std::vector<fs::path> others = renders_.alternatives(request); !others.empty()) {
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
    result.verisimilitude = likenesses(request, reference, *result.metrics, options_, renders_);
  const bool rules = request.thresholds.empty() && !request.pixel_limits;
  Verdict verdict = !rules ? judge_limits(request, *oracle, native, *result.metrics)
                    : options_.baseline.empty() || request.reference
                        ? judge_deterministic(*result.metrics, request.antialiased(), request.allowed)
                        : judge_baseline(*result.metrics, request.antialiased(), request.allowed);
  if (result.scene_class == SceneClass::stochastic && rules && verdict.status != Status::exact) {
    if (!request.reference && !options_.baseline.empty()) {
      if (!stored_noise(request, stem, native, result, verdict)) return;
    } else if (request.reference) {
      verdict.reason += "; a stored picture says nothing about noise";
    } else if (!judge_noise(request, stem, *oracle, native, files_read, result, verdict)) {
      return;
    }
  }
  if (rules && result.scene_class == SceneClass::deterministic)
    verdict = verdict.status == Status::differ ? judge_again(request, *oracle, native, files_read, verdict, result)
                                               : judge_leaning(request, *oracle, native, verdict, result);
  if (const fs::path file = renders_.reference_file(request); !file.empty() && !request.fit.any()) {
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

void Judge::leave_out(const SceneRequest& request, Picture& oracle, Picture& native) const {
  std::optional<PixelTags> tags;
  if (!request.ignored.objects.empty() && options_.tags) {
    const WorkingCopy copy(request.scene);
    tags = options_.tags(renders_.native_request(request, copy), 1, {});
  }
  ignore_pixels(request.ignored, tags ? &*tags : nullptr, oracle, native);
}

bool Judge::stored_noise(const SceneRequest& request, const std::string& stem, const Picture& native,
                         SceneResult& result, Verdict& verdict) const {
  if (const auto stored = read_stored_variance(renders_.stored_picture(request))) {
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

Verdict Judge::judge_leaning(const SceneRequest& request, const Picture& oracle, const Picture& native,
                             const Verdict& verdict, SceneResult& result) const {
  const TagSource& source = options_.tags ? options_.tags : options_.reference_tags;
  if (!worth_asking_objects(*result.metrics)) return verdict;
  const std::optional<PixelTags> tags = tags_by(source, request, {}, result);
  if (!tags) return verdict;
  return judge_objects(oracle, native, *tags, request.allowed).value_or(verdict);
}

Verdict Judge::judge_again(const SceneRequest& request, const Picture& oracle, const Picture& native,
                           const std::vector<fs::path>& files_read, const Verdict& verdict, SceneResult& result) const {
  if (!options_.baseline.empty() || request.reference || request.ignored.any() || options_.replay) return verdict;
  constexpr int kOtherOrder = 2;
  const OracleRender again = renders_.reference(request, files_read, kOtherOrder);
  result.oracle_seconds += again.seconds, result.oracle_cpu_seconds += again.cpu_seconds;
  if (!again.ok) return verdict;
  const MetricOptions how = metric_options(request);
  const Metrics itself = measure(oracle, again.picture, how);
  if (itself.max_abs <= 1) return verdict;
  const std::string unsteady = fmt::format(
      "the reference differs from itself in another run, at {:.3f} % of its pixels", 100 - itself.within_1_pct);
  const Verdict other =
      judge_deterministic(measure(again.picture, native, how), request.antialiased(), request.allowed);
  if (other.status != Status::differ) return {Status::match, unsteady + ", where this picture is the same"};
  return {Status::differ, verdict.reason + "; " + unsteady};
}

bool Judge::judge_noise(const SceneRequest& request, const std::string& stem, const Picture& oracle,
                        const Picture& native, const std::vector<fs::path>& files_read, SceneResult& result,
                        Verdict& verdict) const {
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

void Judge::write_p_map(const std::vector<float>& p, const Picture& shape, const std::string& stem,
                        SceneResult& result) const {
  constexpr float kWhite = 10;  // -log10
  Picture map;
  map.width = shape.width, map.height = shape.height, map.channels = 1;
  for (const float value : p) map.samples.push_back(std::min(1.0f, -std::log10(std::max(value, 1e-30f)) / kWhite));
  const fs::path path = renders_.work() / (stem + ".p.png");
  image::write_picture(map, path);
  result.p_map = path;
}

bool Judge::more_references(const SceneRequest& request, const std::vector<fs::path>& files_read, int runs,
                            std::vector<Picture>& references, SceneResult& result) const {
  while (static_cast<int>(references.size()) < runs) {
    OracleRender again = renders_.reference(request, files_read, 2 * static_cast<int>(references.size()));
    result.oracle_seconds += again.seconds, result.oracle_cpu_seconds += again.cpu_seconds;
    if (!again.ok) {
      result.status = Status::oracle_failed, result.reason = "another run for the noise: " + again.message;
      return false;
    }
    references.push_back(std::move(again.picture));
  }
  return true;
}

bool Judge::more_tests(const SceneRequest& request, const std::string& stem, int runs, std::vector<Picture>& tests,
                       SceneResult& result, Verdict& verdict) const {
  while (static_cast<int>(tests.size()) < runs) {
    const int run = static_cast<int>(tests.size());
    std::vector<fs::path> ignored;
    const fs::path output = renders_.native_output(request, stem, run);
    const NativeResult again = renders_.native(request, output, run, ignored);
    if (again.outcome != NativeResult::Outcome::rendered) {
      verdict = {Status::error, fmt::format("run {}: {}", run + 1, again.message)};
      return false;
    }
    result.native_seconds += again.seconds, result.native_cpu_seconds += again.cpu_seconds;
    tests.push_back(image::read_picture(output));
  }
  return true;
}

std::optional<PixelTags> Judge::tags_by(const TagSource& source, const SceneRequest& request,
                                        const std::vector<std::pair<int, int>>& trees, SceneResult& result) const {
  constexpr double kMaxPixels = 300000;
  if (!source || request.scene.extension() != ".pov") return std::nullopt;  // another renderer's scenes
  try {
    const WorkingCopy copy(request.scene);
    const double pixels = static_cast<double>(request.width) * request.height;
    PixelTags tags = source(
        renders_.native_request(request.passes.empty() ? request : request_of_pass(request, request.passes[0]), copy),
        std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMaxPixels)))), trees);
    const std::vector<fs::path> library = renders_.library_paths();
    for (PixelTags::Tag& tag : tags.tags) tag.name = short_names(std::move(tag.name), copy, library);
    for (PixelTags::Tree& tree : tags.trees) tree.text = short_names(std::move(tree.text), copy, library);
    return tags;
  } catch (const std::exception& error) {
    result.blame_failed = error.what();
    return std::nullopt;
  }
}

void Judge::find_causes(const SceneRequest& request, const Picture& oracle, const Picture& native,
                        SceneResult& result) const {
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

}  // namespace verisim::compare
