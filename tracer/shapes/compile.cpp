// From a description to a shape: one entry per kind of object.
#include <stdexcept>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;  // clang 14 does not deduce it itself

std::unique_ptr<Shape> dispatch(const scene::Object& object) {
  using namespace scene;
  const Object& o = object;
  return std::visit(Overloaded{
                        [&](const Sphere&) { return compile_sphere(o); },
                        [&](const Box&) { return compile_box(o); },
                        [&](const Plane&) { return compile_plane(o); },
                        [&](const Cone&) { return compile_cone(o); },
                        [&](const Torus&) { return compile_torus(o); },
                        [&](const Disc&) { return compile_disc(o); },
                        [&](const Triangle&) { return compile_triangle(o); },
                        [&](const Boxed<SmoothTriangle>&) { return compile_smooth_triangle(o); },
                        [&](const Polygon&) { return compile_polygon(o); },
                        [&](const Poly&) { return compile_poly(o); },
                        [&](const Boxed<Quadric>&) { return compile_quadric(o); },
                        [&](const Superellipsoid&) { return compile_superellipsoid(o); },
                        [&](const Ovus&) { return compile_ovus(o); },
                        [&](const std::shared_ptr<const Blob>&) { return compile_blob(o); },
                        [&](const std::shared_ptr<const Lathe>&) { return compile_lathe(o); },
                        [&](const std::shared_ptr<const Sor>&) { return compile_sor(o); },
                        [&](const std::shared_ptr<const Prism>&) { return compile_prism(o); },
                        [&](const std::shared_ptr<const SphereSweep>&) { return compile_sphere_sweep(o); },
                        [&](const std::shared_ptr<const BicubicPatch>&) { return compile_bicubic_patch(o); },
                        [&](const std::shared_ptr<const HeightField>&) { return compile_height_field(o); },
                        [&](const std::shared_ptr<const Isosurface>&) { return compile_isosurface(o); },
                        [&](const std::shared_ptr<const Parametric>&) { return compile_parametric(o); },
                        [&](const std::shared_ptr<const JuliaFractal>&) { return compile_julia_fractal(o); },
                        [&](const std::shared_ptr<const Text>&) { return compile_text(o); },
                        [&](const Mesh&) { return compile_mesh(o); },
                        [&](const Csg&) { return compile_csg(o); },
                        [&](const LightGroup&) { return compile_light(o); },
                        [&](const Boxed<LightSource>&) { return compile_light(o); },
                    },
                    object.shape);
}

// POV-Ray says "Unnecessary bounding object removed." for these at frame level (spec 03 6.2).
bool bounds_are_removed(const scene::Object& object) {
  if (object.bounded_by.empty() || object.as<scene::Csg>() || object.as<scene::Poly>() ||
      object.as<scene::LightGroup>())
    return false;
  if (object.as<std::shared_ptr<const scene::Text>>()) return false;
  return !(object.as<scene::Quadric>() && scene::is_infinite(object));
}

}  // namespace

std::unique_ptr<Shape> compile(const scene::Object& object, const CompileOptions& options) {
  if (!options.remove_bounds || !bounds_are_removed(object)) return dispatch(object);
  scene::Object unbounded = object;
  unbounded.bounded_by.clear();
  std::unique_ptr<Shape> shape = dispatch(unbounded);
  shape->object = &object;
  return shape;
}

}  // namespace verisim::shapes

namespace verisim::scene {

std::shared_ptr<const Solid> compile_solid(const Object& object) { return shapes::compile(object); }

}  // namespace verisim::scene
