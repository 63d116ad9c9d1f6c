// Probes P24, P25, P27, P28 of spec 01, and random expressions against a plain model of the folding rules.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "tracer/functions/evaluation_budget.h"
#include "tracer/functions/expression.h"
#include "tracer/functions/program.h"

namespace verisim::functions {
namespace function_test {

Node num(double v) { return {Constant{v}}; }
Node arg(int i) { return {Parameter{i}}; }
Node neg(Node n) { return {Negate{{std::move(n)}}}; }
Node paren(Node n) {
  n.parenthesised = true;
  return n;
}
Node chain(std::vector<Node> operands, std::vector<Op> operators) {
  return {Chain{std::move(operands), std::move(operators)}};
}
Node call(Builtin b, std::vector<Node> arguments) { return {BuiltinCall{b, std::move(arguments)}}; }
Node call(FunctionPtr f, std::vector<Node> arguments) { return {UserCall{std::move(f), std::move(arguments)}}; }

double value(const Node& n, std::vector<double> arguments, int slots = 0) {
  const int count = static_cast<int>(arguments.size());
  const FunctionPtr f = compile(n, count, std::max(slots, count));
  double result;
  f->evaluate(arguments, &result);
  // Every batch must give the same bits.
  for (const std::size_t size : {1u, 3u, 8u, 9u, 70u}) {
    std::vector<double> columns, results(size);
    for (const double a : arguments) columns.insert(columns.end(), size, a);
    f->evaluate_batch(columns.data(), size, size, results.data());
    for (const double r : results) EXPECT_TRUE(r == result || (std::isnan(r) && std::isnan(result)));
  }
  return result;
}

constexpr Op kAdd = Op::add, kSub = Op::subtract, kMul = Op::multiply, kDiv = Op::divide;
Node product(double a, double b) { return chain({num(a), num(b)}, {kMul}); }

TEST(Functions, EvaluatesAsProbed) {
  const double nan = std::nan("");
  EXPECT_EQ(value(chain({arg(0), chain({arg(1), arg(1)}, {kMul})}, {kAdd}), {2, 3}), 11);
  EXPECT_EQ(value(chain({neg(arg(0)), neg(num(2))}, {kMul}), {3}), 6);
  EXPECT_EQ(value(chain({arg(0), arg(1)}, {Op::equal}), {1, 1 + 1e-11}), 0);
  const Node inner{Loop{true, 2, {num(1), arg(1), arg(2)}}};
  EXPECT_EQ(value(Node{Loop{false, 1, {num(1), arg(0), inner}}}, {4}, 3), 33);
  EXPECT_EQ(value(chain({arg(0), num(3)}, {kDiv}), {10}), 3.3333333333333330);
  EXPECT_EQ(value(chain({arg(0), paren(num(3))}, {kDiv}), {10}), 3.3333333333333335);
  EXPECT_EQ(value(call(Builtin::pow_, {arg(0), num(7)}), {1.1}), 1.9487171000000010);
  EXPECT_EQ(value(call(Builtin::pow_, {arg(0), paren(num(7))}), {1.1}), 1.9487171000000012);
  EXPECT_EQ(value(call(Builtin::pow_, {arg(0), arg(1)}), {0, 0}), 1);
  EXPECT_EQ(value(call(Builtin::pow_, {arg(0), num(0)}), {nan}), 1);
  EXPECT_EQ(value(chain({arg(0), num(1)}, {Op::greater}), {nan}), 1);
  EXPECT_EQ(value(chain({arg(0), num(1)}, {Op::less}), {nan}), 0);
  EXPECT_EQ(value(chain({arg(0), num(1)}, {Op::not_equal}), {nan}), 1);
  EXPECT_EQ(value(call(Builtin::select_, {arg(0), num(1), num(2), num(3)}), {nan}), 3);
  EXPECT_EQ(value(call(Builtin::select_, {arg(0), num(1), num(2)}), {0}), 2);
  EXPECT_EQ(value(call(Builtin::mod_, {num(-5.5), num(2)}), {}), -1.5);
  EXPECT_EQ(value(call(Builtin::div_, {num(-5.5), num(2)}), {}), -2);
  EXPECT_EQ(value(call(Builtin::int_, {arg(0)}), {-5.5}), -5);
  EXPECT_EQ(value(call(Builtin::int_, {arg(0)}), {1e10}), -2147483648.0);
  EXPECT_EQ(value(call(Builtin::int_, {arg(0)}), {nan}), -2147483648.0);
  EXPECT_TRUE(std::isnan(value(call(Builtin::acos_, {arg(0)}), {2})));
  EXPECT_TRUE(std::isinf(value(chain({num(1), arg(0)}, {kDiv}), {0})));
  EXPECT_EQ(value(call(Builtin::min_, {arg(0), num(1)}), {nan}), 1);
  EXPECT_EQ(value(call(Builtin::max_, {num(1), arg(0)}), {nan}), 1);
  EXPECT_EQ(value(Node{Zero{}}, {5}), 0);
}

TEST(Functions, FoldsChainsAsProbed) {
  const auto f1 = compile(chain({arg(0), num(10)}, {kAdd}), 1, 1);
  EXPECT_EQ(value(chain({arg(0), product(2, 3), num(4)}, {kSub, kAdd}), {0}), -10);
  EXPECT_EQ(value(chain({arg(0), product(2, 3), num(4)}, {kSub, kSub}), {0}), -2);
  EXPECT_EQ(value(chain({arg(0), chain({num(6), num(2)}, {kDiv}), num(4)}, {kSub, kAdd}), {0}), -7);
  EXPECT_EQ(value(chain({chain({num(2), arg(0)}, {kMul}), product(2, 3), num(4)}, {kSub, kAdd}), {0}), -10);
  EXPECT_EQ(value(chain({arg(0), paren(product(2, 3)), num(4)}, {kSub, kAdd}), {0}), -2);
  EXPECT_EQ(value(chain({num(1), product(2, 3), arg(0)}, {kSub, kAdd}), {0}), -5);
  EXPECT_EQ(value(chain({arg(0), product(2, 3), arg(0), num(4)}, {kSub, kAdd, kAdd}), {0}), -2);
  EXPECT_EQ(value(chain({arg(0), neg(num(2)), num(4)}, {kSub, kAdd}), {0}), -2);
  EXPECT_EQ(value(chain({chain({call(f1, {num(1)}), num(2), num(3)}, {kDiv, kMul}), arg(0)}, {kAdd}), {0}),
            1.8333333333333333);
  EXPECT_EQ(value(chain({call(f1, {arg(0)}), num(2), num(3)}, {kDiv, kMul}), {1}), 16.5);
  EXPECT_EQ(value(chain({chain({call(Builtin::sin_, {num(1)}), num(2), num(3)}, {kDiv, kMul}), arg(0)}, {kAdd}), {0}),
            0.1402451641346494);
  EXPECT_EQ(value(chain({arg(0), num(2), num(3)}, {Op::less, Op::less}), {5}), 0);
  EXPECT_EQ(value(chain({arg(0), num(2), num(4)}, {kMul, kDiv}), {3}), 1.5);
}

TEST(Functions, RejectsDivisionByLiteralZero) {
  EXPECT_THROW(compile(chain({arg(0), num(0)}, {kDiv}), 1, 1), std::invalid_argument);
  EXPECT_THROW(compile(chain({num(1), num(0)}, {kDiv}), 0, 0), std::invalid_argument);
}

// --- An independent model: evaluates the rules of 23.5 and 23.3 directly on the tree. ---
struct Model {
  std::vector<double> x;
  // A chain element as the rules see it: a known literal or an opaque value.
  struct Item {
    double v;
    bool literal, parameter;
  };
  Item item(const Node& n) const {
    Item r = bare(n);
    if (n.parenthesised) r.literal = false;
    return r;
  }
  Item bare(const Node& n) const {
    if (auto* c = std::get_if<Constant>(&n.value)) return {c->value, true, false};
    if (auto* p = std::get_if<Parameter>(&n.value)) return {x[static_cast<std::size_t>(p->index)], false, true};
    if (auto* m = std::get_if<Negate>(&n.value)) {
      Item i = item(m->operand[0]);
      i.v = -i.v;
      return i;
    }
    const auto& c = std::get<Chain>(n.value);
    std::vector<Item> items{item(c.operands[0])};
    std::vector<Op> ops;
    bool parameter = items[0].parameter;
    for (std::size_t k = 0; k < c.operators.size(); ++k) {
      Op op = c.operators[k];
      Item i = item(c.operands[k + 1]);
      if (op == kSub && std::holds_alternative<Constant>(c.operands[k + 1].value) && !c.operands[k + 1].parenthesised)
        op = kAdd, i.v = -i.v;
      parameter = parameter || i.parameter;
      const bool product_level = op == kMul || op == kDiv;
      if (items.back().literal && i.literal && !(product_level && parameter))
        items.back().v = plain(op, items.back().v, i.v);
      else
        items.push_back(i), ops.push_back(op);
    }
    Item result = items[0];
    for (std::size_t k = 0; k < ops.size(); ++k) {
      const Item& i = items[k + 1];
      result.v = ops[k] == kDiv && i.literal ? result.v * (1 / i.v) : plain(ops[k], result.v, i.v);
      result.literal = false;
    }
    result.parameter = parameter;
    return result;
  }
  static double plain(Op op, double a, double b) {
    return op == kAdd ? a + b : op == kSub ? a - b : op == kMul ? a * b : a / b;
  }
};

Node random_node(std::mt19937& rng, int depth) {
  std::uniform_int_distribution<int> pick(0, 9), digit(1, 9), length(2, 5);
  const int k = pick(rng);
  Node n;
  if (depth == 0 || k < 3)
    n = k % 2 == 0 ? num(digit(rng)) : arg(k % 3);
  else if (k == 3)
    n = neg(random_node(rng, 0));
  else {
    const bool sum = k % 2 == 0;
    std::vector<Node> operands;
    std::vector<Op> operators;
    for (int i = length(rng); i > 0; --i) {
      operands.push_back(random_node(rng, depth - 1));
      // A chain never directly holds one of the same or a looser level: the parser would have put it in parentheses.
      if (std::holds_alternative<Chain>(operands.back().value)) {
        const Op inner = std::get<Chain>(operands.back().value).operators[0];
        if (!(sum && (inner == kMul || inner == kDiv))) operands.back().parenthesised = true;
      }
      if (i > 1) operators.push_back(sum ? (pick(rng) % 2 ? kAdd : kSub) : (pick(rng) % 3 ? kMul : kDiv));
    }
    n = chain(std::move(operands), std::move(operators));
    n.parenthesised = pick(rng) == 0;
  }
  return n;
}

TEST(Functions, RandomExpressionsFollowTheFoldingRules) {
  std::mt19937 rng(20);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const Node n = random_node(rng, 3);
    const std::vector<double> x{1.25, -0.7, 3.1};
    const double expected = Model{x}.item(n).v;
    const double got = value(n, x);
    ASSERT_TRUE(got == expected || (std::isnan(got) && std::isnan(expected))) << i << ": " << got << " != " << expected;
    ++compared;
  }
  EXPECT_EQ(compared, 3000);
}

// Random programs with everything in them: one point and batches, inlined and called, must agree.
TEST(Functions, SelectsAndLoopsAreLazyAndExact) {
  const auto cube = compile(call(Builtin::pow_, {arg(0), num(3)}), 1, 1);
  // select(x, -cube(x), 0, sum(i,1,4,cube(x)*i))
  const Node loop{Loop{false, 1, {num(1), num(4), chain({call(cube, {arg(0)}), arg(1)}, {kMul})}}};
  const Node n = call(Builtin::select_, {arg(0), neg(call(cube, {arg(0)})), num(7), loop});
  EXPECT_EQ(value(n, {-2}, 2), 8);
  EXPECT_EQ(value(n, {0}, 2), 7);
  EXPECT_EQ(value(n, {2}, 2), 80);
  EXPECT_EQ(value(Node{Loop{false, 1, {num(3), num(2), num(1)}}}, {0}, 2), 0);
  EXPECT_EQ(value(Node{Loop{true, 1, {num(3), num(2), num(1)}}}, {0}, 2), 1);
}

TEST(Functions, ManyRegistersSpillToTheHeap) {
  std::vector<Node> operands;
  for (int i = 0; i < 400; ++i) operands.push_back(call(Builtin::sin_, {chain({arg(0), num(i + 1)}, {kMul})}));
  // Sums from the right keep all sines alive: sin1 - (sin2 - (sin3 - ...)).
  Node n = operands.back();
  for (int i = 398; i >= 0; --i) n = paren(chain({operands[static_cast<std::size_t>(i)], n}, {kSub}));
  double expected = std::sin(0.3 * 400);
  for (int i = 399; i >= 1; --i) expected = std::sin(0.3 * i) - expected;
  EXPECT_EQ(value(n, {0.3}), expected);
}

TEST(Functions, RepeatedInliningStaysSmall) {
  FunctionPtr f = compile(chain({arg(0), arg(0)}, {kMul}), 1, 1);
  for (int i = 0; i < 60; ++i) f = compile(chain({call(f, {arg(0)}), call(f, {arg(0)})}, {kAdd}), 1, 1);
  const double one = 1;
  double result;
  f->evaluate({&one, 1}, &result);
  EXPECT_EQ(result, std::ldexp(1.0, 60));
}

// Each calls the one before twice, with other arguments, so that nothing is shared.
FunctionPtr doubled(int times) {
  FunctionPtr f = compile(call(Builtin::abs_, {arg(0)}), 1, 1);
  for (int i = 0; i < times; ++i)
    f = compile(chain({call(f, {chain({arg(0), num(2)}, {kMul})}), call(f, {chain({arg(0), num(3)}, {kMul})})}, {kAdd}),
                1, 1);
  return f;
}

TEST(Functions, ValuesThatNobodyCanWaitForAreCutShort) {
  EvaluationBudget::take_overrun();
  const double one = 1;
  double result = 0;
  doubled(14)->evaluate({&one, 1}, &result);
  EXPECT_FALSE(std::isnan(result));
  EXPECT_FALSE(EvaluationBudget::take_overrun());

  const FunctionPtr endless = doubled(60);
  endless->evaluate({&one, 1}, &result);
  EXPECT_TRUE(std::isnan(result));
  EXPECT_TRUE(EvaluationBudget::take_overrun());
  EXPECT_FALSE(EvaluationBudget::take_overrun());

  const std::vector<double> arguments(70, 1.0);
  std::vector<double> results(70);
  endless->evaluate_batch(arguments.data(), 70, 70, results.data());
  EXPECT_TRUE(std::isnan(results[0]) && std::isnan(results[69]));
  EXPECT_TRUE(EvaluationBudget::take_overrun());
}

TEST(InternalFunctions, TableAtOnePoint) {
  const double expected[] = {0.1657749528424,
                             -0.3518815233621,
                             -0.1671916679978,
                             -0.08884547308266,
                             -0.27148,
                             -0.36476,
                             -0.0657371118125,
                             -0.5187280173509,
                             -10,
                             -0.07367715054362,
                             -0.08383109941525,
                             0.46475,
                             0.4499,
                             0.01925,
                             -0.10736,
                             -0.1680361898762,
                             -5.043266459,
                             0.5714017850865,
                             0.005907789163237,
                             -1.242771145764,
                             0.41272,
                             -1.397082134842,
                             -0.4452085,
                             0.0990506,
                             -0.5169048105155,
                             0.2830951894845,
                             -0.171673560951,
                             0.4964101615138,
                             0.05980762113533,
                             1.189759086954,
                             10,
                             -0.33968,
                             -0.07825313791474,
                             -0.4681072,
                             -0.1771692649122,
                             -3.5233,
                             -0.57123,
                             0.629508,
                             -0.36091,
                             -0.2374895405282,
                             0.1236937115126,
                             -0.09416,
                             -1.3871,
                             0.01925,
                             -0.04224,
                             -0.814,
                             -0.55671,
                             2.172060543474,
                             -0.44418,
                             0.43021,
                             -0.2713413551291,
                             -0.4061848105155,
                             0.3606439041492,
                             1.199750699463,
                             -0.51766,
                             -0.38016,
                             -0.04576,
                             0.7071067811865,
                             0.1772653409032,
                             0.1539400313681,
                             0.4297048540778,
                             -0.3928932188135,
                             0.9328183313702,
                             -1.240963447905,
                             -0.09289321881345,
                             -0.01859,
                             -0.203225,
                             -0.24707563618,
                             0.3739538616482,
                             0.5404195002706,
                             0.05359818170955,
                             0.48532,
                             -9.16531,
                             -0.209,
                             1.0736,
                             1.27120322107,
                             0.541900080635,
                             0,
                             0.5538240385724};
  const double a[] = {0.3, -0.4, 0.5, 1.1, .6, .8, .5, 1.3, .9, 25, 2.2, .4, .35};
  for (int n = 0; n <= 78; ++n) {
    const FunctionPtr f = internal_function(n, 2);
    double result;
    f->evaluate({a, static_cast<std::size_t>(f->parameters())}, &result);
    EXPECT_NEAR(result, expected[n], 6e-13 * std::max(1.0, std::fabs(expected[n]))) << "internal(" << n << ")";
  }
  EXPECT_THROW(internal_function(79, 2), std::invalid_argument);
  EXPECT_THROW(internal_function(-1, 2), std::invalid_argument);
}

double at(const FunctionPtr& f, std::vector<double> a) {
  double result;
  f->evaluate(a, &result);
  return result;
}

TEST(InternalFunctions, NoiseSums) {
  EXPECT_NEAR(at(internal_function(29, 2), {.3, -.4, .5, .7, 2.1, 4.5, .3, 1.5, 2}), 0.5692528444498981, 1e-14);
  EXPECT_NEAR(at(internal_function(58, 2), {.3, -.4, .5, 2.1, 4.3, .6, .3, .7, 1}), -0.0561733860951293, 1e-14);
  const FunctionPtr ridged = internal_function(59, 2);
  EXPECT_NEAR(at(ridged, {.3, -.4, .5, .7, 2.1, 4, .9, 1.5, 2}), 1.4386497262653106, 1e-14);
  EXPECT_NEAR(at(ridged, {.3, -.4, .5, .1, 2.1, 4, .9, 1.5, 2}), 1.4386497262653106, 1e-14);
  EXPECT_NEAR(at(internal_function(59, 2), {.3, -.4, .5, .1, 2.1, 4, .9, 1.5, 2}), 2.3545448899027210, 1e-14);
  const double generators[] = {0.5538240385724160, 0.5538240385724160, 0.5419000806350024, 0.5488755355104851};
  for (int g = 0; g < 4; ++g) EXPECT_NEAR(at(internal_function(78, 2), {.3, -.4, .5, double(g)}), generators[g], 1e-15);
}

TEST(InternalFunctions, OtherParameters) {
  const auto f = [](int n, std::vector<double> a) { return at(internal_function(n, 2), std::move(a)); };
  EXPECT_NEAR(f(23, {.5, .6, .7, 2}), 0.17836, 1e-14);
  EXPECT_NEAR(f(24, {.5, .6, .7, 1, 2, 0.5, .3, .4, .1, .2, 3, .5, .2}), 0.615955290863467, 1e-14);
  EXPECT_NEAR(f(64, {.5, .6, .7, .4, .1, 1.2, 1, 1, 1}), 0.505211667066929, 1e-14);
  EXPECT_NEAR(f(68, {.5, .6, .7, .8, .4}), 0.177830584826285, 1e-14);
  EXPECT_NEAR(f(60, {1.2, .3, .9, .2, 1, .5, .8}), 0.299999, 1e-14);
  EXPECT_NEAR(f(18, {.5, .6, .1, 1}), 0.092132373285322, 1e-14);
  EXPECT_NEAR(f(27, {.5, .6, .7, 0}), 0.769615242270663, 1e-14);
  EXPECT_NEAR(f(28, {.5, .6, .7, 0}), 0.133012701892219, 1e-14);
  EXPECT_NEAR(f(70, {.5, .6, .7, .8, .4}), 0.203015718927110, 1e-14);
  EXPECT_NEAR(f(34, {.5, .6, .7, 1, .3, .4, 1, .2, 33}), -0.744972310699615, 1e-14);
  EXPECT_NEAR(f(40, {.5, .1, .7, .3, .4, 1, .2, 1}), 0.1, 1e-14);
  EXPECT_NEAR(f(9, {.5, .6, .7, 1}), 0.215816557462588, 1e-14);
  EXPECT_NEAR(f(53, {.5, .6, .7, 0}), 1.199841927088341, 1e-14);
  EXPECT_NEAR(f(52, {.5, .6, .7, 5, .3, .1, .2, .1, .1}), 0.551809961490367, 1e-14);
  EXPECT_NEAR(f(8, {.5, .6, .7, 1e-3, 1}), -0.445476070766776, 1e-14);
  EXPECT_NEAR(f(25, {.5, .6, .7, 2, 3, .1, .5, 1.2, .5, 30}), 0.365120557126072, 1e-14);
  EXPECT_NEAR(f(26, {.5, .6, .7, 0, 3, .1, .5, 1.2, 2, 30}), 0.614057575992452, 1e-14);
  EXPECT_NEAR(f(58, {.3, .4, .5, 2, 4, .5, .3, .6, 3}), -0.275296616025, 1e-12);
  EXPECT_NEAR(f(29, {.3, .4, .5, .5, 2, 4, .3, 1, 3}), 1.374531499548, 1e-12);
}

}  // namespace function_test
}  // namespace verisim::functions
