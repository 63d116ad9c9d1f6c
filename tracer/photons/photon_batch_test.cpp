#include "tracer/photons/photon_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "tracer/math/scaled.h"
#include "tracer/shading/finish.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

struct Case {
  std::vector<Photon> photons;
  PhotonSurface surface;
  std::vector<Rgb> expected;  // of each photon
};

// Spec 07 3.10, a photon at a time.
Case random_case(std::mt19937& generator, std::size_t count, int kind) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto direction = [&] { return normalize(Vec3(u(generator), u(generator), u(generator))); };
  const auto color = [&] {
    return Rgb(static_cast<float>(std::fabs(u(generator))), static_cast<float>(std::fabs(u(generator))),
               static_cast<float>(std::fabs(u(generator))));
  };
  Case c;
  const float opacity = kind % 5 == 0 ? -0.3f : 0.8f, diffuse = kind % 3 == 1 ? 0.0f : 0.7f,
              back = kind % 2 == 0 ? 0.0f : 0.4f;
  c.surface = {direction(), direction(), color(),

               shading::diffuse_share(opacity, diffuse), shading::diffuse_share(opacity, back)};
  for (std::size_t i = 0; i < count; ++i) {
    Photon p;
    p.energy = Photon::encode(color());
    p.set_direction(direction());
    c.photons.push_back(p);
    const double cosine = dot(c.surface.normal, p.direction()),
                 slant = std::max(0.1, dot(c.surface.geometric_normal, p.direction()));
    const float coefficient = cosine < kEpsilon ? back : diffuse;
    const Rgb intensity = p.color() * static_cast<float>(1 / slant);
    c.expected.push_back(coefficient > 0
                             ? scaled(c.surface.pigment, shading::diffuse_share(opacity, coefficient, 1.0f, cosine)) *
                                   intensity
                             : Rgb());
  }
  return c;
}

class PhotonBatches : public testing::TestWithParam<int> {};

TEST_P(PhotonBatches, AddWhatEachPhotonAdds) {
  const PhotonBatchKernels* kernels = photon_batch_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::mt19937 generator(5);
  const auto batch = std::make_unique<PhotonBatch>();
  for (int round = 0; round < 300; ++round) {
    const std::size_t count = 1 + static_cast<std::size_t>(round) % PhotonBatch::kMax;
    const Case c = random_case(generator, count, round);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 d = c.photons[i].direction();
      const Rgb energy = c.photons[i].color();
      batch->x[i] = d.x, batch->y[i] = d.y, batch->z[i] = d.z;
      batch->r[i] = energy.r, batch->g[i] = energy.g, batch->b[i] = energy.b;
    }
    kernels->shade(c.surface, count, *batch);
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(Rgb(batch->r[i], batch->g[i], batch->b[i]), c.expected[i]) << round << ' ' << i;
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, PhotonBatches, testing::Range(0, static_cast<int>(simd::kInstructionSets)));

TEST(PhotonLight, IsTheSumInTheirOrder) {
  std::mt19937 generator(6);
  for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 200u}) {
    const Case c = random_case(generator, count, 3);
    std::vector<std::uint32_t> numbers;
    Rgb expected(0.25f), sum(0.25f);
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(static_cast<std::uint32_t>(i)), expected += c.expected[i];
    add_light({c.photons, numbers}, c.surface, sum);
    EXPECT_EQ(sum, expected) << count;
  }
}

}  // namespace
}  // namespace verisim::global
