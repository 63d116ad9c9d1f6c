#include "tracer/global/radiosity.h"

#include <algorithm>
#include <cmath>

#include "tracer/global/gather_lattice.h"

namespace verisim::global {
namespace {

double radical_inverse(unsigned index, unsigned base) {
  double result = 0.0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) result += digit * (index % base);
  return result;
}

// A pool entry (y up) in the frame of `n` (spec 07 2.7): within 2.56 degrees of the poles the axis is exactly +-y.
Vec3 to_world(const Vec3& d, const Vec3& n) {
  if (n.y > 0.999) return d;
  if (n.y < -0.999) return -d;
  const Vec3 a = std::fabs(n.z) > 0.9 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const Vec3 x = normalize(cross(n, a)), z = normalize(cross(x, n));
  return d.x * x + d.y * n + d.z * z;
}

}  // namespace

RadiositySettings::RadiositySettings(const scene::Radiosity& description, const Vec3& camera_location)
    : description_(&description), camera_location_(camera_location) {
  const int count = std::max(5, description.count);
  const int size = std::max({count, description.count_directions, 1});
  pool_.reserve(size);
  for (int k = 1; k <= size; ++k) {
    const double u = radical_inverse(k, 2), phi = 2.0 * 3.14159265358979323846 * radical_inverse(k, 3), r = std::sqrt(u);
    pool_.emplace_back(r * std::cos(phi), std::sqrt(1.0 - u), r * std::sin(phi));
  }
  for (int d = 0; d < kMaxRadiosityDepth; ++d) {
    rays_[d] = std::min(size, std::max(5, static_cast<int>(std::floor(std::ldexp(static_cast<double>(description.count), -d)))));
  }
}

IrradianceCache RadiositySettings::empty_cache() const {
  // Queries of little weight are content with a quarter more (spec 07 2.5).
  const double widest = description_->error_bound * std::max(1.0, static_cast<double>(description_->low_error_factor)) + 0.25;
  return IrradianceCache(description_->error_bound, widest);
}

double RadiositySettings::required_weight(int depth) const {
  if (depth == 0) return description_->nearest_count;
  return depth == 1 ? std::min(2, description_->nearest_count) : 1;
}

float RadiositySettings::gather_weight(int depth) const {
  return static_cast<float>(std::max(description_->adc_bailout + kEpsilon, std::pow(0.5 * description_->brightness, depth + 1)));
}

RadiosityTask::RadiosityTask(const RadiositySettings& settings, const IrradianceCache* base, IrradianceCache* own, bool pretrace, int pass, int tile)
    : settings_(settings), base_(base), own_(own), pretrace_(pretrace), pass_(pass), tile_(tile) {}

void RadiosityTask::accumulate(const IrradianceCache& cache, const RadiosityQuery& query, const Vec3& normal, double bound,
                               Estimate& estimate) const {
  const bool smooth = !pretrace_ && query.depth == 0;
  // 2 sqrt |1 - N.Ni| alone must stay below the bound; with a margin, so that the exact test below decides.
  const double widest_turn = 0.25 * bound * bound * (1.0 + 1e-9);
  cache.visit(query.depth, query.point, bound, normal, widest_turn, [&](const IrradianceSample& s, double squared) {
    const double turn = std::fabs(1.0 - dot(normal, s.normal));
    if (turn > widest_turn) return;
    const Vec3 delta = query.point - s.point;
    const double r = std::sqrt(squared);
    double radius = s.mean_distance, facing = 1.0;
    if (r > 1e-6) {
      const Vec3 u = delta / r;
      const double c = dot(u, s.nearest_direction);
      if (c > 0.0) radius = c * s.nearest_distance + (1.0 - c) * s.mean_distance;
      if (r >= radius * bound) return;
      facing = dot(u, normalize(normal + s.normal));
    }
    const double error = r / radius + 2.0 * std::sqrt(turn);
    if (!(error < bound)) return;
    if (facing <= -0.05) return;
    const double t = error / bound;
    double weight = 1.0 - t;
    if (smooth) weight = t < 0.5 ? 1.0 - 2.0 * t * t : 2.0 * (1.0 - t) * (1.0 - t);
    if (facing <= 0.0) weight *= 1.0 + 20.0 * facing;
    if (!(weight > 0.001)) return;
    weight *= s.quality;
    estimate.sum += s.irradiance * static_cast<float>(weight);
    estimate.weight += weight;
  });
}

