// What the tests of packets of rays share: rays with strange numbers, the comparison of bits, instruction sets.
#pragma once

#include <cstring>
#include <limits>
#include <memory>

#include "tracer/shapes/packet_kernels.h"
#include "tracer/shapes/test_support.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes::testing {

constexpr int kLanes = RayPacket::kCount, kRounds = 3000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }
inline bool same(const Hit& a, const Hit& b) {
  return same(a.t, b.t) && same(a.point.x, b.point.x) && same(a.point.y, b.point.y) && same(a.point.z, b.point.z) &&
         a.shape == b.shape && a.part == b.part && same(a.u, b.u) && same(a.v, b.v);
}

// Rays towards and beside the origin; every third round some of their numbers are strange.
class Rays {
 public:
  void fill(int round, int first) {
    static const double kStrange[] = {
        0.0, -0.0, 5e-324, -1e-310, 1e-11,     -1e-9,      1,
        -1,  1e8,  1e200,  -1e300,  kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
    std::normal_distribution<double> d;
    std::uniform_int_distribution<std::size_t> any(0, std::size(kStrange) - 1);
    for (int i = first; i < first + kLanes; ++i) {
      const Vec3 origin = Vec3(d(random), d(random), d(random)) * (round % 2 ? 3.0 : 0.5),
                 target = Vec3(d(random), d(random), d(random)) * 0.7;
      batches->origin.set(i, origin);
      batches->direction.set(i, normalize(target - origin));
      if (round % 3 == 0) {
        double* const numbers[] = {batches->origin.x,    batches->origin.y,    batches->origin.z,
                                   batches->direction.x, batches->direction.y, batches->direction.z};
        for (std::size_t n = 0; n < 1 + any(random) % 2; ++n) numbers[any(random) % 6][i] = kStrange[any(random)];
        // Directions are of unit length, or nothing that has one.
        const Vec3 strange = batches->direction.at(i), unit = normalize(strange);
        if (length(strange) < kInfinity && length(unit) > 0.5) batches->direction.set(i, unit);
      }
      limit[i - first] = round % 5 == 0 ? 2 + std::fabs(d(random)) : kInfinity;
    }
    active = round % 4 == 0 ? static_cast<unsigned>(any(random) * 17 & 255) : 255;
  }
  std::mt19937 random{21};
  std::unique_ptr<RayBatch> batches = std::make_unique<RayBatch>();
  alignas(64) double limit[kLanes];
  unsigned active = 255;
};

// The parameter is an instruction set: kernels_of(GetParam()) are null where this machine cannot run them.
using EachInstructionSet = ::testing::TestWithParam<int>;
inline auto all_instruction_sets() { return ::testing::Range(0, static_cast<int>(simd::kInstructionSets)); }

struct Term {
  int x, y, z;  // powers
  double factor;
};
inline scene::Poly poly(int order, const std::vector<Term>& terms) {
  scene::Poly result{order, {}};
  for (int i = order; i >= 0; --i)
    for (int j = order - i; j >= 0; --j)
      for (int k = order - i - j; k >= 0; --k) {
        result.coefficients.push_back(0);
        for (const Term& t : terms)
          if (t.x == i && t.y == j && t.z == k) result.coefficients.back() = t.factor;
      }
  return result;
}

// A bumpy sheet, folded so that rays cross it more than once, and a tent that is solid.
inline void add_meshes(const Steps& steps, std::vector<ObjectRef>& objects) {
  constexpr std::uint32_t kSide = 24;
  scene::MeshData sheet;
  for (std::uint32_t i = 0; i <= kSide; ++i)
    for (std::uint32_t k = 0; k <= kSide; ++k) {
      const double x = i * 2.4 / kSide - 1.2, z = k * 2.4 / kSide - 1.2;
      sheet.vertices.emplace_back(x, float(0.5 * std::sin(5 * x) + 0.2 * std::cos(7 * z)), z);
    }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    scene::MeshTriangle t;
    t.vertex = t.normal = t.uv = {a, b, c};
    sheet.triangles.push_back(t);
  };
  for (std::uint32_t i = 0; i < kSide; ++i)
    for (std::uint32_t k = 0; k < kSide; ++k) {
      const std::uint32_t a = i * (kSide + 1) + k;
      add(a, a + 1, a + kSide + 1), add(a + 1, a + kSide + 2, a + kSide + 1);
      if (i == k) add(a, a + 1, a + kSide + 1);  // written twice
    }
  scene::MeshData solid = sheet;
  solid.inside_vector = Vec3(0, 1, 0);
  for (const auto& data : {sheet, solid})
    objects.push_back(make(scene::Mesh{std::make_shared<const scene::MeshData>(data), {}}, steps));
  objects.push_back(make(scene::Mesh{std::make_shared<const scene::MeshData>(sheet), {}}, [&](Object& o) {
    if (steps) steps(o);
    o.hierarchy = false;
  }));
}

}  // namespace verisim::shapes::testing
