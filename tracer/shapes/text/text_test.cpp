// Probes 25 to 28 of spec 04 with the fonts of the package povray-includes; skipped without it.
#include <filesystem>
#include <fstream>
#include <random>

#include "tracer/scene/bounds.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/trace_test_support.h"
#include "tracer/shapes/text/truetype.h"

namespace verisim::shapes {
namespace {

using namespace test;

const std::string kTimes = "/usr/share/povray-3.7/include/timrom.ttf";

scene::Text text(std::u16string s, double depth = 0.3, const Vec3& offset = Vec3(0)) {
  scene::Text t;
  t.font = kTimes, t.text = std::move(s), t.thickness = depth, t.offset = offset;
  return t;
}

class Text : public ::testing::Test {
  void SetUp() override {
    if (!std::filesystem::exists(kTimes)) GTEST_SKIP() << "no fonts";
  }
};

Box3 text_box(const scene::Text& t) {
  scene::Object object;
  object.shape = std::make_shared<const scene::Text>(t);
  const scene::Bounds bounds = scene::local_bounds(object);
  return {scene::low_corner(bounds), scene::high_corner(bounds)};
}

void expect_x(const scene::Text& t, double x_max) { EXPECT_NEAR(text_box(t).max.x, x_max, 1e-6); }

TEST_F(Text, Extents) {
  const Box3 a = text_box(text(u"A"));
  EXPECT_NEAR(a.min.x, -0.000012, 1e-6);
  EXPECT_NEAR(a.min.y, -0.000005, 1e-6);
  EXPECT_NEAR(a.max.y, 0.696013, 1e-6);
  expect_x(text(u"A"), 0.736005);
  expect_x(text(u" A"), 0.996005);
  expect_x(text(u"A A"), 1.740005);
  expect_x(text(u"\u4e2d"), 0.466005);
  expect_x(text(u"A\u4e2dA"), 2.032005);
  const Box3 moved = text_box(text(u"AB", 0.3, {.5, .25, .125}));
  EXPECT_NEAR(moved.max.x, 1.865005, 1e-6);
  EXPECT_NEAR(moved.max.y, 0.930033, 1e-6);
  EXPECT_NEAR(moved.max.z, 0.300017, 1e-6);
  const Box3 all = text_box(text(u"ABg Qj&8"));
  EXPECT_NEAR(all.min.y, -0.213005229830742, 1e-6);
  EXPECT_NEAR(all.max.x, 4.456008911132812, 1e-6);
  EXPECT_NEAR(all.max.y, 0.696077823638916, 1e-6);
}

TEST_F(Text, KerningAndOffsets) {
  const Box3 b = text_box(text(u"AVAWA To", 0.3, {.1, .05, .3}));
  EXPECT_NEAR(b.max.x, 5.291005134582520, 2e-6);
  EXPECT_NEAR(b.max.y, 0.980092346668243, 2e-6);
}

TEST_F(Text, BuiltinFonts) {
  scene::Text t = text(u"P");
  t.font.clear(), t.builtin_font = 0;
  const Box3 b = text_box(t);
  EXPECT_NEAR(b.max.x, 0.669927120208740, 2e-6);
  EXPECT_NEAR(b.max.y, 1.001964807510376, 2e-6);
}

TEST_F(Text, CompositeGlyphs) {
  const std::string path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no DejaVu font";
  const auto x = [&](std::u16string s) {
    scene::Text t = text(std::move(s));
    t.font = path, t.unicode = true;
    return text_box(t).max.x;
  };
  EXPECT_NEAR(x(u"e"), 0.506841, 1e-6);
  EXPECT_NEAR(x(u"\u00e9"), 0.562017, 1e-6);
  EXPECT_NEAR(x(u"B\u00e9"), 1.205084, 1e-6);
}

TEST_F(Text, LargeTextLosesItsCurvedSides) {
  for (const double s : {1.0, 1e4, 1e5}) {
    auto o = object(text(u"O"));
    o.transform = text_frame().then(Transform::scaling(Vec3(s)));
    const auto hit = trace(o, Vec3(-2, .3, .15) * s, {1, 0, 0});
    if (s == 1.0) {
      EXPECT_NEAR(hit->point.x, 0.002422884337431, 1e-13);
      EXPECT_NEAR(hit->normal.x, 0.993757899136217, 1e-12);  // POV-Ray's geometric normals of sides point inwards
    } else if (s == 1e4) {
      EXPECT_NEAR(hit->point.x, 24.228843374305143, 1e-9);
    } else {
      EXPECT_FALSE(hit);
    }
  }
}

// 1000 units make an em, so that second differences of equal steps are not 0: roots are off by POV-Ray's errors, and
// ends are where the height is theirs. Measured with trace().
TEST_F(Text, NearlyStraightCurvesAreOffAsInPovRay) {
  scene::Text t = text(u"0123456789", 0.1);
  t.font = "/usr/share/povray-3.7/include/cyrvetic.ttf";
  const auto front = [&](double x, double y) {
    const auto hit = trace(object(t), {x, y, -1}, {0, 0, 1});
    return hit && hit->point.z < 0.05;
  };
  EXPECT_TRUE(front(3.44857315613156512, 0.25276839206990986));
  EXPECT_TRUE(front(3.4447, 0.224));
  EXPECT_TRUE(front(3.451, 0.264));
  EXPECT_FALSE(front(3.449, 0.256));
  EXPECT_FALSE(front(3.336, 0.2175));
  EXPECT_TRUE(front(3.38, 0.2175));
}

// Points of a letter's own walls, found by trace(), and what inside() tells of them in POV-Ray.
TEST_F(Text, OwnWallsAreInsideByTheLastBit) {
  struct Wall {
    const char* font;
    char16_t letter;
    Vec3 point;
    bool inside;
  };
  const Wall walls[] = {
      {"crystal.ttf", u'A', {0.25573584697538293, 0.33967573002926343, 0.8959437596795929}, false},  // slanting walls
      {"crystal.ttf", u'A', {0.2626221594884002, 0.6077766663694062, 0.19592458483324637}, true},
      {"crystal.ttf", u'A', {0.11552408308850415, 0.4767336835021272, 0.9929847946033759}, false},
      {"crystal.ttf", u'A', {0.32100971586812954, 0.3672766968955976, 0.6452528974951295}, true},
      {"timrom.ttf", u'S', {0.036356937285822344, 0.011596717013483637, 0.5090968552178974}, true},  // curves
      {"timrom.ttf", u'S', {0.01648591160701751, -0.016006940770146638, 0.41416218056071097}, true},
      {"cyrvetic.ttf", u'R', {0.21790553919092304, 0.30598657165070753, 0.9872948168534577}, true},  // level with ends
      {"cyrvetic.ttf", u'R', {0.5179514789745263, -4.07045117079008e-06, 0.7511621118034184}, true},
  };
  for (const Wall& wall : walls) {
    scene::Text t = text(std::u16string(1, wall.letter), 1);
    t.font = std::string("/usr/share/povray-3.7/include/") + wall.font;
    EXPECT_EQ(compile(object(t))->inside(wall.point), wall.inside) << wall.font << " " << wall.point.x;
  }
}

TEST_F(Text, NegativeDepthHasNoSurface) { EXPECT_FALSE(trace(object(text(u"A", -0.3)), {.35, .3, -5}, {0, 0, 1})); }

TEST_F(Text, IntersectionsSeparateInsideFromOutside) {
  const auto o = object(text(u"AB&g8"));
  const auto s = compile(o);
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int seen = 0, wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from(unit(rng) * 4 - 1, unit(rng) * 3 - 1, -1.5), to(unit(rng) * 2.5, unit(rng) * .7, unit(rng) * .3);
    const Ray ray{from, normalize(to - from)};
    HitList hits;
    s->intersect_all(ray, RayKind::query, hits);
    std::vector<double> t{0};
    for (const Hit& h : hits) {
      t.push_back(h.t);
      ASSERT_NEAR(length(s->normal(h)), 1, 1e-12);
    }
    std::sort(t.begin(), t.end());
    t.push_back(t.back() + 1);
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
      if (t[k + 1] - t[k] < 1e-6) continue;
      wrong += s->inside(ray.at((t[k] + t[k + 1]) / 2)) != (k % 2 == 1);
    }
    seen += static_cast<int>(hits.size());
  }
  EXPECT_GT(seen, 500);
  EXPECT_LE(wrong, 2);  // POV-Ray's absolute discriminant limit loses intersections near the extremes of a curve
}

TEST_F(Text, BrokenFonts) {
  std::ifstream file(kTimes, std::ios::binary);
  const std::vector<std::uint8_t> good((std::istreambuf_iterator<char>(file)), {});
  std::mt19937 rng(9);
  int survived = 0;
  for (int i = 0; i < 300; ++i) {
    auto bytes = good;
    if (i % 3 == 0)
      bytes.resize(rng() % bytes.size());
    else
      for (int k = 0; k < 40; ++k) bytes[rng() % (i % 3 == 1 ? 1000 : bytes.size())] = static_cast<std::uint8_t>(rng());
    try {
      const TrueTypeFont font(bytes);
      for (char16_t c = 30; c < 130; ++c) {
        const Glyph g = font.glyph(font.glyph_index(c, c % 2 == 0));
        font.kerning(g.metrics_glyph, c);
      }
      ++survived;
    } catch (const std::runtime_error&) {
    }
  }
  EXPECT_GT(survived, 0);
  EXPECT_THROW(TrueTypeFont(std::vector<std::uint8_t>{}), std::runtime_error);
  EXPECT_THROW(TrueTypeFont::open("/nonexistent.ttf"), std::runtime_error);
}

}  // namespace
}  // namespace verisim::shapes
