#include "tracer/render/requirements.h"

#include "tracer/scene/parts.h"
#include "tracer/shapes/factories.h"

namespace verisim::render {
namespace {

constexpr int kMaxBlurSamples = 1 << 20;
constexpr int kMaxRadiosityDirections = 1 << 24, kMaxMediaIntervals = 256;
constexpr std::int64_t kMaxAreaLightSamples = std::int64_t{1} << 24;

void check_light(const scene::LightSource& light, const scene::SourceLocation& place) {
  if (light.area && static_cast<std::int64_t>(light.size1) * light.size2 > kMaxAreaLightSamples)
    throw Unsupported("area_light with more than 16777216 samples", place);
}

template <class AllMedia>
void check_media(const AllMedia& media) {
  for (const scene::Media& m : media)
    if (m.intervals > kMaxMediaIntervals) throw Unsupported("media with more than 256 intervals", m.place);
}

// What every object of a description is asked, once for all copies of one.
class Check {
 public:
  explicit Check(int quality) : lit_(quality >= 9) {}

  void object(const scene::Object& object) {
    if (const auto* patch = object.as<std::shared_ptr<const scene::BicubicPatch>>();
        patch && !shapes::bicubic_patch_fits(**patch))
      throw Unsupported("bicubic_patch with more than 2097152 pieces", object.place);
    if (lit_ && object.interior) check_media(object.interior->media);
    if (const auto* light = object.as<scene::LightSource>()) {
      if (lit_) check_light(*light, object.place);
      if (light->looks_like) this->object(*light->looks_like);
    }
    if (!seen_.first(object)) return;
    for (const auto& child : scene::declared_children(object)) this->object(*child);
  }

 private:
  bool lit_;
  scene::SharedLists seen_;
};

}  // namespace

void check_supported(const scene::Scene& scene, const Options& options) {
  if (scene.camera.blur_samples > kMaxBlurSamples) throw Unsupported("more than 1048576 blur_samples", {});
  Check check(options.quality);
  for (const auto& object : scene.objects) check.object(*object);
  if (options.quality < 9) return;
  const scene::Settings& settings = scene.settings;
  if (settings.radiosity.enabled && settings.radiosity.count_directions > kMaxRadiosityDirections)
    throw Unsupported("radiosity with more than 16777216 directions", settings.radiosity.place);
  check_media(scene.atmosphere);
}

}  // namespace verisim::render
