// Soft shadows: recursive quartering of the grid of an area light (spec 06 section 8.2).
#include "tracer/shading/tracer.h"

namespace verisim::shading {
namespace {

// Independent of each other for different n or key.
std::uint64_t scrambled(std::uint32_t n, std::uint64_t key) {
  std::uint64_t z = key + n * 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}
double unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

// Where i of n stands after a shuffle.
std::uint32_t shuffled(std::uint32_t i, std::uint32_t n, std::uint64_t key) {
  const std::uint64_t own = scrambled(i, key);
  std::uint32_t place = 0;
  for (std::uint32_t j = 0; j < n; ++j) {
    const std::uint64_t other = scrambled(j, key);
    place += other < own || (other == own && j < i) ? 1 : 0;
  }
  return place;
}

}  // namespace

// By default the offsets of a grid's samples are multi-jittered (Chiu, Shirley and Wang 1994; with one shuffle for all rows and one for all columns as in
// Kensler 2013): the samples of a row share out the height of their cells among them, those of a column the width. Each by itself is anywhere in its cell, as
// POV-Ray's are, but an edge of a shadow finds them spread more evenly.
struct Tracer::AreaGrid {
  const ShadowQuery& query;
  const Vec3& p;
  Light::Axes axes;
  const Rgb& color;  // of the unshadowed light
  std::uint64_t key = 0;

  Vec2 jitter(int column, int row) const {
    const auto u = static_cast<std::uint32_t>(column), v = static_cast<std::uint32_t>(row);
    const auto columns = static_cast<std::uint32_t>(query.light.size1()), rows = static_cast<std::uint32_t>(query.light.size2());
    const std::uint32_t cell = v * columns + u;
    const double across = shuffled(v, rows, key) + unit(scrambled(cell, key + 1)), along = shuffled(u, columns, key + 2) + unit(scrambled(cell, key + 3));
    return {across / rows - 0.5, along / columns - 0.5};
  }
};

Rgb Tracer::area_shadow(const ShadowQuery& query, const Vec3& p, const LightDirection& centre, const Rgb& color) {
  const Light& light = query.light;
  AreaGrid grid{query, p, light.axes(centre.towards), color};
  if (light.source().jitter && !random_.replay()) grid.key = static_cast<std::uint64_t>(random_.shading() * 0x1p53) << 11;
  if (light.fixed_weights()) {
    Rgb sum;
    for (int v = 0; v < light.size2(); ++v)
      for (int u = 0; u < light.size1(); ++u) sum += area_sample(grid, u, v) * (light.weights1()[u] * light.weights2()[v]);
    return sum;
  }
  const std::size_t cells = static_cast<std::size_t>(light.size1()) * light.size2();
  if (corners_.size() < cells) corners_.resize(cells);
  ++corner_stamp_;
  return area_region(grid, 0, 0, light.size1() - 1, light.size2() - 1, 0);
}

Rgb Tracer::area_sample(const AreaGrid& grid, int column, int row) {
  const Light& light = grid.query.light;
  double u = column, v = row;
  if (light.source().jitter && random_.replay()) {
    u += random_.shading() - 0.5, v += random_.shading() - 0.5;
  } else if (light.source().jitter) {
    const Vec2 offset = grid.jitter(column, row);
    u += offset.x, v += offset.y;
  }
  const LightDirection to = light.direction(grid.p, light.offset(grid.axes, u, v));
  Rgb color = grid.color;
  cast_shadow(grid.query, grid.p, to.towards, to.distance, color);
  return color;
}

Rgb Tracer::area_corner(AreaGrid& grid, int u, int v) {
  CornerResult& corner = corners_[static_cast<std::size_t>(v) * grid.query.light.size1() + u];
  if (corner.stamp == corner_stamp_ && corner.color.r >= 0) return corner.color;  // POV-Ray reads negative red as "not yet known"
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
      return std::fabs(c[i].r - c[j].r) + std::fabs(c[i].g - c[j].g) + std::fabs(c[i].b - c[j].b) > 0.1f;  // absolute, not relative
    };
    if (depth < grid.query.light.source().adaptive || differ(0, 1) || differ(1, 3) || differ(3, 2) || differ(2, 0)) {
      const int u_low = (u1 + u2) / 2, u_high = (u1 + u2 + 1) / 2, v_low = (v1 + v2) / 2, v_high = (v1 + v2 + 1) / 2;
      c[0] = area_region(grid, u1, v1, u_low, v_low, depth + 1);
      c[1] = area_region(grid, u_high, v1, u2, v_low, depth + 1);
      c[2] = area_region(grid, u1, v_high, u_low, v2, depth + 1);
      c[3] = area_region(grid, u_high, v_high, u2, v2, depth + 1);
    }
  }
  return (c[0] + c[1] + c[2] + c[3]) * 0.25f;
}

}  // namespace verisim::shading
