#include "compare/verdict/verdict.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "compare/metrics/systematic.h"

namespace verisim::compare {
namespace {

constexpr double kExactPct = 99.99, kMatchPct = 99.5, kMatchRmse = 2, kBaselineMae = 0.02, kDrift = 0.1;
// Largest mean difference of 16x16 pixels: of whole code values, and of finer ones.
constexpr double kCoarseDrift = 0.25, kFineDrift = 0.04;
// Part of the pixels that may go to one side, of whole code values and of finer ones.
constexpr double kCoarseLeaning = 0.25, kFineLeaning = 0.5;
constexpr std::pair<Status, const char*> kStatusNames[] = {
    {Status::exact, "exact"},   {Status::match, "match"},
    {Status::differ, "differ"}, {Status::unsupported, "unsupported"},
    {Status::error, "error"},   {Status::oracle_failed, "oracle_failed"},
    {Status::added, "new"},     {Status::removed, "removed"}};

std::optional<Verdict> not_finite(const Metrics& m) {
  if (m.nan_pixels == 0) return std::nullopt;
  return Verdict{Status::differ, fmt::format("{} pixels are NaN or infinite", m.nan_pixels)};
}

std::optional<double> figure(const Metrics& m, const std::string& name) {
  if (name == "max_abs") return m.max_abs;
  if (name == "mae") return m.mae;
  if (name == "rmse") return m.rmse;
  if (name == "psnr") return m.psnr;
  if (name == "within_1_pct") return m.within_1_pct;
  if (name == "within_2_pct") return m.within_2_pct;
  if (name == "bias") return std::fabs(m.bias);
  if (name == "ssim_mean") return m.ssim_mean;
  if (name == "ssim_block_min") return m.ssim_block_min;
  if (name == "flip_mean") return m.flip_mean;
  if (name == "hdr_flip_mean") return m.hdr_flip_mean.value_or(0);
  if (name == "ciede2000_mean") return m.ciede2000_mean;
  if (name == "ciede2000_p95") return m.ciede2000_p95;
  if (name == "edge_rmse") return m.edge_rmse.value_or(0);
  if (name == "interior_rmse") return m.interior_rmse.value_or(0);
  if (name == "alpha_max_abs") return m.alpha_max_abs.value_or(0);
  if (name == "alpha_rmse") return m.alpha_rmse.value_or(0);
  if (name == "solid_2_pixels") return static_cast<double>(m.solid_2_pixels);
  if (name == "solid_4_pixels") return static_cast<double>(m.solid_4_pixels);
  if (name == "drift_max") return m.drift_max;
  if (name == "one_sided_pixels") return static_cast<double>(m.one_sided_pixels);
  if (name == "leaning") return m.signs.share();
  return std::nullopt;
}

double leaning_limit(const Allowance& allowed, bool fine) {
  return allowed.leaning.value_or(fine ? kFineLeaning : kCoarseLeaning);
}
const char* side(const SignTest& signs) { return signs.brighter > signs.darker ? "brighter" : "darker"; }

std::optional<Verdict> together(const Metrics& m, bool antialiased, const Allowance& allowed) {
  const auto solid = static_cast<double>(antialiased ? m.solid_4_pixels : m.solid_2_pixels);
  if (solid > allowed.solid_pixels)
    return Verdict{Status::differ, fmt::format("wrong pixels lie together around {}, {}: solid_{}_pixels {} > {}",
                                               m.solid_x, m.solid_y, antialiased ? 4 : 2, solid, allowed.solid_pixels)};
  const double drift = allowed.drift_max.value_or(m.fine ? kFineDrift : kCoarseDrift);
  if (m.drift_max > drift)
    return Verdict{Status::differ,
                   fmt::format("a small difference to one side everywhere around {}, {}: drift_max {:.3f} > {}",
                               m.drift_x, m.drift_y, m.drift_max, drift)};
  if (allowed.drift_max) return std::nullopt;  // how much may go to one side is said
  if (m.fine && static_cast<double>(m.one_sided_pixels) > allowed.one_sided_pixels)
    return Verdict{Status::differ,
                   fmt::format("connected pixels all go to one side around {}, {}: one_sided_pixels {} > {}",
                               m.one_sided_x, m.one_sided_y, m.one_sided_pixels, allowed.one_sided_pixels)};
  if (const double limit = leaning_limit(allowed, m.fine); m.signs.leans(limit))
    return Verdict{Status::differ,
                   fmt::format("{} everywhere: leaning {:.3f} > {}", side(m.signs), m.signs.share(), limit)};
  return std::nullopt;
}

}  // namespace

const char* to_string(SceneClass scene_class) {
  return scene_class == SceneClass::deterministic ? "deterministic" : "stochastic";
}

const char* to_string(Status status) {
  for (const auto& [value, name] : kStatusNames)
    if (value == status) return name;
  return "error";
}

std::optional<Status> status_from_string(const std::string& text) {
  for (const auto& [value, name] : kStatusNames)
    if (text == name) return value;
  return std::nullopt;
}

Verdict judge_deterministic(const Metrics& m, bool antialiased, const Allowance& allowed) {
  if (auto bad = not_finite(m)) return *bad;
  const int step = antialiased ? 2 : 1;
  const double within = antialiased ? m.within_2_pct : m.within_1_pct;
  if (within >= kMatchPct)
    if (auto bad = together(m, antialiased, allowed)) return *bad;
  if (within >= kExactPct) return {Status::exact, ""};
  if (within < kMatchPct) return {Status::differ, fmt::format("within_{}_pct {:.3f} < {}", step, within, kMatchPct)};
  if (m.rmse > kMatchRmse) return {Status::differ, fmt::format("rmse {:.3f} > {}", m.rmse, kMatchRmse)};
  return {Status::match, fmt::format("within_{}_pct {:.3f} < {}", step, within, kExactPct)};
}

Verdict judge_baseline(const Metrics& m, bool antialiased, const Allowance& allowed) {
  const Verdict plain = judge_deterministic(m, antialiased, allowed);
  if (plain.status == Status::differ) return plain;
  if (m.mae > kBaselineMae) return {Status::differ, fmt::format("mae {:.4f} > {}", m.mae, kBaselineMae)};
  return plain;
}

bool worth_asking_objects(const Metrics& m) {
  constexpr std::uint64_t kFew = 20;
  return m.signs.brighter + m.signs.darker > kFew;
}

std::optional<Verdict> judge_objects(const Picture& reference, const Picture& test, const PixelTags& tags,
                                     const Allowance& allowed) {
  if (allowed.drift_max) return std::nullopt;
  const auto fine = [](const Picture& p) { return p.is_float || p.bits > 8; };
  const double limit = leaning_limit(allowed, fine(reference) && fine(test));
  const std::optional<LeaningObject> object = leaning_object(reference, test, tags, limit);
  if (!object) return std::nullopt;
  return Verdict{Status::differ, fmt::format("{}: {} of {} pixels {}: leaning {:.3f} > {}", object->name,
                                             std::max(object->signs.brighter, object->signs.darker),
                                             object->signs.pixels, side(object->signs), object->signs.share(), limit)};
}

std::string systematic_drift(const Metrics& m) {
  // Rounding to whole code values leaves means near 0 when the pictures are the same.
  if (m.nan_pixels || std::fabs(m.bias) < kDrift) return "";
  return fmt::format("{:.2f} code values {} on average", std::fabs(m.bias), m.bias < 0 ? "darker" : "brighter");
}

NoiseLimits noise_limits(const LowPass& noise) {
  return {1.6 * noise.mad + 0.5, 1.5 * noise.bias + 1, 1.5 * noise.rmse + 1};
}

Verdict judge_stochastic(const Metrics& m, bool antialiased, const LowPass& native, const LowPass& noise,
                         const Allowance& allowed) {
  if (auto bad = not_finite(m)) return *bad;
  if (const Verdict plain = judge_deterministic(m, antialiased, allowed); plain.status == Status::exact) return plain;
  const NoiseLimits limit = noise_limits(noise);
  if (native.mad > limit.mad)
    return {Status::differ, fmt::format("blurred mad {:.3f} > {:.3f}", native.mad, limit.mad)};
  if (native.bias > limit.bias)
    return {Status::differ, fmt::format("blurred bias {:.3f} > {:.3f}", native.bias, limit.bias)};
  if (native.rmse > limit.rmse)
    return {Status::differ, fmt::format("blurred rmse {:.3f} > {:.3f}", native.rmse, limit.rmse)};
  return {Status::match, "within the oracle's own noise"};
}

Verdict judge_thresholds(const Metrics& m, const Thresholds& thresholds) {
  for (const auto& [key, limit] : thresholds) {
    const bool upper = key.starts_with("max_"), lower = key.starts_with("min_");
    const auto value = upper || lower ? figure(m, key.substr(4)) : std::nullopt;
    if (!value)
      throw std::invalid_argument(fmt::format(
          "unknown threshold '{}': it is max_ or min_ and the name of a metric, like max_rmse or min_within_1_pct",
          key));
  }
  if (auto bad = not_finite(m)) return *bad;
  for (const auto& [key, limit] : thresholds) {
    const std::string name = key.substr(4);
    const double value = *figure(m, name);
    if (key.starts_with("max_") ? !(value <= limit) : !(value >= limit))
      return {Status::differ, fmt::format("{} {:.4f} {} {}", name, value, key.starts_with("max_") ? ">" : "<", limit)};
  }
  const Verdict plain = judge_deterministic(m, false);
  return {plain.status == Status::exact ? Status::exact : Status::match, ""};
}

}  // namespace verisim::compare
