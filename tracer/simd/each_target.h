// Which of Highway's targets kernels are compiled for. A kernel file says
//
//   #undef HWY_TARGET_INCLUDE
//   #define HWY_TARGET_INCLUDE "tracer/.../name_kernels.cpp"  // itself: included once more for each target
//   #include "tracer/simd/each_target.h"
//   #include "tracer/simd/packet-inl.h"
//
// and keeps its kernels between HWY_BEFORE_NAMESPACE() and HWY_AFTER_NAMESPACE(), in an unnamed namespace around
// HWY_NAMESPACE that ends with a constant kKernels; what is to be compiled once stands within #if HWY_ONCE, with
// VERISIM_EXPORT_KERNELS (kernel_table.h). Highway's names for the targets: N_SCALAR or N_EMU128 (baseline), N_SSE4,
// N_AVX2, N_AVX3 (AVX-512), N_NEON.
#pragma once

// The others would cost time of compilation and are few; those of x86 ask for no more than instruction_sets.cpp looks
// for. Highway has none for SSE2 alone, so the baseline is one number at a time there.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#define HWY_DISABLE_PCLMUL_AES
#define HWY_DISABLE_F16C

#include "hwy/foreach_target.h"
