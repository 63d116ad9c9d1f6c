// How much radiosity samples count for a query (spec 07 2.5), a batch of samples at a time. Compiled for several
// instruction sets; every lane does the same operations.
#pragma once

#include "tracer/math/vec.h"

namespace verisim::global {

struct IrradianceWeightQuery {
  Vec3 normal;
  double bound;  // of the error
  bool smooth;   // weights fall off smoothly, as in the final render at depth 0
};

// Samples side by side. Some behind the last one are weighed with them, whatever they are.
struct alignas(64) IrradianceBatch {
  static constexpr int kMax = 32, kStep = 4;
  struct Vectors {
    double x[kMax] = {}, y[kMax] = {}, z[kMax] = {};
    void set(int i, const Vec3& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
  };
  Vectors delta, normal, nearest_direction;  // delta: from the sample to the query
  double squared[kMax] = {}, mean_distance[kMax] = {}, nearest_distance[kMax] = {};
  double weight[kMax];  // what comes out: not above kNone: the sample does not count
  static constexpr double kNone = 0.001;
};

struct IrradianceWeightKernels {
  // Weights of `count` samples, without their quality.
  void (*weigh)(const IrradianceWeightQuery& query, int count, IrradianceBatch& batch);
};

const IrradianceWeightKernels& irradiance_weight_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const IrradianceWeightKernels* irradiance_weight_kernels(int instruction_set);

}  // namespace verisim::global
