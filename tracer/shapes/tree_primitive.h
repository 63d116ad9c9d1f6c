// The base of primitives that keep a BVH: rays of a shaft start where the shaft enters it.
//
// Beside what a Primitive writes, a shape `class Mesh final : public TreePrimitive<Mesh>` writes
//   template <class Sink> void intersections(const Ray& ray, Sink& sink, const accel::EntryPoints* entry = nullptr)
//   const; const accel::Bvh& tree() const;
// and, if its tree lives in another space than Primitive::local, turned() and to_tree().
#pragma once

#include "tracer/bvh/bvh.h"
#include "tracer/bvh/shaft.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

template <class Derived>
class TreePrimitive : public Primitive<Derived> {
 public:
  bool enter(const accel::Shaft& shaft, accel::EntryPoints& entry) const final {
    if (!derived().turned()) {
      derived().tree().enter(shaft, entry);
      return true;
    }
    const auto own = accel::Shaft::between(tree_box(shaft.from()), tree_box(shaft.to()));
    if (own) derived().tree().enter(*own, entry);
    return own.has_value();
  }
  bool intersect_from(const accel::EntryPoints& entry, const Ray& ray, RayKind, double t_min, double t_max,
                      Hit& hit) const final {
    return this->nearest_of(ray, t_min, t_max, hit, false,
                            [&](NearestHit& sink) { derived().intersections(ray, sink, &entry); });
  }
  bool occludes_from(const accel::EntryPoints& entry, const Ray& ray, double t_min, double t_max) const final {
    Hit hit;
    return this->nearest_of(ray, t_min, t_max, hit, true,
                            [&](NearestHit& sink) { derived().intersections(ray, sink, &entry); });
  }

  // Whether the tree's space is not the world, and where a point of the world lies in it.
  bool turned() const { return this->has_matrix(); }
  Vec3 to_tree(const Vec3& p) const { return this->local(p); }

 protected:
  using Primitive<Derived>::Primitive;

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
  Box3 tree_box(const Box3& box) const {
    Box3 result;
    for (int corner = 0; corner < 8; ++corner)
      result.extendBy(derived().to_tree(Vec3(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                                             corner & 4 ? box.max.z : box.min.z)));
    return result;
  }
};

}  // namespace verisim::shapes
