// Soft shadows: recursive quartering of the grid of an area light (spec 06 section 8.2). What is known to be asked for
// goes in batches of rays.
#include <algorithm>
#include <array>
#include <span>

#include "tracer/math/ray_batch.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/shading/direct/shadow_batch.h"
#include "tracer/shading/tracer.h"

namespace verisim::shading {
namespace {

double unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

// 0, 1, 2 ...: all rays of a batch.
constexpr auto kInTurn = [] {
  std::array<int, ShadowBatch::kMax> numbers{};
  for (int i = 0; i < ShadowBatch::kMax; ++i) numbers[static_cast<std::size_t>(i)] = i;
  return numbers;
}();

Rgb mean(const Rgb& a, const Rgb& b, const Rgb& c, const Rgb& d) { return (a + b + c + d) * 0.25f; }

// Whether some colours are one.
struct Agreement {
  std::optional<Rgb> color;
  bool disagreed = false;
  void add(const Rgb& other) {
    if (!color) color = other;
    disagreed = disagreed || !(*color == other);
  }
  std::optional<Rgb> all() const { return disagreed ? std::nullopt : color; }
};

}  // namespace

// By default the offsets of a grid's samples are multi-jittered (Chiu, Shirley and Wang 1994; with one shuffle for all
// rows and one for all columns as in Kensler 2013): the samples of a row share out the height of their cells among
// them, those of a column the width. Each by itself is anywhere in its cell, as POV-Ray's are, but an edge of a shadow
// finds them spread more evenly.
struct Tracer::AreaGrid {
  const ShadowQuery& query;
  const Vec3& p;
  Light::Axes axes;
  const Rgb& color;  // of the unshadowed light
  std::uint64_t key = 0;
  Shuffle *rows = nullptr, *columns = nullptr;  // null: no jitter, or POV-Ray's own
  bool together = false;                        // rays may go in batches
  accel::WorldEntry* entry = nullptr;           // of these
  bool attenuates = false, quartered = false;   // media or fog act on what lies behind the last surface
  ShadowSegment rest{};                         // of the sample that was taken last

