#include "tracer/global/photon_kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tracer/textures/instruction_sets.h"

namespace verisim::global {
namespace {

TEST(PhotonKernels, AllInstructionSetsSayWhatThePlainFormulasSay) {
  constexpr std::size_t kAtOnce = PhotonPositions::kAtOnce;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> u(-1, 1);
  PhotonPositions photons;
  photons.resize(100);
  PhotonBoxes boxes;
  for (std::size_t i = 0; i < 100; ++i) photons.x[i] = static_cast<float>(u(generator)), photons.y[i] = static_cast<float>(u(generator)), photons.z[i] = static_cast<float>(u(generator));
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < kAtOnce; ++i) boxes.low[a][i] = static_cast<float>(u(generator)), boxes.high[a][i] = boxes.low[a][i] + 0.3f;
  }
  for (int set = 0; set < textures::kInstructionSets; ++set) {
    const PhotonKernels* kernels = photon_kernels(set);
    if (!kernels) continue;
    for (int run = 0; run < 500; ++run) {
      const Vec3 p(u(generator), u(generator), u(generator)), normal = run % 3 == 0 ? Vec3(0.0) : normalize(Vec3(u(generator), u(generator), u(generator)));
      const std::size_t first = static_cast<std::size_t>(run) % 90;
      const double limit = 1 + u(generator);
      std::array<double, kAtOnce> squared;
      const unsigned near = kernels->near(photons, first, p, normal, limit, squared.data()), within = kernels->within(squared.data(), 0.3, limit);
      const std::array<float, 3> at{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
      const unsigned met = kernels->boxes(boxes, at, static_cast<float>(limit));
      std::size_t below = 0;
      for (std::size_t i = 0; i < kAtOnce; ++i) {
        const Vec3 d = Vec3(photons.x[first + i], photons.y[first + i], photons.z[first + i]) - p;
        EXPECT_EQ(squared[i], dot(d, d) * (1.0 + 16.0 * std::fabs(dot(normal, d))));
        EXPECT_EQ(near >> i & 1, squared[i] < limit);
        EXPECT_EQ(within >> i & 1, squared[i] >= 0.3 && squared[i] < limit);
        below += squared[i] < limit;
        float gaps = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          const float gap = std::max({0.0f, boxes.low[a][i] - at[a], at[a] - boxes.high[a][i]});
          gaps += gap * gap;
        }
        EXPECT_EQ(met >> i & 1, gaps <= static_cast<float>(limit));
      }
      EXPECT_EQ(kernels->below(squared.data(), kAtOnce, limit), below);
    }
  }
}

}  // namespace
}  // namespace verisim::global
