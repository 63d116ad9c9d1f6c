#include "tracer/render/sampling/focal_blur.h"

#include <array>
#include <random>
#include <span>

#include "tracer/math/chi_square.h"
#include "tracer/math/constants.h"
#include "tracer/render/sampling/jitter.h"

namespace verisim::render {
namespace {

// A hexagonal base set: integer multiples of two steps, decimals rounded to six digits; the order matters.
struct BaseSet {
  double h, k;
  std::span<const std::pair<int, int>> points;
  std::span<const int> groups;
  double jitter;
};
using Pairs = std::pair<int, int>;
constexpr Pairs kSeven[] = {{-2, 0}, {0, 0}, {2, 0}, {-1, 1}, {-1, -1}, {1, 1}, {1, -1}};
constexpr int kSevenGroups[] = {7};
constexpr Pairs kNineteen[] = {{-2, 2},  {-2, -2}, {2, 2},  {2, -2},  {4, 0}, {-4, 0}, {0, 0},
                               {0, 2},   {0, -2},  {-3, 1}, {-3, -1}, {3, 1}, {3, -1}, {-1, 1},
                               {-1, -1}, {1, 1},   {1, -1}, {-2, 0},  {2, 0}};
constexpr int kNineteenGroups[] = {7, 6, 6};
constexpr Pairs kThirtySeven[] = {{0, 0},   {-3, 3},  {3, -3}, {-3, -3}, {3, 3},   {-6, 0}, {6, 0},  {-2, 2},
                                  {2, -2},  {-2, -2}, {2, 2},  {-4, 0},  {4, 0},   {-1, 1}, {1, -1}, {-1, -1},
                                  {1, 1},   {-2, 0},  {2, 0},  {-5, 1},  {-5, -1}, {5, 1},  {5, -1}, {-4, 2},
                                  {-4, -2}, {4, 2},   {4, -2}, {-1, 3},  {-1, -3}, {1, 3},  {1, -3}, {-3, 1},
                                  {-3, -1}, {3, 1},   {3, -1}, {0, 2},   {0, -2}};
constexpr int kThirtySevenGroups[] = {7, 6, 6, 4, 4, 4, 4, 2};

double six_decimals(double v) { return std::round(v * 1e6) / 1e6; }

Vec2 base_point(const BaseSet& set, std::size_t i) {
  return {six_decimals(set.points[i].first * set.h), six_decimals(set.points[i].second * set.k)};
}

BaseSet hexagonal(int count) {
  if (count >= 37) return {0.07216878364870322, 0.125, kThirtySeven, kThirtySevenGroups, 0.0721688};
  if (count >= 19) return {0.09622504486493763, 1.0 / 6, kNineteen, kNineteenGroups, 0.096225};
  return {0.14433756729740643, 0.25, kSeven, kSevenGroups, 0.144338};
}

// The n-th point of the Halton sequence mapped to the disc of radius 1/2.
Vec2 disc_point(std::uint32_t n) {
  const double r = std::sqrt(radical_inverse(2, n + 1) / 4), phi = 2 * kPi * radical_inverse(3, n + 1);
  return {r * std::cos(phi), r * std::sin(phi)};
}

// Which cells of [-1/2, 1/2]^2 already hold a lens point.
class Occupancy {
 public:
  explicit Occupancy(int count)
      : side_(2 * static_cast<int>(std::ceil(std::sqrt(count / kPi))) + 1),
        cells_(static_cast<std::size_t>(side_) * side_, false) {}
  void mark(const Vec2& p) { cells_[index(p)] = true; }
  bool marked(const Vec2& p) const { return cells_[index(p)]; }

