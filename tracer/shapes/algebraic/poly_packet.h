// A polynomial surface along eight rays at once. Compiled for several instruction sets.
#pragma once

#include "tracer/math/polynomial.h"
#include "tracer/shapes/packet_kernels.h"

namespace verisim::shapes {

struct alignas(64) PolyPacket {
  double c[kMaxPolynomialDegree + 1][RayPacket::kCount];  // constant terms first
  int size;                                               // how many, for all lanes; 0 is zero
};

using PolyAlong = void (*)(int order, const double* coefficients, const unsigned char* used, const LocalPacket& rays,
                           PolyPacket& packet);

// That of the best instruction set of this machine.
const PolyAlong& poly_along();
// That of any set, for tests; null: this machine cannot run it.
const PolyAlong* poly_along(int instruction_set);

}  // namespace verisim::shapes
