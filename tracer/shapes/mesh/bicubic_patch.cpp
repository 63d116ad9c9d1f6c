// bicubic_patch (spec 04 section 4): the patch is halved until flat or deep enough; its leaves are two triangles each,
// kept in a BVH. Types 0 and 1 differ in POV-Ray only by what they store.
#include <stdexcept>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/tree_primitive.h"

namespace verisim::shapes {

namespace {

constexpr double kNearest = 1e-5;
constexpr std::size_t kMaxLeaves = 1u << 21;  // of some 300 bytes
constexpr int kMaxDepth = 48;                 // halvings after which floating point has no finer steps

using Points = std::array<Vec3, 16>;  // row major: index 4 * row + column

// Halves one curve of four points: `first` and `second` are its parts.
void halve(const Vec3 (&p)[4], Vec3 (&first)[4], Vec3 (&second)[4]) {
  const Vec3 a = (p[0] + p[1]) / 2, b = (p[1] + p[2]) / 2, c = (p[2] + p[3]) / 2, d = (a + b) / 2, e = (b + c) / 2,
             m = (d + e) / 2;
  first[0] = p[0], first[1] = a, first[2] = d, first[3] = m;
  second[0] = m, second[1] = e, second[2] = c, second[3] = p[3];
}

void halve(const Points& p, bool rows, Points& first, Points& second) {
  for (std::size_t line = 0; line < 4; ++line) {
    const auto at = [&](std::size_t k) { return rows ? 4 * k + line : 4 * line + k; };
    const Vec3 curve[4] = {p[at(0)], p[at(1)], p[at(2)], p[at(3)]};
    Vec3 a[4], b[4];
    halve(curve, a, b);
    for (std::size_t k = 0; k < 4; ++k) first[at(k)] = a[k], second[at(k)] = b[k];
  }
}

bool flat_enough(const Points& p, double flatness) {
  const Vec3& a = p[0];
  Vec3 b = p[3];
  const Vec3& c = p[12];
  if (length(a - b) < kEpsilon) {
    b = p[15];
    if (length(a - b) < kEpsilon) return false;
  }
  if (length(b - c) < kEpsilon) return false;
  const Vec3 u = a - b, v = c - b, n = cross(u, v);
  const double n2 = dot(n, n);
  if (n2 <= 1e-10 * dot(u, u) * dot(v, v)) return false;
  const Vec3 unit = n / std::sqrt(n2);
  double largest = 0;
  for (const Vec3& q : p) largest = std::max(largest, std::fabs(dot(unit, q - a)));
  return largest < flatness;
}

// Rows run with s, columns with r.
struct Range {
  double s0, s1, r0, r1;
};

// As POV-Ray keeps it, to the last bit (spec 08 B): a point P of its plane is p + a (q - p) + b (s - p) with
// a = (P - p).to_a, b = (P - p).to_b.
struct FlatPiece {
  Vec3 to_a, to_b, normal;  // columns of the inverse of the rows q - p, s - p, and the unit normal; 0: a degenerate one

