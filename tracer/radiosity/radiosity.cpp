#include "tracer/radiosity/radiosity.h"

#include <algorithm>
#include <cmath>

#include "tracer/math/constants.h"
#include "tracer/math/scaled.h"

namespace verisim::global {
namespace {

double radical_inverse(unsigned index, unsigned base) {
  double result = 0.0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) result += digit * (index % base);
  return result;
}

// Takes entries of the pool (y up) to the frame of a normal (spec 07 2.7): within 2.56 degrees of the poles the axis is
// exactly +-y.
class NormalFrame {
 public:
  explicit NormalFrame(const Vec3& n) : y_(n), pole_(n.y > 0.999 ? 1 : n.y < -0.999 ? -1 : 0) {
    if (pole_ != 0) return;
    x_ = cross(n, std::fabs(n.z) > 0.9 ? Vec3(0, 1, 0) : Vec3(0, 0, 1)), x_ = x_ / length(x_);
    z_ = cross(x_, n), z_ = z_ / length(z_);
  }
  Vec3 operator()(const Vec3& d) const {
    if (pole_ != 0) return pole_ > 0 ? d : -d;
    return d.x * x_ + d.y * y_ + d.z * z_;
  }

 private:
  Vec3 x_, y_, z_;
  int pole_;
};

// c with a share of its grey, times the brightness (spec 07 2.5), rounded as there: blue twice more than the others.
Rgb adjusted(const Rgb& c, double share, double brightness) {
  const double grey = static_cast<float>(0.297 * c.r + 0.589 * c.g + 0.114 * c.b) * share, left = 1.0 - share;
  const auto blue = static_cast<float>(static_cast<float>(c.b * left) + grey);
  return {static_cast<float>((c.r * left + grey) * brightness), static_cast<float>((c.g * left + grey) * brightness),
          static_cast<float>(blue * brightness)};
}

// The rays of one sample, drawn as POV-Ray does (spec 07 2.7), or on a lattice.
class SampleRays {
 public:
  // `cursor`: into the pool of directions; `next_lattice`: empty for POV-Ray's own directions.
  SampleRays(const RadiositySettings& settings, const RadiosityQuery& query, std::size_t& cursor,
             std::optional<std::size_t>& next_lattice)
      : settings_(settings),
        query_(query),
        about_normal_(query.geometric_normal),
        about_layer_normal_(query.layer_normal),
        cursor_(cursor),
        count_(settings.rays(query.depth)) {
    if (next_lattice && FinalGatherLattice::worthwhile(count_)) {
      count_ = FinalGatherLattice::enough(count_);
      lattice_.emplace(settings.lattice_plan(query.depth), (*next_lattice)++);
    }
    perturbed_ = settings.description().normal && dot(query.layer_normal, query.geometric_normal) < 1.0 - 1e-12;
    most_tries_ = std::min<std::size_t>(5 * static_cast<std::size_t>(count_), settings.pool_size());
  }

  int count() const { return count_; }
  // Of the rays so far, those about the layer's normal instead of the surface's.
  int about_layer() const { return about_layer_; }

  FinalGatherRay next() {
    Vec3 direction;
    bool found = false;
    while (perturbed_ && tries_ < most_tries_ && !found) {
      ++tries_;
      direction = about_layer_normal_(draw());
      found = dot(direction, query_.geometric_normal) > 0.0;
    }
    if (found) {
      ++about_layer_;
    } else {
      direction = about_normal_(draw());
    }
    return {direction, static_cast<float>(drawn_++) / static_cast<float>(count_ - 1)};
  }

 private:
  Vec3 draw() {
    if (lattice_) return lattice_->next();
    const Vec3& direction = settings_.direction(cursor_);
    cursor_ = cursor_ + 1 == settings_.pool_size() ? 0 : cursor_ + 1;
    return direction;
  }

  const RadiositySettings& settings_;
  const RadiosityQuery& query_;
  const NormalFrame about_normal_, about_layer_normal_;
  std::size_t& cursor_;
  std::optional<FinalGatherLattice> lattice_;
  int count_, drawn_ = 0, about_layer_ = 0;
  bool perturbed_;
  std::size_t most_tries_, tries_ = 0;
};

}  // namespace

