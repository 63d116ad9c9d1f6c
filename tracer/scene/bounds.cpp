#include "tracer/scene/bounds.h"

#include <algorithm>

#include "tracer/scene/complement.h"
#include "tracer/scene/extents.h"

namespace verisim::scene {

Bounds make_bounds(const Vec3& low, const Vec3& high) {
  Bounds b;
  for (int i = 0; i < 3; ++i) {
    b.low[i] = static_cast<float>(low[i]);
    b.size[i] = static_cast<float>(high[i] - low[i]);
  }
  return b;
}

Bounds unbounded() { return {}; }

Vec3 low_corner(const Bounds& b) { return {b.low[0], b.low[1], b.low[2]}; }
Vec3 high_corner(const Bounds& b) { return {b.low[0] + b.size[0], b.low[1] + b.size[1], b.low[2] + b.size[2]}; }
Vec3 far_corner(const Bounds& b) { return low_corner(b) + Vec3(b.size[0], b.size[1], b.size[2]); }
float volume(const Bounds& b) { return b.size[0] * b.size[1] * b.size[2]; }

Bounds transformed(const Bounds& b, const Transform& t) {
  // The least and greatest coordinates among the 8 transformed corners: rounding is monotonic, so the sums of the least
  // (greatest) terms are exactly those.
  const Vec3 a = low_corner(b);
  Vec3 c = a;
  for (int k = 0; k < 3; ++k) c[k] += static_cast<double>(b.size[k]);
  Vec3 low, high;
  for (int k = 0; k < 3; ++k) {
    const double x0 = a.x * t.m[0][k], x1 = c.x * t.m[0][k], y0 = a.y * t.m[1][k], y1 = c.y * t.m[1][k],
                 z0 = a.z * t.m[2][k], z1 = c.z * t.m[2][k];
    low[k] = std::max(std::min(x0, x1) + std::min(y0, y1) + std::min(z0, z1) + t.m[3][k], -kBoxLimit);
    high[k] = std::min(std::max(x0, x1) + std::max(y0, y1) + std::max(z0, z1) + t.m[3][k], kBoxLimit);
  }
  return make_bounds(low, high);
}

void BoxRange::clip(const Bounds& b) {
  const Vec3 l = low_corner(b), h = far_corner(b);
  for (int i = 0; i < 3; ++i) low[i] = std::max(low[i], l[i]), high[i] = std::min(high[i], h[i]);
}

bool bounds_are_removed(const Object& object) {
  if (object.bounded_by.empty() || object.as<Csg>() || object.as<Poly>() || object.as<LightGroup>() ||
      object.as<std::shared_ptr<const Text>>())
    return false;
  return object.automatic_box;
}

void clip_by_plane(const Object& object, BoxRange& range) {
  const Plane& plane = *object.as<Plane>();
  Vec3 n = plane.normal;
  double d = plane.distance;
  if (object.transform) {
    const Affine& m = object.transform->m;
    // POV-Ray multiplies by the transpose of the linear part, which is wrong for anything but rigid motions (spec
    // 03 5.6).
    const Vec3 k = plane.normal;
    n = {k.x * m[0][0] + k.y * m[0][1] + k.z * m[0][2], k.x * m[1][0] + k.y * m[1][1] + k.z * m[1][2],
         k.x * m[2][0] + k.y * m[2][1] + k.z * m[2][2]};
    const Vec3 p = object.transform->inverse_point(n);
    d = plane.distance - dot(p, n) + 1.0;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    if (std::fabs(n[i]) >= kEpsilon || std::fabs(n[j]) >= kEpsilon) continue;
    if (n[axis] > 0) range.high[axis] = std::min(range.high[axis], d);
    if (n[axis] < 0) range.low[axis] = std::max(range.low[axis], -d);
  }
}

namespace {

BoxRange intersection_range(std::vector<ObjectPtr>& children) {
  BoxRange box;
  for (const ObjectPtr& child : children) {
    if (child->as<Plane>())
      clip_by_plane(*child, box);
    else if (!is_complement(*child) && !child->as<Quadric>() && !child->as<std::shared_ptr<const HeightField>>())
      box.clip(child->bounds);
  }
  for (ObjectPtr& child : children) {
    if (!child->as<Quadric>() || child->inverted) continue;
    fit_quadric(const_cast<Object&>(*child), box);  // the tree is ours: see scene::copy
    box.clip(child->bounds);
  }
  return box;
}

}  // namespace

Bounds csg_bounds(Object& object) {
  BoxRange box;
  const Csg* csg = object.as<Csg>();
  if (csg && csg->kind == CsgKind::intersection) {
    box = intersection_range(own_children(object));
  } else {
    BoxUnion all;
    for (const ObjectPtr& child : children_of(object)) all.extend(child->bounds);  // a light is everywhere
    box = {all.low, all.high};
  }
  for (int i = 0; i < 3; ++i)
    if (box.high[i] < box.low[i] || box.high[i] - box.low[i] > kCriticalLength) return unbounded();
  const Bounds fitted = make_bounds(box.low, box.high);
  return volume(fitted) < volume(unbounded()) ? fitted : unbounded();
}

namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;  // clang 14 does not deduce it itself

Bounds from_box(const Box3& box) {
  Vec3 low, high;
  for (int i = 0; i < 3; ++i) low[i] = std::max(box.min[i], -kBoxLimit), high[i] = std::min(box.max[i], kBoxLimit);
  return make_bounds(low, high);
}

// Of its letters, each moved to its place, turned as one.
Bounds text_bounds(const Text& text) {
  BoxUnion all;
  for (const shapes::LetterBox& letter : shapes::letter_boxes(text))
    all.extend(transformed(from_box(letter.box), Transform::translation({letter.place.x, letter.place.y, 0})));
  return all.low.x > all.high.x ? unbounded() : transformed(all.bounds(), shapes::text_frame());
}

Bounds cone_bounds(const Cone& cone) { return from_box(shapes::cone_box(cone)); }

Bounds triangle_bounds(const std::array<Vec3, 3>& p) {
  const Vec3 n = cross(p[0] - p[1], p[2] - p[1]);
  if (length(n) == 0) return unbounded();
  Box3 box;
  for (const Vec3& v : p) box.extendBy(v);
  return make_bounds(box.min - Vec3(kEpsilon), box.max + Vec3(kEpsilon));
}

Bounds sweep_bounds(const SphereSweep& sweep) {
  Vec3 low(kBoxLimit), high(-kBoxLimit);
  const double factor = sweep.spline == SplineKind::cubic ? 2 : 1;
  for (std::size_t k = 0; k < sweep.centers.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], sweep.centers[k][i] - factor * sweep.radii[k]);
      high[i] = std::max(high[i], sweep.centers[k][i] + factor * sweep.radii[k]);
    }
  return make_bounds(low, high);
}

}  // namespace

