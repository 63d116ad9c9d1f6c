// Roots of eight polynomials of one degree at once, as bernstein_roots finds them, to the last bit. Compiled for
// several instruction sets.
#pragma once

#include <cstdint>

#include "tracer/math/bernstein.h"

namespace verisim {

// Fill `power`, `from` and `to`, call begin, then next as often as roots are wanted: most only want a lane's first.
// Sets of lanes are bits.
struct alignas(64) RootPacket {
  static constexpr int kCount = 8, kMaxTerms = kMaxBernsteinDegree + 1;
  using Lane = double[kCount];

  Lane power[kMaxTerms];  // constant terms first
  Lane from, to;          // where roots are wanted
  Lane root;              // what `next` finds

  // The interval that is looked at, in Bernstein form, and the right halves of those that it came from, by their depth.
  struct Interval {
    Lane c[kMaxTerms], from, to;
  };
  Interval now, later[bernstein::kMaxDepth];
  std::int64_t depth[kCount];
  std::uint64_t waiting[kCount];  // which of `later` belong to a lane
  Lane last;                      // the root before
  int found[kCount];
  unsigned open;  // lanes that may have more roots
  unsigned done;  // those whose interval has given its root
};

struct BernsteinKernels {
  // The lanes of `active` that may have roots.
  unsigned (*begin)(int degree, unsigned active, RootPacket& packet);
  // The lanes of `active` that have another root, in increasing order; of others there is none left.
  unsigned (*next)(int degree, unsigned active, RootPacket& packet);
};

// Those of the best instruction set of this machine.
const BernsteinKernels& bernstein_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const BernsteinKernels* bernstein_kernels(int instruction_set);

}  // namespace verisim
