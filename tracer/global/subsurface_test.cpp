#include "tracer/global/subsurface.h"

#include <gtest/gtest.h>

namespace verisim::global {
namespace {

// Spec 07 section 5.2: rho = 0.9, 0.6, 0.4 at ior 1.4.
TEST(Subsurface, ReducedAlbedoEqualsTheSpecification) {
  EXPECT_NEAR(reduced_albedo(0.9, 1.4), 0.998826, 1e-6);
  EXPECT_NEAR(reduced_albedo(0.6, 1.4), 0.972707, 1e-6);
  EXPECT_NEAR(reduced_albedo(0.4, 1.4), 0.913844, 1e-6);
}

TEST(Subsurface, FresnelTransmittanceAtNormalIncidence) {
  EXPECT_NEAR(fresnel_transmittance(1.0, 1.5), 0.96, 1e-12);
  EXPECT_NEAR(fresnel_transmittance(1.0, 1.0), 1.0, 1e-12);
  EXPECT_EQ(fresnel_transmittance(0.1, 0.5), 0.0);  // total reflection
}

}  // namespace
}  // namespace verisim::global
