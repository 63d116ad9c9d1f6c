// Probes 11 to 13 of spec 04, and the pyramid against testing every cell.
#include <cmath>
#include <random>

#include "tracer/shapes/heights/height_map.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/heights/height_packet.h"
#include "tracer/shapes/heights/height_walk.h"
#include "tracer/shapes/trace_test_support.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes {
namespace {

using namespace test;

// What the parser makes of `function W, H { f }`.
ImagePtr function_image(int w, int h, const std::function<double(double, double)>& f) {
  auto image = std::make_shared<Image>();
  image->width = w, image->height = h;
  image->grey = image->sixteen_bit = true;
  image->channels = 1;
  std::vector<float> values;
  for (int j = 0; j < h; ++j) {
    for (int i = 0; i < w; ++i) {
      const auto v = static_cast<std::uint16_t>(static_cast<int>(f(i / (w - 1.0), j / (h - 1.0)) * 65535));
      values.push_back(float(v) / 65535);
    }
  }
  image->samples = image::Samples(std::move(values));
  return image;
}
scene::HeightField field(ImagePtr image) {
  scene::HeightField f;
  if (image) f.map = height_map(*image);
  return f;
}

Image row(ImageType type, bool grey, bool sixteen, bool alpha, const std::vector<std::array<float, 3>>& values,
          float scale) {
  Image image;
  image.width = static_cast<int>(values.size()), image.height = 1;
  image.type = type, image.grey = grey, image.sixteen_bit = sixteen, image.has_alpha = alpha;
  image.channels = 3;
  std::vector<float> samples;
  for (const auto& v : values) {
    for (const float c : v) samples.push_back(c / scale);
  }
  image.samples = image::Samples(std::move(samples));
  return image;
}
std::vector<int> heights(const Image& image) {
  std::vector<int> result;
  for (int i = 0; i < image.width; ++i) result.push_back(height_of_pixel(image, i, 0));
  return result;
}
std::vector<std::array<float, 3>> greys(std::initializer_list<float> values) {
  std::vector<std::array<float, 3>> result;
  for (const float v : values) result.push_back({v, v, v});
  return result;
}

TEST(HeightField, HeightsOfFileFormats) {
  using V = std::vector<int>;
  const auto levels = greys({0, 1, 2, 3, 7, 100, 127, 128, 200, 254});
  EXPECT_EQ(heights(row(ImageType::png, true, false, false, levels, 255)),
            (V{0, 257, 514, 514, 1799, 25443, 32382, 32896, 51143, 65021}));
  EXPECT_EQ(heights(row(ImageType::png, true, false, true, levels, 255)),
            (V{0, 257, 514, 771, 1799, 25700, 32639, 32896, 51400, 65278}));
  EXPECT_EQ(heights(row(ImageType::png, true, false, false, greys({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}), 15)),
            (V{0, 4369, 8738, 12850, 17476, 21588, 25957, 30583, 34952, 39321, 43433}));
  EXPECT_EQ(heights(row(ImageType::png, false, false, false,
                        {{0, 1, 0}, {1, 0, 0}, {1, 2, 3}, {10, 200, 30}, {127, 255, 9}}, 255)),
            (V{1, 256, 258, 2760, 32767}));
  EXPECT_EQ(heights(row(ImageType::png, false, true, false,
                        {{1000, 2000, 3000}, {65535, 0, 0}, {0, 65535, 0}, {0, 0, 65535}}, 65535)),
            (V{1817, 19463, 38600, 7470}));
  EXPECT_EQ(heights(row(ImageType::png, false, true, false, greys({32400, 31759, 30243, 18022, 24575}), 65535)),
            (V{32399, 31758, 30242, 18022, 24575}));
  EXPECT_EQ(heights(row(ImageType::pgm, true, false, false, greys({1, 3, 100}), 100)), (V{655, 1966, 65535}));
  for (int v = 0; v < 65536; ++v) {
    ASSERT_EQ(heights(row(ImageType::png, true, true, false, greys({float(v)}), 65535)), V{v});
  }
}

TEST(HeightField, FunctionsCountFromTheTopAndWrap) {
  const auto o = object(field(function_image(5, 5, [](double, double y) { return y * 0.5; })));
  const auto at = [](const scene::Object& f, double x, double z) { return trace(f, {x, 5, z}, {0, -1, 0})->point.y; };
  EXPECT_NEAR(at(o, .3, .25), 24575 / 65536.0, 1e-14);
  EXPECT_NEAR(at(o, .3, .5), 16383 / 65536.0, 1e-14);
  EXPECT_NEAR(at(o, .3, .75), 8191 / 65536.0, 1e-14);
  const auto wrapped = object(field(function_image(11, 2, [](double x, double) { return x * 2 - 0.5; })));
  EXPECT_NEAR(at(wrapped, .1, .5), 45876 / 65536.0, 1e-9);
  EXPECT_NEAR(at(wrapped, .2, .5), 58983 / 65536.0, 1e-9);
  EXPECT_NEAR(at(wrapped, .8, .5), 6552 / 65536.0, 1e-9);
}

TEST(HeightField, WaterLevel) {
  auto f = field(function_image(5, 5, [](double x, double) { return x * 0.5; }));
  f.water_level = 0.2;
  const auto o = object(f);
  EXPECT_FALSE(trace(o, {.3, 5, .3}, {0, -1, 0}));
  const auto hit = trace(o, {.7, 5, .3}, {0, -1, 0});
  EXPECT_NEAR(hit->point.y, 0.349984741210937, 1e-14);
  EXPECT_VEC_NEAR(hit->normal, Vec3(-0.447213595499958, 0.894427190999916, 0), 1e-14);
  EXPECT_NEAR(trace(o, {5, .25, .3}, {-1, 0, 0})->point.x, 0.500030517578125, 1e-14);
  EXPECT_FALSE(trace(o, {5, .1, .3}, {-1, 0, 0}));
  const auto s = compile(o);
  EXPECT_TRUE(s->inside({.2, .01, .3}));
  EXPECT_TRUE(s->inside({.7, .3, .3}));
  EXPECT_FALSE(s->inside({.7, .4, .3}));
  EXPECT_TRUE(s->inside({.7, -40, .3}));
  const Box3 b = height_field_box(f);
  EXPECT_NEAR(b.min.y / 65536, 0.2, 2e-8);
  EXPECT_NEAR(b.max.y / 65536, 0.499984771013260, 2e-8);
}

TEST(HeightField, ThePyramidFindsTheNearestHit) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto f = field(function_image(37, 21, [&](double, double) { return unit(rng); }));
  const HeightGrid grid(f);
  auto o = object(f);
  const auto s = compile(o);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const Vec3 from(unit(rng) * 3 - 1, unit(rng) * 3 - 1, unit(rng) * 3 - 1), to(unit(rng), unit(rng), unit(rng));
    const Ray ray{from, normalize(to - from)};
    // All triangles.
    const Vec3 cells(36, 65536, 20);
    double nearest = 1e30;
    bool too_near = false;
    for (int i = 0; i < 36; ++i) {
      for (int k = 0; k < 20; ++k) {
        for (int t = 0; t < 2; ++t) {
          const double h10 = grid.at(i + 1, k), h01 = grid.at(i, k + 1), hc = grid.at(i + t, k + t);
          const Vec3 N = t == 0 ? Vec3(hc - h10, 1, hc - h01) : Vec3(h01 - hc, 1, h10 - hc);
          const Vec3 oo(from.x * cells.x, from.y * cells.y, from.z * cells.z),
              d(ray.direction.x * cells.x, ray.direction.y * cells.y, ray.direction.z * cells.z);
          const double depth = dot(N, Vec3(i + t, hc, k + t) - oo) / dot(N, d);
          const double a = oo.x + depth * d.x - i, b = oo.z + depth * d.z - k;
          const bool in =
              t == 0 ? a >= -1e-4 && b >= -1e-4 && a + b <= 1.0001 : a <= 1.0001 && b <= 1.0001 && a + b >= 0.9999;
          const Vec3 g = oo + depth * d;
          if (!in || !(depth >= 1e-6) || g.x < 0 || g.x > 36 || g.z < 0 || g.z > 20) continue;
          too_near = too_near || depth < 1e-4;
          nearest = std::min(nearest, depth);
        }
      }
    }
    const auto hit = trace(*s, from, ray.direction);
    if (too_near) continue;  // the search ends there
    ASSERT_EQ(hit.has_value(), nearest < 1e30) << n;
    if (hit) {
      ASSERT_NEAR(hit->hit.t, nearest, 1e-9) << n;
      ++hits;
    }
  }
  EXPECT_GT(hits, 500);
}

