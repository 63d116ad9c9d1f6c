#include "tracer/textures/patterns/pavement.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace verisim::textures {
namespace {

scene::PavementParams pavement(int sides, int tiles, int pattern, int exterior, int interior, int form) {
  scene::PavementParams p;
  p.sides = sides, p.tiles = tiles, p.pattern = pattern, p.exterior = exterior, p.interior = interior, p.form = form;
  return p;
}

// Probe P6 of spec 05.
TEST(Pavement, EqualsPovRay) {
  const double points[5][2] = {{0.3, 0.7}, {2.4, -1.9}, {-5.2, 3.3}, {7.7, 6.1}, {-2.9, -8.4}};
  struct Probe {
    scene::PavementParams p;
    double value[5];
  };
  const Probe probes[] = {
      {pavement(3, 4, 2, 0, 1, 1), {0.6875644, 0.6182069, 0.6842324, 0.8689802, 0.8492268}},
      {pavement(3, 6, 7, 2, 0, 2), {0.8303309, 0.4428927, 0.8289843, 1, 0.09845357}},
      {pavement(4, 5, 11, 0, 2, 0), {0.4, 0.8, 0.4, 0.8, 0.8}},
      {pavement(4, 6, 28, 1, 0, 2), {0.4, 1, 1, 0.3675445, 0.8}},
      {pavement(6, 3, 2, 0, 0, 1), {1, 0.6182069, 0, 0, 1}},
      {pavement(6, 5, 8, 0, 1, 0), {0.2686533, 0, 0, 0.4655099, 0}},
  };
  for (const Probe& probe : probes) {
    const Pavement compiled = compile_pavement(probe.p);
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(evaluate_pavement(compiled, points[k][0], points[k][1]), probe.value[k], 3e-7)
          << probe.p.sides << " sides, point " << k;
  }
}

TEST(Pavement, EveryAllowedNumberHasData) {
  const int patterns[3][6] = {{1, 1, 1, 3, 4, 12}, {1, 1, 2, 5, 12, 35}, {1, 1, 3, 7, 22, 0}};
  const int sides[3] = {3, 4, 6};
  for (int s = 0; s < 3; ++s)
    for (int tiles = 1; tiles <= 6; ++tiles) {
      for (int k = 1; k <= patterns[s][tiles - 1]; ++k)
        EXPECT_NO_THROW(compile_pavement(pavement(sides[s], tiles, k, 0, 0, 0)));
      EXPECT_THROW(compile_pavement(pavement(sides[s], tiles, patterns[s][tiles - 1] + 1, 0, 0, 0)),
                   std::invalid_argument);
    }
}

TEST(Pavement, SurvivesFarAndInvalidPoints) {
  for (const int sides : {3, 4, 6})
    for (const double x :
         {1e17, -1e17, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
      evaluate_pavement(compile_pavement(pavement(sides, 3, 1, 1, 1, 1)), x, -x);
}

}  // namespace
}  // namespace verisim::textures
