#include "tracer/photons/photon_map.h"

#include <gtest/gtest.h>

#include <random>

namespace verisim::global {
namespace {

Photon photon(const Rgb& energy) {
  Photon result;
  result.energy = Photon::encode(energy);
  result.set_direction(normalize(Vec3(1, 2, -1)));
  return result;
}
void add(PhotonMap& map, const Vec3& p, const Rgb& energy) {
  map.add({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}, photon(energy));
}

TEST(Photon, EncodesAsTheMapFileOfProbeH1) {
  // Spec 07 P-H1: energy bytes 144 72 36 245; the ratios 1.2 : 0.6 : 0.3 of that light.
  const Photon p = photon({144.5f / 8192, 72.25f / 8192, 36.1f / 8192});
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

// POV-Ray's search as its pictures show it, without any haste.
struct PlainSearch {
  const PhotonMap& map;
  Vec3 x;
  const Vec3* normal;
  std::size_t maximum;
  double limit;
  std::vector<std::pair<double, std::uint32_t>> found{};

  void walk(std::ptrdiff_t first, std::ptrdiff_t last) {
    if (first > last) return;
    const std::ptrdiff_t middle = (first + last) / 2;
    const auto node = static_cast<std::uint32_t>(middle);
    test(node);
    const std::uint8_t axis = map.photons()[node].axis;
    const double d = x[axis] - map.positions()[node][axis];
    d < 0 ? walk(first, middle - 1) : walk(middle + 1, last);
    if (d * d < limit) d < 0 ? walk(middle + 1, last) : walk(first, middle - 1);
  }
  double squared_distance(const PhotonPosition& p) const {
    const Vec3 d = Vec3(p[0], p[1], p[2]) - x;
    return dot(d, d) * (normal ? 1 + 16 * std::fabs(dot(*normal, d)) : 1);
  }
  void test(std::uint32_t number) {
    const double squared = squared_distance(map.positions()[number]);
    if (squared >= limit) return;
    const bool full = found.size() == maximum;
    if (full) found.erase(std::max_element(found.begin(), found.end()));
    found.emplace_back(squared, number);
    if (full) limit = std::max_element(found.begin(), found.end())->first;
  }
  std::vector<std::uint32_t> photons() {
    walk(0, static_cast<std::ptrdiff_t>(map.size()) - 1);
    std::vector<std::uint32_t> result;
    for (const auto& f : found) result.push_back(f.second);
    std::sort(result.begin(), result.end());
    return result;
  }
};

// Dense and sparse places, plane and solid, point after point as a picture asks for them: what is remembered of earlier
// searches must not show.
TEST(PhotonMap, GathersWhatAPlainWalkFinds) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> u(-1, 1);
  std::normal_distribution<double> spot(0.0, 0.08);
  PhotonMap map;
  for (int i = 0; i < 4000; ++i) add(map, {u(generator), 0.3 * u(generator), u(generator)}, Rgb(1.0f));
  for (int i = 0; i < 8000; ++i) add(map, {0.3 + spot(generator), spot(generator), spot(generator)}, Rgb(1.0f));
  map.build();
  CLibraryRandom random;
  map.set_gather_radius(0.3, 1, 60, false, random);
  const Vec3 up(0, 1, 0);
  PhotonMap::Gathered flat, solid;
  int overlooked = 0;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) {
      const Vec3 x(-0.2 + 0.04 * column, 0.01, -0.4 + 0.04 * row);
      for (const Vec3* normal : {&up, static_cast<const Vec3*>(nullptr)}) {
        PlainSearch plain{map, x, normal, 60, 0.3 * 0.3};
        const std::vector<std::uint32_t> expected = plain.photons();
        PhotonMap::Gathered& found = normal ? flat : solid;
        map.gather(x, normal, {.minimum = 0, .maximum = 60}, found);
        ASSERT_EQ(found.radius, std::sqrt(plain.limit)) << row << ' ' << column;
        ASSERT_EQ(found.numbers, expected) << row << ' ' << column;
        for (std::uint32_t i = 0; i < map.size(); ++i) {
          const bool near = plain.squared_distance(map.positions()[i]) < plain.limit;
          overlooked += near && !std::binary_search(expected.begin(), expected.end(), i);
        }
      }
    }
  }
  EXPECT_GT(overlooked, 100);  // else this would not show that the same ones are
}

