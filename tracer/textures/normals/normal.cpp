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

// The normals of a map's entries at a point, blended; in and out in the frame of its pattern.
Vec3 mapped(const CompiledNormal& c, const MapPlace& place, const Vec3& p, const Vec3& n, SurfacePoint& surface) {
  const Vec3 upper = perturb_alone(*c.children[place.upper], p, n, surface);
  if (place.single()) return upper;
  return (1 - place.t) * perturb_alone(*c.children[place.lower], p, n, surface) + place.t * upper;
}

Vec3 averaged(const CompiledNormal& c, const Vec3& p, const Vec3& n, SurfacePoint& surface) {
  Vec3 sum(0, 0, 0);
  float total = 0;  // the bits of POV-Ray's sum of weights
  for (std::size_t i = 0; i < c.children.size(); ++i) {
    sum += static_cast<double>(c.positions.position(i)) * perturb_alone(*c.children[i], p, n, surface);
    total += c.positions.position(i);
  }
  return sum * (1.0 / total);
}

}  // namespace

Vec3 perturb_alone(const CompiledNormal& c, const Vec3& p, const Vec3& n, SurfacePoint& surface) {
  using enum CompiledNormal::Method;
  if (c.method == uv_mapping) return perturb_alone(*c.children[0], uv_point(surface), n, surface);
  if (c.method == unusable) {
    UnusableNormal::note();
    return n;
  }
  const Vec3 q = warped(*c.pattern, p);
  const auto in_frame = [&](auto&& change) {
    return normal_out_of_frame(*c.pattern, c.no_bump_scale, change(normal_into_frame(*c.pattern, c.no_bump_scale, n)));
  };
  switch (c.method) {
    case displacement:
      surface.normal = in_frame([&](const Vec3& local) { return displaced(c, q, local); });
      break;
    case height:
      surface.normal = in_frame([&](const Vec3& local) { return height_field(c, q, surface, local); });
      break;
    case map: {
      const MapPlace place = c.positions.find(value_at(*c.pattern, q, &surface));
      // Normalised once more, as in POV-Ray: the last bit may change.
      surface.normal = normalize(in_frame([&](const Vec3& local) { return mapped(c, place, q, local, surface); }));
      break;
    }
    default:
      surface.normal = in_frame([&](const Vec3& local) { return averaged(c, q, local, surface); });
  }
  return surface.normal;
}

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

Vec3 perturb(const CompiledNormal& normal, const Vec3& p, const Vec3& n, SurfacePoint& surface) {
  const Vec3 perturbed = perturb_alone(normal, p, n, surface);
  return normal.no_bump_scale ? perturbed / length(perturbed) : perturbed;
}

}  // namespace verisim::textures