RadiositySettings::RadiositySettings(const scene::Radiosity& description, const Vec3& camera_location)
    : description_(&description), camera_location_(camera_location) {
  const int count = std::max(5, description.count);
  const int size = std::max({count, description.count_directions, 1});
  pool_.reserve(size);
  for (int k = 1; k <= size; ++k) {
    const double r = std::sqrt(radical_inverse(k, 2)), phi = 2.0 * kPi * radical_inverse(k, 3);
    const double x = r * std::cos(phi), z = r * std::sin(phi);
    pool_.emplace_back(x, std::sqrt(1.0 - x * x - z * z), z);
  }
  for (int d = 0; d < kMaxRadiosityDepth; ++d) {
    rays_[d] = std::min(
        size, std::max(5, static_cast<int>(std::floor(std::ldexp(static_cast<double>(description.count), -d)))));
    if (FinalGatherLattice::worthwhile(rays_[d]))
      lattice_plans_[d] = FinalGatherLattice::Plan(FinalGatherLattice::enough(rays_[d]));
  }
}

IrradianceCache RadiositySettings::empty_cache() const {
  // Queries of little weight are content with a quarter more (spec 07 2.5).
  const double widest =
      description_->error_bound * std::max(1.0, static_cast<double>(description_->low_error_factor)) + 0.25;
  return IrradianceCache(description_->error_bound, widest);
}

double RadiositySettings::required_weight(int depth) const {
  if (depth == 0) return description_->nearest_count;
  return depth == 1 ? std::min(2, description_->nearest_count) : 1;
}

float RadiositySettings::gather_weight(int depth) const {
  return static_cast<float>(
      std::max(description_->adc_bailout + kEpsilon, std::pow(0.5 * description_->brightness, depth + 1)));
}

RadiosityTask::RadiosityTask(const RadiositySettings& settings, const IrradianceCache* base, IrradianceCache* own,
                             bool pretrace, int pass, int tile)
    : settings_(settings), base_(base), own_(own), pretrace_(pretrace), pass_(pass), tile_(tile) {}

void RadiosityTask::accumulate(const IrradianceCache& cache, const RadiosityQuery& query, const Vec3& normal,
                               double bound, Estimate& estimate) {
  static const IrradianceWeightKernels& kernels = irradiance_weight_kernels();
  const IrradianceWeightQuery weights{normal, bound, /*smooth=*/!pretrace_ && query.depth == 0};
  IrradianceBatch& batch = batch_;
  const IrradianceSample* samples[IrradianceBatch::kMax];
  int count = 0;
  contributions_.clear();
  const auto weigh_batch = [&] {
    kernels.weigh(weights, count, batch);
    for (int i = 0; i < count; ++i) {
      if (batch.weight[i] > IrradianceBatch::kNone)
        contributions_.push_back({cache.turn_of(*samples[i]), batch.weight[i] * samples[i]->quality});
    }
    count = 0;
  };
  cache.visit(query.depth, query.point, bound, normal, [&](const IrradianceSample& s, double squared) {
    batch.delta.set(count, query.point - s.point);
    batch.normal.set(count, s.normal);
    batch.nearest_direction.set(count, s.nearest_direction);
    batch.squared[count] = squared;
    batch.mean_distance[count] = s.mean_distance;
    batch.nearest_distance[count] = s.nearest_distance;
    samples[count++] = &s;
    if (count == IrradianceBatch::kMax) weigh_batch();
  });
  if (count > 0) weigh_batch();
  // The last bit of the sum hangs on the order.
  std::ranges::sort(contributions_, std::less<>(), &Contribution::turn);
  for (const Contribution& c : contributions_) {
    estimate.sum += scaled(c.turn.sample->irradiance, c.weight);
    estimate.weight += c.weight;
  }
}