// Hardly more within the radius than wanted: the first one too many takes the place of the last one kept, even if it is
// farther away, and stays if nothing nearer comes.
TEST(PhotonMap, FindsTheSameAsAPlainWalkWhereFewAreTooMany) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> u(-1, 1);
  int farther_kept = 0;  // or a nearer one overlooked
  for (const int count : {12, 40, 700}) {
    PhotonMap map;
    for (int i = 0; i < count; ++i) add(map, {u(generator), u(generator), u(generator)}, Rgb(1.0f));
    map.build();
    CLibraryRandom random;
    const double radius = std::cbrt(8.0 / count * 12 / 4.2);  // about twelve
    map.set_gather_radius(radius, 1, 10, false, random);
    PhotonMap::Gathered found;
    for (int run = 0; run < 2000; ++run) {
      const Vec3 x(u(generator), u(generator), u(generator));
      PlainSearch plain{map, x, nullptr, 10, radius * radius};
      const std::vector<std::uint32_t> expected = plain.photons();
      map.gather(x, nullptr, {.minimum = 0, .maximum = 10}, found);
      ASSERT_EQ(found.radius, std::sqrt(plain.limit)) << count << ' ' << run;
      ASSERT_EQ(found.numbers, expected) << count << ' ' << run;
      std::size_t nearer = 0;
      for (const PhotonPosition& p : map.positions()) nearer += plain.squared_distance(p) < plain.limit;
      farther_kept += expected.size() == 10 && nearer > 10;
    }
  }
  EXPECT_GT(farther_kept, 100);
}

// Map files of 3.7.0.10, photons on a line in the order of shooting: two stay as they are, three are sorted, of more
// some pairs are left the wrong way round.
TEST(PhotonMap, KeepsPhotonsInPovRaysOrder) {
  const std::vector<std::pair<std::vector<int>, std::vector<int>>> cases = {
      {{1, 0}, {1, 0}},
      {{2, 0, 1}, {0, 1, 2}},
      {{0, 2, 1, 3}, {1, 0, 2, 3}},
      {{0, 2, 3, 1}, {0, 1, 3, 2}},
      {{3, 1, 2, 0}, {0, 1, 2, 3}},
      {{1, 4, 2, 0, 3}, {0, 1, 2, 4, 3}},
      {{3, 5, 0, 4, 2, 1}, {0, 1, 3, 2, 4, 5}},
      {{2, 5, 3, 6, 4, 1, 0}, {0, 1, 2, 4, 3, 5, 6}},
      {{8, 6, 5, 0, 4, 3, 7, 1, 2}, {1, 0, 2, 3, 4, 6, 5, 7, 8}},
      {{6, 7, 8, 1, 5, 3, 0, 9, 2, 11, 10, 4}, {1, 0, 2, 3, 4, 6, 7, 5, 8, 9, 10, 11}},
  };
  for (const auto& [shot, kept] : cases) {
    PhotonMap map;
    for (int x : shot) add(map, {1.0 * x, 0, 0}, Rgb(1.0f));
    map.build();
    for (std::size_t i = 0; i < kept.size(); ++i)
      EXPECT_EQ(map.positions()[i][0], static_cast<float>(kept[i])) << shot.size() << ' ' << i;
  }
}

TEST(CLibraryRandom, DrawsWhatTheCLibraryDraws) {
  CLibraryRandom random;
  for (const std::size_t expected : {1804289383u, 846930886u, 1681692777u, 1714636915u}) EXPECT_EQ(random(), expected);
}

TEST(PhotonMap, WidensTheSearchOnceWhereFewAreFound) {
  PhotonMap map;
  for (int i = 0; i < 10; ++i) add(map, {0.25 + 0.001 * i, 0, 0}, Rgb(1.0f));
  map.build();
  CLibraryRandom random;
  map.set_gather_radius(0.1, 1, 100, false, random);
  const Vec3 normal(0, 1, 0);
  PhotonMap::Gathered found;
  map.gather({0, 0, 0}, &normal, {}, found);
  EXPECT_EQ(found.photons.size(), 10u);
  EXPECT_NEAR(found.radius, 0.3, 1e-12);
}

TEST(PhotonMap, SurvivesItsFileAndRefusesABrokenOne) {
  const auto path = std::filesystem::temp_directory_path() / "verisim_photon_map_test.ph";
  PhotonMap surface, media, surface2, media2;
  for (int i = 0; i < 5; ++i) add(surface, {1.0 * i, 2, 3}, {1, 0.5f, 0.25f});
  add(media, {4, 5, 6}, Rgb(0.1f));
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