Bounds local_bounds(const Object& object) {
  return std::visit(
      Overloaded{
          [](const auto& shape) {
            const Box3 box = shape.box();
            return make_bounds(box.min, box.max);
          },
          [](const Plane&) { return unbounded(); },
          [](const Cone& c) { return cone_bounds(c); },
          [](const Triangle& t) { return triangle_bounds(t.p); },
          [](const Boxed<SmoothTriangle>& t) { return triangle_bounds(t->p); },
          [](const Polygon& p) { return from_box(shapes::polygon_box(p)); },
          [](const Poly&) { return unbounded(); },
          [](const Boxed<Quadric>&) { return unbounded(); },
          [](const Ovus& o) { return from_box(shapes::ovus_box(o)); },
          [](const std::shared_ptr<const Blob>& b) { return from_box(shapes::blob_box(*b)); },
          [](const std::shared_ptr<const Lathe>& l) { return from_box(shapes::lathe_box(*l)); },
          [](const std::shared_ptr<const Sor>& s) { return from_box(shapes::sor_box(*s)); },
          [](const std::shared_ptr<const Prism>& p) { return from_box(shapes::prism_box(*p)); },
          [](const std::shared_ptr<const SphereSweep>& s) { return sweep_bounds(*s); },
          [](const std::shared_ptr<const BicubicPatch>& p) { return from_box(shapes::bicubic_patch_box(*p)); },
          [](const std::shared_ptr<const HeightField>& h) { return from_box(shapes::height_field_box(*h)); },
          [](const std::shared_ptr<const Isosurface>& i) { return from_box(shapes::isosurface_box(*i)); },
          [](const std::shared_ptr<const Parametric>& p) { return from_box(shapes::parametric_box(*p)); },
          [](const std::shared_ptr<const JuliaFractal>& j) { return from_box(shapes::julia_fractal_box(*j)); },
          [](const std::shared_ptr<const Text>& t) { return text_bounds(*t); },
          [](const Mesh& m) { return from_box(shapes::mesh_box(m)); },
          [](const Csg&) { return unbounded(); },
          [](const LightGroup&) { return unbounded(); },
          [](const Boxed<LightSource>&) { return unbounded(); },
      },
      object.shape);
}

}  // namespace verisim::scene
