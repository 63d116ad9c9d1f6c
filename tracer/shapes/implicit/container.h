// contained_by of isosurface and parametric: a box or a sphere that limits the search (spec 04 6.1).
#pragma once

#include "tracer/scene/object.h"

namespace verisim::shapes {

// The interval of a ray inside the container. Faces: 0 none, 1..6 = -x +x -y +y -z +z of the box, 7 the sphere.
struct ContainerSpan {
  double enter = 0, leave = 0;
  int enter_face = 0, leave_face = 0;
};

// False: the ray misses. The direction need not have unit length; distances are in its units. A box clamps `enter` to
// 0, a sphere gives it negative when the ray starts inside.
bool intersect_container(const scene::Contained& container, const Vec3& origin, const Vec3& direction,
                         ContainerSpan& span);
// Points on the surface belong to the container.
bool in_container(const scene::Contained& container, const Vec3& p);
// Outward unit normal of a face at p.
Vec3 container_normal(const scene::Contained& container, int face, const Vec3& p);
Box3 container_box(const scene::Contained& container);

}  // namespace verisim::shapes
