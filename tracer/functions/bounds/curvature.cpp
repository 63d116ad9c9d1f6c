#include "tracer/functions/bounds/curvature.h"

#include <array>
#include <optional>
#include <vector>

#include "tracer/functions/bounds/interval.h"
#include "tracer/functions/program_packet.h"

namespace verisim::functions {

Interval sine(const Interval& a) {
  constexpr double kTurn = 6.28318530717958647693, kQuarter = kTurn / 4, kManyTurns = 1e6;
  if (!(a.high - a.low < kTurn) || a.magnitude() > kManyTurns) return {-1, 1};
  constexpr double kNear = 1e-9;  // more than what rounding moves the places of the extremes
  const auto holds = [&](double extreme) {
    return extreme + kTurn * std::ceil((a.low - kNear - extreme) / kTurn) <= a.high + kNear;
  };
  const double p = std::sin(a.low), q = std::sin(a.high);
  const Interval inner = Interval::around(std::min(p, q), std::max(p, q));
  return {holds(-kQuarter) ? -1 : inner.low, holds(kQuarter) ? 1 : inner.high};
}

// A value over the box.
struct CurvatureBounds::Jet {
  Interval value;
  std::array<Interval, 3> slope;
  std::array<Interval, 6> bend;  // xx yy zz xy xz yz
  double error = 0;              // of the computed value
  bool smooth = true;            // false: nothing is known
  unsigned axes = 0;             // the coordinates it depends on; derivatives by others are zero
};

namespace {

using Jet = CurvatureBounds::Jet;

constexpr double kRounding =
    0x1p-51;  // of an operation, or of a function of the C library, relative to the largest result

constexpr std::array<std::array<int, 2>, 6> kPairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

// Calls by_one(i) and by_two(i, p, q) for the derivatives by the coordinates of `axes`.
template <class ByOne, class ByTwo>
void each_derivative(unsigned axes, ByOne&& by_one, ByTwo&& by_two) {
  for (std::size_t i = 0; i < 3; ++i)
    if (axes >> i & 1) by_one(i);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [p, q] = kPairs[i];
    if (axes >> p & axes >> q & 1) by_two(i, static_cast<std::size_t>(p), static_cast<std::size_t>(q));
  }
}

Jet rough() {
  Jet result;
  result.smooth = false;
  return result;
}
Jet constant(double v) {
  Jet result;
  result.value = {v, v};
  return result;
}
Jet rounded(Jet jet) {
  jet.error += jet.value.magnitude() * kRounding;
  return jet;
}

Jet sum(const Jet& a, const Jet& b, bool subtracted) {
  Jet result;
  const auto both = [&](const Interval& p, const Interval& q) { return subtracted ? p - q : p + q; };
  result.value = both(a.value, b.value);
  result.axes = a.axes | b.axes, result.smooth = a.smooth && b.smooth;
  if (b.axes == 0) {
    result.slope = a.slope, result.bend = a.bend;
  } else {
    each_derivative(
        result.axes, [&](std::size_t i) { result.slope[i] = both(a.slope[i], b.slope[i]); },
        [&](std::size_t i, std::size_t, std::size_t) { result.bend[i] = both(a.bend[i], b.bend[i]); });
  }
  result.error = a.error + b.error;
  return rounded(result);
}

Jet product(const Jet& a, const Jet& b) {
  if (a.axes == 0 && b.axes != 0) return product(b, a);
  Jet result;
  result.value = a.value * b.value;
  result.axes = a.axes | b.axes, result.smooth = a.smooth && b.smooth;
  if (b.axes == 0) {
    each_derivative(
        a.axes, [&](std::size_t i) { result.slope[i] = b.value * a.slope[i]; },
        [&](std::size_t i, std::size_t, std::size_t) { result.bend[i] = b.value * a.bend[i]; });
  } else {
    each_derivative(
        result.axes, [&](std::size_t i) { result.slope[i] = a.value * b.slope[i] + b.value * a.slope[i]; },
        [&](std::size_t i, std::size_t p, std::size_t q) {
          result.bend[i] =
              a.value * b.bend[i] + b.value * a.bend[i] + a.slope[p] * b.slope[q] + a.slope[q] * b.slope[p];
        });
  }
  result.error = a.value.magnitude() * b.error + b.value.magnitude() * a.error + a.error * b.error;
  return rounded(result);
}

// f(a), from f and its first two derivatives over a's values.
Jet applied(const Jet& a, const Interval& f, const Interval& first, const Interval& second) {
  Jet result;
  result.value = f;
  result.axes = a.axes, result.smooth = a.smooth;
  each_derivative(
      result.axes, [&](std::size_t i) { result.slope[i] = first * a.slope[i]; },
      [&](std::size_t i, std::size_t p, std::size_t q) {
        result.bend[i] = first * a.bend[i] + second * (p == q ? square(a.slope[p]) : a.slope[p] * a.slope[q]);
      });
  result.error = first.magnitude() * a.error;
  return rounded(result);
}

Jet squared(const Jet& a) { return applied(a, square(a.value), 2 * a.value, {2, 2}); }

// Where a function is not smooth, or not defined, is kept away from by more than what values may be wrong.
std::optional<Interval> away_from_zero(const Jet& a) {
  const Interval v{a.value.low - a.error, a.value.high + a.error};
  if (!(v.least_magnitude() > 0x1p-300)) return std::nullopt;
  return v;
}
Interval inverse(const Interval& v) { return Interval::around(1 / v.high, 1 / v.low); }  // of one sign

Jet reciprocal(const Jet& a) {
  const auto v = away_from_zero(a);
  if (!v) return rough();
  const Interval r = inverse(*v), r2 = square(r);
  return applied(a, r, -r2, 2 * (r2 * r));
}
Jet root(const Jet& a) {
  const auto v = away_from_zero(a);
  if (!v || v->low < 0) return rough();
  const Interval r = Interval::around(std::sqrt(v->low), std::sqrt(v->high)), first = 0.5 * inverse(r);
  return applied(a, r, first, -0.5 * (first * inverse(*v)));
}
Jet logarithm(const Jet& a) {
  const auto v = away_from_zero(a);
  if (!v || v->low < 0) return rough();
  const Interval r = inverse(*v);
  return applied(a, Interval::around(std::log(v->low), std::log(v->high)), r, -square(r));
}
Jet exponential(const Jet& a) {
  const Interval e = Interval::around(std::exp(a.value.low - a.error), std::exp(a.value.high + a.error));
  return applied(a, e, e, e);
}
// Those of ProgramKernels::approximate.
Jet approximate_sine(const Jet& a, const Interval& sine, const Interval& derivative) {
  if (!(a.value.magnitude() < ProgramKernels::kMaxApproximate)) return rough();
  Jet result = applied(a, sine, derivative, -sine);
  result.error += ProgramKernels::kApproximateError;
  return result;
}
Jet sine_of(const Jet& a) { return approximate_sine(a, sine(a.value), cosine(a.value)); }
Jet cosine_of(const Jet& a) { return approximate_sine(a, cosine(a.value), -sine(a.value)); }
Jet arctangent(const Jet& a) {
  const Interval d = square(a.value) + Interval{1, 1}, r = inverse({std::max(d.low, 0.5), d.high});
  return applied(a, Interval::around(std::atan(a.value.low), std::atan(a.value.high)), r, -2 * (a.value * square(r)));
}
Jet magnitude(const Jet& a) {
  if (!away_from_zero(a)) return rough();
  return a.value.low > 0 ? a : applied(a, -a.value, {-1, -1}, {});
}

Jet power(const Jet& base, double exponent) {
  const auto v = away_from_zero(base);
  if (!v || v->low < 0) return rough();
  const auto monotone = [&](double e) {
    const double p = std::pow(v->low, e), q = std::pow(v->high, e);
    return Interval::around(std::min(p, q), std::max(p, q));
  };
  return applied(base, monotone(exponent), exponent * monotone(exponent - 1),
                 Interval::around(exponent * (exponent - 1), exponent * (exponent - 1)) * monotone(exponent - 2));
}

// The angle of (x, y), which jumps where y is 0 and x negative: elsewhere it is an arctangent and a constant.
Jet angle(const Jet& y, const Jet& x) {
  constexpr double kQuarter = 1.57079632679489661923;
  if (const auto right = away_from_zero(x); right && right->low > 0) return arctangent(product(y, reciprocal(x)));
  const auto side = away_from_zero(y);
  if (!side) return rough();
  return sum(constant(side->low > 0 ? kQuarter : -kQuarter), arctangent(product(x, reciprocal(y))), true);
}

// The one that is chosen, if it is the same all over the box.
Jet chosen(const Jet& a, const Jet& b, bool greater) {
  const double slack = a.error + b.error;
  if (a.value.low > b.value.high + slack) return greater ? a : b;
  if (b.value.low > a.value.high + slack) return greater ? b : a;
  return rough();
}

bool all_smooth(std::initializer_list<const Jet*> jets) {
  return std::all_of(jets.begin(), jets.end(), [](const Jet* j) { return j->smooth; });
}

Jet unary(Code code, const Jet& a) {
  constexpr double kDegree = 180.0 / 3.14159265358979323846;
  switch (code) {
    case Code::move:
      return a;
    case Code::negate:
      return applied(a, -a.value, {-1, -1}, {});
    case Code::degrees:
      return product(a, constant(kDegree));
    case Code::radians:
      return product(a, constant(1 / kDegree));
    case Code::abs:
      return magnitude(a);
    case Code::sqrt:
      return root(a);
    case Code::ln:
      return logarithm(a);
    case Code::log:
      return product(logarithm(a), constant(1 / std::log(10.0)));
    case Code::exp:
      return exponential(a);
    case Code::sin:
      return sine_of(a);
    case Code::cos:
      return cosine_of(a);
    case Code::tan:
      return product(sine_of(a), reciprocal(cosine_of(a)));
    case Code::atan:
      return arctangent(a);
    default:
      return rough();
  }
}

Jet binary(Code code, const Jet& a, const Jet& b) {
  switch (code) {
    case Code::add:
      return sum(a, b, false);
    case Code::subtract:
      return sum(a, b, true);
    case Code::multiply:
      return &a == &b ? squared(a) : product(a, b);
    case Code::divide:
      return product(a, reciprocal(b));
    case Code::minimum:
      return chosen(a, b, false);
    case Code::maximum:
      return chosen(a, b, true);
    case Code::atan2:
      return angle(a, b);
    case Code::pow:
      return b.axes == 0 && b.value.low == b.value.high ? power(a, b.value.low) : rough();
    default:
      return rough();
  }
}

Jet result_of(const Instruction& i, const std::vector<Jet>& r) {
  const Jet& a = r[i.a];
  if (i.code == Code::select) {
    if (!all_smooth({&a})) return rough();
    return a.value.high + a.error < 0 ? r[i.b] : a.value.low - a.error > 0 ? r[i.d] : rough();
  }
  if (is_unary(i.code)) return all_smooth({&a}) ? unary(i.code, a) : rough();
  return all_smooth({&a, &r[i.b]}) ? binary(i.code, a, r[i.b]) : rough();
}

// The largest stretching of a symmetric matrix whose elements are not larger than those of m: by Collatz and Wielandt,
// from any positive vector.
double norm(const std::array<std::array<double, 3>, 3>& m) {
  std::array<double, 3> x{1, 1, 1};
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 4; ++round) {
    std::array<double, 3> y{};
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) y[i] += m[i][j] * x[j];
      largest = std::max(largest, y[i] / x[i]);
    }
    least = std::min(least, largest);
    const double scale = std::max({y[0], y[1], y[2]});
    if (!(scale > 0)) return 0;
    for (std::size_t i = 0; i < 3; ++i) x[i] = std::max(y[i] / scale, 0x1p-20);
  }
  return least * (1 + 1e-9);
}

}  // namespace

