// The tiles of tilings 1 .. 24 (spec 05 section 9.1).
//
// They are given as polygons that repeat by two lattice vectors. Once, each tiling is turned into the list of all
// tiles, shifted copies included, that touch one lattice cell.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "tracer/textures/patterns/tilings/tiling.h"

namespace verisim::textures {
namespace {

using Polygon = std::vector<Vec2>;  // convex; x and z

const double kH = std::sqrt(3.0) / 2;  // height of a triangle with sides of 1

Vec2 direction(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return {std::cos(a), std::sin(a)};
}

// Regular polygon of unit side with edge normals at `normal` + k * 360/n degrees.
Polygon regular(const Vec2& center, int n, double normal) {
  const double radius = 0.5 / std::sin(std::numbers::pi / n);
  Polygon result;
  for (int k = 0; k < n; ++k) result.push_back(center + radius * direction(normal + (k + 0.5) * 360 / n));
  return result;
}

double inner_radius(int n) { return 0.5 / std::tan(std::numbers::pi / n); }

Polygon rectangle(double x, double z, double width, double height) {
  return {{x, z}, {x + width, z}, {x + width, z + height}, {x, z + height}};
}

// The unit n-gon that sits outside on the edge with this normal of a polygon with the given inner radius.
Polygon on_edge(const Vec2& center, double radius, double normal, int n) {
  return regular(center + (radius + inner_radius(n)) * direction(normal), n, normal + 180);
}

class Builder {
 public:
  Builder(int classes, double flat_distance, const Vec2& a, const Vec2& b)
      : classes_(classes), flat_(flat_distance), a_(a), b_(b) {
    const double determinant = a.x * b.y - a.y * b.x;
    tiling_ = {{{a.x, a.y}, {b.x, b.y}},
               {{b.y / determinant, -b.x / determinant}, {-a.y / determinant, a.x / determinant}},
               {},
               false,
               {0, 0},
               0,
               false};
  }

  // `radii`: distance at which the tile is flat, per edge; empty: the tiling's.
  void add(int tile_class, const Polygon& polygon, double offset = 0, double flat_minimum = 0,
           const std::vector<double>& radii = {}) {
    constexpr int kReach = 4;
    for (int i = -kReach; i <= kReach; ++i)
      for (int j = -kReach; j <= kReach; ++j) {
        Polygon shifted;
        for (const Vec2& v : polygon) shifted.push_back(v + static_cast<double>(i) * a_ + static_cast<double>(j) * b_);
        if (touches_cell(shifted)) tiling_.tiles.push_back(make_tile(tile_class, shifted, offset, flat_minimum, radii));
      }
  }

  bool in_first_cell(const Vec2& p) const {
    const Vec2 c = cell_coordinates(p);
    return std::floor(c.x) == 0 && std::floor(c.y) == 0;
  }

  Tiling finish() {
    // Large tiles first: most points lie in them.
    std::stable_sort(tiling_.tiles.begin(), tiling_.tiles.end(),
                     [](const Tile& x, const Tile& y) { return x.edges.size() > y.edges.size(); });
    return std::move(tiling_);
  }

 private:
  Vec2 cell_coordinates(const Vec2& p) const {
    return {p.x * tiling_.inverse[0][0] + p.y * tiling_.inverse[0][1],
            p.x * tiling_.inverse[1][0] + p.y * tiling_.inverse[1][1]};
  }

  static std::vector<Tile::Edge> edges_of(const Polygon& polygon) {
    Vec2 middle(0, 0);
    for (const Vec2& v : polygon) middle += v / static_cast<double>(polygon.size());
    std::vector<Tile::Edge> edges;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 from = polygon[k], along = polygon[(k + 1) % polygon.size()] - from;
      const double n = std::sqrt(along.x * along.x + along.y * along.y);
      Tile::Edge e{-along.y / n, along.x / n, 0};
      e.c = e.nx * from.x + e.nz * from.y;
      if (e.nx * middle.x + e.nz * middle.y < e.c) e = {-e.nx, -e.nz, -e.c};
      edges.push_back(e);
    }
    return edges;
  }

  // Separating axes of two convex polygons.
  bool touches_cell(const Polygon& polygon) const {
    const Polygon cell = {{0, 0}, a_, a_ + b_, b_};
    const auto separated = [](const Polygon& p, const Polygon& q) {
      for (const Tile::Edge& e : edges_of(p))
        if (std::all_of(q.begin(), q.end(), [&](const Vec2& v) { return e.nx * v.x + e.nz * v.y - e.c < -1e-9; }))
          return true;
      return false;
    };
    return !separated(cell, polygon) && !separated(polygon, cell);
  }

