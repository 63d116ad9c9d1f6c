#include "tracer/shapes/plane_set.h"

#include "tracer/shapes/plane.h"
#include "tracer/textures/instruction_sets.h"

namespace verisim::shapes {
namespace {

constexpr double kFar = 1e300;

namespace baseline {
#include "tracer/shapes/plane_set.inc"
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi2")
namespace avx2 {
#include "tracer/shapes/plane_set.inc"
}  // namespace avx2
#pragma GCC target("avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
namespace avx512 {
#include "tracer/shapes/plane_set.inc"
}  // namespace avx512
#pragma GCC pop_options

const PlaneKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, &avx2::kKernels, &avx512::kKernels};
#else
const PlaneKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, nullptr, nullptr};
#endif

}  // namespace

const PlaneKernels* plane_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

PlaneSet::PlaneSet() : kernels_(*plane_kernels(textures::best_instruction_set())) {}

void PlaneSet::add(const Vec3& normal, double distance, bool inverted) {
  const int lane = count_ % 8;
  if (lane == 0) blocks_.emplace_back();
  EightPlanes& block = blocks_.back();
  block.x[lane] = normal.x, block.y[lane] = normal.y, block.z[lane] = normal.z, block.distance[lane] = distance;
  block.side[lane] = inverted ? -1 : 1;
  all_ |= std::uint64_t{1} << count_;
  if (!inverted) inside_ |= std::uint64_t{1} << count_;
  ++count_;
}

}  // namespace verisim::shapes
