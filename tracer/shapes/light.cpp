// light_source and light_group among the objects: a light has no surface of its own, only that of its looks_like; a
// group is the sum of its children.
#include <algorithm>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {
namespace {

class LightHolder final : public Shape {
 public:
  LightHolder(const scene::Object& description, const std::vector<scene::ObjectPtr>& objects) : Shape(description) {
    for (const scene::ObjectPtr& o : objects)
      if (o) children_.push_back(compile(*o));
    for (const auto& child : children_) bounds_.extendBy(child->bounds());
  }
  void intersect_all(const Ray& ray, RayKind kind, HitList& hits) const override {
    for (const auto& child : children_) child->intersect_all(ray, kind, hits);
  }
  bool inside(const Vec3& p) const override {
    const bool all = object->inverted;  // of an inverted group the children are inverted, too
    for (const auto& child : children_)
      if (child->inside(p) != all) return !all;
    return all;
  }
  Vec3 normal(const Hit&) const override { return Vec3(0); }  // hits belong to the children
  Box3 bounds() const override { return bounds_; }
  bool may_stray() const override {
    return std::ranges::any_of(children_, [](const auto& child) { return child->may_stray(); });
  }
  bool strays(const Ray& ray) const override {
    return std::ranges::any_of(children_, [&](const auto& child) { return child->strays(ray); });
  }
  std::span<const std::unique_ptr<Shape>> children() const override { return children_; }

 private:
  std::vector<std::unique_ptr<Shape>> children_;
  Box3 bounds_;
};

}  // namespace

std::unique_ptr<Shape> compile_light_group(const scene::Object& object) {
  return std::make_unique<LightHolder>(object, scene::children_of(object));
}

std::unique_ptr<Shape> compile_light_source(const scene::Object& object) {
  return std::make_unique<LightHolder>(object,
                                       std::vector<scene::ObjectPtr>{object.as<scene::LightSource>()->looks_like});
}

}  // namespace verisim::shapes
