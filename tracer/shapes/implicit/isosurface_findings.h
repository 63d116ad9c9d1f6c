// What is told to the author of an isosurface whose max_gradient, or whose `evaluate`, does not fit what rays met (spec
// 04 6.7). Empty: it fits.
#pragma once

#include <string>

#include "tracer/math/vec.h"

namespace verisim::shapes {

std::string max_gradient_finding(double found, double set);
// `evaluate`: as written; the largest gradient, by how much it had to be raised at most, and the mean over all rays.
std::string evaluate_finding(const Vec3& evaluate, double largest, double variation, double average);

}  // namespace verisim::shapes