// All instruction sets find the same cells, in the same order; and cells at the ray's own heights are never left out.
TEST(HeightField, WalksAreTheSameWithAllInstructionSets) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const HeightGrid grid(field(function_image(
      150, 90, [&](double x, double y) { return 0.5 + 0.3 * std::sin(9 * x) * std::cos(7 * y) + 0.1 * unit(rng); })));
  const auto cells_of = [&](int set, const Vec3& o, const Vec3& d, double enter, double leave) {
    std::vector<std::array<int, 2>> all;
    HeightWalk walk(grid, o, d, enter, leave);
    HeightCell cells[HeightWalk::kCells];
    while (const int count = walk.next(set, static_cast<float>(leave), cells)) {
      if (count < 0) return all;
      for (int n = 0; n < count; ++n) all.push_back({cells[n].i, cells[n].k});
    }
    return all;
  };
  for (int n = 0; n < 10000; ++n) {
    Vec3 o(unit(rng) * 149, unit(rng) * 65536, unit(rng) * 89),
        d((unit(rng) - .5) * 149, (unit(rng) - .5) * 65536, (unit(rng) - .5) * 89);
    if (n % 5 == 0) d.x = 0;
    if (n % 7 == 0) d.z = 0;
    const auto expected = cells_of(simd::kBaseline, o, d, 0, 1);
    for (int set = 1; set <= simd::best_instruction_set(); ++set) ASSERT_EQ(cells_of(set, o, d, 0, 1), expected) << n;
    for (int step = 0; step < 20; ++step) {
      const Vec3 p = o + unit(rng) * d;
      if (!(p.x >= 0 && p.x < 149 && p.z >= 0 && p.z < 89)) continue;
      const int i = static_cast<int>(p.x), k = static_cast<int>(p.z);
      const auto [low, high] =
          std::minmax({grid.at(i, k), grid.at(i + 1, k), grid.at(i, k + 1), grid.at(i + 1, k + 1)});
      if (p.y < low || p.y > high) continue;
      ASSERT_NE(std::ranges::find(expected, std::array{i, k}), expected.end()) << n << ": " << i << ' ' << k;
    }
  }
}

