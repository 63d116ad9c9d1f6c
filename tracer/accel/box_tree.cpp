#include "tracer/accel/box_tree.h"

#include <cmath>
#include <limits>

#include "tracer/accel/device.h"

namespace verisim::accel {
namespace {

constexpr std::size_t kFewBoxes = 4;
// Of the half diagonal of everything: what rounding a ray to binary32 and following it across the volume can amount to, several times over.
constexpr double kSlack = 2e-6;

float down(double v) {
  const float f = static_cast<float>(v);
  return f <= v ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
float up(double v) {
  const float f = static_cast<float>(v);
  return f >= v ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

}  // namespace

struct BoxTree::Embree {
  RTCScene scene = nullptr;
  Vec3 center;
  double slack = 0;
  const Box3* boxes = nullptr;

  ~Embree() {
    if (scene) rtcReleaseScene(scene);
  }
};

namespace {

struct Context {
  RTCIntersectContext base;  // first: Embree hands a pointer to it back
  double (*visitor)(void*, std::uint32_t, double);
  void* state;
  double offset, slack, t_max;
};

void intersect_function(const RTCIntersectFunctionNArguments* args) {
  if (!args->valid[0]) return;
  Context& context = *reinterpret_cast<Context*>(args->context);
  const double limit = context.visitor(context.state, args->primID, context.t_max);
  if (limit < context.t_max) {
    context.t_max = limit;
    RTCRayHit& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    rayhit.ray.tfar = limit == -HUGE_VAL ? -std::numeric_limits<float>::infinity() : up(limit - context.offset + context.slack);
  }
}

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) : boxes_(std::make_unique<Box3[]>(boxes.size())), count_(boxes.size()) {
  for (std::size_t i = 0; i < count_; ++i) {
    boxes_[i] = boxes[i];
    bounds_.extendBy(boxes[i]);
  }
  if (count_ <= kFewBoxes) return;

  embree_ = std::make_unique<Embree>();
  embree_->center = bounds_.center();
  embree_->slack = kSlack * length(bounds_.max - bounds_.min) + std::numeric_limits<float>::min();
  embree_->boxes = boxes_.get();
  RTCDevice dev = device();
  embree_->scene = rtcNewScene(dev);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(dev, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count_));
  rtcSetGeometryUserData(geometry, embree_.get());
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* args) {
        const Embree& tree = *static_cast<const Embree*>(args->geometryUserPtr);
        const Box3& box = tree.boxes[args->primID];
        const Vec3 low = box.min - tree.center - Vec3(tree.slack), high = box.max - tree.center + Vec3(tree.slack);
        RTCBounds& b = *args->bounds_o;
        b.lower_x = down(low.x), b.lower_y = down(low.y), b.lower_z = down(low.z);
        b.upper_x = up(high.x), b.upper_y = up(high.y), b.upper_z = up(high.z);
      },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_function);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(embree_->scene);
}

BoxTree::BoxTree() = default;
BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

void BoxTree::walk(const Ray& ray, double t_min, double t_max, Visitor visitor, void* state) const {
  if (!embree_) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      double near = t_min, far = t_max;
      if (clip_to_box(ray, boxes_[i], near, far)) t_max = visitor(state, i, t_max);
      if (t_max < t_min) return;
    }
    return;
  }
  const double slack = embree_->slack;
  double near = t_min, far = t_max;
  if (!clip_to_box(ray, {bounds_.min - Vec3(slack), bounds_.max + Vec3(slack)}, near, far)) return;

  Context context;
  rtcInitIntersectContext(&context.base);
  context.visitor = visitor;
  context.state = state;
  context.offset = near;
  context.slack = slack;
  context.t_max = t_max;
  const Vec3 origin = ray.origin - embree_->center + near * ray.direction;
  RTCRayHit rayhit;
  rayhit.ray.org_x = static_cast<float>(origin.x), rayhit.ray.org_y = static_cast<float>(origin.y), rayhit.ray.org_z = static_cast<float>(origin.z);
  rayhit.ray.dir_x = static_cast<float>(ray.direction.x), rayhit.ray.dir_y = static_cast<float>(ray.direction.y);
  rayhit.ray.dir_z = static_cast<float>(ray.direction.z);
  rayhit.ray.tnear = 0;
  rayhit.ray.tfar = up(far - near + slack);
  rayhit.ray.time = 0;
  rayhit.ray.mask = ~0u;
  rayhit.ray.id = 0;
  rayhit.ray.flags = 0;
  rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context.base, &rayhit);
}

}  // namespace verisim::accel
