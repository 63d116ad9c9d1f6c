// From a description to a shape: one entry per kind of object.
#include <stdexcept>

#include "tracer/scene/bounds.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {
namespace {

std::unique_ptr<Shape> dispatch(const scene::Object& object) {
  using namespace scene;
  struct Factory {
    const Object& o;
#define VERISIM_SHAPE(held, name) \
  std::unique_ptr<shapes::Shape> operator()(const held&) const { return compile_##name(o); }
    VERISIM_SHAPES(VERISIM_SHAPE)
#undef VERISIM_SHAPE
  };
  return std::visit(Factory{object}, object.shape);
}

}  // namespace

std::unique_ptr<Shape> compile(const scene::Object& object, const CompileOptions& options) {
  if (!options.remove_bounds || !scene::bounds_are_removed(object)) return dispatch(object);
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