// Two ridges along z, each of two facets, and a ray along x just below their tops (spec 04 5.2).
TEST(HeightField, TheSearchEndsAtAHitThatIsTooNear) {
  const auto ridges = [](double x, double) { return std::fabs(std::remainder(2 * x, 1)); };  // 0 .5 0 .5 0
  const auto o = object(field(function_image(5, 3, ridges)));
  constexpr double kBelow = 1e-4;
  double tolerance = 1e-3;
  Hit hit;
  const auto meets = [&](const scene::Object& object, double x) {
    return compile(object)->intersect({{x, 0.5 - kBelow, 0.3}, {1, 0, 0}}, RayKind::camera, tolerance, 10, hit);
  };
  ASSERT_TRUE(meets(o, 0.1));
  const double first = hit.t + 0.1;
  EXPECT_NEAR(first, 0.25, kBelow);
  EXPECT_FALSE(meets(o, first));               // the back of this ridge is nearer than 0.001
  tolerance = std::nextafter(tolerance, 1.0);  // as of shadows through what is transparent, and with --replay
  EXPECT_FALSE(meets(o, first));
  ASSERT_TRUE(meets(o, first + 2 * kBelow));  // from behind it the next one shows
  EXPECT_NEAR(hit.t + first, 0.75, 4 * kBelow);
  scene::Csg both;
  both.children.push_back(std::make_shared<scene::Object>(o));
  scene::Object sum;
  sum.shape = both;
  ASSERT_TRUE(meets(sum, first));  // a union that is asked as a whole collects all hits
  EXPECT_NEAR(hit.t + first, 0.75, 4 * kBelow);
}

