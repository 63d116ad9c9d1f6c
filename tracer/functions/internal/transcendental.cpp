// Internal functions with angles, roots and exponentials (spec 01 section 24).
#include "tracer/functions/internal/formula_table.h"

namespace verisim::functions {

namespace {

double radius(const Call3& c) { return std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z); }
double positive_mod(double a, double b) {
  const double r = std::fmod(a, b);
  return r < 0 ? r + b : r;
}
// "S": cross section between square (0), circle (1) and anything else. `root`: p / 2, in one of its roundings.
double section(double a, double b, double p, double root) {
  if (p == 1) return hyp(a, b);
  a = std::fabs(a), b = std::fabs(b);
  if (p == 0) return std::max(a, b);
  return std::pow(std::pow(a, 2 / p) + std::pow(b, 2 / p), root);
}
double section(double a, double b, double p) { return section(a, b, p, p / 2); }

double blob(const Call3& c) {
  const auto falloff = [&](double x, double scale) {
    return 1 - std::min(1.0, (x * x + c.y * c.y + c.z * c.z) * scale * scale);
  };
  const double h = c.p[0] / 2, a = falloff(c.x + h, c.p[2]), b = falloff(c.x - h, c.p[4]);
  return -c.p[1] * a * a - c.p[3] * b * b;
}
double blob2(const Call3& c) {
  const auto bell = [&](double x) { return std::exp(-c.p[1] * (x * x + c.y * c.y + c.z * c.z)); };
  return c.p[3] - c.p[2] * (bell(c.x) + bell(c.x - c.p[0]));
}
double comma(const Call3& c) {
  const double s = c.p[0], x = c.x == 0 && c.z == 0 ? 1e-4 : c.x;
  const double theta = std::atan2(c.z, x), r = hyp(x + s / 4, c.z);
  const double t = std::min(c.z, s / 2 * std::cos(theta / 2) - hyp(r - 0.75 * s, c.y));
  const double u = s / 2 - std::sqrt(sq(x - s / 2) + c.z * c.z + c.y * c.y);
  return -std::max(t, u);
}
struct Ellipsoids {
  double e1, e2, e3;
  explicit Ellipsoids(const Call3& c) {
    const double X = c.x * c.x, Y = c.y * c.y, Z = c.z * c.z, a = c.p[0], b = c.p[1];
    e1 = std::exp(-b * (a * X + a * Y + Z)), e2 = std::exp(-b * (a * X + Y + a * Z)),
    e3 = std::exp(-b * (X + a * Y + a * Z));
  }
};
double cross_ellipsoids(const Call3& c) {
  const Ellipsoids e(c);
  return c.p[3] - c.p[2] * std::max(e.e1, std::max(e.e2, e.e3));
}
double isect_ellipsoids(const Call3& c) {
  const Ellipsoids e(c);
  return c.p[3] - c.p[2] * std::min(e.e1, std::min(e.e2, e.e3));
}
double flange_cover(const Call3& c) {
  const Ellipsoids e(c);
  return c.p[3] - c.p[2] * (e.e1 + e.e2 + e.e3);
}
double spikes(const Call3& c) {
  const Ellipsoids e(c);
  return -c.p[2] * (c.p[4] * std::exp(-c.p[3] * (c.x * c.x + c.y * c.y + c.z * c.z)) - e.e1 - e.e2 - e.e3);
}
double ellipsoid(const Call3& c) {
  const double* p = c.p;
  return std::sqrt(c.x * c.x * p[0] * p[0] + c.y * c.y * p[1] * p[1] + c.z * c.z * p[2] * p[2]);
}
double helical_torus(const Call3& c) {
  const double* p = c.p;
  const double rho = hyp(c.x, c.z), x = c.x == 0 && c.z == 0 ? 1e-6 : c.x;
  const double phi = std::atan2(x, c.z), r = hyp(rho - p[0], c.y);
  const double theta = positive_mod(phi * p[1] + std::atan2(rho - p[0], c.y) * p[2], 2 * kPi) - kPi;
  const double tau = std::atan2(theta * p[8], r - p[5]);
  const double t = p[3] * std::cos(tau * p[7] + phi * p[9]) + p[4];
  return -std::max(p[4] + p[5] - p[0] - rho, t - std::min(std::sqrt(sq(r - p[5]) + theta * theta * p[6]), r + p[5]));
}
double helix1(const Call3& c) {
  const double* p = c.p;
  const double r = hyp(c.x, c.z), x = c.x == 0 && c.z == 0 ? 1e-6 : c.x;
  const double theta = positive_mod(p[0] * std::atan2(c.z, x) + c.y * p[1] * p[0], 2 * kPi);
  double b = (theta - kPi) / p[4] / (p[1] * p[0]), a = r - p[3];
  if (p[5] != 1 && p[6] != 0) {
    const double angle = p[6] * (kPi / 180), k = std::cos(angle), s = std::sin(angle), turned = a * k - b * s;
    b = a * s + b * k, a = turned;
  }
  return std::min(p[3] + r, section(a, b, p[5])) - p[2];
}
double helix2(const Call3& c) {
  const double k = std::cos(c.p[1] * c.y), s = std::sin(c.p[1] * c.y), a = c.x - c.p[3] * k, b = c.z - c.p[3] * s;
  return section(a * k + b * s, b * k - a * s, c.p[5]) - c.p[2];
}
// The nearest centre of a hexagonal lattice, as (a, b) in the first quadrant.
void hexagon_cell(const Call3& c, double& a, double& b) {
  const double root3 = std::sqrt(3.0), half = root3 / 2;
  a = std::fabs(std::fmod(std::fabs(c.x), root3) - half), b = std::fabs(std::fmod(std::fabs(c.y), 3.0) - 1.5);
  const double e = half - a, d = 1.5 - b;
  if (a * a + b * b > e * e + d * d) a = e, b = d;
}
double hex_x(const Call3& c) {
  double a, b;
  hexagon_cell(c, a, b);
  return std::atan2(b, a) < kPi / 6 ? a : a * std::cos(kPi / 3) + b * std::sin(kPi / 3);
}
double hex_y(const Call3& c) {
  double a, b;
  hexagon_cell(c, a, b);
  return std::atan2(b, a) < kPi / 6 ? b : std::fabs(b * std::cos(kPi / 3) - a * std::sin(kPi / 3));
}
double mesh1(const Call3& c) {
  const double *p = c.p, a = p[0], b = p[1];
  const auto wave = [&](double u, double period) { return p[2] * std::fabs(positive_mod(u, 2 * period) - period); };
  const double w = p[3] * std::cos(kPi / b * c.z), v = p[3] * std::cos(kPi / a * c.x);
  const double d1 = hyp(p[4] * (c.y - w), wave(c.x, a)), d2 = hyp(p[4] * (c.y + w), wave(c.x - a, a));
  const double d3 = hyp(p[4] * (c.y + v), wave(c.z, b)), d4 = hyp(p[4] * (c.y - v), wave(c.z - b, b));
  return std::min(std::min(d1, d2), std::min(d3, d4));
}
double ph(const Call3& c) { return std::atan2(hyp(c.x, c.z), c.y); }
double th(const Call3& c) { return std::atan2(c.x, c.z); }
double poly4(const Call3& c) {
  const double *p = c.p, y = c.y, y2 = y * y;
  return hyp(c.x, c.z) - std::max(-5.0, p[0] + p[1] * y + p[2] * y2 + p[3] * y2 * y + p[4] * y2 * y2);
}
double polytubes(const Call3& c) {
  const double *p = c.p, y = c.y, y2 = y * y;
  const double rho = p[1] + p[2] * y + p[3] * y2 + p[4] * y2 * y + p[5] * y2 * y2;
  double nearest = 10000;
  const double count =
      std::min(std::trunc(p[0]), 100000.0);  // a limit against endless loops; one tube is 10^-5 of a turn
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / p[0];
    nearest = std::min(nearest, hyp(c.x - rho * std::sin(angle), c.z - rho * std::cos(angle)));
  }
  return nearest;
}
double quantum(const Call3& c) {
  const double x = c.x == 0 && c.z == 0 ? 1e-6 : c.x;
  const double k = std::cos(std::atan2(hyp(x, c.z), c.y)), r = 2 * std::sqrt(x * x + c.y * c.y + c.z * c.z);
  const double q = r * r * std::exp(-0.33333333 * r) * (3 * k * k - 1);
  return (12 - q * q) * 0.1;
}
double distance(const Call3& c) { return radius(c); }
double sphere(const Call3& c) { return radius(c) - c.p[0]; }
double rounded_box(const Call3& c) {
  const auto beyond = [&](double v, double half) { return std::max(0.0, std::fabs(v) - (half - c.p[0])); };
  return std::sqrt(sq(beyond(c.x, c.p[1])) + sq(beyond(c.y, c.p[2])) + sq(beyond(c.z, c.p[3]))) - c.p[0] - 1e-6;
}
double spikes_2d(const Call3& c) {
  return c.y - c.p[0] * std::cos(c.p[1] * c.x) * std::cos(c.p[2] * c.z) * std::exp(-c.p[3] * (c.x * c.x + c.z * c.z));
}
double spiral(const Call3& c) {
  const double* p = c.p;
  const double x = c.x == 0 && c.z == 0 ? 1e-6 : c.x;
  const double r = hyp(x, c.z) + p[0] * std::atan2(c.z, x) / (2 * kPi);
  const double q = section(std::fmod(r, p[0]) - p[0] / 2, c.y, p[5], 1 / (2 / p[5]));
  const double R = std::sqrt(x * x + c.y * c.y + c.z * c.z);
  return -std::min(p[2] - R, p[1] - std::min(q, R));
}
double superellipsoid(const Call3& c) {
  const double e = c.p[0], n = c.p[1];
  const double plane = std::pow(std::pow(std::fabs(c.x), 2 / e) + std::pow(std::fabs(c.y), 2 / e), e * (1 / n));
  return 1 - std::pow(plane + std::pow(std::fabs(c.z), 2 / n), n / 2);
}
double torus(const Call3& c) { return hyp(hyp(c.x, c.z) - c.p[0], c.y) - c.p[1]; }
double nothing(const Call3&) { return 0; }

// By number: the formula and how many parameters it has.
constexpr NumberedEntry kTranscendentals[] = {
    {6, {blob, 5}},       {7, {blob2, 4}},         {9, {comma, 1}},           {10, {cross_ellipsoids, 4}},
    {17, {ellipsoid, 3}}, {19, {flange_cover, 4}}, {24, {helical_torus, 10}}, {25, {helix1, 7}},
    {26, {helix2, 7}},    {27, {hex_x, 1}},        {28, {hex_y, 1}},          {32, {isect_ellipsoids, 4}},
    {40, {mesh1, 5}},     {47, {ph, 0}},           {51, {poly4, 5}},          {52, {polytubes, 6}},
    {53, {quantum, 1}},   {57, {distance, 0}},     {60, {rounded_box, 4}},    {61, {sphere, 1}},
    {62, {spikes, 5}},    {63, {spikes_2d, 4}},    {64, {spiral, 6}},         {68, {superellipsoid, 2}},
    {69, {th, 0}},        {70, {torus, 2}},        {77, {nothing, 0}},  // the place of pattern functions
};

}  // namespace

Entry transcendental_function(int n) { return entry_of(n, kTranscendentals); }

}  // namespace verisim::functions
