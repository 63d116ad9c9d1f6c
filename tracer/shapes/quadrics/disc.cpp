// disc (spec 03 4.6): lies in z = 0 of its frame; its inside is the half space behind it, whatever its radius.
#include "tracer/shapes/factories.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-6, kFarthest = 1e7;

class Disc final : public Primitive<Disc> {
 public:
  Disc(const scene::Object& description, const scene::Disc& d)
      : Primitive(description, {Box3(Vec3(-d.radius, -d.radius, -1e-9), Vec3(d.radius, d.radius, 1e-9)), false}),
        hole2_(d.hole * d.hole),
        radius2_(d.radius * d.radius),
        normal_(d.normal) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    if (!(std::fabs(l.direction.z) > kEpsilon)) return;
    const double t = -l.origin.z / l.direction.z, depth = t / l.scale;
    if (!(depth > kNearest && depth < kFarthest)) return;
    const double x = l.origin.x + t * l.direction.x, y = l.origin.y + t * l.direction.y, r2 = x * x + y * y;
    if (r2 >= hole2_ && r2 <= radius2_) sink.add(depth, [&] { return ray.origin + depth * ray.direction; });
  }

  bool contains(const Vec3& p) const { return local(p).z < 0; }
  Vec3 geometric_normal(const Hit&) const { return normal_; }

 private:
  double hole2_, radius2_;
  Vec3 normal_;  // in the world
};

}  // namespace

Transform disc_frame(const scene::Disc& d) { return frame_along(d.center, d.normal, 1, 1); }

std::unique_ptr<Shape> compile_disc(const scene::Object& object) {
  scene::Disc disc = *object.as<scene::Disc>();
  if (!object.transform) disc.normal = normalize(disc.normal);
  return compile_in_frame<Disc>(object, disc, disc_frame);
}

}  // namespace verisim::shapes
