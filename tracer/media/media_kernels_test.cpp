#include "tracer/media/media_kernels.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "tracer/math/scaled.h"
#include "tracer/media/media.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

class MediaPacketOf : public testing::TestWithParam<int> {};

TEST_P(MediaPacketOf, AreThoseOfEachPlace) {
  const MediaKernels* kernels = media_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Vec3(u(generator), u(generator), u(generator)); };
  const auto color = [&] {
    return Rgb(static_cast<float>(u(generator)), static_cast<float>(u(generator)), static_cast<float>(u(generator)));
  };
  const auto lanes = std::make_unique<MediaPacket>();
  for (int round = 0; round < 300; ++round) {
    const int count = 1 + round % MediaPacket::kMax;
    const Vec3 light = 9.0 * vector();
    std::vector<scene::Media> media(static_cast<std::size_t>(1 + round % 3));
    for (scene::Media& m : media)
      m.scattering_type = (round + static_cast<int>(&m - media.data())) % 5 + 1, m.eccentricity = 0.9 * u(generator);
    std::vector<Vec3> place, view;
    std::vector<Rgb> scattering, arriving;
    for (int i = 0; i < count; ++i) {
      place.push_back(5.0 * vector()), view.push_back(normalize(vector())), scattering.push_back(color()),
          arriving.push_back(color());
      lanes->to_light.origin.set(i, place.back()), lanes->view.set(i, view.back()),
          lanes->scattering.set(i, scattering.back()), lanes->arriving.set(i, arriving.back());
      lanes->phase[i] = 0;
    }
    for (int i = 0; i < count; ++i)
      lanes->to_light.direction.set(i, normalize(light - place[static_cast<std::size_t>(i)]));
    for (const scene::Media& m : media) kernels->add_phase(m, count, *lanes);
    kernels->scatter(static_cast<int>(media.size()), count, *lanes);
    for (int i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Vec3 towards = lanes->to_light.direction.at(i);
      double sum = 0;
      for (const scene::Media& m : media) sum += phase(m, dot(towards, view[k]));
      const double mean = sum / static_cast<double>(media.size());
      ASSERT_EQ(lanes->scattered.at(i), scaled(scattering[k], mean) * arriving[k]) << round << ' ' << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, MediaPacketOf, testing::Range(0, static_cast<int>(simd::kInstructionSets)));

}  // namespace
}  // namespace verisim::global
