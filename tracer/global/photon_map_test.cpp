#include "tracer/global/photon_map.h"

#include <gtest/gtest.h>

#include <random>

namespace verisim::global {
namespace {

Photon photon(const Vec3& p, const Rgb& energy) {
  Photon result;
  result.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  result.energy = Photon::encode(energy);
  result.set_direction(normalize(Vec3(1, 2, -1)));
  return result;
}

TEST(Photon, EncodesAsTheMapFileOfProbeH1) {
  // Spec 07 P-H1: energy bytes 144 72 36 245; the ratios 1.2 : 0.6 : 0.3 of that light.
  const Photon p = photon({0, 0, 0}, {144.5f / 8192, 72.25f / 8192, 36.1f / 8192});
  EXPECT_EQ(p.energy, (std::array<std::uint8_t, 4>{144, 72, 36, 245}));
  EXPECT_FLOAT_EQ(p.color().r, 144.0f / 8192);
}

TEST(Photon, KeepsItsDirectionWithinTheByteResolution) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 d = normalize(Vec3(normal(generator), normal(generator), normal(generator)));
    Photon p{};
    p.set_direction(d);
    EXPECT_GT(dot(p.direction(), d), std::cos(0.05));
  }
}

TEST(PhotonMap, GathersWhatAnExhaustiveSearchFinds) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> u(-1, 1);
  PhotonMap map;
  for (int i = 0; i < 3000; ++i) map.add(photon({u(generator), 0.05 * u(generator), u(generator)}, Rgb(1.0f)));
  map.build();
  map.set_gather_radius(0.2, 1, 50, false);
  const Vec3 normal(0, 1, 0);
  for (int i = 0; i < 50; ++i) {
    const Vec3 x(u(generator), 0, u(generator));
    std::vector<double> all;
    for (const Photon& p : map.photons()) {
      const Vec3 d = Vec3(p.position[0], p.position[1], p.position[2]) - x;
      const double flattened = std::sqrt(dot(d, d) * (1 + 16 * std::fabs(dot(normal, d))));
      if (flattened < 0.2) all.push_back(flattened);
    }
    std::sort(all.begin(), all.end());
    PhotonMap::Gathered found;
    map.gather(x, &normal, {.minimum = 0, .maximum = 50}, found);
    ASSERT_EQ(found.photons.size(), std::min<std::size_t>(all.size(), 50));
    EXPECT_NEAR(found.radius, all.size() > 50 ? all[49] : 0.2, 1e-9);
  }
}

// What is remembered of earlier searches must not show: dense and sparse places, plane and solid, point after point as a picture asks for them.
TEST(PhotonMap, FindsTheSameWhateverItWasAskedBefore) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> u(-1, 1);
  std::normal_distribution<double> spot(0.0, 0.08);
  PhotonMap map;
  for (int i = 0; i < 4000; ++i) map.add(photon({u(generator), 0.3 * u(generator), u(generator)}, Rgb(1.0f)));
  for (int i = 0; i < 8000; ++i) map.add(photon({0.3 + spot(generator), spot(generator), spot(generator)}, Rgb(1.0f)));
  map.build();
  map.set_gather_radius(0.3, 1, 60, false);
  const Vec3 up(0, 1, 0);
  PhotonMap::Gathered flat, solid;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) {
      const Vec3 x(-0.2 + 0.04 * column, 0.01, -0.4 + 0.04 * row);
      for (const Vec3* normal : {&up, static_cast<const Vec3*>(nullptr)}) {
        std::vector<std::pair<double, std::size_t>> all;
        for (std::size_t i = 0; i < map.size(); ++i) {
          const auto& p = map.photons()[i].position;
          const Vec3 d = Vec3(p[0], p[1], p[2]) - x;
          double squared = dot(d, d);
          if (normal) squared *= 1.0 + 16.0 * std::fabs(dot(*normal, d));
          if (squared < 0.3 * 0.3) all.emplace_back(squared, i);
        }
        std::sort(all.begin(), all.end());
        const double radius = all.size() > 60 ? std::sqrt(all[59].first) : 0.3;
        all.resize(std::min<std::size_t>(all.size(), 60));
        std::vector<const Photon*> expected;
        for (const auto& [squared, i] : all) expected.push_back(&map.photons()[i]);
        std::sort(expected.begin(), expected.end());
        PhotonMap::Gathered& found = normal ? flat : solid;
        map.gather(x, normal, {.minimum = 0, .maximum = 60}, found);
        ASSERT_EQ(found.radius, radius) << row << ' ' << column;
        ASSERT_EQ(found.photons, expected) << row << ' ' << column;
      }
    }
  }
}

TEST(PhotonMap, WidensTheSearchOnceWhereFewAreFound) {
  PhotonMap map;
  for (int i = 0; i < 10; ++i) map.add(photon({0.25 + 0.001 * i, 0, 0}, Rgb(1.0f)));
  map.build();
  map.set_gather_radius(0.1, 1, 100, false);
  const Vec3 normal(0, 1, 0);
  PhotonMap::Gathered found;
  map.gather({0, 0, 0}, &normal, {}, found);
  EXPECT_EQ(found.photons.size(), 10u);
  EXPECT_NEAR(found.radius, 0.3, 1e-12);
}

TEST(PhotonMap, SurvivesItsFileAndRefusesABrokenOne) {
  const auto path = std::filesystem::temp_directory_path() / "verisim_photon_map_test.ph";
  PhotonMap surface, media, surface2, media2;
  for (int i = 0; i < 5; ++i) surface.add(photon({1.0 * i, 2, 3}, {1, 0.5f, 0.25f}));
  media.add(photon({4, 5, 6}, Rgb(0.1f)));
  save_photons(path, surface, media);
  EXPECT_EQ(std::filesystem::file_size(path), 4u + 5 * 20 + 4 + 20);
  load_photons(path, surface2, media2);
  EXPECT_EQ(surface2.size(), 5u);
  EXPECT_EQ(media2.size(), 1u);
  EXPECT_EQ(media2.photons()[0].energy, media.photons()[0].energy);
  std::filesystem::resize_file(path, 40);
  PhotonMap broken;
  EXPECT_THROW(load_photons(path, broken, media2), std::runtime_error);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace verisim::global
