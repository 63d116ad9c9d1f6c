#include "tracer/functions/bounds/drift.h"

#include <vector>

#include "tracer/functions/bounds/interval.h"
#include "tracer/functions/program_lanes.h"

namespace verisim::functions {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kRounding = 0x1p-51;  // of two results, relative to the larger one

// What exact values may be, and how far near ones are from them. Operations on equal values give equal results.
struct Value {
  Interval exact;
  double drift = 0;
};

Interval quotient(const Interval& a, const Interval& b) {
  if (!(b.least_magnitude() > 0x1p-300)) return Interval::everything();
  return a * Interval::around(1 / b.high, 1 / b.low);
}

Value near(const Interval& exact, double drift) {
  const double size = exact.magnitude();
  return {exact, drift + LaneKernels::kNearError + (drift > 0 && size <= 1e300 ? size * kRounding : 0)};
}

Value unary(Code code, const Value& a) {
  const Interval& v = a.exact;
  const double unless_same = a.drift == 0 ? 0 : kUnknown;
  switch (code) {
    case Code::move:
      return a;
    case Code::negate:
      return {-v, a.drift};
    case Code::abs:
      return {{v.least_magnitude(), v.magnitude()}, a.drift};
    case Code::sin:
      return v.magnitude() + a.drift < LaneKernels::kMostNear ? near(sine(v), a.drift) : Value{{-1, 1}, kUnknown};
    case Code::cos:
      return v.magnitude() + a.drift < LaneKernels::kMostNear ? near(cosine(v), a.drift) : Value{{-1, 1}, kUnknown};
    case Code::sqrt: {
      const Interval root = Interval::around(std::sqrt(std::max(v.low, 0.0)), std::sqrt(std::max(v.high, 0.0)));
      if (a.drift == 0) return {root, 0};
      return {root, v.low > 2 * a.drift ? a.drift / std::sqrt(v.low) + root.magnitude() * kRounding : kUnknown};
    }
    default:
      return {Interval::everything(), unless_same};
  }
}

Value binary(Code code, const Value& a, const Value& b) {
  const bool same = a.drift == 0 && b.drift == 0;
  const auto rounded = [&](const Interval& exact, double drift) {
    return Value{exact, same ? 0 : drift + (exact.magnitude() + drift) * kRounding};
  };
  switch (code) {
    case Code::add:
      return rounded(a.exact + b.exact, a.drift + b.drift);
    case Code::subtract:
      return rounded(a.exact - b.exact, a.drift + b.drift);
    case Code::multiply:
      return rounded(a.exact * b.exact,
                     a.exact.magnitude() * b.drift + b.exact.magnitude() * a.drift + a.drift * b.drift);
    case Code::divide: {
      const double least = b.exact.least_magnitude() - b.drift;
      return rounded(
          quotient(a.exact, b.exact),
          least > 0x1p-300 ? (a.drift + quotient(a.exact, b.exact).magnitude() * b.drift) / least : kUnknown);
    }
    case Code::minimum:
      return {{std::min(a.exact.low, b.exact.low), std::min(a.exact.high, b.exact.high)}, std::max(a.drift, b.drift)};
    case Code::maximum:
      return {{std::max(a.exact.low, b.exact.low), std::max(a.exact.high, b.exact.high)}, std::max(a.drift, b.drift)};
    case Code::atan2:
      return near({-3.2, 3.2}, same ? 0 : kUnknown);
    default:
      return {Interval::everything(), same ? 0 : kUnknown};
  }
}

}  // namespace

double drift(const Program& program, const Box3& box) {
  if (program.has_jumps() || !program.calls().empty() || program.parameters() != 3) return kUnknown;
  std::vector<double> constants(program.registers());
  program.set_constants(constants.data(), 1);
  std::vector<Value> r;
  for (const double c : constants) r.push_back({{c, c}, 0});
  for (unsigned k = 0; k < 3; ++k) r[k].exact = {box.min[static_cast<int>(k)], box.max[static_cast<int>(k)]};
  for (const Instruction& i : program.code()) {
    if (i.code == Code::select) {
      const Value &a = r[i.b], &b = r[i.c], &c = r[i.d];
      const double most = std::max({a.drift, b.drift, c.drift});
      r[i.to] = {
          {std::min({a.exact.low, b.exact.low, c.exact.low}), std::max({a.exact.high, b.exact.high, c.exact.high})},
          r[i.a].drift == 0 ? most : kUnknown};
    } else {
      r[i.to] = is_unary(i.code) ? unary(i.code, r[i.a]) : binary(i.code, r[i.a], r[i.b]);
    }
  }
  const double found = r[program.result_register()].drift;
  return found < kUnknown ? found : kUnknown;
}

}  // namespace verisim::functions
