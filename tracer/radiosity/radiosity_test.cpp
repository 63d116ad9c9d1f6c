#include "tracer/radiosity/radiosity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tracer/radiosity/final_gather_lattice.h"

namespace verisim::global {
namespace {

TEST(RadiositySettings, FirstDirectionIsHaltons) {
  scene::Radiosity description;
  const RadiositySettings settings(description, Vec3(0, 0, 0));
  EXPECT_NEAR(settings.direction(0).x, -0.353553, 1e-6);
  EXPECT_NEAR(settings.direction(0).y, 0.707107, 1e-6);
  EXPECT_NEAR(settings.direction(0).z, 0.612372, 1e-6);
  EXPECT_EQ(settings.rays(0), 35);
  EXPECT_EQ(settings.rays(1), 17);
  EXPECT_EQ(settings.rays(4), 5);
}

// The moments of a cosine-weighted hemisphere: the mean of cos^k is 2 / (k + 2), azimuths cancel. Beginnings, which
// importance uses, are spread, too; so are the directions behind the lattice, for normals that turn many away.
TEST(FinalGatherLattice, IsCosineWeightedFromItsBeginning) {
  for (const int count : {5, 34, 46, 89, 160, 1600, 1000000}) {
    const FinalGatherLattice::Plan plan(count);
    for (const std::size_t number : {0u, 7u, 123456u}) {
      for (const int rays : {count / 5, count / 2, count, 3 * count}) {
        if (rays > 5000) continue;
        FinalGatherLattice lattice(plan, number);
        Vec3 mean(0, 0, 0);
        double square = 0;
        for (int i = 0; i < rays; ++i) {
          const Vec3 d = lattice.next();
          EXPECT_NEAR(length(d), 1.0, 1e-12);
          EXPECT_GE(d.y, 0.0);
          mean += d / rays;
          square += d.y * d.y / rays;
        }
        const double tolerance = (rays < count ? 3.0 : 1.5) / rays;
        EXPECT_NEAR(mean.x, 0.0, tolerance) << count << ' ' << rays;
        EXPECT_NEAR(mean.y, 2.0 / 3.0, tolerance) << count << ' ' << rays;
        EXPECT_NEAR(mean.z, 0.0, tolerance) << count << ' ' << rays;
        EXPECT_NEAR(square, 0.5, tolerance) << count << ' ' << rays;
      }
    }
  }
}

TEST(FinalGatherLattice, TakesTimeFromSamplesOfManyRaysAndGivesItToThoseOfFew) {
  EXPECT_EQ(FinalGatherLattice::enough(200), 160);
  EXPECT_EQ(FinalGatherLattice::enough(60), 60);
  EXPECT_EQ(FinalGatherLattice::enough(35), 46);
  EXPECT_EQ(FinalGatherLattice::enough(17), 34);
  EXPECT_TRUE(FinalGatherLattice::worthwhile(17));
  EXPECT_FALSE(FinalGatherLattice::worthwhile(8));
}

TEST(IrradianceCache, SamplesBeforeTheLatticeBeginsAreInNoCell) {
  IrradianceCache cache(1.8, 2.05);
  IrradianceSample s;
  s.normal = {0, 1, 0}, s.mean_distance = 1;
  for (const double x : {0.0, -1e7 - 50, -1e8, 5.0}) {
    s.point = {x, 0, 0};
    cache.add(s);
  }
  EXPECT_EQ(cache.samples().size(), 2u);
}

TEST(OctreeOrder, ChildrenComeBeforeTheirNodeByXThenYThenZ) {
  const LatticeCell node{5, 9, 3, 2};
  std::vector<LatticeCell> walk;
  for (int child = 0; child < 8; ++child)
    walk.push_back({2 * node.x + (child >> 2), 2 * node.y + (child >> 1 & 1), 2 * node.z + (child & 1), 1});
  walk.push_back(node);
  walk.push_back({node.x, node.y, node.z + 1, 2});                      // the upper half along z of what holds both
  walk.push_back({4 * node.x, 4 * (node.y + 1), 4 * (node.z + 1), 0});  // a small one beyond, along y
  walk.push_back({node.x >> 3, node.y >> 3, node.z >> 3, 5});           // what holds all of them
  for (std::size_t i = 1; i < walk.size(); ++i)
    EXPECT_LT(OctreeOrder(walk[i - 1]), OctreeOrder(walk[i])) << "cell " << i;
}

TEST(OctreeOrder, HoldsTheLargestCellsThereAre) {
  const LatticeCell largest{0, 0, 0, LatticeCell::kMaxLevel}, smallest{(std::int64_t{1} << 38) - 1, 0, 0, -6};
  EXPECT_LT(OctreeOrder(smallest), OctreeOrder(largest));
  EXPECT_LT(OctreeOrder(LatticeCell{0, 0, 0, 40}), OctreeOrder(largest));
}

TEST(IrradianceCache, SamplesOfOneCellComeTheLastOneFirst) {
  IrradianceCache cache(1.8, 2.05);
  IrradianceSample s;
  s.normal = {0, 1, 0}, s.mean_distance = 1;
  for (const double x : {0.1, 0.11, -40.0}) s.point = {x, 0, 0}, cache.add(s);
  const auto& samples = cache.samples();
  EXPECT_TRUE(cache.turn_of(samples[1]) < cache.turn_of(samples[0]));
  EXPECT_TRUE(cache.turn_of(samples[2]) < cache.turn_of(samples[0]));
  EXPECT_FALSE(cache.turn_of(samples[0]) < cache.turn_of(samples[0]));
}

TEST(IrradianceCache, FindsEverySampleThatCanReachTheQuery) {
  // At depth 0 nothing within reach may be lost (spec 07 2.8).
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> u(-5, 5), radius(0.01, 1.5);
  IrradianceCache cache(1.8, 2.05);
  for (int i = 0; i < 2000; ++i) {
    IrradianceSample s;
    s.point = {u(generator), u(generator), u(generator)};
    s.normal = {0, 1, 0};
    s.mean_distance = static_cast<float>(radius(generator));
    cache.add(s);
  }
  for (int i = 0; i < 300; ++i) {
    const Vec3 x(u(generator), u(generator), u(generator));
    std::vector<const IrradianceSample*> found;
    cache.visit(0, x, 1.8, {0, 1, 0}, [&](const IrradianceSample& s, double) { found.push_back(&s); });
    auto sorted = found;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end()) << "a sample was visited twice";
    for (const IrradianceSample& s : cache.samples()) {
      const Vec3 d = x - s.point;
      if (length(d) < s.mean_distance * 1.8) {
        EXPECT_TRUE(std::binary_search(sorted.begin(), sorted.end(), &s));
      }
    }
  }
}

TEST(IrradianceCache, LeavesOutOnlyWhatCannotCount) {
  // Samples of all sizes, many at one place and some far away; floats must not lose one of them.
  std::mt19937 generator(12);
  std::normal_distribution<double> u(0, 1);
  std::uniform_real_distribution<double> exponent(-3, 1);
  IrradianceCache cache(1.5, 1.75);
  for (int i = 0; i < 3000; ++i) {
    IrradianceSample s;
    const double spread = std::pow(10, exponent(generator));
    s.point = Vec3(1000, -2000, 30) + spread * Vec3(u(generator), u(generator), u(generator));
    s.normal = normalize(Vec3(u(generator), u(generator), u(generator)));
    s.mean_distance = static_cast<float>(spread * std::pow(10, 0.3 * exponent(generator)));
    s.nearest_distance = s.mean_distance * (i % 2 == 0 ? 0.5f : 1.3f);
    cache.add(s);
  }
  std::size_t found = 0, reachable = 0;
  for (int i = 0; i < 500; ++i) {
    const double spread = std::pow(10, exponent(generator));
    const Vec3 x = Vec3(1000, -2000, 30) + spread * Vec3(u(generator), u(generator), u(generator));
    const Vec3 normal = normalize(Vec3(u(generator), u(generator), u(generator)));
    const double bound = 1.5;
    std::vector<const IrradianceSample*> expected, visited;
    for (const IrradianceSample& s : cache.samples()) {
      const double r = length(x - s.point),
                   error = r / std::max(s.mean_distance, s.nearest_distance) + 2 * std::sqrt(1 - dot(normal, s.normal));
      if (r < s.mean_distance * bound && error < bound) expected.push_back(&s);
    }
    cache.visit(0, x, bound, normal, [&](const IrradianceSample& s, double) { visited.push_back(&s); });
    reachable += visited.size(), found += expected.size();
    EXPECT_TRUE(std::is_sorted(visited.begin(), visited.end())) << "not in the order of taking";
    EXPECT_TRUE(std::includes(visited.begin(), visited.end(), expected.begin(), expected.end()));
  }
  EXPECT_GT(found, 1000u);
  // A leaf has one unit for the points of all its samples: the smallest of them are found from a little too far.
  EXPECT_LT(reachable, found + found / 12) << "what is too far or turned away should be left out";
}

// A gatherer in a uniform furnace: every ray sees the same radiance at the same distance.
class Furnace : public FinalGatherer {
 public:
  void gather(const Vec3&, std::span<const FinalGatherRay> together, int, FinalGatherResult* results) override {
    rays += static_cast<int>(together.size());
    std::fill_n(results, together.size(),
                FinalGatherResult{.distance = 1.0, .shaded = true, .importance = 1, .color = Rgb(0.25f), .notes = {}});
  }
  int rays = 0;
};

// The first ray of a sample hits something of importance 0.2 and of radiance 1, the others what is black; a sample is
// taken while one of them is followed.
class Lamp : public FinalGatherer {
 public:
  void gather(const Vec3&, std::span<const FinalGatherRay> rays, int depth, FinalGatherResult* results) override {
    for (std::size_t i = 0; i < rays.size(); ++i) results[i] = gather(depth, rays[i].threshold);
  }
  FinalGatherResult gather(int depth, float threshold) {
    if (depth > 0)
      return {.distance = 1.0, .shaded = true, .importance = nested_importance, .color = Rgb(0.0f), .notes = {}};
    FinalGatherResult result{.distance = 1.0,
                             .shaded = true,
                             .importance = threshold == 0 ? 0.2f : 1.0f,
                             .color = Rgb(threshold == 0 ? 1.0f : 0.0f),
                             .notes = {}};
    if (task && threshold == nested_threshold)
      task->irradiance({{0, 3, 0}, {0, -1, 0}, {0, -1, 0}, 1.0, 1}, *this, result.notes);
    return result;
  }
  RadiosityTask* task = nullptr;  // of samples within samples
  float nested_threshold = 0, nested_importance = 1;
};

TEST(RadiosityTask, RaysAreWeighedByTheImportanceOfWhatWasHitLast) {
  scene::Radiosity description;
  description.count = 5;
  const RadiositySettings settings(description, Vec3(0, 1, -3));
  const auto irradiance = [&](Lamp lamp, bool nested) {
    IrradianceCache cache = settings.empty_cache();
    RadiosityTask task(settings, &cache, &cache, true, 0, 0);
    lamp.task = nested ? &task : nullptr;
    shading::FinalGatherNotes notes;
    return task.irradiance({{0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1.0, 0}, lamp, notes).r;
  };
  Lamp lamp;
  EXPECT_FLOAT_EQ(irradiance(lamp, false), 5.0f / 9.0f);  // one of five such rays may be followed: it counts for five
  EXPECT_FLOAT_EQ(irradiance(lamp, true), 1.0f / 5.0f);   // but the sample within it has hit what is important
  lamp.nested_threshold = 0.75f, lamp.nested_importance = 0.5f;
  EXPECT_FLOAT_EQ(irradiance(lamp, true),
                  5.0f / 8.0f);  // of too little importance in the end for the fourth ray: it is left out
}

TEST(RadiosityTask, ReusesSamplesNearbyAndTakesNewOnesElsewhere) {
  scene::Radiosity description;
  const RadiositySettings settings(description, Vec3(0, 1, -3));
  IrradianceCache cache = settings.empty_cache();
  RadiosityTask task(settings, &cache, &cache, true, 0, 0);
  Furnace furnace;
  const auto query = [&](const Vec3& p) {
    shading::FinalGatherNotes notes;
    return task.irradiance({p, {0, 1, 0}, {0, 1, 0}, 1.0, 0}, furnace, notes);
  };
  EXPECT_FLOAT_EQ(query({0, 0, 0}).r, 0.25f);
  EXPECT_EQ(furnace.rays, 35);
  EXPECT_EQ(cache.samples().size(), 1u);
  EXPECT_FLOAT_EQ(query({5, 0, 0}).g, 0.25f);  // far away: another sample
  EXPECT_EQ(furnace.rays, 70);
  RadiosityTask final_trace(settings, &cache, nullptr, false, 0, 0);
  shading::FinalGatherNotes notes;
  EXPECT_FLOAT_EQ(final_trace.irradiance({{0.01, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1.0, 0}, furnace, notes).b, 0.25f);
  EXPECT_EQ(furnace.rays, 70);  // reused
}

}  // namespace
}  // namespace verisim::global
