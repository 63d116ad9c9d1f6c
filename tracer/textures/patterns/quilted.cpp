#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

// Position in the unit cell about its centre; negative integers fall on the far side, as in POV-Ray.
double centred_fraction(double v) {
  double t = v - std::trunc(v);
  if (v < 0) t += 1;
  return t - 0.5;
}

}  // namespace

// Products in POV-Ray's order: facing cells along an edge, their last bits decide.
Vec3 quilt(const QuiltedData& data, const Vec3& p) {
  const Vec3 u(centred_fraction(p.x), centred_fraction(p.y), centred_fraction(p.z));
  const double r = length(u), s = 1 - r;
  const double q = 1.154700538 * (r * r * r + 3 * r * (s * s) * data.control0 + 3 * (r * r) * s * data.control1);
  return q * u;
}

double formulas::quilted(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const Vec3 q = quilt(c.as<QuiltedData>(), p);
  return (std::fabs(q.x) + std::fabs(q.y) + std::fabs(q.z)) / 3;
}

}  // namespace verisim::textures
