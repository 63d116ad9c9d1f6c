// The formulas of a finish: iridescence, mirror reflectivity and directions, diffuse light (spec 06 sections 4 and 5);
// with those of highlights.h.
#pragma once

#include <optional>

#include "tracer/math/scaled.h"
#include "tracer/math/vec.h"
#include "tracer/noise/noise.h"
#include "tracer/scene/texture.h"
#include "tracer/shading/highlights.h"

namespace verisim::shading {

// The mirror direction about the layer's normal, corrected where it would point below the geometric surface; unit (spec
// 06 5.3).
Vec3 reflected_direction(const Vec3& d, const Vec3& normal, const Vec3& geometric_normal);
// By Snell's law, `ratio` that of the refractive indices before and behind the surface; as long as `d`, which is a unit
// vector, but for rounding. None: all light is reflected.
std::optional<Vec3> refracted_direction(const Vec3& d, const Vec3& normal, double ratio);

// POV-Ray's approximation of Fresnel's term for metals, as a function of the angle's cosine (spec 06 4.2.5).
double metallic_fresnel(double cosine);
// Light colour as a metallic surface reflects it.
Rgb metallic_tint(const Rgb& pigment, float metallic, double cosine);

// Thin-film interference factor per channel; `thickness` includes turbulence, cosines is abs(N.L) + abs(N.D) (spec
// 06 4.2.6).
Rgb iridescence(float amount, double thickness, double cosines, const Rgb& wavelength);

// The film's turbulence, and its thickness where that is t.
inline textures::Octaves film_octaves() { return {5, 2, 0.5}; }
inline double turbulent_thickness(const scene::Finish& f, double t) {
  return f.irid_thickness * (1 + (2 * t - 1) * f.irid_turbulence);
}

// Unpolarised dielectric reflectance for relative index eta and cosine of the viewing angle; 1 on total reflection
// (spec 06 5.1).
double fresnel_reflectance(double eta, double cosine);
// What a layer mirrors, and by what the weight of reflected rays goes down (spec 06 2.2).
struct Mirror {
  Rgb reflectivity;
  float strength = 0;
};
// cosine = -D.N, may be negative; eta is only used by `fresnel`.
Mirror mirror_of(const scene::Reflection& reflection, const Rgb& pigment, double cosine, double eta);

// Light that is darker in all channels is none.
inline constexpr float kDark = static_cast<float>(kEpsilon);

// Whether lights are asked about at all.
inline bool reflects_light(const scene::Finish& f) {
  return f.diffuse != 0 || f.diffuse_back != 0 || f.specular != 0 || f.phong != 0;
}

// Opacity of a pigment colour for the surface's own light: before 3.7 it stays in double precision (spec 06 3.3).
inline double surface_opacity(const Color& c, int version) {
  return version < 370 ? 1.0 - (c.f * c.rgb().max() + c.t) : rounded_opacity(c.opacity());
}

// Ambient light and emission of a layer, each rounded by itself (spec 06 4.1).
inline Rgb own_light(const scene::Finish& f, const Rgb& pigment, const Rgb& ambient_light, double opacity) {
  return scaled(pigment * f.ambient * ambient_light, opacity) + scaled(pigment * f.emission, opacity);
}

// How diffuse light falls off: abs(cosine)^brilliance.
inline double brilliance(float exponent, double cosine) {
  return exponent == 1.0f ? std::fabs(cosine) : std::pow(std::fabs(cosine), exponent);
}
// How much of the light that falls straight upon a layer it reflects diffusely; at an angle, but for crand.
inline double diffuse_share(double opacity, float diffuse) { return opacity * diffuse; }
inline double diffuse_share(double opacity, float diffuse, float exponent, double cosine) {
  return diffuse_share(opacity, diffuse) * brilliance(exponent, cosine);
}

}  // namespace verisim::shading
