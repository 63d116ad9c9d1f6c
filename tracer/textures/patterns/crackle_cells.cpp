#include "tracer/textures/patterns/crackle_cells.h"

#include <memory>

#include "tracer/textures/patterns/crackle_kernels.h"
#include "tracer/textures/patterns/crackle_offsets.h"

namespace verisim::textures {
namespace {

void fill(CrackleCell& cell, CrackleMetric metric, std::int64_t a, std::int64_t b, std::int64_t c) {
  const NoiseTables& t = noise_tables();
  CrackleCell all;
  for (int i = 0; i < 81; ++i) {
    const CellOffset& o = kCrackleOffsets[i];
    const int h = lattice_hash(t, a + o.x, b + o.y, c + o.z);
    all.x[i] = o.x + random_value(t, h);
    all.y[i] = o.y + random_value(t, h + 1);
    all.z[i] = o.z + random_value(t, h + 2);
  }
  constexpr double kFar = 1e30;
  for (int i = 81; i < CrackleCell::kMax; ++i) all.x[i] = all.y[i] = all.z[i] = kFar;
  all.count = CrackleCell::kMax;

  // A point that is farther from the whole cell than three others are from any place in it is never among the nearest
  // three. Places may lie beyond the cell's faces by the epsilon of POV-Ray's floor.
  const CrackleKernels& kernels = crackle_kernels();
  alignas(64) double at_least[CrackleCell::kMax] = {};
  const double limit = metric == CrackleMetric::any       ? 0
                       : metric == CrackleMetric::squares ? kernels.bound_squares(all, at_least) * (1 + 1e-8) + 1e-8
                                                          : kernels.bound_sums(all, at_least) * (1 + 1e-8) + 1e-8;
  const double ax = static_cast<double>(a), ay = static_cast<double>(b), az = static_cast<double>(c);
  int n = 0;
  for (int i = 0; i < 81; ++i) {
    cell.x[n] = ax + all.x[i];
    cell.y[n] = ay + all.y[i];
    cell.z[n] = az + all.z[i];
    n += at_least[i] <= limit;
  }
  for (; n % 8 != 0; ++n) cell.x[n] = cell.y[n] = cell.z[n] = kFar;
  cell.count = n;
}

class CellMemory {
 public:
  const CrackleCell& get(CrackleMetric metric, std::int64_t a, std::int64_t b, std::int64_t c) {
    // A number of 20 bits for cells near the origin. Far away, differences are rounded by more than the bounds allow
    // for, so that all points are kept, and the cell is not remembered.
    constexpr std::uint64_t kHalf = 1u << 19;
    const auto index = [](std::int64_t v) { return static_cast<std::uint64_t>(v) + kHalf; };
    const bool near = ((index(a) | index(b) | index(c)) >> 20) == 0;
    const std::uint64_t key =
        1 | static_cast<std::uint64_t>(metric) << 1 | index(a) << 3 | index(b) << 23 | index(c) << 43;
    const std::size_t slot = key * 0x9e3779b97f4a7c15 >> 55;
    if (!near || keys_[slot] != key) {
      fill(cells_[slot], near ? metric : CrackleMetric::any, a, b, c);
      keys_[slot] = near ? key : 0;
    }
    return cells_[slot];
  }

 private:
  static constexpr std::size_t kSlots = 512;
  std::uint64_t keys_[kSlots] = {};
  CrackleCell cells_[kSlots];
};

}  // namespace

const CrackleCell& crackle_cell(CrackleMetric metric, std::int64_t a, std::int64_t b, std::int64_t c) {
  thread_local constinit CellMemory* memory = nullptr;
  if (!memory) [[unlikely]] {
    static thread_local const std::unique_ptr<CellMemory> owner = std::make_unique_for_overwrite<CellMemory>();
    memory = owner.get();
  }
  return memory->get(metric, a, b, c);
}

}  // namespace verisim::textures
