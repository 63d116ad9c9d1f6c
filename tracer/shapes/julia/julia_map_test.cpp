// The map against the set itself.
#include "tracer/shapes/julia/julia_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace verisim::shapes::julia {
namespace {

std::vector<Field> fields() {
  std::vector<Field> all;
  for (const Kind kind :
       {Kind::quaternion_square, Kind::quaternion_cube, Kind::hypercomplex_square, Kind::hypercomplex_cube}) {
    Field f;
    f.kind = kind;
    f.parameter = {-0.162, 0.163, -0.56, 0.1};
    f.slice = Vec3(0.1, 0.2, -0.1), f.slice_w = 0.97, f.slice_distance = 0.05;
    f.escape = is_quaternion(kind) ? 2.6 : 16;
    f.iterations = 7;
    all.push_back(f);
  }
  return all;
}

// One point at a time, by the formulas of spec 04 section 8.
bool survives(const Field& f, const Vec3& p) {
  Number h = first_iterate<Number>(f, p);
  for (int i = 1; i <= f.iterations; ++i) {
    if (norm2<Kind::quaternion_square>(h) > f.escape) return false;
    h = plus(with_kind(f.kind,
                       [&]<Kind K>() {
                         if constexpr (K != Kind::function) return image<K>(h);
                         return Number{};
                       }),
             f.parameter);
  }
  return true;
}

TEST(JuliaMap, NothingOfTheSetLiesBehindTheLastCell) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const Field& f : fields()) {
    const Map map(f);
    int inside_seen = 0, missed = 0;
    for (int n = 0; n < 3000; ++n) {
      const Vec3 d = normalize(Vec3(coordinate(random), coordinate(random), coordinate(random)));
      const Vec3 o = Vec3(coordinate(random), coordinate(random), coordinate(random)) * 1.2 - 3.0 * d;
      const double last = map.last(o, d, 0, 6);
      missed += last < 0;
      for (double t = 0.01; t < 6; t += 0.03) {
        if (!survives(f, o + t * d)) continue;
        ++inside_seen;
        ASSERT_LE(t, last + 1e-9);
        ASSERT_TRUE(map.grid().box.intersects(o + t * d));
      }
    }
    EXPECT_GT(inside_seen, 1000);
    EXPECT_GT(missed, 100);
  }
}

}  // namespace
}  // namespace verisim::shapes::julia