  FlatPiece(const Vec3& p, const Vec3& q, const Vec3& s) : to_a(0.0), to_b(0.0), normal(0.0) {
    const Vec3 e1 = q - p, e2 = s - p, n = cross(e1, e2);
    if (!(dot(n, n) > 1e-10 * dot(e1, e1) * dot(e2, e2))) return;
    const Vec3 unit = normalize(n);
    const double determinant = e1.x * e2.y * unit.z + e1.y * e2.z * unit.x + e1.z * e2.x * unit.y -
                               e1.z * e2.y * unit.x - e1.x * e2.z * unit.y - e1.y * e2.x * unit.z;
    const double by = 1 / determinant;
    to_a = cross(e2, unit) * by, to_b = cross(unit, e1) * by, normal = n * by;
  }
};

struct Leaf {
  Vec3 first;           // the corner 00, which both triangles have
  FlatPiece pieces[2];  // 00, 03, 33 and 00, 33, 30
  Vec3 normal[4];       // of the whole patch at 00, 03, 33, 30
  Range range;
};

// Halves a patch until its pieces are flat or deep enough; visit(points, range) -> bool for each of those, false ends
// it all. False: it ended early.
template <class Visit>
bool subdivide(const scene::BicubicPatch& patch, const Points& p, const Range& range, int depth, Visit&& visit) {
  const bool deep_s = depth >= patch.u_steps || depth >= kMaxDepth,
             deep_r = depth >= patch.v_steps || depth >= kMaxDepth;
  if ((deep_s && deep_r) || flat_enough(p, patch.flatness)) return visit(p, range);
  const double s = (range.s0 + range.s1) / 2, r = (range.r0 + range.r1) / 2;
  const auto columns = [&](const Points& q, double s0, double s1) {
    if (deep_r) return subdivide(patch, q, {s0, s1, range.r0, range.r1}, depth + 1, visit);
    Points left, right;
    halve(q, false, left, right);
    return subdivide(patch, left, {s0, s1, range.r0, r}, depth + 1, visit) &&
           subdivide(patch, right, {s0, s1, r, range.r1}, depth + 1, visit);
  };
  if (deep_s) return columns(p, range.s0, range.s1);
  Points first, second;
  halve(p, true, first, second);
  return columns(first, range.s0, s) && columns(second, s, range.s1);
}

class BicubicPatch final : public TreePrimitive<BicubicPatch> {
 public:
  BicubicPatch(const scene::Object& description, const scene::BicubicPatch& patch)
      : TreePrimitive(description, {bicubic_patch_box(patch), true}), points_(patch.points), uv_(patch.uv) {
    std::vector<Box3> boxes;
    const bool fits = subdivide(patch, points_, {0, 1, 0, 1}, 0, [&](const Points& p, const Range& range) {
      const auto& [s0, s1, r0, r1] = range;
      Box3 box(p[0]);
      for (const std::size_t corner : {3, 15, 12}) box.extendBy(p[corner]);
      boxes.push_back(box);
      leaves_.push_back({p[0],
                         {{p[0], p[3], p[15]}, {p[0], p[15], p[12]}},
                         {exact_normal(s0, r0), exact_normal(s0, r1), exact_normal(s1, r1), exact_normal(s1, r0)},
                         range});
      return leaves_.size() <= kMaxLeaves;
    });
    if (!fits) throw std::runtime_error("bicubic_patch: too many pieces");
    tree_ = accel::Bvh(
        leaves_.size(), [&](std::size_t i) { return boxes[i]; }, 2);
    std::vector<Leaf> sorted;
    sorted.reserve(tree_.order().size());
    for (const std::uint32_t i : tree_.order()) sorted.push_back(leaves_[i]);
    leaves_ = std::move(sorted);
  }

  const accel::Bvh& tree() const { return tree_; }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink, const accel::EntryPoints* entry = nullptr) const {
    const LocalRay r = local(ray);
    const auto limit = [&] { return sink.upper() * r.scale * (1 + 1e-12); };
    tree_.traverse_leaves(
        {r.origin, r.direction}, 0, limit(),
        [&](std::uint32_t first, std::uint32_t count, double) {
          for (std::uint32_t i = first; i < first + count; ++i) {
            for (int half = 0; half < 2; ++half) triangle(i, half, ray, r, sink);
          }
          return limit();
        },
        entry);
  }

  bool contains(const Vec3&) const { return false; }
  bool formula(const Vec3&) const { return false; }

  Vec3 geometric_normal(const Hit& hit) const {
    const Leaf& leaf = leaves_[static_cast<std::size_t>(hit.part) / 2];
    const bool second = hit.part % 2 != 0;
    const Vec3 n = (1 - hit.u - hit.v) * leaf.normal[0] + hit.u * leaf.normal[second ? 2 : 1] +
                   hit.v * leaf.normal[second ? 3 : 2];
    if (dot(n, n) <= kEpsilon) return world_normal({1, 0, 0});
    return world_normal(n);
  }