Rgb RadiosityTask::irradiance(const RadiosityQuery& query, FinalGatherer& gatherer, shading::FinalGatherNotes& notes) {
  const scene::Radiosity& d = settings_.description();
  const Vec3& normal = d.normal ? query.layer_normal : query.geometric_normal;
  const double bound =
      (d.error_bound * (pretrace_ ? d.low_error_factor : 1.0) + std::max(0.0, 0.25 - query.contribution)) *
      std::ldexp(1.0, query.depth);
  Estimate estimate;
  if (base_) accumulate(*base_, query, normal, bound, estimate);
  if (own_ && own_ != base_) accumulate(*own_, query, normal, bound, estimate);
  const double required = settings_.required_weight(query.depth);
  if (query.depth == 0) ++primary_queries_.count, primary_queries_.weight += 4.0 * estimate.weight;

  Rgb result;
  const bool enough = 4.0 * estimate.weight >= required || (!pretrace_ && !d.always_sample && estimate.weight > 0.0);
  if (enough) {
    result = scaled(estimate.sum, 1.0 / estimate.weight);
  } else {
    shading::FinalGatherNotes of_sample;
    const Rgb sample = take_sample(query, gatherer, of_sample);
    const double total = estimate.weight + of_sample.quality;
    if (estimate.weight > 0.0 && total > 0.0) {
      const Rgb before = scaled(scaled(estimate.sum, 1.0 / estimate.weight), estimate.weight);
      result = scaled(before + scaled(sample, of_sample.quality), 1.0 / total);
    } else {
      result = sample;
    }
    estimate.weight = total;
    notes.quality = std::max(notes.quality, of_sample.quality);
    notes.importance = of_sample.importance, notes.threshold = of_sample.threshold;
  }
  notes.quality = std::min(notes.quality, static_cast<float>(4.0 * estimate.weight / required));
  return adjusted(result, d.gray_threshold, d.brightness);
}

Rgb RadiosityTask::take_sample(const RadiosityQuery& query, FinalGatherer& gatherer, shading::FinalGatherNotes& notes) {
  const scene::Radiosity& d = settings_.description();
  SampleRays rays(settings_, query, cursor_[static_cast<std::size_t>(query.depth)], next_lattice_);
  const int n = rays.count();
  auto& workspace = gathering_[static_cast<std::size_t>(query.depth)];
  if (!workspace) workspace = std::make_unique<Gathering>();

  Rgb sum;
  double nearest = 2e10;
  Vec3 nearest_direction(0, 0, 0);
  double quality_sum = 0, inverse_sum = 0;
  for (int done = 0; done < n;) {
    const int together = std::min(n - done, kGatheredTogether);
    done += together;
    for (int i = 0; i < together; ++i) workspace->rays[i] = rays.next(), workspace->results[i] = {};
    gatherer.gather(query.point, {workspace->rays, static_cast<std::size_t>(together)}, query.depth,
                    workspace->results);
    for (int i = 0; i < together; ++i) {
      const FinalGatherRay& ray = workspace->rays[i];
      const FinalGatherResult& g = workspace->results[i];
      const float importance = notes.importance = g.notes.importance < 0 ? g.importance : g.notes.importance;
      notes.threshold = ray.threshold;
      if (g.shaded && importance >= ray.threshold) {
        float q = g.notes.quality;
        if (importance < 1.0f) q *= static_cast<float>(n) / (std::floor(importance * static_cast<float>(n - 1)) + 1.0f);
        Rgb color = g.color;
        if (d.max_sample > 0.0 && color.max() > d.max_sample) color *= static_cast<float>(d.max_sample / color.max());
        sum += color * q;
        quality_sum += q;
      }
      inverse_sum += 1.0 / g.distance;  // a miss is infinitely far
      if (g.distance < nearest) nearest = g.distance, nearest_direction = ray.direction;
    }
  }
  const Rgb irradiance = quality_sum > 0.0 ? scaled(sum, 1.0 / quality_sum) : sum;
  const float quality = notes.quality = static_cast<float>(quality_sum / n);

  const Vec3 from_camera = query.point - settings_.camera_location();
  const double distance = length(from_camera), scale = std::ldexp(1.0, query.depth);
  if (own_ && nearest > 1e-4 * distance * d.maximum_reuse * scale) {
    double mean = inverse_sum > 0.0 ? n / inverse_sum : std::numeric_limits<double>::infinity();
    mean = std::min(std::max(mean, distance * d.minimum_reuse * scale), distance * d.maximum_reuse * scale);
    IrradianceSample sample;
    sample.point = query.point;
    sample.normal = 2 * rays.about_layer() > n ? query.layer_normal : query.geometric_normal;
    sample.nearest_direction = nearest_direction;
    sample.irradiance = irradiance;
    sample.mean_distance = static_cast<float>(mean);
    sample.nearest_distance = static_cast<float>(nearest);
    sample.quality = quality;
    sample.depth = static_cast<std::int16_t>(query.depth);
    sample.pass = static_cast<std::int16_t>(pass_);
    sample.tile = tile_;
    own_->add(sample);
  }
  return irradiance;
}

}  // namespace verisim::global
