// The search for crossings of an isosurface along eight rays in step: every ray visits the nodes that it visits alone (isosurface.cpp), in the same order, so
// it finds the same.
#pragma once

#include <cstdint>

#include "tracer/functions/program.h"
#include "tracer/math/ray_row.h"

namespace verisim::shapes {

inline constexpr int kMostHalvings = 50;

// The nodes that eight rays are at, and the way to them. A search of lane k is set up in begin ... sign; `slope` is the slope bound along its ray.
struct alignas(64) SearchLanes {
  static constexpr int kCount = RayLanes::kCount;
  double origin[3][kCount] = {}, direction[3][kCount] = {};  // in object space
  double begin[kCount] = {}, width[kCount] = {}, value0[kCount] = {}, value1[kCount] = {}, slope[kCount] = {}, sign[kCount] = {};
  double root_width[kCount] = {};
  double steepest[kCount] = {};  // change of the function over a node, for its width
  std::int64_t place[kCount] = {}, unit[kCount] = {};  // where the node begins and how long it is, in 2^-50 of the root
  std::int64_t depth[kCount] = {}, active[kCount] = {}, found[kCount] = {};  // the last two: 0 or -1
  double accuracy = 0, threshold = 0;
  double begins[kMostHalvings + 1][kCount], ends[kMostHalvings + 1][kCount];  // of the nodes above: where they begin, and the value where they end
};

struct IsosurfaceKernels {
  // The middles of the nodes.
  void (*middles)(const SearchLanes& lanes, double* points);
  // Begins at the roots; the lanes that want the value in the middle of their node.
  unsigned (*start)(SearchLanes& lanes, unsigned asked);
  // Goes on with the values in the middles. A lane that ends has found the surface at begin + width, or nothing.
  unsigned (*advance)(SearchLanes& lanes, const double* values);
};

// Those of the best instruction set of this machine.
const IsosurfaceKernels& isosurface_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const IsosurfaceKernels* isosurface_kernels(int instruction_set);

// A function evaluated at eight points, again and again.
class FieldLanes {
 public:
  static constexpr std::size_t kMostRegisters = 256;
  // Programs for which this is worth while.
  static const functions::Program* suitable(const Function* function);
  explicit FieldLanes(const functions::Program& program);
  // x, y and z of the points, eight each.
  double* points() { return registers_; }
  // The values at the points of the lanes that are asked for.
  const double* evaluate(unsigned asked);

 private:
  const functions::Program& program_;
  alignas(64) double registers_[kMostRegisters * SearchLanes::kCount];
};

// The lanes of `asked` that find the surface; where is begin + width.
unsigned find_crossings(FieldLanes& field, SearchLanes& lanes, unsigned asked);

}  // namespace verisim::shapes