Rgb RadiosityTask::irradiance(const RadiosityQuery& query, Gatherer& gatherer, float& quality) {
  const scene::Radiosity& d = settings_.description();
  const Vec3& normal = d.normal ? query.layer_normal : query.geometric_normal;
  const double bound =
      (d.error_bound * (pretrace_ ? d.low_error_factor : 1.0) + std::max(0.0, 0.25 - query.contribution)) * std::ldexp(1.0, query.depth);
  Estimate estimate;
  if (base_) accumulate(*base_, query, normal, bound, estimate);
  if (own_ && own_ != base_) accumulate(*own_, query, normal, bound, estimate);
  const double required = settings_.required_weight(query.depth);
  if (query.depth == 0) ++primary_queries_.count, primary_queries_.weight += 4.0 * estimate.weight;

  Rgb result;
  const bool enough = 4.0 * estimate.weight >= required || (!pretrace_ && !d.always_sample && estimate.weight > 0.0);
  if (enough) {
    result = estimate.sum * static_cast<float>(1.0 / estimate.weight);
  } else {
    float sample_quality = 1.0f;
    const Rgb sample = take_sample(query, gatherer, sample_quality);
    const double total = estimate.weight + sample_quality;
    result = estimate.weight > 0.0 && total > 0.0 ? (estimate.sum + sample * sample_quality) * static_cast<float>(1.0 / total) : sample;
    estimate.weight = total;
    quality = std::max(quality, sample_quality);
  }
  quality = std::min(quality, static_cast<float>(4.0 * estimate.weight / required));
  const auto g = static_cast<float>(d.gray_threshold);
  if (g > 0.0f) result = result * (1.0f - g) + Rgb(result.grey() * g);
  return result * static_cast<float>(d.brightness);
}

Rgb RadiosityTask::take_sample(const RadiosityQuery& query, Gatherer& gatherer, float& quality) {
  const scene::Radiosity& d = settings_.description();
  const bool on_lattice = next_lattice_ && GatherLattice::worthwhile(settings_.rays(query.depth));
  const int n = on_lattice ? GatherLattice::enough(settings_.rays(query.depth)) : settings_.rays(query.depth);
  const std::size_t pool = settings_.pool_size();
  std::size_t& cursor = cursor_[query.depth];
  std::optional<GatherLattice> lattice;
  if (on_lattice) lattice.emplace(n, (*next_lattice_)++);
  const auto draw = [&]() -> Vec3 {
    if (lattice) return lattice->next();
    const Vec3& direction = settings_.direction(cursor);
    cursor = cursor + 1 == pool ? 0 : cursor + 1;
    return direction;
  };

  const bool perturbed = d.normal && dot(query.layer_normal, query.geometric_normal) < 1.0 - 1e-12;
  const std::size_t most_tries = std::min<std::size_t>(5 * static_cast<std::size_t>(n), pool);
  std::size_t tries = 0;
  int about_layer = 0;

  Rgb sum;
  float quality_sum = 0, nearest = 2e10f;
  Vec3 nearest_direction(0, 0, 0);
  double inverse_sum = 0;
  for (int i = 0; i < n; ++i) {
    Vec3 direction;
    bool found = false;
    while (perturbed && tries < most_tries && !found) {
      ++tries;
      direction = to_world(draw(), query.layer_normal);
      found = dot(direction, query.geometric_normal) > 0.0;
    }
    if (found) {
      ++about_layer;
    } else {
      direction = to_world(draw(), query.geometric_normal);
    }
    const float threshold = static_cast<float>(i) / static_cast<float>(n - 1);
    latest_importance_ = -1;
    const GatherResult g = gatherer.gather({query.point, direction}, query.depth, threshold);
    if (latest_importance_ < 0) latest_importance_ = g.importance;
    if (g.shaded && latest_importance_ >= threshold) {
      float q = g.quality;
      if (latest_importance_ < 1.0f) q *= static_cast<float>(n) / (std::floor(latest_importance_ * static_cast<float>(n - 1)) + 1.0f);
      Rgb color = g.color;
      if (d.max_sample > 0.0 && color.max() > d.max_sample) color *= static_cast<float>(d.max_sample / color.max());
      sum += color * q;
      quality_sum += q;
    }
    inverse_sum += 1.0 / g.distance;  // a miss is infinitely far
    if (g.distance < nearest) nearest = static_cast<float>(g.distance), nearest_direction = direction;
  }
  const Rgb irradiance = quality_sum > 0.0f ? sum * (1.0f / quality_sum) : sum;
  quality = quality_sum / static_cast<float>(n);

  const Vec3 from_camera = query.point - settings_.camera_location();
  const double distance = length(from_camera), scale = std::ldexp(1.0, query.depth);
  if (own_ && nearest > 1e-4 * distance * d.maximum_reuse * scale) {
    double mean = inverse_sum > 0.0 ? n / inverse_sum : std::numeric_limits<double>::infinity();
    mean = std::min(std::max(mean, distance * d.minimum_reuse * scale), distance * d.maximum_reuse * scale);
    IrradianceSample sample;
    sample.point = query.point;
    sample.normal = 2 * about_layer > n ? query.layer_normal : query.geometric_normal;
    sample.nearest_direction = nearest_direction;
    sample.irradiance = irradiance;
    sample.mean_distance = static_cast<float>(mean);
    sample.nearest_distance = nearest;
    sample.quality = quality;
    sample.depth = static_cast<std::int16_t>(query.depth);
    sample.pass = static_cast<std::int16_t>(pass_);
    sample.tile = tile_;
    own_->add(sample);
  }
  return irradiance;
}

}  // namespace verisim::global