 private:
  int cell(double c) const { return std::clamp(static_cast<int>(std::floor((c + 0.5) * side_)), 0, side_ - 1); }
  std::size_t index(const Vec2& p) const { return static_cast<std::size_t>(cell(p.y)) * side_ + cell(p.x); }
  int side_;
  std::vector<bool> cells_;
};

}  // namespace

FocalBlur::FocalBlur(const scene::Camera& camera, const Weight& bokeh)
    : minimum_(camera.blur_samples_min),
      aperture_(camera.aperture),
      lens_{camera.location, camera.focal_distance / length(camera.direction),
            normalize(cross(camera.up, camera.direction)), Vec3()} {
  lens_.along = normalize(cross(camera.direction, lens_.across));
  const int count = camera.blur_samples;
  std::vector<int> sizes;
  if (bokeh) {
    place_by_bokeh(count, bokeh);
    lens_jitter_ = 0.5 / std::sqrt(count);
  } else {
    place_without_bokeh(count);
    lens_jitter_ = 0.5 / std::sqrt(count);
    if (count >= 7) {
      const BaseSet set = hexagonal(count);
      sizes.assign(set.groups.begin(), set.groups.end());
      if (count == static_cast<int>(set.points.size())) lens_jitter_ = set.jitter;
    }
  }
  make_groups(camera, sizes);
  for (const Vec2& p : positions_)
    lens_extent_ = Vec2(std::fmax(lens_extent_.x, std::fabs(p.x)), std::fmax(lens_extent_.y, std::fabs(p.y)));
  lens_extent_ = (lens_extent_ + Vec2(lens_jitter_, lens_jitter_)) * std::fabs(aperture_ / 2);
}

void FocalBlur::place_without_bokeh(int count) {
  Occupancy cells(count);
  if (count >= 7) {
    const BaseSet set = hexagonal(count);
    for (std::size_t i = 0; i < set.points.size(); ++i) positions_.push_back(base_point(set, i));
  } else {
    positions_ = {{-0.25, 0.25}, {0.25, 0.25}, {-0.25, -0.25}, {0.25, -0.25}};
  }
  if (static_cast<int>(positions_.size()) > count) positions_.resize(static_cast<std::size_t>(count));
  for (const Vec2& p : positions_) cells.mark(p);
  const std::int64_t restart = 10 * static_cast<std::int64_t>(count);
  std::int64_t budget = restart, n = 0;
  for (int i = static_cast<int>(positions_.size()); i < count; ++i) {
    Vec2 p;
    bool found = false;
    do {
      p = disc_point(static_cast<std::uint32_t>(n % restart));
      ++n, --budget;
      found = !cells.marked(p) && p.x * p.x + p.y * p.y <= 0.25;
    } while (!found && budget > count - i);
    cells.mark(p);
    positions_.push_back(p);
  }
}

void FocalBlur::place_by_bokeh(int count, const Weight& weight) {
  std::mt19937 generator;
  generator();  // the first output is discarded
  std::uint32_t tried = 0;
  const double growth = 1.0 / (static_cast<double>(count) * count);  // guarantees an end even on a black pigment
  for (std::uint32_t n = 0; static_cast<int>(positions_.size()) < count; ++n) {
    const Vec2 v{radical_inverse(2, n + 1) - 0.5, radical_inverse(3, n + 1) - 0.5};
    const double w = weight({v.x + 0.5, v.y + 0.5, 0}) + tried * growth;
    ++tried;
    if (generator() / 4294967296.0 <= w) positions_.push_back(v);
  }
}

void FocalBlur::make_groups(const scene::Camera& camera, const std::vector<int>& sizes) {
  const int count = camera.blur_samples;
  const double reference = count > 1 ? chi_square_quantile(count - 1, camera.confidence) : 1;
  std::size_t next = 0;
  for (int end = 0; end < count;) {
    end = std::min(count, end + (next < sizes.size() ? sizes[next] : 4));
    ++next;
    const double threshold = count == 1 ? 0 : camera.variance * chi_square_quantile(end, camera.confidence) / reference;
    groups_.push_back({end, static_cast<float>(threshold)});
  }
}

namespace {

// A grid of 16 by 16 places, each shaken.
using PlacesInPixel = std::array<std::array<Vec2, 16>, 16>;

const PlacesInPixel& places_in_pixel() {
  static const PlacesInPixel places = [] {
    PlacesInPixel grid;
    for (std::size_t i = 0; i < 16; ++i) {
      for (std::size_t j = 0; j < 16; ++j) {
        const double x = static_cast<double>(2 * i + 1) / 32 - 0.5, y = static_cast<double>(2 * j + 1) / 32 - 0.5;
        const Vec2 e = jitter2(x, y);
        grid[i][j] = {x + (e.x - 0.5) / 16, y + (e.y - 0.5) / 16};
      }
    }
    return grid;
  }();
  return places;
}

}  // namespace

FocalBlur::Points FocalBlur::points(double x, double y, int n) const {
  const auto& p = permutation();
  const std::int64_t seed = static_cast<std::int64_t>(313 * x + 11) + static_cast<std::int64_t>(311 * y + 17);
  const Vec2 d = places_in_pixel()[p[(seed + n) & 4095] % 16][p[(seed + n + 1) & 4095] % 16];
  const Vec2 f = jitter2(x + d.x + 0.5, y + d.y - 0.5);
  return {{x + d.x, y + d.y}, (positions_[n] + f * (2 * lens_jitter_)) * (aperture_ / 2)};
}

std::optional<PrimaryRay> FocalBlur::ray(const CameraRays& camera, double x, double y, int n) const {
  const Points at = points(x, y, n);
  std::optional<PrimaryRay> primary = camera.at(at.picture.x, at.picture.y);
  if (!primary) return std::nullopt;
  primary->ray = lens_.ray(at.lens.x, at.lens.y, primary->ray.direction);
  return primary;
}

void FocalBlur::rays(const CameraRays& camera, const Vec2* places, const std::uint32_t* numbers, int count,
                     RayBatch& rays) const {
  const PerspectiveView* const view = camera.perspective();
  if (!view) {
    for (int i = 0; i < count; ++i) {
      const Ray ray = this->ray(camera, places[i].x, places[i].y, static_cast<int>(numbers[i]))->ray;
      rays.origin.set(i, ray.origin), rays.direction.set(i, ray.direction);
    }
    return;
  }
  LensPoints points;
  for (int i = 0; i < count; ++i) {
    const Points at = this->points(places[i].x, places[i].y, static_cast<int>(numbers[i]));
    points.x[i] = at.picture.x, points.y[i] = at.picture.y, points.across[i] = at.lens.x, points.along[i] = at.lens.y;
  }
  lens_kernels().aim(*view, lens_, points, count, rays);
}

void FocalBlur::Average::add(const std::optional<Color>& seen) {
  const Color c = seen.value_or(Color());
  const float t = seen ? c.t : 1.0f;  // a missing ray is opaque in the sum, clear in the test
  if (!seen) no_ray_transmit_ += 1.0f;
  sum_ += c;
  squares_[0] += c.r * c.r, squares_[1] += c.g * c.g, squares_[2] += c.b * c.b, squares_[3] += t * t;
  if (++n_ == wanted()) test();
}

void FocalBlur::Average::test() {
  const Group& group = blur_->groups_[group_++];
  complete_ = group_ == blur_->groups_.size();
  if (complete_ || n_ < blur_->minimum_ || !(group.threshold > 0)) return;
  const float sums[4] = {sum_.r, sum_.g, sum_.b, sum_.t + no_ray_transmit_};
  complete_ = true;
  for (int c = 0; c < 4; ++c) {
    const double mean = static_cast<double>(sums[c]) / n_;
    complete_ =
        complete_ && static_cast<float>((static_cast<double>(squares_[c]) / n_ - mean * mean) / n_) < group.threshold;
  }
}

Color FocalBlur::Average::mean() const {
  const auto count = static_cast<float>(n_);
  return {sum_.r / count, sum_.g / count, sum_.b / count, sum_.f / count, sum_.t / count};
}

Box3 FocalBlur::lens() const {
  constexpr double kRounding = 1e-6;
  Vec3 reach;
  for (int i = 0; i < 3; ++i)
    reach[i] =
        (lens_extent_.x * std::fabs(lens_.across[i]) + lens_extent_.y * std::fabs(lens_.along[i])) * (1 + kRounding) +
        1e-12 * std::fabs(lens_.location[i]);
  return {lens_.location - reach, lens_.location + reach};
}

// A ray is at location + q + s (d - q) for s >= 0, where q lies on the lens and d leads to the point that is in focus.
// It is followed to the s at which all rays are behind the world: a longer shaft would be wider than need be, because
// lens rays diverge on both sides of the focus.
std::optional<accel::Shaft> FocalBlur::shaft(const CameraRays& camera, const Box3& world, double left, double top,
                                             double right, double bottom) const {
  constexpr double kJitter = 0.54, kRounding = 1e-6;  // the pixel's area is jittered by less, see `ray`
  const Vec3 ahead = cross(lens_.across, lens_.along);
  Box3 focused;
  double depth = std::numeric_limits<double>::infinity(), furthest = 0;
  for (const Vec2& at : {Vec2(left - kJitter, top - kJitter), Vec2(right + kJitter, top - kJitter),
                         Vec2(left - kJitter, bottom + kJitter), Vec2(right + kJitter, bottom + kJitter)}) {
    const Vec3 d = camera.at(at.x, at.y)->ray.direction * lens_.focal_scale;
    focused.extendBy(d);
    depth = std::min(depth, dot(d, ahead));
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? world.max.x : world.min.x, corner & 2 ? world.max.y : world.min.y,
                 corner & 4 ? world.max.z : world.min.z);
    furthest = std::max(furthest, dot(p - lens_.location, ahead));
  }
  if (!(depth > 0)) return std::nullopt;
  const double s = furthest / depth * (1 + kRounding);
  const Box3 from = lens();
  const Vec3 spread = 0.5 * (from.max - from.min) * std::fabs(1 - s);
  return accel::Shaft::between(from,
                               {lens_.location + s * focused.min - spread, lens_.location + s * focused.max + spread});
}

}  // namespace verisim::render