CurvatureBounds::CurvatureBounds(const Program& program, double coordinate_error)
    : program_(program), coordinate_error_(coordinate_error) {
  if (program.has_jumps() || !program.calls().empty() || program.parameters() != 3) return;
  std::vector<double> constants(program.registers());
  program.set_constants(constants.data(), 1);
  for (const double c : constants) registers_.push_back(constant(c));
}
CurvatureBounds::~CurvatureBounds() = default;

Curvature CurvatureBounds::within(const Box3& box) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  constexpr Curvature kUnknown{kNoLimit, {kNoLimit, kNoLimit, kNoLimit, kNoLimit, kNoLimit, kNoLimit}, 0};
  if (registers_.empty()) return kUnknown;
  for (unsigned k = 0; k < 3; ++k) {
    Jet& coordinate = registers_[k] = Jet{};
    coordinate.value = {box.min[static_cast<int>(k)] - coordinate_error_,
                        box.max[static_cast<int>(k)] + coordinate_error_};
    coordinate.slope[k] = {1, 1}, coordinate.axes = 1u << k, coordinate.error = coordinate_error_;
  }
  for (const Instruction& i : program_.code()) registers_[i.to] = result_of(i, registers_);
  const Jet& result = registers_[program_.result_register()];
  if (!result.smooth || !result.value.finite()) return kUnknown;
  std::array<std::array<double, 3>, 3> most{};
  Curvature found{0, {}, 2 * result.error};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [p, q] = kPairs[i];
    if (!result.bend[i].finite()) return kUnknown;
    most[p][q] = most[q][p] = found.parts[i] = result.bend[i].magnitude();
  }
  found.bend = norm(most);
  return std::isfinite(found.bend) && std::isfinite(result.error) ? found : kUnknown;
}

}  // namespace verisim::functions
