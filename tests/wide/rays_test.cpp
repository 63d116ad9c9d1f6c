// Eight rays at once find what each finds alone, to the last bit, whatever their numbers are.
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <memory>
#include <random>

#include "tests/wide/each_instruction_set.h"
#include "tests/wide/sdl_tables.h"
#include "tracer/bvh/shaft.h"
#include "tracer/world/world.h"

namespace verisim::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPacketRays = RayPacket::kCount;

const SdlTables& tables() {
  static const SdlTables tables("rays.sdl");
  return tables;
}
scene::Scene scene_of(const std::string& sdl) {
  scene::Scene scene = tables().scene(sdl);
  scene::complete(scene);
  return scene;
}

// Rays that go the same way or anywhere, from outside or within, along axes and the lines of grids; every third round
// some of their numbers are strange.
class RandomRays {
 public:
  void fill(int round, int first) {
    const Vec3 eye = vector(round % 2 ? 3.0 : 0.5), aim = vector(0.6), step = vector(round % 4 == 1 ? 0.1 : 0.01);
    for (int k = 0; k < kPacketRays; ++k) {
      const int i = first + k;
      Vec3 from = vector(round % 2 ? 3.0 : 0.5), to = vector(0.6);
      if (round % 5 == 1) from = eye, to = aim + step * double(k);
      if (round % 5 == 2) from = eye + step * double(k), to = aim + step * double(k);
      if (round % 10 == 3) from = to = vector(0.6), from[round % 3] = 3, to[round % 3] = 0;
      if (round % 10 == 8) from = Vec3(k, round % 17, 9) / 8.5 - Vec3(0.5), to = from - Vec3(round % 4 / 17.0, 1, 0);
      rays->origin.set(i, from), rays->direction.set(i, normalize(to - from));
      if (round % 3 == 0) spoil(i);
      limit[k] = round % 6 == 0 ? 2 + std::fabs(normal_(random)) : kInfinity;
    }
    active = round % 4 == 0 ? static_cast<unsigned>(random() & 255) : 255;
  }
  Vec3 vector(double size) { return Vec3{normal_(random), normal_(random), normal_(random)} * size; }

  std::mt19937 random{21};
  std::unique_ptr<RayBatch> rays = std::make_unique<RayBatch>();
  alignas(64) double limit[kPacketRays];
  unsigned active = 255;

