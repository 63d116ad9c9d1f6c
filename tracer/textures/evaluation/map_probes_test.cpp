// Probes P9 to P11 and P13 of spec 05 section 15: maps, averages, what children see; and the surface patterns of P14.
#include <gtest/gtest.h>

#include "tracer/functions/function.h"
#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/evaluation/pigment.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {
namespace {

using namespace scene;

// x, y or z stretched, as a function pattern would give it.
class Linear final : public Function {
 public:
  Linear(double factor, double offset, int axis = 0) : factor_(factor), offset_(offset), axis_(axis) {}
  int parameters() const override { return 3; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> p, double* result) const override {
    *result = factor_ * p[static_cast<std::size_t>(axis_)] + offset_;
  }

 private:
  double factor_, offset_;
  int axis_;
};

PigmentPtr colored(const Color& c) {
  auto p = std::make_shared<Pigment>();
  p->pattern.kind = PatternKind::plain;
  p->color = c;
  return p;
}

std::shared_ptr<Pigment> gradient_along(const Vec3& direction) {
  auto p = std::make_shared<Pigment>();
  p->pattern.kind = PatternKind::gradient;
  p->pattern.params = GradientParams{direction};
  return p;
}

Color color_at(const PigmentPtr& description, const Vec3& p) {
  Compiler compiler{Settings{}};
  Color c;
  EXPECT_TRUE(evaluate(*compiler.pigment(description), p, nullptr, c));
  return c;
}

void expect_color(const Color& c, const Color& expected, const char* what) {
  EXPECT_NEAR(c.r, expected.r, 1e-8) << what;
  EXPECT_NEAR(c.g, expected.g, 1e-8) << what;
  EXPECT_NEAR(c.b, expected.b, 1e-8) << what;
  EXPECT_NEAR(c.f, expected.f, 3.1e-8) << what;
  EXPECT_NEAR(c.t, expected.t, 1e-8) << what;
}

// All bits, by a pigment function: of 20,000 values of this map each was the same, of maps in single precision
// throughout a fifth was not.
TEST(ColorMap, BlendedColorsHaveAllBits) {
  const auto entries = [](const auto& value) {
    return std::pair(value(Color(.31f, .42f, .53f, .11f, .22f)), value(Color(.91f, .22f, .17f, .37f, .13f)));
  };
  auto by_color = gradient_along({1, 0, 0}), by_pigment = gradient_along({1, 0, 0});
  const auto colors = entries([](const Color& c) { return c; });
  by_color->color_map = std::make_shared<ColorMap>(ColorMap{{.1234f, colors.first}, {.9871f, colors.second}});
  const auto pigments = entries([](const Color& c) {
    auto average = std::make_shared<Pigment>();  // not plain, so that the map is not made one of colours
    average->pattern.kind = PatternKind::average;
    average->pigment_map = std::make_shared<BlendMap<PigmentPtr>>(BlendMap<PigmentPtr>{{1, colored(c)}});
    return PigmentPtr(average);
  });
  by_pigment->pigment_map =
      std::make_shared<BlendMap<PigmentPtr>>(BlendMap<PigmentPtr>{{.1234f, pigments.first}, {.9871f, pigments.second}});
  const struct {
    double x;
    Color seen;
  } probes[] = {
      {0.70075055661330709622,
       {0.71107715368270874023f, 0.2863076329231262207f, 0.28935372829437255859f, 0.28380006551742553711f,
        0.15983842313289642334f}},
      {0.96256824304814636584,
       {0.89295816421508789062f, 0.22568061947822570801f, 0.18022513389587402344f, 0.36261516809463500977f,
        0.13255627453327178955f}},
      {0.94589826812844213233,
       {0.88137775659561157227f, 0.22954075038433074951f, 0.18717336654663085938f, 0.35759699344635009766f,
        0.13429334759712219238f}},
      {0.72582651728224623078,
       {0.72849702835083007812f, 0.28050097823143005371f, 0.27890178561210632324f, 0.29134869575500488281f,
        0.15722543001174926758f}},
  };
  for (const auto& probe : probes) {
    EXPECT_EQ(color_at(by_color, {probe.x, 0, 0}), probe.seen) << probe.x;
    EXPECT_EQ(color_at(by_pigment, {probe.x, 0, 0}), probe.seen) << probe.x;
  }
}

TEST(ColorMap, InterpolatesInSinglePrecisionAsPovRay) {  // P9
  auto p = gradient_along({1, 0, 0});
  p->color_map = std::make_shared<ColorMap>(ColorMap{
      {0.2f, {1, 0, 0, 0.1f, 0.2f}}, {0.5f, {0, 1, 0, 0.3f, 0.4f}}, {0.5f, {0, 0, 1}}, {0.9f, {1, 1, 0, 0.5f, 0}}});
  expect_color(color_at(p, {0.1, 0, 0}), {1, 0, 0, 0.1f, 0.2f}, "0.1");
  expect_color(color_at(p, {0.35, 0, 0}), {0.5f, 0.49999997f, 0, 0.2f, 0.3f}, "0.35");
  expect_color(color_at(p, {0.5, 0, 0}), {0, 1, 0, 0.3f, 0.4f}, "0.5");
  expect_color(color_at(p, {0.500001, 0, 0}), {2.5e-6f, 2.5e-6f, 0.999997497f, 1.25e-6f, 0}, "0.500001");
  expect_color(color_at(p, {0.7, 0, 0}), {0.50000006f, 0.50000006f, 0.49999994f, 0.25f, 0}, "0.7");
  expect_color(color_at(p, {0.95, 0, 0}), {1, 1, 0, 0.5f, 0}, "0.95");
}

TEST(ColorMap, IsNeverSorted) {  // spec 05 4.1
  const MapPositions middle(ColorMap{{0.5f, {}}, {0.2f, {}}, {0.9f, {}}});
  EXPECT_EQ(middle.find(0.1).upper, 0);
  EXPECT_EQ(middle.find(0.3).upper, 0);
  const MapPlace blend = middle.find(0.6);
  EXPECT_EQ(blend.lower, 1);
  EXPECT_EQ(blend.upper, 2);
  EXPECT_NEAR(blend.t, 0.571428, 1e-6);
  const MapPositions falling(ColorMap{{0.5f, {}}, {0.9f, {}}, {0.2f, {}}});
  EXPECT_EQ(falling.find(0.1).upper, 0);
  EXPECT_EQ(falling.find(0.3).upper, 2);
}

TEST(ColorMap, LongMapsAreSearchedLikeShortOnes) {
  ColorMap entries;
  for (int i = 0; i < 200; ++i) entries.push_back({static_cast<float>((i * 37 % 101) / 150.0 + i / 400.0), {}});
  const MapPositions map(entries);
  for (int k = 0; k < 2000; ++k) {
    const double v = k / 1500.0 - 0.1;
    int expected = 199;
    if (v < entries.back().position) {
      expected = 0;
      while (v > entries[expected].position) ++expected;
    }
    EXPECT_EQ(map.find(v).upper, expected) << v;
  }
}

TEST(PigmentMap, Average) {  // P10
  auto p = std::make_shared<Pigment>();
  p->pattern.kind = PatternKind::average;
  p->pigment_map = std::make_shared<BlendMap<PigmentPtr>>(
      BlendMap<PigmentPtr>{{3, colored({0, 1, 0})}, {1, gradient_along({1, 0, 0})}});
  const Color c = color_at(p, {0.3, 0, 0});
  EXPECT_NEAR(c.r, 0.075, 1e-7);
  EXPECT_NEAR(c.g, 0.825, 1e-7);
  EXPECT_NEAR(c.b, 0.075, 1e-7);
  p->pigment_map = std::make_shared<BlendMap<PigmentPtr>>(
      BlendMap<PigmentPtr>{{1, colored({1, 0, 0})}, {3, colored({0, 1, 0, 0, 0.5f})}});
  expect_color(color_at(p, {0.3, 0, 0}), {0.25f, 0.75f, 0, 0, 0.375f}, "plain children");
}

TEST(PigmentMap, ChildrenSeeTheWarpOfTheirParent) {  // P11
  auto child = std::make_shared<Pigment>();
  child->pattern.kind = PatternKind::function;
  child->pattern.params = FunctionParams{std::make_shared<Linear>(1.0 / 64, 0.5)};
  auto p = gradient_along({0, 1, 0});
  p->pattern.turbulence = Turbulence{{0.5, 0.5, 0.5}};
  p->pigment_map = std::make_shared<BlendMap<PigmentPtr>>(BlendMap<PigmentPtr>{{0, child}, {1, child}});
  EXPECT_NEAR((color_at(p, {1.25, -2.75, 3.6}).r - 0.5) * 64, 1.170715, 2e-5);
  p->pattern.kind = PatternKind::marble;  // does not displace
  EXPECT_NEAR((color_at(p, {1.25, -2.75, 3.6}).r - 0.5) * 64, 1.25, 2e-5);
}

TEST(Pattern, PigmentsAndFunctionsAsPatterns) {  // P13
  Compiler compiler{Settings{}};
  auto source = gradient_along({1, 0, 0});
  source->color_map = std::make_shared<ColorMap>(ColorMap{{0, {1, 0, 0.5f}}, {1, {0, 1, 0.25f}}});
  Pattern grey;
  grey.kind = PatternKind::pigment_pattern;
  grey.params = PigmentPatternParams{source};
  EXPECT_NEAR(evaluate(*compiler.pattern(grey), {0.3, 0, 0}, nullptr), 0.433050006628, 1e-7);
  Pattern function;
  function.kind = PatternKind::function;
  function.params = FunctionParams{std::make_shared<Linear>(3, 0)};
  EXPECT_NEAR(evaluate(*compiler.pattern(function), {0.9, 0, 0}, nullptr), 0.7, 1e-12);
  function.params = FunctionParams{std::make_shared<Linear>(-0.4, 0)};
  EXPECT_NEAR(evaluate(*compiler.pattern(function), {0.5, 0, 0}, nullptr), 0.8, 1e-12);
}

TEST(Pattern, OldScenesUseTheFirstNoise) {  // P13
  const Vec3 p(1.25, -2.75, 3.6);
  Pattern bozo;
  bozo.kind = PatternKind::bozo;
  Settings settings;
  settings.noise_generator = 1;
  Compiler old_scene(settings), new_scene{Settings{}};
  EXPECT_NEAR(evaluate(*old_scene.pattern(bozo), p, nullptr), 0.339298602446, 1e-12);
  EXPECT_NEAR(evaluate(*new_scene.pattern(bozo), p, nullptr), 0.436813547210, 1e-12);
  bozo.noise_generator = 3;
  EXPECT_NEAR(evaluate(*old_scene.pattern(bozo), p, nullptr), 0.445168696205, 1e-12);
}

// P14: the point (-0.25, 0.25) of a unit sphere seen along z.
TEST(Pattern, SlopeAndAngleOfIncidence) {
  const Vec3 hit(-0.25, 0.25, -std::sqrt(1 - 0.125));
  SurfacePoint surface;
  surface.point = surface.normal = hit;
  surface.ray_direction = Vec3(0, 0, 1);
  Compiler compiler{Settings{}};
  Pattern p;
  p.kind = PatternKind::aoi;
  EXPECT_NEAR(evaluate(*compiler.pattern(p), hit, &surface), 0.884977, 1e-5);
  p.kind = PatternKind::slope;
  const auto slope = [&](const SlopeParams& s) {
    p.params = s;
    return evaluate(*compiler.pattern(p), hit, &surface);
  };
  SlopeParams s;
  s.direction = Vec3(0, 1, 0);
  EXPECT_NEAR(slope(s), 0.580438, 1e-5);
  s.direction = Vec3(1, 2, 0);
  EXPECT_NEAR(slope(s), 0.535668, 1e-5);
  s.direction = Vec3(0, 1, 0);
  s.slope_low = 0.4, s.slope_high = 0.9;
  EXPECT_NEAR(slope(s), 0.360861, 1e-5);
  s.slope_low = 0, s.slope_high = 0.5;
  EXPECT_NEAR(slope(s), 0.160861, 1e-5);
  s = SlopeParams{};
  s.direction = Vec3(0, 3, 0);
  s.point_at = true;
  EXPECT_NEAR(slope(s), 0.472679, 1e-5);
  s = SlopeParams{};
  s.direction = Vec3(0, 1, 0);
  s.altitude = Vec3(1, 0, 0);
  EXPECT_NEAR(slope(s), 0.165209, 1e-5);
  s.direction = Vec3(0, 3, 0);
  s.slope_high = 0.9;
  s.altitude_low = -1, s.altitude_high = 1;
  EXPECT_NEAR(slope(s), 0.577447, 1e-5);
  s.altitude = Vec3(0, 0, 2);
  s.altitude_low = -3, s.altitude_high = 1;
  EXPECT_NEAR(slope(s), 0.593408, 1e-5);
  EXPECT_EQ(evaluate(*compiler.pattern(p), hit, nullptr), 0) << "there is no slope without a surface";
}

TEST(WaterPatterns, SourcesAndFrequencies) {  // section 8
  const auto sources = wave_sources(10);
  ASSERT_EQ(sources->size(), 10u);
  EXPECT_NEAR(length((*sources)[0].position - Vec3(-0.604378213, 0.492048408, -0.626590248)), 0, 1e-8);
  EXPECT_NEAR((*sources)[0].frequency, 0.919115878781, 1e-11);
  EXPECT_NEAR((*sources)[1].frequency, 0.960041199988, 1e-11);
}

TEST(Compiler, EqualDescriptionsAreCompiledOnce) {
  Compiler compiler{Settings{}};
  const PigmentPtr p = gradient_along({1, 0, 0});
  EXPECT_EQ(compiler.pigment(p), compiler.pigment(p));
  EXPECT_NE(compiler.pigment(p), compiler.pigment(gradient_along({1, 0, 0})));
}

TEST(Compiler, RefusesBottomlessNesting) {
  PigmentPtr p = gradient_along({1, 0, 0});
  for (int i = 0; i < 5000; ++i) {
    auto parent = gradient_along({1, 0, 0});
    parent->pigment_map = std::make_shared<BlendMap<PigmentPtr>>(BlendMap<PigmentPtr>{{0, p}});
    p = parent;
  }
  Compiler compiler{Settings{}};
  EXPECT_THROW(compiler.pigment(p), std::runtime_error);
}

// Layers, maps and pigments that look at the same pattern in the same way share it, and see the values that they would
// see alone.
TEST(SharedPatterns, AreCompiledAndEvaluatedOnce) {
  const auto marbled = [](Color second, double scale) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->pattern.kind = scene::PatternKind::marble;
    pigment->pattern.turbulence = scene::Turbulence{Vec3(0.7, 0.7, 0.7), 6, 2, 0.5f};
    pigment->pattern.prepend(Transform::scaling(Vec3(scale, scale, scale)));
    pigment->color_map = std::make_shared<scene::ColorMap>(scene::ColorMap{{0, Color(1, 1, 1)}, {1, second}});
    return pigment;
  };
  const auto red = marbled(Color(1, 0, 0), 0.5), blue = marbled(Color(0, 0, 1), 0.5),
             larger = marbled(Color(0, 0, 1), 0.6);
  Compiler together{Settings{}};
  const CompiledPigment *a = together.pigment(red), *b = together.pigment(blue), *c = together.pigment(larger);
  EXPECT_EQ(a->pattern, b->pattern);
  EXPECT_NE(a->pattern, c->pattern);
  EXPECT_NE(a->pattern->shared_id, 0u);
  EXPECT_EQ(c->pattern->shared_id, 0u);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p(0.37 * i - 50, 0.11 * i, 3 - 0.2 * i);
    for (const auto& [description, compiled] : {std::pair{red, a}, {blue, b}}) {
      Compiler alone{Settings{}};
      Color expected, seen;
      evaluate(*alone.pigment(description), p, nullptr, expected);
      evaluate(*compiled, p, nullptr, seen);
      ASSERT_EQ(seen, expected);
    }
  }
}

}  // namespace
}  // namespace verisim::textures
