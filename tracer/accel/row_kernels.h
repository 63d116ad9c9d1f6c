// What many rays meet first, computed for all of them at once: boxes and planes. Compiled for several instruction sets; every lane does the operations of
// the scalar code in the same order.
#pragma once

#include <cstdint>

#include "tracer/accel/box_node.h"

namespace verisim::accel {

// Rays that are traced together, as arrays. Kernels work on eight lanes at a time: behind the last ray stands any number.
struct alignas(64) RayRow {
  static constexpr int kMost = 40, kStep = 8, kSize = kMost + kStep;  // the default block of a picture and the column beside it fit
  struct Vectors {
    double x[kSize], y[kSize], z[kSize];
    Vec3 at(int i) const { return {x[i], y[i], z[i]}; }
    void set(int i, const Vec3& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
  };
  Vectors origin, direction;
  Ray at(int i) const { return {origin.at(i), direction.at(i)}; }
};

// Which of the boxes of an entry the rays meet.
struct alignas(64) BoxesMet {
  std::int64_t mask[RayRow::kSize];  // bit 4 n + k: child k of node n
  double near[EntryPoints::kMost][RayRow::kSize];
};

struct RowKernels {
  // Rays first .. first + count - 1 against boxes relative to `center`, at distances above t_min.
  void (*boxes)(const EntryPoints& entry, const Vec3& center, const RayRow& rays, int first, int count, double t_min, BoxesMet& met);
  // The distance at which they meet a plane (shapes/plane.h); -1 where they do not.
  void (*plane)(const Vec3& normal, double distance, const RayRow& rays, int first, int count, double* t);
};

// Those of the best instruction set of this machine.
const RowKernels& row_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const RowKernels* row_kernels(int instruction_set);

}  // namespace verisim::accel
