#include "tracer/textures/normals/normal.h"
#include "tracer/textures/evaluation/evaluation_faults.h"

#include <iterator>

#include "tracer/textures/evaluation/evaluation.h"
#include "tracer/noise/noise.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

Vec3 dents_bump(double amount, const Vec3& p, int noise_generator) {
  const double n = noise(p, noise_generator);
  return n * n * n * amount * vector_noise(p);
}

Vec3 facets(const scene::FacetsParams& f, const Vec3& p, const Vec3& n_in) {
  const Vec3 n = normalize(n_in);
  double size = f.size;
  Vec3 t = f.coords != 0 ? p : n;
  t = size < 1e-6 ? t * 1e6 : t / size;
  const Vec3 q = nearest_facet_point(t, f.metric);
  if (f.coords == 0) return q;
  const Vec3 g = vector_noise(q);
  return n + f.coords * (g - dot(g, n) * n);
}

// Spec 05 section 12.6: the plane through three neighbouring heights, laid on the surface.
Vec3 bump_map(const ImageLookup& lookup, double amount, const Vec3& p, const Vec3& n) {
  double u, v;
  if (!locate(lookup, p, u, v)) return n;
  const double w = lookup.image->width, h = lookup.image->height;
  const double left = u - 1 < 0 ? u - 1 + w : u - 1, right = u + 1 >= w ? u + 1 - w : u + 1,
               below = v + 1 >= h ? v + 1 - h : v + 1;
  const double g1 = amount * bump_height(lookup, u, v), g2 = amount * bump_height(lookup, left, below),
               g3 = amount * bump_height(lookup, right, below);
  const Vec3 b = normalize(Vec3(g2 - g3, 2, 2 * g1 - g2 - g3));
  Vec3 x = cross(n, Vec3(0, 1, 0)), y = n;
  if (length(x) < kEpsilon) {
    y = Vec3(0, std::fabs(n.y - 1) < kEpsilon ? 1 : -1, 0);  // what is no unit vector turns over
    x = Vec3(1, 0, 0);
  } else {
    x = normalize(x);
  }
  const Vec3 z = normalize(cross(x, y));
  return b.x * x + b.y * y - b.z * z;
}

Vec3 displaced(const CompiledNormal& c, const Vec3& p, const Vec3& n) {
  const CompiledPattern& pattern = *c.pattern;
  switch (pattern.kind) {
    case scene::PatternKind::bumps:
      return n + c.amount * vector_noise(p);
    case scene::PatternKind::dents:
      return n + dents_bump(c.amount, p, pattern.noise_generator);
    case scene::PatternKind::wrinkles:
      return n + c.amount * wrinkles_vector_sum(p);
    case scene::PatternKind::ripples:
    case scene::PatternKind::waves:
      return waves_bump(pattern, c.amount, p, n);
    case scene::PatternKind::quilted:
      return n + c.amount * quilt(pattern.as<QuiltedData>(), p);
    case scene::PatternKind::facets:
      return facets(pattern.as<scene::FacetsParams>(), p, n);
    default:
      return bump_map(pattern.as<ImageLookup>(), c.amount, p, n);
  }
}

Vec3 height_field(const CompiledNormal& c, const Vec3& p, const SurfacePoint& surface, Vec3 n) {
  constexpr int kCount = std::size(kHeightSamples);
  PointBatch points;
  for (int i = 0; i < kCount; ++i) points.set(i, p + c.accuracy * kHeightSamples[i]);
  points.fill_up(kCount);
  const SurfacePoint* const surfaces[kCount] = {&surface, &surface, &surface, &surface};
  alignas(64) double values[PointBatch::kMax];
  values_at(*c.pattern, kCount, points, surfaces, values);
  const double strength = height_strength(c);
  for (int i = 0; i < kCount; ++i) n += height_of(c, values[i]) * strength * kHeightSamples[i];
  return n;
}

// The whole process of one normal, children included; `surface.normal` in and out.
void apply(const CompiledNormal& c, const Vec3& p, SurfacePoint& surface) {
  using enum CompiledNormal::Method;
  if (c.method == uv_mapping) {
    apply(*c.children[0], uv_point(surface), surface);
    return;
  }
  if (c.method == unusable) return UnusableNormal::note();
  const Vec3 q = warped(*c.pattern, p);
  switch (c.method) {
    case displacement: {
      const Vec3 n = normal_into_frame(*c.pattern, c.no_bump_scale, surface.normal);
      surface.normal = normal_out_of_frame(*c.pattern, c.no_bump_scale, displaced(c, q, n));
      return;
    }
    case height: {
      const Vec3 n = normal_into_frame(*c.pattern, c.no_bump_scale, surface.normal);
      surface.normal = normal_out_of_frame(*c.pattern, c.no_bump_scale, height_field(c, q, surface, n));
      return;
    }
    case map: {
      const MapPlace place = c.positions.find(value_at(*c.pattern, q, &surface));
      const Vec3 n = normal_into_frame(*c.pattern, c.no_bump_scale, surface.normal);
      surface.normal = n;
      apply(*c.children[place.upper], q, surface);
      if (!place.single()) {
        const Vec3 upper = surface.normal;
        surface.normal = n;
        apply(*c.children[place.lower], q, surface);
        surface.normal = (1 - place.t) * surface.normal + place.t * upper;
      }
      // Normalised once more, as in POV-Ray: the last bit may change.
      surface.normal = normalize(normal_out_of_frame(*c.pattern, c.no_bump_scale, surface.normal));
      return;
    }
    default: {
      const Vec3 n = normal_into_frame(*c.pattern, c.no_bump_scale, surface.normal);
      Vec3 sum(0, 0, 0);
      float total = 0;  // the bits of POV-Ray's sum of weights
      for (std::size_t i = 0; i < c.children.size(); ++i) {
        surface.normal = n;
        apply(*c.children[i], q, surface);
        sum += static_cast<double>(c.positions.position(i)) * surface.normal;
        total += c.positions.position(i);
      }
      surface.normal = sum * (1.0 / total);
      break;
    }
  }
  surface.normal = normal_out_of_frame(*c.pattern, c.no_bump_scale, surface.normal);
}

}  // namespace

// Hermite segments (spec 05 10.4).
double height_of(const CompiledNormal& c, double v) {
  if (c.slopes.empty()) return v;
  const MapPlace place = c.positions.find(v);
  if (place.single()) return c.slopes[place.upper].height;
  const scene::SlopeEntry &a = c.slopes[place.lower], &b = c.slopes[place.upper];
  const double t = place.t, rise = a.height - b.height;
  return t * t * t * (a.slope + b.slope + 2 * rise) - t * t * (2 * a.slope + b.slope + 3 * rise) +
         (t * a.slope + a.height);
}

Vec3 perturb(const CompiledNormal& normal, const Vec3& p, SurfacePoint& surface) {
  apply(normal, p, surface);
  return normal.no_bump_scale ? surface.normal / length(surface.normal) : surface.normal;
}

}  // namespace verisim::textures
