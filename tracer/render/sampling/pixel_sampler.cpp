#include "tracer/render/sampling/pixel_sampler.h"

#include <algorithm>

namespace verisim::render {

CameraModel::CameraModel(const scene::Camera& description, int width, int height, textures::Compiler& compiler,
                         WindowPlace window)
    : camera(description), rays(description, width, height, window) {
  origin_varies = rays.origin_varies();
  if (description.kind == scene::CameraKind::mesh_camera) {
    mesh.emplace(description, width, height, window.left, window.top);
    origin_varies = true;
  } else if (description.aperture != 0 && description.blur_samples > 0) {
    FocalBlur::Weight weight;
    if (description.bokeh) {
      weight = [pigment = compiler.pigment(description.bokeh)](const Vec3& p) {
        Color c;
        textures::evaluate(*pigment, p, nullptr, c);
        return static_cast<double>(c.grey());
      };
    }
    blur.emplace(description, weight);
    origin_varies = true;
  }
  if (description.normal) normal = compiler.normal(description.normal);
  if (!mesh) find_coherence(width, height);
}

// Whether each camera ray looks up what it starts in. Where a camera of that type has a single origin without a lens,
// and is no perspective one, the first ray does it for all (spec 02 1.8); only in POV-Ray's order there is a first one.
// Of a mesh_camera the first ray always does.
static bool starts_differ(const CameraModel& camera, shading::Tracer& tracer) {
  if (camera.mesh) {
    if (const std::optional<Ray> first = camera.mesh->first_ray()) tracer.camera_state(*first, false);
    return false;
  }
  if (!camera.blur) return camera.origin_varies;
  const bool first_decides =
      tracer.random().replay() && camera.camera.kind != scene::CameraKind::perspective && !camera.rays.origin_varies();
  return tracer.expect_origins(camera.blur->lens()) && !first_decides;
}

PixelSampler::PixelSampler(const CameraModel& camera, shading::Tracer& tracer)
    : camera_(camera), tracer_(tracer), starts_differ_(starts_differ(camera, tracer)), wavefront_(tracer) {}

// From the rays of three pixels in the middle.
void CameraModel::find_coherence(int width, int height) {
  using Kind = accel::CameraCoherence::Kind;
  if (blur && camera.kind != scene::CameraKind::perspective) return;
  const double x = width / 2, y = height / 2;
  const auto here = rays.at(x, y), right = rays.at(x + 1, y), below = rays.at(x, y + 1);
  if (!here || !right || !below) return;
  const auto apart = [&](const PrimaryRay& other) {
    return rays.origin_varies() ? length(other.ray.origin - here->ray.origin)
                                : length(normalize(other.ray.direction) - normalize(here->ray.direction));
  };
  if (rays.origin_varies() && camera.kind != scene::CameraKind::orthographic) return;
  linear = !normal && (camera.kind == scene::CameraKind::perspective || camera.kind == scene::CameraKind::orthographic);
  coherence = {rays.origin_varies() ? Kind::parallel : Kind::common_origin, std::max(apart(*right), apart(*below))};
}

std::optional<Ray> CameraModel::ray(double x, double y, int number) const {
  if (mesh) {
    const std::optional<Ray> of_face = mesh->ray(x, y, number);
    return of_face ? std::optional(bent(*of_face, Vec2(0, 0))) : std::nullopt;
  }
  const std::optional<PrimaryRay> primary = rays.at(x, y);
  if (!primary) return std::nullopt;
  return bent({primary->ray.origin, normalize(primary->ray.direction)}, primary->image);
}

double CameraModel::limit() const {
  return mesh && camera.max_distance >= kEpsilon ? camera.max_distance : accel::kFarthestHit;
}

// Rays of linear cameras are spanned by those of the corners.
std::optional<accel::Shaft> CameraModel::shaft(const Box3& world, double left, double top, double right,
                                               double bottom) const {
  if (blur) return blur->shaft(rays, world, left, top, right, bottom);
  Box3 from, to;
  for (const Vec2& at : {Vec2(left, top), Vec2(right, top), Vec2(left, bottom), Vec2(right, bottom)}) {
    const Ray ray = rays.at(at.x, at.y)->ray;
    // To beyond the sphere around the world, whose distance from the corner's own origin this bounds; parallel rays
    // count from behind it, too.
    const double reach =
        2 * (length(world.center() - ray.origin) + length(world.max - world.min)) / length(ray.direction);
    from.extendBy(origin_varies ? ray.origin - reach * ray.direction : ray.origin);
    to.extendBy(ray.origin + reach * ray.direction);
  }
  return accel::Shaft::between(from, to);
}

Color PixelSampler::operator()(double x, double y) {
  ++tracer_.statistics().samples;
  if (camera_.free()) return free_sample({x, y});
  if (camera_.blur) return lens_sample({x, y});
  tracer_.random().begin_sample(x, y, 0);
  int one = 1;
  const accel::WorldEntry* const from = entry(x, y, one);
  return tracer_.trace_camera(*camera_.ray(x, y), starts_differ_, accel::kFarthestHit, from);
}

const accel::WorldEntry* PixelSampler::entry(double x, double y, int& count) {
  return tracer_.coherent().camera_batch(x, y, count, [this](double left, double top, double right, double bottom) {
    return camera_.shaft(tracer_.scene().world.tree().bounds(), left, top, right, bottom);
  });
}

void PixelSampler::row(double x, double y, int count, Color* colors) {
  if (!together()) {
    for (int i = 0; i < count; ++i) colors[i] = (*this)(x + i, y);
    return;
  }
  for (int done = 0; done < count; done += shading::Wavefront::kMax) {
    const int n = std::min(count - done, shading::Wavefront::kMax);
    for (int i = 0; i < n; ++i) wavefront_.places()[i] = Vec2(x + done + i, y);
    if (camera_.blur || camera_.free())
      other_points(n, colors + done);
    else
      batch_wavefront(n, colors + done);
  }
}

// How many of the places, from the first on, may share a wavefront: where their rays enter the world is remembered for
// all of them.
int PixelSampler::near_each_other(const Vec2* places, int count) {
  Imath::Box2d around(places[0]);
  for (int i = 1; i < count; ++i) {
    around.extendBy(places[i]);
    const Vec2 size = around.size();
    if (std::max(size.x, size.y) > accel::CoherentRays::camera_reach()) return i;
  }
  return count;
}

void PixelSampler::points(const Vec2* places, int count, Color* colors) {
  if (!together()) {
    for (int i = 0; i < count; ++i) colors[i] = (*this)(places[i].x, places[i].y);
    return;
  }
  for (int done = 0, n = 0; done < count; done += n) {
    n = near_each_other(places + done, std::min(count - done, shading::Wavefront::kMax));
    std::copy_n(places + done, n, wavefront_.places());
    if (camera_.blur || camera_.free())
      other_points(n, colors + done);
    else
      point_wavefront(n, colors + done);
  }
}

// The rays through the wavefront's places, from one point or parallel. False: they do not all start within the same
// objects.
bool PixelSampler::aim(int count) {
  RayBatch& rays = wavefront_.packet().rays;
  const Vec2* const places = wavefront_.places();
  if (!camera_.origin_varies) {
    for (int i = 0; i < count; ++i) rays.origin.set(i, camera_.camera.location);
    camera_.rays.directions(places, count, wavefront_.packet());
    return true;
  }
  for (int i = 0; i < count; ++i) {
    const Ray ray = camera_.rays.at(places[i].x, places[i].y)->ray;
    rays.origin.set(i, ray.origin);
    rays.direction.set(i, normalize(ray.direction));
    if (!starts_like_the_first(i)) return false;
  }
  return true;
}

bool PixelSampler::starts_like_the_first(int i) {
  if (!starts_differ_) return true;
  const auto around = tracer_.interiors(tracer_.camera_state(wavefront_.packet().rays.at(i), starts_differ_).interiors);
  if (i == 0) around_.assign(around.begin(), around.end());
  return std::ranges::equal(around, around_);
}

void PixelSampler::one_by_one(int count, Color* colors) {
  Vec2 places[shading::Wavefront::kMax];
  std::copy_n(wavefront_.places(), count, places);
  for (int i = 0; i < count; ++i) colors[i] = (*this)(places[i].x, places[i].y);
}

void PixelSampler::batch_wavefront(int count, Color* colors) {
  if (!aim(count)) return one_by_one(count, colors);
  const double x = wavefront_.places()[0].x, y = wavefront_.places()[0].y;
  tracer_.statistics().samples += static_cast<std::uint64_t>(count);
  const accel::WorldEntry* entries[shading::Wavefront::kMax];
  for (int i = 0; i < count;) {
    int served = count - i;
    const accel::WorldEntry* const here = entry(x + i, y, served);
    for (; served > 0; --served) entries[i++] = here;
  }
  wavefront_.trace(count, entries, colors);
}

void PixelSampler::point_wavefront(int count, Color* colors) {
  if (!aim(count)) return one_by_one(count, colors);
  tracer_.statistics().samples += static_cast<std::uint64_t>(count);
  const accel::WorldEntry* entries[shading::Wavefront::kMax];
  for (int i = 0, one = 1; i < count; ++i) entries[i] = entry(wavefront_.places()[i].x, wavefront_.places()[i].y, one);
  wavefront_.trace(count, entries, colors);
}

void PixelSampler::other_points(int count, Color* colors) {
  if (camera_.blur)
    lens_points(count, colors);
  else
    free_points(count, colors);
}

}  // namespace verisim::render