  // Moves a position within its cell.
  void jitter(int column, int row, double& x, double& y) const {
    const auto u = static_cast<std::uint32_t>(column), v = static_cast<std::uint32_t>(row);
    const auto width = static_cast<std::uint32_t>(query.light.size1()),
               height = static_cast<std::uint32_t>(query.light.size2());
    const std::uint32_t cell = v * width + u;
    const double across = rows->place(v) + unit(scrambled(cell, key + 1)),
                 along = columns->place(u) + unit(scrambled(cell, key + 3));
    x += across / height - 0.5, y += along / width - 0.5;
  }
};

Rgb Tracer::area_shadow(const ShadowQuery& query, const Vec3& p, const LightDirection& centre, const Rgb& color) {
  const Light& light = query.light;
  AreaGrid grid{query, p, light.axes(centre.towards), color};
  if (light.source().jitter && !random_.replay()) {
    grid.key = static_cast<std::uint64_t>(random_.shading() * 0x1p53) << 11;
    grid.rows = &area_rows_, grid.columns = &area_columns_;
    area_rows_.begin(static_cast<std::uint32_t>(light.size2()), grid.key),
        area_columns_.begin(static_cast<std::uint32_t>(light.size1()), grid.key + 2);
  }
  const std::size_t cells = static_cast<std::size_t>(light.size1()) * light.size2();
  if (corners_.size() < cells) corners_.resize(cells);
  ++corner_stamp_;
  grid.attenuates = light_on_way_changes(light, query.eye);
  if (!light.projector() && !in_order_ && !grid.attenuates) grid.together = true, grid.entry = shadow_entry(query, p);
  // Where all first samples agree, as they do beside penumbras, no others are asked for, and means of one colour are
  // that colour, unless its sum is too large for binary32.
  if (grid.together)
    if (const auto all = ask_first_corners(grid); all && all->r >= 0 && mean(*all, *all, *all, *all) == *all)
      return *all;
  Rgb result = area_region(grid, 0, 0, light.size1() - 1, light.size2() - 1, 0);
  if (grid.attenuates) area_volumes(grid, result);
  return result;
}

// Media and fog act once for all samples: behind the last surface on the way of the one that was taken last, and, where
// the grid was quartered, on a ray to twice the position of the light; within things that are not hollow not at all
// (spec 06 9.4).
void Tracer::area_volumes(const AreaGrid& grid, Rgb& color) {
  if (color == Rgb()) return;
  RayState ray = grid.query.eye;
  double length = grid.rest.length;
  if (grid.quartered) {
    const Light& light = grid.query.light;
    const LightDirection to = light.direction(grid.p, light.source().position);
    ray.ray = {grid.p, to.towards}, length = to.distance;
  } else {
    ray.ray = grid.rest.ray;
  }
  if (length > kShadowTolerance) shadow_volumes(grid.query, ray, length, false, color);
}

Rgb Tracer::area_sample(AreaGrid& grid, int column, int row) {
  const Light& light = grid.query.light;
  double u = column, v = row;
  if (grid.rows)
    grid.jitter(column, row, u, v);
  else if (light.source().jitter)
    u += random_.shading() - 0.5, v += random_.shading() - 0.5;
  const LightDirection to = light.direction(grid.p, light.offset(grid.axes, u, v));
  Rgb color = grid.color;
  cast_shadow(grid.query, {{grid.p, to.towards}, to.distance}, color, grid.attenuates ? &grid.rest : nullptr);
  return color;
}

// The samples in these columns and rows that are not known, at once; those on whose way media may draw random numbers
// are left for later.
std::optional<Rgb> Tracer::ask_corners(const AreaGrid& grid, std::span<const int> columns, std::span<const int> rows) {
  const Light& light = grid.query.light;
  RayBatch rays;
  double distance[RayBatch::kSize];
  GridPlaces places;
  CornerResult* corners[RayBatch::kMax];
  int count = 0;
  Agreement agreement;
  const bool any_decides = only_opaque(grid.entry);
  const bool draws = scene_.effects && scene_.effects->interior_draws_count;
  const auto ask = [&] {
    ShadowBatch filtered;
    CornerResult* filtered_corners[ShadowBatch::kMax];
    aim_at_grid(light, grid.axes, grid.p, places, count, rays, distance);
    int active = 0;
    for (int k = 0; k < count; ++k) {
      const Vec3 towards = rays.direction.at(k);
      const bool decides = any_decides || scene_.world.only_opaque_between(grid.p, grid.p + distance[k] * towards);
      if (!(distance[k] > 2 * kShadowTolerance) || (draws && !decides)) {
        corners[k]->stamp = 0;
        agreement.disagreed = true;
        continue;
      }
      if (!decides) {
        filtered_corners[filtered.count] = corners[k];
        filtered.add({grid.p, towards}, distance[k], grid.color, grid.query.lit, {});
        continue;
      }
      rays.origin.set(active, grid.p), rays.direction.set(active, towards);
      distance[active] = distance[k] - kShadowTolerance;
      corners[active++] = corners[k];
    }
    bool blocked[RayBatch::kMax] = {};
    scene_.world.occluded_batch(rays, 0, active, contact_tolerance(light), distance, grid.entry, blocked);
    for (int k = 0; k < active; ++k) {
      const Rgb color = blocked[k] ? Rgb() : grid.color;
      *corners[k] = {color, corner_stamp_};
      agreement.add(color);
    }
    if (filtered.count > 0) {
      filter_batch(light, grid.query.eye, grid.entry, kInTurn.data(), filtered.count, filtered);
      for (int k = 0; k < filtered.count; ++k) {
        *filtered_corners[k] = {filtered.light[k], corner_stamp_};
        agreement.add(filtered.light[k]);
      }
    }
    statistics_.shadow_rays += static_cast<std::uint64_t>(active + filtered.count);
    count = 0;
  };
  for (const int v : rows) {
    for (const int u : columns) {
      CornerResult& corner = corners_[static_cast<std::size_t>(v) * light.size1() + u];
      if (corner.stamp == corner_stamp_) continue;
      places.u[count] = u, places.v[count] = v;
      if (grid.rows) grid.jitter(u, v, places.u[count], places.v[count]);
      corners[count++] = &corner;
      corner.stamp = corner_stamp_;  // the middle of an even number of cells is named twice
      if (count == RayBatch::kMax) ask();
    }
  }
  if (count > 0) ask();
  return agreement.all();
}

// Those that quartering asks for whatever it finds.
std::optional<Rgb> Tracer::ask_first_corners(const AreaGrid& grid) {
  const Light& light = grid.query.light;
  const int levels = light.source().adaptive;
  // The coordinates of corners, halved and halved again.
  const auto lines = [levels](int size, std::vector<int>& found) {
    found.clear();
    const auto divide = [&](const auto& self, int low, int high, int depth) -> void {
      if (depth >= levels || high - low <= 1) {
        found.push_back(low);
        if (high != low) found.push_back(high);
        return;
      }
      self(self, low, (low + high) / 2, depth + 1);
      self(self, (low + high + 1) / 2, high, depth + 1);
    };
    divide(divide, 0, size - 1, 0);
    found.erase(std::unique(found.begin(), found.end()), found.end());
  };
  if (const std::array of{light.size1(), light.size2(), levels}; area_lines_of_ != of) {
    lines(light.size1(), area_lines_[0]), lines(light.size2(), area_lines_[1]);
    area_lines_of_ = of;
  }
  return ask_corners(grid, area_lines_[0], area_lines_[1]);
}

Rgb Tracer::area_corner(AreaGrid& grid, int u, int v) {
  CornerResult& corner = corners_[static_cast<std::size_t>(v) * grid.query.light.size1() + u];
  if (corner.stamp == corner_stamp_ && corner.color.r >= 0)
    return corner.color;  // POV-Ray reads negative red as "not yet known"
  const Rgb color = area_sample(grid, u, v);
  corner = {color, corner_stamp_};
  return color;
}

Rgb Tracer::area_region(AreaGrid& grid, int u1, int v1, int u2, int v2, int depth) {
  Rgb c[4];
  c[0] = area_corner(grid, u1, v1);
  c[1] = area_corner(grid, u2, v1);
  c[2] = area_corner(grid, u1, v2);
  c[3] = area_corner(grid, u2, v2);
  if (u2 - u1 > 1 || v2 - v1 > 1) {
    const auto differ = [&](int i, int j) {
      return std::fabs(c[i].r - c[j].r) + std::fabs(c[i].g - c[j].g) + std::fabs(c[i].b - c[j].b) >
             0.1f;  // absolute, not relative
    };
    if (depth < grid.query.light.source().adaptive || differ(0, 1) || differ(1, 3) || differ(3, 2) || differ(2, 0)) {
      grid.quartered = true;
      const int u_low = (u1 + u2) / 2, u_high = (u1 + u2 + 1) / 2, v_low = (v1 + v2) / 2, v_high = (v1 + v2 + 1) / 2;
      if (grid.together && depth >= grid.query.light.source().adaptive)
        ask_corners(grid, std::array{u1, u_low, u_high, u2}, std::array{v1, v_low, v_high, v2});
      c[0] = area_region(grid, u1, v1, u_low, v_low, depth + 1);
      c[1] = area_region(grid, u_high, v1, u2, v_low, depth + 1);
      c[2] = area_region(grid, u1, v_high, u_low, v2, depth + 1);
      c[3] = area_region(grid, u_high, v_high, u2, v2, depth + 1);
    }
  }
  return mean(c[0], c[1], c[2], c[3]);
}

}  // namespace verisim::shading
