// Highlights of a finish: powers of a cosine (spec 06 4.2.5). Written once, for one ray here and, in plain loops that
// become wide instructions, for many in wavefront/wavefront_kernels.cpp; the path tracer draws directions from the same
// lobes.
#pragma once

#include <array>

#include "tracer/math/vec.h"
#include "tracer/scene/texture.h"

namespace verisim::shading {

// A lobe: amount * cosine^exponent, 0 up to the cosine `dark_to`.
struct Highlight {
  double amount = 0, exponent = 0, dark_to = 0;
};
inline Highlight phong_highlight(const scene::Finish& f) {
  return {f.phong, f.phong_size, f.phong_size >= 60 ? 0.0008 : 0};
}
// The exponent is of single precision, as in POV-Ray.
inline Highlight blinn_highlight(const scene::Finish& f) {
  return {f.specular, f.roughness == 0 ? 0 : static_cast<float>(1.0 / f.roughness), 0};
}
inline bool has_highlight(const scene::Finish& f) { return f.phong > 0 || f.specular > 0; }

inline Vec3 mirrored(const Vec3& d, const Vec3& n) { return d - n * (2 * dot(d, n)); }

// The cosines of both lobes for the normal n, the view ray's direction d and the direction l towards a light; unit
// vectors. Without branches.
inline double phong_cosine(const Vec3& n, const Vec3& d, const Vec3& l) { return dot(mirrored(d, n), l); }
inline double blinn_cosine(const Vec3& n, const Vec3& d, const Vec3& l) {
  const Vec3 h = (l - d) * 0.5;
  const double size = std::sqrt(dot(h, h)), m = dot(h, n) / size;
  return size <= 0 ? 0 : m;
}

inline double strength(const Highlight& highlight, double cosine) {
  return cosine <= highlight.dark_to ? 0 : highlight.amount * std::pow(cosine, highlight.exponent);
}
// Of Phong's and of Blinn's, which light is multiplied by one after the other.
inline std::array<double, 2> highlight_strengths(const scene::Finish& f, const Vec3& n, const Vec3& d, const Vec3& l) {
  return {f.phong > 0 ? strength(phong_highlight(f), phong_cosine(n, d, l)) : 0,
          f.specular > 0 ? strength(blinn_highlight(f), blinn_cosine(n, d, l)) : 0};
}
// Of both together.
inline double highlight_strength(const scene::Finish& f, const Vec3& n, const Vec3& d, const Vec3& l) {
  const auto [phong, blinn] = highlight_strengths(f, n, d, l);
  return phong + blinn;
}

}  // namespace verisim::shading