 private:
  void spoil(int i) {
    static const double kStrange[] = {
        0.0, -0.0, 5e-324, -1e-310, 1e-11,     -1e-9,      1,
        -1,  1e8,  1e200,  -1e300,  kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
    double* const numbers[] = {rays->origin.x,    rays->origin.y,    rays->origin.z,
                               rays->direction.x, rays->direction.y, rays->direction.z};
    for (auto n = random() % 2; n < 2; ++n) numbers[random() % 6][i] = kStrange[random() % std::size(kStrange)];
    // Directions are of unit length, or nothing that has one.
    const Vec3 strange = rays->direction.at(i), unit = normalize(strange);
    if (length(strange) < kInfinity && length(unit) > 0.5) rays->direction.set(i, unit);
  }
  std::normal_distribution<double> normal_;
};

// What a hit shows; Hit::u and v are the shape's own affair.
bool same_hit(const shapes::Hit& a, const shapes::Hit& b) {
  if (!same_bits(a.t, b.t) || !same_bits(a.point, b.point) || a.shape != b.shape || a.part != b.part) return false;
  const Vec2 uv_a = a.shape->uv(a), uv_b = b.shape->uv(b);
  return same_bits(a.shape->normal(a), b.shape->normal(b)) && same_bits(uv_a.x, uv_b.x) && same_bits(uv_a.y, uv_b.y);
}
void note(Journal& journal, const shapes::Hit& hit) {
  journal.add(hit.t), journal.add(hit.point), journal.add(hit.part), journal.add(hit.shape->normal(hit));
}
using Numbers = std::map<const shapes::Shape*, int>;
void number(const shapes::Shape& shape, Numbers& numbers) {
  numbers.emplace(&shape, static_cast<int>(numbers.size()));
  for (const auto& child : shape.children()) number(*child, numbers);
}

// Adds to `met` the rays that meet the shape.
void expect_the_same(const shapes::Shape& shape, int rounds, int& met, Journal& journal) {
  using shapes::Hit, shapes::RayKind;
  RandomRays random;
  Numbers numbers;
  number(shape, numbers);
  shapes::HitList all;
  for (int round = 0; round < rounds; ++round) {
    const int first = round % 9;
    random.fill(round, first);
    const RayPacket packet{*random.rays, first, random.active};
    const double t_min = round % 7 == 0 ? 1.5 : round % 7 == 1 ? 0 : 1e-4;
    Hit hits[kPacketRays], alone;
    const unsigned found = shape.intersect_packet(packet, nullptr, RayKind::camera, t_min, random.limit, hits),
                   blocked = shape.occludes_packet(packet, nullptr, t_min, random.limit);
    ASSERT_EQ(found & ~packet.active, 0u);
    for (int k = 0; k < kPacketRays; ++k) {
      if (!(packet.active >> k & 1)) continue;
      const Ray ray = packet.at(k);
      const bool hit = shape.intersect(ray, RayKind::camera, t_min, random.limit[k], alone);
      ASSERT_EQ(found >> k & 1, hit) << round << ' ' << k;
      ASSERT_EQ(blocked >> k & 1, shape.occludes(ray, t_min, random.limit[k])) << round << ' ' << k;
      if (!hit) continue;
      ASSERT_TRUE(same_hit(hits[k], alone)) << round << ' ' << k << ": " << hits[k].t << " is not " << alone.t;
      note(journal, alone), journal.add(numbers[alone.shape]);
      ++met;
    }
    all.clear();
    shape.intersect_all(packet.at(0), RayKind::camera, all);
    for (const Hit& hit : all) note(journal, hit);
    journal.add(shape.inside(packet.rays.origin.at(first)));
  }
}

TEST(WideRays, MeetEachShapeAsTheyMeetItAlone) {
  with_each_instruction_set([](Journal& journal) {
    for (const SdlLine& line : tables()["objects"]) {
      for (const SdlLine& variant : tables()["variants"]) {
        SCOPED_TRACE(line.name + ", " + variant.name);
        journal.begin(line.name + ", " + variant.name);
        const scene::Scene scene = scene_of("#macro M() " + variant.sdl + " #end " + line.sdl);
        int met = 0;
        expect_the_same(*shapes::compile(*scene.objects.at(0)), 600, met, journal);
        EXPECT_GT(met, 60);
      }
    }
  });
}

TEST(WideRays, MeetRandomTreesOfSolidsAndBlobsAsTheyMeetThemAlone) {
  with_each_instruction_set([](Journal& journal) {
    int met = 0;
    for (int seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE(seed);
      journal.begin("solid " + std::to_string(seed));
      const scene::Scene scene = scene_of("Solid(" + std::to_string(seed) + ")");
      expect_the_same(*shapes::compile(*scene.objects.at(0)), 150, met, journal);
    }
    EXPECT_GT(met, 40000);
  });
}

// Batches of rays through one tile of a camera's picture, in a world of all objects, of few, and below skies that let
// light through.
std::string crowd_of(std::size_t from, std::size_t count, int balls, bool skies) {
  std::string sdl = "#macro M() #end #declare S = seed(3); #macro V() 6*(<rand(S),rand(S),rand(S)>-.5) #end\n";
  for (std::size_t i = from; i < from + count; ++i)
    sdl += "union { " + tables()["objects"][i].sdl + " rotate 99*V() scale .6 translate V() pigment { rgbt <1,1,1," +
           (i % 6 == 0 ? ".5" : "0") + "> } }\n";
  sdl += "#for (I, 1, " + std::to_string(balls) +
         ") sphere { V(), .3 pigment { rgbt <1,1,1,select(mod(I,20),0,.5,0)> } } #end\n";
  if (skies) sdl += "sphere { 0, 99 hollow pigment { rgbt .5 } } plane { y, -70 hollow pigment { rgbt .9 } }";
  return sdl;
}

TEST(WideRays, MeetAWorldAsTheyMeetItAlone) {
  const std::size_t all = tables()["objects"].size();
  with_each_instruction_set([all](Journal& journal) {
    for (const std::string& sdl : {crowd_of(0, all, 0, false), crowd_of(20, 2, 0, false), crowd_of(0, 15, 100, false),
                                   crowd_of(30, 30, 5, true)}) {
      journal.begin("world of " + std::to_string(sdl.size()));
      const scene::Scene scene = scene_of(sdl);
      textures::Compiler compiler{textures::Settings{}};
      const accel::World world(scene, compiler);
      RandomRays random;
      std::uniform_real_distribution<double> u(-1, 1);
      RayBatch& rays = *random.rays;
      int found_rays = 0, blocked_rays = 0, beyond = 0;
      for (int round = 0; round < 300; ++round) {
        const Vec3 eye = normalize(random.vector(1)) * 6.0, size(20 + round % 3 * 100),
                   target = eye + (random.vector(0.3) - eye) * 1e3;  // behind everything: rays end there
        accel::WorldEntry entry;
        world.enter(*accel::Shaft::between(Box3(eye, eye), Box3(target - size, target + size)), entry);
        const int first = round % 5, count = 1 + round % 20;
        double limits[RayBatch::kSize] = {};
        for (int i = first; i < first + count; ++i) {
          const Vec3 to = target + size * Vec3(u(random.random), u(random.random), u(random.random));
          rays.origin.set(i, eye), rays.direction.set(i, normalize(to - eye));
          limits[i] = 3 + 5 * (1 + u(random.random));
        }
        accel::WorldEntry* const known = round % 4 == 0 ? nullptr : &entry;
        constexpr auto kKind = shapes::RayKind::camera;
        shapes::Hit hits[RayBatch::kMax], hits_before[RayBatch::kMax], alone;
        bool found[RayBatch::kMax], found_before[RayBatch::kMax], blocked[RayBatch::kMax] = {};
        world.intersect_batch(rays, first, count, kKind, 1e-4, known, hits, found);
        world.intersect_batch(rays, first, count, kKind, 1e-4, known, hits_before, found_before, limits);
        world.occluded_batch(rays, first, count, 1e-3, limits, known, blocked);
        for (int i = first; i < first + count; ++i) {
          ASSERT_EQ(found[i], world.intersect(rays.at(i), kKind, 1e-4, kInfinity, alone)) << round << ' ' << i;
          if (found[i]) {
            ASSERT_TRUE(same_hit(hits[i], alone)) << round << ' ' << i;
            note(journal, alone);
          }
          ASSERT_EQ(found_before[i], world.intersect(rays.at(i), kKind, 1e-4, limits[i], alone));
          ASSERT_TRUE(!found_before[i] || same_hit(hits_before[i], alone));
          ASSERT_EQ(blocked[i], world.occluded(rays.at(i), 1e-3, limits[i])) << round << ' ' << i;
          journal.add(blocked[i]);
          found_rays += found[i], blocked_rays += blocked[i], beyond += found[i] && !found_before[i];
        }
      }
      EXPECT_GT(found_rays, 80);
      EXPECT_GT(blocked_rays, 50);
      EXPECT_GT(beyond, 10);
    }
  });
}

}  // namespace
}  // namespace verisim::test
