// Algebraic surfaces among the internal functions. X, Y, Z are the squares of the coordinates, as in the
// specification's table. Products and sums stand in the order that gives POV-Ray's last bits (spec 01 section 24).
#include "tracer/functions/internal/formula_table.h"

namespace verisim::functions {

namespace {

// "SOR": a 2D curve turned about y: x becomes the distance from the axis less `offset`, then (x, y) turns by `angle`
// degrees.
Call3 revolve(const Call3& c, double on, double offset, double angle) {
  if (!(on > 0)) return c;
  const double r = hyp(c.x, c.z) - offset;
  if (angle == 0) return {r, c.y, c.z, c.p};
  const double a = angle * (kPi / 180), s = std::sin(a), k = std::cos(a);
  return {r * k - c.y * s, r * s + c.y * k, c.z, c.p};
}

struct Squares {
  double X, Y, Z, Q;  // Q: their sum
  explicit Squares(const Call3& c) : X(c.x * c.x), Y(c.y * c.y), Z(c.z * c.z), Q(X + Y + Z) {}
};

#define FORMULA(NAME) double NAME([[maybe_unused]] const Call3& c)
#define WITH_SQUARES                                       \
  [[maybe_unused]] const double x = c.x, y = c.y, z = c.z; \
  [[maybe_unused]] const double* const P = c.p;            \
  const Squares squares(c);                                \
  [[maybe_unused]] const double X = squares.X, Y = squares.Y, Z = squares.Z, Q = squares.Q

double algebraic_cylinder1(const Call3& at) {
  Call3 c = revolve(at, at.p[2], at.p[3], at.p[4]);
  c.x = std::fabs(c.x);
  WITH_SQUARES;
  return limit(P[0] * (X * x - X + Y), P[1]);
}
double algebraic_cylinder2(const Call3& at) {
  const Call3 c = revolve(at, at.p[2], at.p[3], at.p[4]);
  WITH_SQUARES;
  return limit(-P[0] * (2 * X * X - 3 * X * y + Y - 2 * Y * y + Y * Y), P[1]);
}
double algebraic_cylinder3(const Call3& at) {
  const Call3 c = revolve(at, at.p[2], at.p[3], at.p[4]);
  WITH_SQUARES;
  return limit(-P[0] * (X * X + X * Y - 2 * X * y - x * Y + Y), P[1]);
}
double algebraic_cylinder4(const Call3& at) {
  const Call3 c = revolve(at, at.p[2], at.p[3], at.p[4]);
  WITH_SQUARES;
  return limit(-P[0] * (X * X + Y * Y + 2 * X * Y + 3 * X * y - Y * y), P[1]);
}
FORMULA(bicorn) {
  WITH_SQUARES;
  const double q = X + Z, a = P[1] * P[1];
  return limit(P[0] * (Y * (a - q) - sq(q + 2 * P[1] * y - a)));
}
FORMULA(bifolia) {
  WITH_SQUARES;
  return limit(-P[0] * (Q * Q - P[1] * (X + Z) * y));
}
FORMULA(boy_surface) {
  WITH_SQUARES;
  const double w = 1 - z, q = X + Y, s = std::sqrt(2.0);
  return limit(P[0] * P[1] *
               (64 * cube(w) * Z * z - 48 * sq(w) * Z * (3 * q + 2 * Z) +
                12 * w * z * (27 * sq(q) - 24 * Z * q + 36 * s * y * z * (Y - 3 * X) + 4 * sq(Z)) +
                (9 * q - 2 * Z) * (-81 * sq(q) - 72 * Z * q + 108 * s * x * z * (X - 3 * Y) + 4 * sq(Z))));
}
FORMULA(crossed_trough) {
  WITH_SQUARES;
  return limit(P[0] * (X * z * z - y));
}
FORMULA(cubic_saddle) {
  WITH_SQUARES;
  return limit(-P[0] * (X * x - Y * y - z));
}
FORMULA(cushion) {
  WITH_SQUARES;
  return limit(P[0] *
               (Z * X - Z * Z - 2 * z * X + 2 * Z * z + X - Z - sq(X - z) - Y * Y - 2 * X * Y - Y * Z + 2 * Y * z + Y));
}
FORMULA(devils_curve) {
  WITH_SQUARES;
  return limit(-P[0] * (X * X + 2 * X * Z - 0.36 * X - Y * Y + 0.25 * Y + Z * Z));
}
double devils_curve_2d(const Call3& at) {
  const Call3 c = revolve(at, at.p[3], at.p[4], at.p[5]);
  WITH_SQUARES;
  return limit(-P[0] * (X * (X - sq(P[1])) - Y * (Y - sq(P[2]))));
}
FORMULA(dupin_cyclid) {
  WITH_SQUARES;
  const double R = P[1], a = sq(P[2]), e = P[3], d = P[4], k = sq(P[5]);
  const double A = a - d * d - sq(e + R), B = a - d * d - sq(e - R), t = e * x + d * y;
  return limit(-P[0] * (A * B * Q * Q + 2 * k * Q * ((a + R * R - e * e - d * d) * (2 * t - k) - 4 * d * a * y) +
                        4 * k * k * t * (t - k) + 4 * k * k * R * R * Y + k * k * k * k));
}
FORMULA(enneper) {
  WITH_SQUARES;
  const double m = std::fabs(z) < 0.2 ? 0.2 : z;
  const double a = (Y - X) / (2 * m) + 2 * Z / 9, b = (Y - X) / (4 * m);
  return limit(-P[0] * (cube(a) - 6 * b * b));
}
FORMULA(folium_surface) {
  WITH_SQUARES;
  return limit(P[0] * ((Y + Z) * (1 + (P[2] - 4 * P[1]) * x) + X * (1 + P[2])));
}
double folium_surface_2d(const Call3& at) {
  const Call3 c = revolve(at, at.p[3], at.p[4], at.p[5]);
  WITH_SQUARES;
  return limit(-P[0] * (Y * (1 + (P[2] - 4 * P[1]) * x) + X * (1 + P[2])));
}
FORMULA(glob) {
  WITH_SQUARES;
  return limit(P[0] * (0.5 * X * X * x + 0.5 * X * X - (Y + Z)));
}
FORMULA(heart) {
  WITH_SQUARES;
  return limit(-P[0] * (cube(2 * X + Y + Z - 1) - 0.1 * X * Z * z - Y * Z * z));
}
FORMULA(hunt_surface) {
  WITH_SQUARES;
  return limit(-P[0] * (4 * cube(Q - 13) + 27 * sq(3 * X + Y - 4 * Z - 12)));
}
FORMULA(hyperbolic_torus) {
  WITH_SQUARES;
  const double a = sq(P[1]), b = sq(P[2]);
  return limit(-P[0] * (X * X + 2 * X * Y - 2 * X * Z - 2 * (a + b) * X + Y * Y - 2 * Y * Z + 2 * (a - b) * Y + Z * Z +
                        2 * (a + b) * Z + sq(a - b)));
}
FORMULA(kampyle_of_eudoxus) {
  WITH_SQUARES;
  const double b = sq(P[2]);
  return limit(-P[0] * (Y + Z - b * X * X + b * P[1] * P[1] * X));
}
double kampyle_of_eudoxus_2d(const Call3& at) {
  const Call3 c = revolve(at, at.p[3], at.p[4], at.p[5]);
  WITH_SQUARES;
  const double b = sq(P[2]);
  return limit(-P[0] * (Y - b * X * X + b * P[1] * P[2] * X));
}
FORMULA(klein_bottle) {
  WITH_SQUARES;
  const double m = Q - 2 * y - 1;
  return limit(-P[0] * ((Q + 2 * y - 1) * (m * m - 8 * Z) + 16 * x * z * m));
}
FORMULA(kummer_surface_v1) {
  WITH_SQUARES;
  return limit(-P[0] * (X * X + Y * Y + Z * Z - X - Y - Z - X * Y - X * Z - Y * Z + 1));
}
FORMULA(kummer_surface_v2) {
  WITH_SQUARES;
  return limit(-P[0] * (X * X + Y * Y + Z * Z + P[1] * Q + P[2] * (X * Y + X * Z + Y * Z) + P[3] * x * y * z - 1));
}
FORMULA(lemniscate_of_gerono) {
  WITH_SQUARES;
  return limit(-P[0] * (X * X - X + Y + Z));
}
double lemniscate_of_gerono_2d(const Call3& at) {
  const Call3 c = revolve(at, at.p[3], at.p[4], at.p[5]);
  WITH_SQUARES;
  const double b = sq(P[2]);
  return limit(-P[0] * (Y - b * P[1] * P[1] * X + b * X * X));
}
FORMULA(mitre) {
  WITH_SQUARES;
  return limit(-P[0] * (4 * X * Q - Y * (1 - Y - Z)));
}
FORMULA(nodal_cubic) {
  WITH_SQUARES;
  return limit(-P[0] * (Y * y + Z * z - 6 * y * z));
}
FORMULA(ovals_of_cassini) {
  WITH_SQUARES;
  return limit(-P[0] * (sq(Q + sq(P[1])) - P[3] * P[1] * P[1] * (X + Z) - sq(P[2])));
}
FORMULA(paraboloid) {
  WITH_SQUARES;
  return limit(-P[0] * (X - y + Z));
}
FORMULA(parabolic_torus) {
  WITH_SQUARES;
  const double a = sq(P[1]), b = sq(P[2]);
  return limit(-P[0] * (X * X + 2 * X * Y - 2 * X * z - (a + b) * X + Y * Y - 2 * Y * z + (a - b) * Y + Z +
                        (a + b) * z + sq(a - b)));
}
FORMULA(pillow) {
  WITH_SQUARES;
  return limit(P[0] * (X * X + Y * Y + Z * Z - (X + Y + Z)));
}
FORMULA(piriform) {
  WITH_SQUARES;
  return limit(P[0] * (X * X - X * x + Y + Z));
}
double piriform_2d(const Call3& at) {
  const Call3 c = revolve(at, at.p[4], at.p[5], at.p[6]);
  WITH_SQUARES;
  return limit(-P[0] * (Y - P[1] * P[3] * P[3] * X * x - P[2] * P[3] * P[3] * X * X));
}
FORMULA(quartic_paraboloid) {
  WITH_SQUARES;
  return limit(-P[0] * (X * X + Z * Z - y));
}
FORMULA(quartic_saddle) {
  WITH_SQUARES;
  return limit(-P[0] * (X * X - Z * Z - y));
}
FORMULA(quartic_cylinder) {
  WITH_SQUARES;
  const double h = X + Z, b = sq(P[2]);
  return limit(-P[0] * (h * y * y + b * h - b * P[1] * P[1]));
}
FORMULA(steiners_roman) {
  WITH_SQUARES;
  return limit(-P[0] * (X * Y + X * Z + Y * Z + x * y * z));
}
FORMULA(strophoid) {
  WITH_SQUARES;
  const double b = sq(P[3]);
  return limit(-P[0] * ((P[2] - x) * (Y + Z) - b * P[1] * X - b * X * x));
}
double strophoid_2d(const Call3& at) {
  const Call3 c = revolve(at, at.p[4], at.p[5], at.p[6]);
  WITH_SQUARES;
  const double b = sq(P[3]);
  return limit(-P[0] * ((P[2] - x) * Y - b * P[1] * X - b * X * x));
}
FORMULA(torus2) {
  WITH_SQUARES;
  const double a = sq(P[1]), b = sq(P[2]);
  return limit(-P[0] * (X * X + Y * Y + Z * Z + 2 * X * Y + 2 * X * Z + 2 * Y * Z - 2 * (a + b) * X + 2 * (a - b) * Y -
                        2 * (a + b) * Z + sq(a - b)));
}
FORMULA(torus_gumdrop) {
  WITH_SQUARES;
  const double h = Y + Z;
  return limit(-P[0] * (4 * (X * X + h * h) + 17 * X * h - 20 * Q + 17));
}
FORMULA(umbrella) {
  WITH_SQUARES;
  return limit(-P[0] * (X - y * z * z));
}
FORMULA(witch_of_agnesi) {
  WITH_SQUARES;
  return limit(-P[0] * (P[1] * (y - 1) + (X + Z) * y));
}
double witch_of_agnesi_2d(const Call3& at) {
  const Call3 c = revolve(at, at.p[3], at.p[4], at.p[5]);
  WITH_SQUARES;
  return limit(-P[0] * (sq(P[1]) * y + X * y - P[2]));
}

#undef FORMULA
#undef WITH_SQUARES

// By number: the formula and how many parameters it has.
constexpr NumberedEntry kPolynomials[] = {
    {0, {algebraic_cylinder1, 5}},
    {1, {algebraic_cylinder2, 5}},
    {2, {algebraic_cylinder3, 5}},
    {3, {algebraic_cylinder4, 5}},
    {4, {bicorn, 2}},
    {5, {bifolia, 2}},
    {8, {boy_surface, 2}},
    {11, {crossed_trough, 1}},
    {12, {cubic_saddle, 1}},
    {13, {cushion, 1}},
    {14, {devils_curve, 1}},
    {15, {devils_curve_2d, 6}},
    {16, {dupin_cyclid, 6}},
    {18, {enneper, 1}},
    {20, {folium_surface, 3}},
    {21, {folium_surface_2d, 6}},
    {22, {glob, 1}},
    {23, {heart, 1}},
    {30, {hunt_surface, 1}},
    {31, {hyperbolic_torus, 3}},
    {33, {kampyle_of_eudoxus, 3}},
    {34, {kampyle_of_eudoxus_2d, 6}},
    {35, {klein_bottle, 1}},
    {36, {kummer_surface_v1, 1}},
    {37, {kummer_surface_v2, 4}},
    {38, {lemniscate_of_gerono, 1}},
    {39, {lemniscate_of_gerono_2d, 6}},
    {41, {mitre, 1}},
    {42, {nodal_cubic, 1}},
    {43, {cushion, 1}},
    {44, {ovals_of_cassini, 4}},
    {45, {paraboloid, 1}},
    {46, {parabolic_torus, 3}},
    {48, {pillow, 1}},
    {49, {piriform, 1}},
    {50, {piriform_2d, 7}},
    {54, {quartic_paraboloid, 1}},
    {55, {quartic_saddle, 1}},
    {56, {quartic_cylinder, 3}},
    {65, {steiners_roman, 1}},
    {66, {strophoid, 4}},
    {67, {strophoid_2d, 7}},
    {71, {torus2, 3}},
    {72, {torus_gumdrop, 1}},
    {73, {umbrella, 1}},
    {74, {witch_of_agnesi, 2}},
    {75, {witch_of_agnesi_2d, 6}},
};

}  // namespace

Entry polynomial_function(int n) { return entry_of(n, kPolynomials); }

}  // namespace verisim::functions