  Tile make_tile(int tile_class, const Polygon& polygon, double offset, double flat_minimum,
                 const std::vector<double>& radii) const {
    Tile tile;
    tile.edges = edges_of(polygon);
    for (std::size_t k = 0; k < tile.edges.size(); ++k) {
      const double r = radii.empty() ? flat_ : radii[k];
      tile.edges[k] = {tile.edges[k].nx / r, tile.edges[k].nz / r, tile.edges[k].c / r};
    }
    tile.step = 1.0 / classes_;
    tile.top = (tile_class + 1.0) / classes_;
    tile.offset = offset;
    tile.minimum = flat_minimum;
    tile.rank = tile_class;
    return tile;
  }

  int classes_;
  double flat_;
  Vec2 a_, b_;
  Tiling tiling_;
};

Tiling squares_and_oblongs(int number) {  // 11 and 12
  Builder b(3, 0.5, {3, 0}, {0, 3});
  b.add(0, rectangle(1, 1, 1, 1));
  b.add(2, rectangle(0, 0, 1, 2));
  b.add(2, rectangle(2, 1, 1, 2));
  b.add(1, rectangle(1, 0, 2, 1));
  b.add(1, rectangle(0, 2, 2, 1));
  Tiling tiling = b.finish();
  tiling.mirrored = number == 12;
  return tiling;
}

Tiling oblongs(std::initializer_list<Vec2> upright, std::initializer_list<Vec2> lying) {  // 6 and 18
  Builder b(2, 0.5, {4, 0}, {0, 4});
  for (const Vec2& v : upright) b.add(1, rectangle(v.x, v.y, 1, 2));
  for (const Vec2& v : lying) b.add(0, rectangle(v.x, v.y, 2, 1));
  return b.finish();
}

Tiling trapezoids(int number) {  // 13 and 14
  const double q = std::sqrt(0.5), period = 2 * std::numbers::sqrt2;
  const bool five = number == 14;
  Builder b(five ? 5 : 3, std::numbers::sqrt2 / 4, {period, 0}, {0, period});
  const Vec2 c(2 * q, 2 * q);
  b.add(five ? 4 : 0, rectangle(q, q, 2 * q, 2 * q), five ? 2e-7 : 0);
  for (const double s : {1.0, -1.0}) {
    const Polygon beside = {c + Vec2(s * q, -q), c + Vec2(2 * s * q, -2 * q), c + Vec2(2 * s * q, 2 * q),
                            c + Vec2(s * q, q)};
    const Polygon above = {c + Vec2(-q, s * q), c + Vec2(-2 * q, 2 * s * q), c + Vec2(2 * q, 2 * s * q),
                           c + Vec2(q, s * q)};
    b.add(five ? (s > 0 ? 0 : 1) : 2, beside);
    b.add(five ? (s > 0 ? 3 : 2) : 1, above);
  }
  return b.finish();
}

Tiling hexagons_squares_triangles(int number) {  // 16 and 17
  const bool six = number == 17;
  Builder b(six ? 6 : 3, kH / 3, {0, 1 + 2 * kH}, {1.5 + kH, 0.5 + kH});
  const Vec2 c(0.5 + kH, 0.5 + kH);
  b.add(six ? 5 : 2, regular(c, 6, 30), 0, six ? 5.000001 / 6 : 2.0000001 / 3);
  b.add(0, on_edge(c, kH, 90, 4));
  b.add(six ? 1 : 0, on_edge(c, kH, 30, 4), six ? 1.67e-7 : 0);
  b.add(six ? 2 : 0, on_edge(c, kH, -30, 4), six ? 1.67e-7 : 0);
  for (const double side : {180.0, 0.0}) {
    const Vec2 tip = c + direction(side);
    b.add(six ? (side == 0 ? 4 : 3) : 1, {tip, tip + direction(side + 30), tip + direction(side - 30)});
  }
  return b.finish();
}

Tiling hexagons_in_triangles(const Vec2& a, const Vec2& lattice_b) {  // 19 and 20
  Builder b(3, kH / 3, a, lattice_b);
  const Vec2 center(1, 2 * kH);
  b.add(2, regular(center, 6, 30), 0, 2.000001 / 3);
  const auto in_hexagon = [&](const Vec2& p) {
    for (int i = -6; i <= 6; ++i)
      for (int j = -6; j <= 6; ++j)
        if ((p - center - static_cast<double>(i) * a - static_cast<double>(j) * lattice_b).length() < 1) return true;
    return false;
  };
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j) {
      const Vec2 corner(i + j / 2.0, j * kH);
      const Polygon upright = {corner, corner + Vec2(1, 0), corner + Vec2(0.5, kH)};
      const Polygon inverted = {corner, corner + Vec2(1, 0), corner + Vec2(0.5, -kH)};
      for (int k = 0; k < 2; ++k) {
        const Polygon& triangle = k == 0 ? upright : inverted;
        const Vec2 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        // The shift keeps centres off the border of the cell.
        if (b.in_first_cell(middle + Vec2(1e-3, 2.7e-3)) && !in_hexagon(middle)) b.add(k, triangle);
      }
    }
  return b.finish();
}