  Vec2 uv(const Hit& hit) const override {
    const Range& range = leaves_[static_cast<std::size_t>(hit.part) / 2].range;
    const bool second = hit.part % 2 != 0;
    const double w = 1 - hit.u - hit.v;
    const double s = w * range.s0 + hit.u * (second ? range.s1 : range.s0) + hit.v * range.s1;
    const double r = w * range.r0 + hit.u * range.r1 + hit.v * (second ? range.r0 : range.r1);
    if (!uv_) return {r, s};
    const auto& c = *uv_;
    const Vec2 bottom = c[0] + r * (c[1] - c[0]), top = c[3] + r * (c[2] - c[3]);
    return bottom + s * (top - bottom);
  }

 private:
  template <class Sink>
  void triangle(std::uint32_t i, int half, const Ray& ray, const LocalRay& r, Sink& sink) const {
    const Leaf& leaf = leaves_[i];
    const FlatPiece& piece = leaf.pieces[half];
    const double slope = dot(r.direction, piece.normal);
    if (!(std::fabs(slope) >= kEpsilon)) return;
    const double t = dot(leaf.first - r.origin, piece.normal) / slope, world_t = t / r.scale;
    if (!(world_t >= kNearest && world_t <= sink.upper())) return;
    const Vec3 x = r.origin + t * r.direction - leaf.first;
    const double a = dot(x, piece.to_a), b = dot(x, piece.to_b);
    if (!(a >= 0 && b >= 0 && a + b <= 1)) return;
    sink.add(
        world_t, [&] { return ray.at(world_t); }, static_cast<std::int32_t>(2 * i) + half, a, b);
  }

  // dP/ds x dP/dr of the whole patch.
  Vec3 exact_normal(double s, double r) const {
    const auto basis = [](double t, double(&value)[4], double(&slope)[4]) {
      const double u = 1 - t;
      value[0] = u * u * u, value[1] = 3 * t * u * u, value[2] = 3 * t * t * u, value[3] = t * t * t;
      slope[0] = -3 * u * u, slope[1] = 3 * u * u - 6 * t * u, slope[2] = 6 * t * u - 3 * t * t, slope[3] = 3 * t * t;
    };
    double bs[4], ds[4], br[4], dr[4];
    basis(s, bs, ds), basis(r, br, dr);
    Vec3 along_s(0, 0, 0), along_r(0, 0, 0);
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        const Vec3& p = points_[4 * row + column];
        along_s += ds[row] * br[column] * p;
        along_r += bs[row] * dr[column] * p;
      }
    }
    const Vec3 n = cross(along_s, along_r);
    const double n2 = dot(n, n);
    if (n2 <= 1e-10 * dot(along_s, along_s) * dot(along_r, along_r)) return {1, 0, 0};
    return normalize(n);
  }

  Points points_;
  std::optional<std::array<Vec2, 4>> uv_;
  std::vector<Leaf> leaves_;  // in the tree's order
  accel::Bvh tree_;
};

}  // namespace

std::unique_ptr<Shape> compile_bicubic_patch(const scene::Object& object) {
  const auto& patch = **object.as<std::shared_ptr<const scene::BicubicPatch>>();
  if (object.clipped_by.empty()) return std::make_unique<BicubicPatch>(object, patch);
  // POV-Ray ignores clipped_by on patches (spec 04 section 4).
  scene::Object unclipped = object;
  unclipped.clipped_by.clear();
  auto shape = std::make_unique<BicubicPatch>(unclipped, patch);
  shape->object = &object;
  return shape;
}

bool bicubic_patch_fits(const scene::BicubicPatch& patch) {
  if (patch.u_steps <= 10 && patch.v_steps <= 10) return true;
  std::size_t leaves = 0;
  return subdivide(patch, patch.points, {0, 1, 0, 1}, 0,
                   [&](const Points&, const Range&) { return ++leaves <= kMaxLeaves; });
}

Box3 bicubic_patch_box(const scene::BicubicPatch& patch) {
  Box3 box;
  for (const Vec3& p : patch.points) box.extendBy(p);
  return box;
}

}  // namespace verisim::shapes
