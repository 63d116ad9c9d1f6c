// Soft shadows: recursive quartering of the grid of an area light (spec 06 section 8.2).
#include "tracer/shading/tracer.h"

namespace verisim::shading {

struct Tracer::AreaGrid {
  const ShadowQuery& query;
  const Vec3& p;
  Light::Axes axes;
  const Rgb& color;  // of the unshadowed light
};

Rgb Tracer::area_shadow(const ShadowQuery& query, const Vec3& p, const LightDirection& centre, const Rgb& color) {
  const Light& light = query.light;
  AreaGrid grid{query, p, light.axes(centre.towards), color};
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

Rgb Tracer::area_sample(const AreaGrid& grid, double u, double v) {
  const Light& light = grid.query.light;
  if (light.source().jitter) u += random_.shading() - 0.5, v += random_.shading() - 0.5;
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