Tiling snub_square() {  // 21
  const double period = 1 + 2 * kH, c = 0.5 + kH;
  Builder b(6, kH / 3, {period, 0}, {0, period});
  for (const Vec2& o : {Vec2(0, 0), Vec2(c, c)})
    for (const double s : {1.0, -1.0}) b.add(s > 0 ? 0 : 2, {o + Vec2(0, 0.5), o + Vec2(0, -0.5), o + Vec2(s * kH, 0)});
  for (const Vec2& o : {Vec2(c, 0), Vec2(0, c)})
    for (const double s : {1.0, -1.0}) b.add(s > 0 ? 3 : 1, {o + Vec2(0.5, 0), o + Vec2(-0.5, 0), o + Vec2(0, s * kH)});
  for (const double sx : {1.0, -1.0})
    for (const double sz : {1.0, -1.0}) {
      const int tile_class = sx == sz ? 4 : 5;
      b.add(tile_class, {{0, sz * 0.5}, {sx * kH, 0}, {sx * (kH + 0.5), sz * kH}, {sx * 0.5, sz * (kH + 0.5)}}, 0,
            (tile_class + 1e-6) / 6);
    }
  return b.finish();
}

Tiling dodecagons_triangles() {  // 22
  Builder b(3, kH / 3, {2 + 2 * kH, 0}, {1 + kH, 1.5 + 2 * kH});
  const Polygon dodecagon = regular({1 + kH, 1 + kH}, 12, 0);
  // Edge k of the polygon has normal (k + 1) * 30 degrees.
  std::vector<double> radii(12, kH / 3);
  for (const int normal : {0, 180, 270}) radii[(normal / 30 + 11) % 12] = 1.0 / 3;
  b.add(2, dodecagon, 3.33e-8, 0, radii);
  b.add(0, {{0, 0.5 + kH}, {0.5, 0.5}, {-0.5, 0.5}});
  b.add(1, {{1 + kH, -kH}, {1.5 + kH, 0}, {0.5 + kH, 0}});
  return b.finish();
}

Tiling dodecagons_hexagons_squares(int number) {  // 23 and 24
  const bool five = number == 24;
  Builder b(five ? 5 : 3, 0.5, {3 + 2 * kH, 0}, {1.5 + kH, 1.5 + 3 * kH});
  const Vec2 c(1.5 + kH, 1 + 2 * kH);
  b.add(five ? 4 : 2, regular(c, 12, 0), 0, five ? 0.8 + 2e-7 : 2.0 / 3 + 3.33e-7);
  for (int k = 0; k < 3; ++k) b.add(five ? 1 + k : 1, on_edge(c, inner_radius(12), 60 * k, 4));
  for (const int normal : {30, 90}) b.add(0, on_edge(c, inner_radius(12), normal, 6));
  return b.finish();
}

Tiling triangles_and_more(int number) {  // 2 to 5
  const Polygon up = {{0, 0}, {1, 0}, {0.5, kH}}, down = {{1, 0}, {1.5, kH}, {0.5, kH}},
                rhombus = {{0, 0}, {1, 0}, {1.5, kH}, {0.5, kH}};
  switch (number) {
    case 2: {
      Builder b(1, kH, {1.5, kH}, {0, 2 * kH});
      b.add(0, regular({0.5, kH}, 6, 30));
      return b.finish();
    }
    case 3: {
      Builder b(2, kH / 3, {1, 0}, {0.5, kH});
      b.add(0, up);
      b.add(1, down);
      return b.finish();
    }
    case 4: {
      Builder b(1, kH / 2, {1, 0}, {0.5, kH});
      b.add(0, rhombus);
      return b.finish();
    }
    default: {
      Builder b(3, kH / 2, {0, 2 * kH}, {1.5, kH});
      b.add(0, rhombus);
      b.add(1, {{0, 0}, {0.5, kH}, {0, 2 * kH}, {-0.5, kH}});
      b.add(2, {{0.5, kH}, {1.5, kH}, {1, 2 * kH}, {0, 2 * kH}});
      return b.finish();
    }
  }
}

