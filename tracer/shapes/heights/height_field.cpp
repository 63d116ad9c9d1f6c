// height_field (spec 04 section 5): two triangles per cell, found by descending a pyramid of extremes from near to far.
#include <bit>
#include <cmath>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/heights/height_packet.h"
#include "tracer/shapes/heights/height_walk.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

namespace {

constexpr double kNearest = kHeightFieldNearest, kEdge = kHeightFieldEdge;
// Hits that are refused for being near are not beyond this: where light must lie *above* the tolerance of shadows, that
// is the number after 0.001.
const double kMaxTolerance = std::nextafter(1e-3, 1.0);

class HeightField final : public Primitive<HeightField> {
 public:
  HeightField(const scene::Object& description, const std::shared_ptr<const scene::HeightField>& field)
      : HeightField(description, HeightGrid::of(field)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    if (grid_->empty()) return;
    // The ray in grid units, as the matrix has them; distances stay world distances.
    const Vec3 o = matrix().inverse_point(ray.origin), d = matrix().inverse_direction(ray.direction);
    const double low[3] = {0, grid_->bottom(), 0}, high[3] = {grid_->width() - 1.0, grid_->top(), grid_->depth() - 1.0};
    double enter = kNearest, leave = 1e300;
    for (int k = 0; k < 3; ++k) {
      if (d[k] == 0) {
        if (!(o[k] >= low[k] && o[k] <= high[k])) return;
        continue;
      }
      const double a = (low[k] - o[k]) / d[k], b = (high[k] - o[k]) / d[k];
      enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave)) return;

    descend(ray, o, d, enter, leave, sink);
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (guards() || grid_->empty()) return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    return nearest_of_packet(rays, t_min, t_max, hits);
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (guards() || grid_->empty()) return Shape::occludes_packet(rays, entry, t_min, t_max);
    return nearest_of_packet(rays, t_min, t_max, nullptr);
  }

  // Below the surface, down to minus infinity.
  bool contains(const Vec3& world_point) const {
    if (grid_->empty()) return false;
    const Vec3 p = local(world_point);
    const double x = p.x, y = p.y, z = p.z;
    if (!(x >= 0 && x < grid_->width() - 1 && z >= 0 && z < grid_->depth() - 1 && y < grid_->top())) return false;
    if (y < grid_->bottom()) return true;
    const int i = static_cast<int>(x), k = static_cast<int>(z);
    const double a = x - i, b = z - k;
    const auto h = [&](int di, int dk) { return std::max<double>(grid_->at(i + di, k + dk), grid_->water()); };
    const bool first = a + b < 1;
    const Vec3 up = first ? Vec3(h(0, 0) - h(1, 0), 1, h(0, 0) - h(0, 1))
                          : Vec3(h(0, 1) - h(1, 1), 1, h(1, 0) - h(1, 1)),
               corner = first ? Vec3(i, h(0, 0), k) : Vec3(i + 1, h(1, 1), k + 1);
    return dot(up, p) < dot(up, corner);
  }

  Vec3 geometric_normal(const Hit& hit) const {
    if (!grid_->smooth()) return world_normal(facet(static_cast<int>(hit.u), static_cast<int>(hit.v), hit.part));
    const Vec3 p = local(hit.point);
    const int i = std::clamp(static_cast<int>(p.x), 0, grid_->width() - 2),
              k = std::clamp(static_cast<int>(p.z), 0, grid_->depth() - 2);
    const double a = p.x - i, b = p.z - k;
    const auto corner = [&](int di, int dk) { return world_normal(grid_->smooth_normal(i + di, k + dk)); };
    return normalize((1 - b) * ((1 - a) * corner(0, 0) + a * corner(1, 0)) +
                     b * ((1 - a) * corner(0, 1) + a * corner(1, 1)));
  }