// Two facets that meet in a valley on the border of two cells: the nearer hit is the one of the second cell, within the
// tolerance of its edge.
TEST(HeightField, TheFirstCellOnTheWayCounts) {
  const auto valley = [](double x, double y) { return std::fabs(x - 0.5) + 0.1 * y; };
  const auto o = object(field(function_image(3, 2, valley)));
  const double bottom = 0.1 * (1 - 0.3), y = 0.5e-4;  // where each facet reaches over its edge by 1e-4 of a cell
  Hit hit;
  for (const double direction : {1.0, -1.0}) {
    const Vec3 origin(0.5 - direction * 0.01, bottom + y + 0.02, 0.3),
        d = normalize(Vec3(direction * 0.01, -0.02 - y / 2, 0));
    ASSERT_TRUE(compile(o)->intersect({origin, d}, RayKind::camera, 1e-4, 10, hit));
    EXPECT_EQ(hit.u, direction > 0 ? 0 : 1);
  }
}

// A field of n samples a side, and a ray in units of cells and heights: whether it is hit.
bool meets(int n, const std::function<int(int, int)>& height, bool hierarchy, const Vec3& origin,
           const Vec3& direction) {
  const double cells = n - 1;
  const auto f = field(function_image(n, n, [&](double x, double y) {
    return (height(static_cast<int>(std::lround(x * cells)), static_cast<int>(std::lround((1 - y) * cells))) + 0.5) /
           65535;
  }));
  auto o = object(f);
  o.hierarchy = hierarchy;
  const auto scaled = [&](const Vec3& v) { return Vec3(v.x / cells, v.y / 65536, v.z / cells); };
  Hit hit;
  return compile(o)->intersect({scaled(origin), scaled(direction)}, RayKind::camera, 1e-4, 100, hit);
}

// A ray that rises above the three upper corners of a triangle, which it meets within the tolerance of its edge, in
// POV-Ray by blocks: it counts where something else in the block of cells is as high, or without `hierarchy`.
TEST(HeightField, BeyondAnEdgeWhatIsAroundCounts) {
  for (const bool hierarchy : {true, false})
    for (const int high : {2, 3, 4, 7, 8, 9, 10}) {
      const auto height = [&](int i, int k) { return k == 5 && i == 5 ? 0 : k == 5 && i == high ? 65535 : 60000; };
      EXPECT_EQ(meets(12, height, hierarchy, {5.3, 60003.1, 5.70005}, {1e-3, 1, 1e-4}),
                !hierarchy || (high >= 4 && high <= 8))
          << high;
    }
}

// The upper end of a cliff reaches over its edge by 1e-4 of a cell, higher than it is: who passes above does not meet
// it there.
TEST(HeightField, BeyondAnEdgeATriangleIsNoHigherThanItsCorners) {
  const auto height = [](int i, int k) { return i >= 4 ? 60000 : i == 0 && k == 0 ? 65535 : 0; };
  for (const bool hierarchy : {true, false})
    EXPECT_FALSE(meets(12, height, hierarchy, {4.3, 60003, 1.37}, {-1, 0, 0.01}));
}

TEST(HeightField, SmoothNormalsAreUnitLength) {
  auto f =
      field(function_image(9, 9, [](double x, double y) { return 0.5 + 0.3 * std::sin(5 * x) * std::cos(4 * y); }));
  f.smooth = true;
  auto o = object(f);
  o.transform = height_field_frame(f).then(Transform::scaling({3, 0.8, 3})).then(Transform::rotation({10, 20, 30}));
  const auto hit = trace(o, Vec3(3, 9, 1), Vec3(-0.2, -1, 0.05));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(length(hit->normal), 1, 1e-12);
}

TEST(HeightField, TinyImages) {
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 5}, {5, 1}}) {
    auto image = std::make_shared<Image>();
    image->width = w, image->height = h;
    image->samples = image::Samples(std::vector<float>(static_cast<std::size_t>(4 * w * h), 0.5f));
    const auto o = object(field(image));
    EXPECT_FALSE(trace(o, {.5, 5, .5}, {0, -1, 0}));
    EXPECT_FALSE(compile(o)->inside({.5, .1, .5}));
  }
  EXPECT_FALSE(trace(object(field(nullptr)), {.5, 5, .5}, {0, -1, 0}));
}

}  // namespace
}  // namespace verisim::shapes
