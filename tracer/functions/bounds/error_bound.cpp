#include "tracer/functions/bounds/error_bound.h"

#include <vector>

#include "tracer/functions/bounds/interval.h"
#include "tracer/functions/program_packet.h"

namespace verisim::functions {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kRounding = 0x1p-51;  // of two results, relative to the larger one

// What exact values may be, and how far near ones are from them. Operations on equal values give equal results.
struct Value {
  Interval exact;
  double error_bound = 0;
};

Interval quotient(const Interval& a, const Interval& b) {
  if (!(b.least_magnitude() > 0x1p-300)) return Interval::everything();
  return a * Interval::around(1 / b.high, 1 / b.low);
}

Value near(const Interval& exact, double error_bound) {
  const double size = exact.magnitude();
  return {exact,
          error_bound + ProgramKernels::kApproximateError + (error_bound > 0 && size <= 1e300 ? size * kRounding : 0)};
}

Value unary(Code code, const Value& a) {
  const Interval& v = a.exact;
  const double unless_same = a.error_bound == 0 ? 0 : kUnknown;
  switch (code) {
    case Code::move:
      return a;
    case Code::negate:
      return {-v, a.error_bound};
    case Code::abs:
      return {{v.least_magnitude(), v.magnitude()}, a.error_bound};
    case Code::sin:
      return v.magnitude() + a.error_bound < ProgramKernels::kMaxApproximate ? near(sine(v), a.error_bound)
                                                                             : Value{{-1, 1}, kUnknown};
    case Code::cos:
      return v.magnitude() + a.error_bound < ProgramKernels::kMaxApproximate ? near(cosine(v), a.error_bound)
                                                                             : Value{{-1, 1}, kUnknown};
    case Code::sqrt: {
      const Interval root = Interval::around(std::sqrt(std::max(v.low, 0.0)), std::sqrt(std::max(v.high, 0.0)));
      if (a.error_bound == 0) return {root, 0};
      return {root,
              v.low > 2 * a.error_bound ? a.error_bound / std::sqrt(v.low) + root.magnitude() * kRounding : kUnknown};
    }
    default:
      return {Interval::everything(), unless_same};
  }
}

Value binary(Code code, const Value& a, const Value& b) {
  const bool same = a.error_bound == 0 && b.error_bound == 0;
  const auto rounded = [&](const Interval& exact, double error_bound) {
    return Value{exact, same ? 0 : error_bound + (exact.magnitude() + error_bound) * kRounding};
  };
  switch (code) {
    case Code::add:
      return rounded(a.exact + b.exact, a.error_bound + b.error_bound);
    case Code::subtract:
      return rounded(a.exact - b.exact, a.error_bound + b.error_bound);
    case Code::multiply:
      return rounded(a.exact * b.exact, a.exact.magnitude() * b.error_bound + b.exact.magnitude() * a.error_bound +
                                            a.error_bound * b.error_bound);
    case Code::divide: {
      const double least = b.exact.least_magnitude() - b.error_bound;
      return rounded(quotient(a.exact, b.exact),
                     least > 0x1p-300 ? (a.error_bound + quotient(a.exact, b.exact).magnitude() * b.error_bound) / least
                                      : kUnknown);
    }
    case Code::minimum:
      return {{std::min(a.exact.low, b.exact.low), std::min(a.exact.high, b.exact.high)},
              std::max(a.error_bound, b.error_bound)};
    case Code::maximum:
      return {{std::max(a.exact.low, b.exact.low), std::max(a.exact.high, b.exact.high)},
              std::max(a.error_bound, b.error_bound)};
    case Code::atan2:
      return near({-3.2, 3.2}, same ? 0 : kUnknown);
    default:
      return {Interval::everything(), same ? 0 : kUnknown};
  }
}

}  // namespace

double error_bound(const Program& program, const Box3& box) {
  if (program.has_jumps() || !program.calls().empty() || program.parameters() != 3) return kUnknown;
  std::vector<double> constants(program.registers());
  program.set_constants(constants.data(), 1);
  std::vector<Value> r;
  for (const double c : constants) r.push_back({{c, c}, 0});
  for (unsigned k = 0; k < 3; ++k) r[k].exact = {box.min[static_cast<int>(k)], box.max[static_cast<int>(k)]};
  for (const Instruction& i : program.code()) {
    if (i.code == Code::select) {
      const Value &a = r[i.b], &b = r[i.c], &c = r[i.d];
      const double most = std::max({a.error_bound, b.error_bound, c.error_bound});
      r[i.to] = {
          {std::min({a.exact.low, b.exact.low, c.exact.low}), std::max({a.exact.high, b.exact.high, c.exact.high})},
          r[i.a].error_bound == 0 ? most : kUnknown};
    } else {
      r[i.to] = is_unary(i.code) ? unary(i.code, r[i.a]) : binary(i.code, r[i.a], r[i.b]);
    }
  }
  const double found = r[program.result_register()].error_bound;
  return found < kUnknown ? found : kUnknown;
}

}  // namespace verisim::functions