 private:
  HeightField(const scene::Object& description, std::shared_ptr<const HeightGrid> grid)
      : Primitive(description, {grid_box(grid->width() - 1, grid->depth() - 1, {grid->bottom(), grid->top()}), false}),
        hierarchy_(description.hierarchy),
        grid_(std::move(grid)) {}

 public:
  void join_csg() override { in_csg_ = true; }
  static Box3 grid_box(double cells_x, double cells_z, const HeightGrid::Limits& limits) {
    return Box3({0, limits.bottom, 0}, {cells_x, limits.top, cells_z});
  }

 private:
  // Normal of a cell's triangle (0: at the near corner, 1: at the far one) in grid units.
  Vec3 facet(int i, int k, int triangle) const {
    const double h10 = grid_->at(i + 1, k), h01 = grid_->at(i, k + 1);
    if (triangle == 0) {
      const double h00 = grid_->at(i, k);
      return {h00 - h10, 1, h00 - h01};
    }
    const double h11 = grid_->at(i + 1, k + 1);
    return {h01 - h11, 1, h10 - h11};
  }

  // Outside CSG the search ends at the first cell on the ray's way that has a hit, even if that is refused for being
  // too near, and even if the next cell has a nearer one within the edges' tolerance (spec 04 5.2).
  bool ends_at_first_cell(double t_min) const { return !in_csg_ && t_min <= kMaxTolerance; }

