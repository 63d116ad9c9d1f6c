// What counts as the same picture (docs/comparison.md).
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "compare/metrics/blame.h"
#include "compare/metrics/metrics.h"

namespace verisim::compare {

enum class SceneClass : std::uint8_t { deterministic, stochastic };
// added, removed: a scene without a stored picture, and a stored picture without a scene.
enum class Status : std::uint8_t { exact, match, differ, unsupported, error, oracle_failed, added, removed };
inline constexpr Status kStatuses[] = {Status::exact, Status::match,         Status::differ, Status::unsupported,
                                       Status::error, Status::oracle_failed, Status::added,  Status::removed};
const char* to_string(SceneClass scene_class);
const char* to_string(Status status);
std::optional<Status> status_from_string(const std::string& text);

// Two pictures after a Gaussian blur of 2 pixels, in 8-bit units: what is left when the noise has been averaged.
struct LowPass {
  double mad = 0, bias = 0,
         rmse = 0;  // mean absolute difference, |mean difference| (worst channel), root mean square difference
};
LowPass low_pass(const Picture& a, const Picture& b, double sigma = 2);
// The mean of renders of one scene, all of one size. Throws PictureMismatch.
Picture mean_of(std::span<const Picture> renders);

// Limits of a stochastic scene, from the oracle's difference to itself.
struct NoiseLimits {
  double mad = 0, bias = 0, rmse = 0;
};
NoiseLimits noise_limits(const LowPass& oracle_against_itself);

// Thresholds of one scene beyond (in place of) the rules: metric name as in the JSON report -> limit. `max_` and `min_`
// say which side is bad: {"max_rmse", 1.5}.
using Thresholds = std::map<std::string, double>;

// Errors that lie together (patches.h), and how much of them one scene may have.
struct Allowance {
  double solid_pixels = 2;             // in solid patches: two of POV-Ray's wrong pixels may meet by chance
  std::optional<double> drift_max;     // code values; empty: by how finely the pictures tell differences
  double one_sided_pixels = 8;         // connected pixels that go to one side, of pictures of more than 8 bits
  std::optional<double> leaning = {};  // part of the pixels of the picture, or of an object, that go to one side
};

struct Verdict {
  Status status = Status::differ;
  std::string reason;  // which figure broke which limit; empty when none did
};
Verdict judge_deterministic(const Metrics& metrics, bool antialiased, const Allowance& allowed = {});
// Against an earlier picture of verisim's own, which another machine may change by 1/255 here and there, but not by
// even a little everywhere.
Verdict judge_baseline(const Metrics& metrics, bool antialiased, const Allowance& allowed = {});
// Of a picture that passes: an object whose pixels go to one side. Empty: there is none.
std::optional<Verdict> judge_objects(const Picture& reference, const Picture& test, const PixelTags& tags,
                                     const Allowance& allowed = {});
// Whether so many pixels differ at all that judge_objects could find something.
bool worth_asking_objects(const Metrics& metrics);
// What the rules let pass as exact but is on average to one side: "0.31 code values darker on average"; empty when
// there is nothing to say.
std::string systematic_drift(const Metrics& metrics);
Verdict judge_stochastic(const Metrics& metrics, bool antialiased, const LowPass& native, const LowPass& noise,
                         const Allowance& allowed = {});
// A scene with thresholds of its own is `match` when it keeps them all. Throws std::invalid_argument naming an unknown
// threshold.
Verdict judge_thresholds(const Metrics& metrics, const Thresholds& thresholds);

}  // namespace verisim::compare
