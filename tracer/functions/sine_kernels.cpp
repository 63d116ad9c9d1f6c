#include "tracer/functions/sine_kernels.h"

#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/functions/sine_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/functions/library-inl.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::functions {
namespace {
namespace HWY_NAMESPACE {

void sines_and_cosines(const double* angles, int count, double* sines, double* cosines) {
  int done = 0;
#if HWY_NATIVE_FMA
  for (; done + kPart <= count; done += kPart) {
    Part result;
    const Angle angle = reduced(Part::load(angles + done));
    unsigned unsure = sine<0>(angle, result);
    store(sines + done, result);
    for (; unsure != 0; unsure &= unsure - 1) {
      const int k = done + std::countr_zero(unsure);
      sines[k] = std::sin(angles[k]);
    }
    unsure = sine<1>(angle, result);
    store(cosines + done, result);
    for (; unsure != 0; unsure &= unsure - 1) {
      const int k = done + std::countr_zero(unsure);
      cosines[k] = std::cos(angles[k]);
    }
  }
#endif
  for (; done < count; ++done) sines[done] = std::sin(angles[done]), cosines[done] = std::cos(angles[done]);
}

const SineKernels kSineKernels = {sines_and_cosines};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::functions
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::functions {
VERISIM_EXPORT_KERNELS_OF(SineKernels, sine_kernels, kSineKernels)
}  // namespace verisim::functions
#endif