  // The hits of several rays; null: whether there are any.
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, Hit* hits) const {
    const HeightPacketKernels& kernels = height_packet_kernels();
    HeightPacket packet;
    unsigned found = 0, rest = kernels.enter(*grid_, matrix(), rays, packet);
    const auto quadrant = [&](int k) { return (packet.dx[k] < 0 ? 1 : 0) | (packet.dz[k] < 0 ? 2 : 0); };
    while (rest != 0) {
      const int one = std::countr_zero(rest);
      unsigned group = 0;
      each_lane(rest, [&](int k) { group |= quadrant(k) == quadrant(one) ? 1u << k : 0; });
      rest &= ~group;
      const auto alone = [&](int k) {
        Hit hit;
        NearestHit sink(*this, nullptr, t_min, t_max[k], hits ? hits[k] : hit, !hits);
        const Vec3 o(packet.ox[k], packet.oy[k], packet.oz[k]), d(packet.dx[k], packet.dy[k], packet.dz[k]);
        descend(rays.at(k), o, d, packet.enter[k], packet.leave[k], sink);
        found |= sink.found() ? 1u << k : 0;
      };
      const bool first_cell = ends_at_first_cell(t_min);
      const double from = first_cell ? kNearest : t_min;
      if (std::has_single_bit(group) || !kernels.walk(*grid_, group, from, t_max, !hits, packet)) {
        each_lane(group, alone);
        continue;
      }
      each_lane(group, [&](int k) {
        if (packet.triangle[k] < 0) return;
        if ((first_cell && packet.t[k] < t_min) || near_edge(packet, k)) {
          alone(k);
          return;
        }
        found |= 1u << k;
        if (hits)
          hits[k] = {
              packet.t[k],         rays.at(k).at(packet.t[k]), this, static_cast<std::int32_t>(packet.triangle[k]),
              double(packet.i[k]), double(packet.k[k])};
      });
    }
    return found;
  }

  // Another triangle may have this hit or one beside it within its tolerance.
  static bool near_edge(const HeightPacket& p, int k) {
    return edge_distance(p.ox[k] + p.t[k] * p.dx[k] - static_cast<double>(p.i[k]),
                         p.oz[k] + p.t[k] * p.dz[k] - static_cast<double>(p.k[k])) < 2 * kEdge;
  }

  // Tests the cells between `enter` and `leave` whose heights the ray may meet, roughly from near to far.
  template <class Sink>
  void descend(const Ray& ray, const Vec3& o, const Vec3& d, double enter, double leave, Sink& sink) const {
    if constexpr (Sink::kNearest)
      if (ends_at_first_cell(sink.lower())) return descend_to_first_cell(ray, o, d, enter, leave, sink);
    float end = above_of(std::min(leave, sink.upper()));
    HeightWalk walk(*grid_, o, d, enter, std::min(leave, sink.upper()));
    HeightCell cells[HeightWalk::kCells];
    while (const int count = walk.next(end, cells)) {
      for (int n = 0; n < count; ++n) {
        if (cells[n].near <= end && cell(cells[n].i, cells[n].k, ray, o, d, enter, leave, sink))
          end = above_of(std::min(leave, sink.upper()));
      }
    }
  }
  static float above_of(double v) { return static_cast<float>(v + std::fabs(v) * 1e-6); }

  template <class Sink>
  void descend_to_first_cell(const Ray& ray, const Vec3& o, const Vec3& d, double enter, double leave,
                             Sink& sink) const {
    const double limit = std::min(leave, sink.upper());
    float end = above_of(limit);
    double first = HUGE_VAL;
    int i = 0, k = 0;
    HeightWalk walk(*grid_, o, d, enter, limit);
    HeightCell cells[HeightWalk::kCells];
    while (const int count = walk.next(end, cells)) {
      for (int n = 0; n < count; ++n) {
        if (!(cells[n].near <= end)) continue;
        bool any = false;
        each_hit(cells[n].i, cells[n].k, o, d, enter, leave,
                 [&](double t, int) { any = any || !sink.clipped(ray.at(t)); });
        if (!any) continue;
        const Interval within = in_cell(cells[n].i, cells[n].k, o, d, enter);
        const double entry = within.from;
        if (!within.empty() && entry < first)
          first = entry, i = cells[n].i, k = cells[n].k, end = above_of(std::min(limit, entry));
      }
    }
    if (first < HUGE_VAL) cell(i, k, ray, o, d, enter, leave, sink);
  }

  // A part of a ray.
  struct Interval {
    double from, to;
    bool empty() const { return !(from <= to); }
    void cut(double low, double high, double origin, double along) {
      const double a = (low - origin) / along, b = (high - origin) / along;
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    // Whether it has heights within a range.
    bool reaches(double low, double high, double y, double dy) const {
      const double a = y + from * dy, b = y + to * dy;
      return std::max(a, b) >= low && std::min(a, b) <= high;
    }
  };
  static constexpr double kFar = 1e300;
  // What is within a cell.
  Interval in_cell(int i, int k, const Vec3& o, const Vec3& d, double enter) const {
    Interval within{enter, kFar};
    const auto narrow = [&](double low, double origin, double along, int cells) {
      if (along != 0)
        within.cut(low, low + 1, origin, along);
      else if (std::clamp(std::floor(origin), 0.0, cells - 1.0) != low)
        within.to = -kFar;
    };
    narrow(i, o.x, d.x, grid_->width() - 1), narrow(k, o.z, d.z, grid_->depth() - 1);
    return within;
  }

  // hit(t, triangle) for those of a cell's triangles that the ray meets.
  template <class Hit>
  void each_hit(int i, int k, const Vec3& o, const Vec3& d, double enter, double leave, Hit&& hit) const {
    const double h00 = grid_->at(i, k), h10 = grid_->at(i + 1, k), h01 = grid_->at(i, k + 1),
                 h11 = grid_->at(i + 1, k + 1);
    for (int triangle = 0; triangle < 2; ++triangle) {
      const Vec3 n = triangle == 0 ? Vec3(h00 - h10, 1, h00 - h01) : Vec3(h01 - h11, 1, h10 - h11);
      const double nd = dot(n, d);
      if (!(std::fabs(nd) > kEpsilon)) continue;
      const Vec3 corner(i + triangle, triangle == 0 ? h00 : h11, k + triangle);
      const double t = dot(n, corner - o) / nd;
      if (!(t >= enter && t <= leave)) continue;
      const double a = o.x + t * d.x - i, b = o.z + t * d.z - k;
      const bool in = triangle == 0 ? a >= -kEdge && b >= -kEdge && a + b <= 1 + kEdge
                                    : a <= 1 + kEdge && b <= 1 + kEdge && a + b >= 1 - kEdge;
      if (!in) continue;
      if (inside_by(triangle, a, b) < kSurelyInside) {
        const double h = triangle == 0 ? h00 : h11;
        if (!is_searched(i, k, o, d, enter, leave, std::min(h, std::min(h10, h01)), std::max(h, std::max(h10, h01))))
          continue;
      }
      hit(t, triangle);
    }
  }

  // How far a place within a cell is from the triangles' edges.
  static double edge_distance(double a, double b) {
    return std::min(std::min(std::min(a, 1 - a), std::min(b, 1 - b)), std::fabs(a + b - 1));
  }
  // How far it is within a triangle.
  static double inside_by(int triangle, double a, double b) {
    return triangle == 0 ? std::min(std::min(a, b), 1 - a - b) : std::min(std::min(1 - a, 1 - b), a + b - 1);
  }

  // What lies just beyond a triangle's edge counts only where POV-Ray's search comes to it: where the ray passes
  // through the cell, is somewhere between the triangle's lowest and highest corner while it is in the cell's column
  // across its main direction, and likewise in a block of cells (spec 04 5.2). What is hit inside of the edges fulfils
  // all that.
  static constexpr double kSurelyInside = 1e-6;
  bool is_searched(int i, int k, const Vec3& o, const Vec3& d, double enter, double leave, double low,
                   double high) const {
    if (in_cell(i, k, o, d, enter).empty()) return false;
    Interval column{-kFar, kFar};
    const bool along_x = std::fabs(d.x) >= std::fabs(d.z);
    if (along_x && d.x != 0) column.cut(i, i + 1, o.x, d.x);
    if (!along_x) column.cut(k, k + 1, o.z, d.z);
    if (!column.reaches(low, high, o.y, d.y)) return false;
    if (!hierarchy_) return true;
    const HeightGrid::SearchBlock& block = grid_->search_block(i, k);
    Interval within{enter, leave};
    // A ray that goes back leaves a block a cell later than it seems.
    if (d.x != 0) within.cut(block.x0 - (d.x < 0), block.x1, o.x, d.x);
    if (d.z != 0) within.cut(block.z0 - (d.z < 0), block.z1, o.z, d.z);
    return within.reaches(block.low - 0.001, block.high + 0.001, o.y, d.y);
  }

  // True: a hit was accepted.
  template <class Sink>
  bool cell(int i, int k, const Ray& ray, const Vec3& o, const Vec3& d, double enter, double leave, Sink& sink) const {
    bool any = false;
    each_hit(i, k, o, d, enter, leave, [&](double t, int triangle) {
      any |= sink.add(
          t, [&] { return ray.at(t); }, triangle, i, k);
    });
    return any;
  }

  bool in_csg_ = false;
  const bool hierarchy_;
  std::shared_ptr<const HeightGrid> grid_;
};

}  // namespace

std::unique_ptr<Shape> compile_height_field(const scene::Object& object) {
  return compile_in_frame<HeightField>(object, *object.as<std::shared_ptr<const scene::HeightField>>(),
                                       [](const auto& field) { return height_field_frame(*field); });
}
Box3 height_field_box(const scene::HeightField& field) {
  const HeightGrid::Cells cells = HeightGrid::cells(field);
  return HeightField::grid_box(cells.x, cells.z, HeightGrid::limits(field));
}
Transform height_field_frame(const scene::HeightField& field) {
  const HeightGrid::Cells cells = HeightGrid::cells(field);
  return Transform::scaling({1 / cells.x, 1 / 65536.0, 1 / cells.z});
}

}  // namespace verisim::shapes
