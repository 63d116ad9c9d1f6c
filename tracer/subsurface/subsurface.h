// Subsurface light transport (spec 07 section 5): the dipole of Jensen, Marschner, Levoy and Hanrahan, "A Practical
// Model for Subsurface Light Transport" (2001), with single scattering and an unscattered term, in POV-Ray's variant.
#pragma once

#include <cstdint>
#include <span>

#include "tracer/scene/scene.h"

namespace verisim::global {

inline constexpr int kMaxSubsurfaceLevel = 2;  // at the third nested subsurface surface the term is 0

// What the estimator asks of the tracer.
class SubsurfaceEnvironment {
 public:
  struct SurfaceHit {
    double t = 0;
    Vec3 point, normal;  // geometric unit normal
    const scene::Interior* interior = nullptr;
  };
  virtual ~SubsurfaceEnvironment() = default;
  // The nearest surface at any distance t > 0 (no minimum).
  virtual bool nearest(const Ray& ray, SurfaceHit& hit) = 0;
  // The same for several rays from one point; found[i]: hits[i] is set.
  virtual void nearest(const Vec3& origin, std::span<const Vec3> directions, SurfaceHit* hits, bool* found) {
    for (std::size_t i = 0; i < directions.size(); ++i) found[i] = nearest({origin, directions[i]}, hits[i]);
  }
  virtual std::size_t lights() = 0;
  // Light arriving at p from a light after shadows; false: none. Sets the unit direction towards the light.
  virtual bool illumination(std::size_t light, const Vec3& p, Rgb& color, Vec3& to_light) = 0;
  // Unshadowed direction to the light, for the straight line of single scattering.
  virtual Vec3 direction_to(std::size_t light, const Vec3& p) = 0;
  // Radiance along a ray that leaves the object into `exit` (the unscattered term); `share`: the largest part of it
  // that is used.
  virtual Rgb transmitted(const Ray& ray, const SurfaceHit& exit, double share) = 0;
  virtual Vec3 sphere_direction() = 0;  // next Halton direction on the unit sphere
  virtual double random() = 0;          // next number of the single-scattering stream, [0, 1)
  // Whether random() must be drawn as POV-Ray draws it; otherwise the estimator may use better samples of the same
  // integral.
  virtual bool replay() const { return true; }
  // Radiosity at a point of the surface, for subsurface { radiosity on }; false: none is wanted.
  virtual bool irradiance(const Vec3& /*point*/, const Vec3& /*normal*/, Rgb& /*light*/) { return false; }
};

struct SubsurfaceSettings {
  int diffuse_samples = 50, single_samples = 50;
  double mm_per_unit = 10;
  float adc_bailout = 1.0f / 255;
};

struct SubsurfacePoint {
  Vec3 point, normal;  // geometric, unit, turned towards the viewer
  Vec3 view;           // unit ray direction, towards the surface
  const scene::Interior* interior = nullptr;
  double relative_ior = 1;  // of what lies behind the surface to what the ray comes from
  Rgb reflectance;          // pigment * diffuse
  Rgb translucency;         // mm
};

// Replaces the diffuse part of direct light at the point.
Rgb subsurface(const SubsurfacePoint& point, const SubsurfaceSettings& settings, SubsurfaceEnvironment& environment);

// Reduced albedo whose diffuse reflectance is `reflectance`, for a medium of index `ior`; POV-Ray's table of 101 steps,
// interpolated.
double reduced_albedo(double reflectance, double ior);
// Unpolarised Fresnel transmittance into a medium of relative index eta; 1 where all light is reflected, as POV-Ray has
// it.
double fresnel_transmittance(double cosine, double eta);

}  // namespace verisim::global