Tiling octagons_squares() {  // 7
  const double period = 1 + std::numbers::sqrt2;
  Builder b(2, 0.5, {period, 0}, {0, period});
  b.add(0, regular({period / 2, period / 2}, 4, 45));
  b.add(1, regular({0, 0}, 8, 0), 0, 0.500000000001);
  return b.finish();
}

Tiling squares_triangles() {  // 8
  Builder b(3, kH / 3, {1, 0}, {0.5, 1 + kH});
  b.add(2, rectangle(0, 0, 1, 1), 3.33e-8);
  b.add(0, {{0, 1}, {1, 1}, {0.5, 1 + kH}});
  b.add(1, {{1, 1}, {1.5, 1 + kH}, {0.5, 1 + kH}});
  return b.finish();
}

Tiling hexagons_triangles() {  // 9
  Builder b(3, kH / 3, {2, 0}, {1, 2 * kH});
  b.add(2, regular({0.5, kH}, 6, 30), 0, 2.0000001 / 3);
  b.add(0, {{-1, 0}, {0, 0}, {-0.5, kH}});
  b.add(1, {{-1, 2 * kH}, {0, 2 * kH}, {-0.5, kH}});
  return b.finish();
}

Tiling two_squares() {  // 15
  Builder b(2, 0.5, {2, 1}, {-1, 2});
  b.add(0, rectangle(0, 0, 1, 1));
  b.add(1, rectangle(1, -1, 2, 2), 1e-8);
  return b.finish();
}

Tiling plain_squares(double shift) {  // 1 and 10
  Builder b(1, 0.5, {1, 0}, {shift, 1});
  b.add(0, rectangle(0, 0, 1, 1));
  return b.finish();
}

Tiling build(int number) {
  switch (number) {
    case 1:
      return plain_squares(0);
    case 6:
      return oblongs({{0, 0}, {3, -1}, {1, 1}, {2, 2}}, {{1, 0}, {2, 1}, {-1, 2}, {0, 3}});
    case 7:
      return octagons_squares();
    case 8:
      return squares_triangles();
    case 9:
      return hexagons_triangles();
    case 10:
      return plain_squares(0.5);
    case 11:
    case 12:
      return squares_and_oblongs(number);
    case 13:
    case 14:
      return trapezoids(number);
    case 15:
      return two_squares();
    case 16:
    case 17:
      return hexagons_squares_triangles(number);
    case 18:
      return oblongs({{0, 0}, {1, 0}, {2, 2}, {3, 2}}, {{2, 0}, {2, 1}, {0, 2}, {0, 3}});
    case 19:
      return hexagons_in_triangles({4.5, kH}, {2.5, -kH});
    case 20:
      return hexagons_in_triangles({4.5, -kH}, {2.5, kH});
    case 21:
      return snub_square();
    case 22:
      return dodecagons_triangles();
    case 23:
    case 24:
      return dodecagons_hexagons_squares(number);
    default:
      return triangles_and_more(number);
  }
}

}  // namespace

const Tiling* periodic_tiling(int number) {
  static const std::array<Tiling, 24> tilings = [] {
    std::array<Tiling, 24> all;
    for (int n = 1; n <= 24; ++n) all[n - 1] = build(n);
    // Measured on quarter coordinates (spec 05 9.1): larger x, or larger z first.
    constexpr double kLean = 1e-13;
    for (const int n : {3, 6, 11, 12, 15, 18}) all[n - 1].lean = {kLean, kLean / 2};
    for (const int n : {5, 9}) all[n - 1].lean = {kLean / 8, kLean};
    for (const int n : {9, 11, 15}) all[n - 1].border = 1e-14;
    for (const int n : {16, 17, 22, 23, 24}) all[n - 1].border = kLean, all[n - 1].ranked = true;
    for (const int n : {22, 23, 24})
      for (Tile& tile : all[n - 1].tiles)
        if (tile.rank == 0) tile.rank = std::numeric_limits<int>::max();
    all[2].exchanged = true;
    for (const int n : {12, 13, 14}) all[n - 1].seams = n;
    for (const int n : {19, 20}) all[n - 1].border = kLean, all[n - 1].level_line = n;
    for (const int n : {6, 18}) all[n - 1].fold = 4;
    all[10].fold = 3, all[14].fold = 5;
    for (const int n : {5, 8}) all[n - 1].sided = true;
    for (int n = 1; n <= 24; ++n) all[n - 1].number = n;
    return all;
  }();
  return number >= 1 && number <= 24 ? &tilings[number - 1] : nullptr;
}

}  // namespace verisim::textures
