// Non-linear least squares with few parameters.
#pragma once

#include <functional>
#include <vector>

namespace verisim::compare {

struct LeastSquares {
  std::vector<double> parameters, errors;  // errors: standard deviations, from the residuals that are left
};

// Gauss-Newton with derivatives by differences of the given steps, damped (Levenberg-Marquardt) where a step does not
// help; residuals far from the others count less (Huber). At most 30 iterations.
LeastSquares gauss_newton(const std::function<std::vector<double>(const std::vector<double>&)>& residuals,
                          std::vector<double> parameters, const std::vector<double>& steps);

}  // namespace verisim::compare
