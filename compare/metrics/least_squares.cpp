#include "compare/metrics/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace verisim::compare {
namespace {

using Vector = std::vector<double>;
using Matrix = std::vector<Vector>;

// The inverse of a small symmetric positive matrix, by Gauss-Jordan; what cannot be told becomes 0.
Matrix inverse(Matrix m) {
  const std::size_t n = m.size();
  Matrix out(n, Vector(n));
  for (std::size_t i = 0; i < n; ++i) out[i][i] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i + 1; j < n; ++j)
      if (std::fabs(m[j][i]) > std::fabs(m[pivot][i])) pivot = j;
    std::swap(m[i], m[pivot]), std::swap(out[i], out[pivot]);
    const double scale = m[i][i];
    if (std::fabs(scale) < 1e-300) continue;
    for (std::size_t k = 0; k < n; ++k) m[i][k] /= scale, out[i][k] /= scale;
    for (std::size_t j = 0; j < n; ++j) {
      const double factor = m[j][i];
      if (j == i || factor == 0) continue;
      for (std::size_t k = 0; k < n; ++k) m[j][k] -= factor * m[i][k], out[j][k] -= factor * out[i][k];
    }
  }
  return out;
}

// Huber's: residuals beyond 1.345 standard deviations, estimated by the median, or beyond three times their root mean
// square where most of them are next to nothing, count by their size alone.
Vector weights(const Vector& residuals) {
  Vector sizes;
  for (const double r : residuals) sizes.push_back(std::fabs(r));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  const double mean_square =
      std::inner_product(sizes.begin(), sizes.end(), sizes.begin(), 0.0) / static_cast<double>(sizes.size());
  const double limit = std::max({1e-9, 1.345 * 1.4826 * *middle, 3 * std::sqrt(mean_square)});
  Vector out;
  for (const double r : residuals) out.push_back(std::fabs(r) <= limit ? 1 : limit / std::fabs(r));
  return out;
}

double weighted_sum(const Vector& residuals, const Vector& weight) {
  double sum = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) sum += weight[i] * residuals[i] * residuals[i];
  return sum;
}

}  // namespace

LeastSquares gauss_newton(const std::function<Vector(const Vector&)>& residuals, Vector parameters,
                          const Vector& steps) {
  constexpr int kMaxIterations = 30;
  constexpr double kSmallGain = 1e-5;
  const std::size_t n = parameters.size();
  Vector now = residuals(parameters);
  double damping = 1e-3;
  Matrix normal(n, Vector(n));
  double rest = 0, count = 0;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const Vector weight = weights(now);
    Matrix derivative;
    for (std::size_t k = 0; k < n; ++k) {
      Vector up = parameters, down = parameters;
      up[k] += steps[k], down[k] -= steps[k];
      Vector d = residuals(up);
      const Vector low = residuals(down);
      for (std::size_t i = 0; i < d.size(); ++i) d[i] = (d[i] - low[i]) / (2 * steps[k]);
      derivative.push_back(std::move(d));
    }
    Vector gradient(n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k) {
        normal[j][k] = 0;
        for (std::size_t i = 0; i < now.size(); ++i) normal[j][k] += weight[i] * derivative[j][i] * derivative[k][i];
      }
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < now.size(); ++i) gradient[j] -= weight[i] * derivative[j][i] * now[i];
    const double before = weighted_sum(now, weight);
    rest = before, count = 0;
    for (const double w : weight) count += w;
    bool better = false;
    double after = before;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      Matrix damped = normal;
      for (std::size_t k = 0; k < n; ++k) damped[k][k] *= 1 + damping;
      const Matrix solve = inverse(damped);
      Vector tried = parameters;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < n; ++k) tried[j] += solve[j][k] * gradient[k];
      Vector then;
      try {
        then = residuals(tried);
      } catch (const std::runtime_error&) {  // no place that there can be
        damping *= 10;
        continue;
      }
      after = weighted_sum(then, weight);
      better = after < before;
      if (better) parameters = std::move(tried), now = std::move(then);
      damping = better ? std::max(1e-9, damping / 10) : damping * 10;
    }
    if (!better || before - after < kSmallGain * before) break;
  }
  LeastSquares out{parameters, Vector(n)};
  const Matrix covariance = inverse(normal);
  const double variance = rest / std::max(1.0, count - static_cast<double>(n));
  for (std::size_t k = 0; k < n; ++k) out.errors[k] = std::sqrt(std::max(0.0, variance * covariance[k][k]));
  return out;
}

}  // namespace verisim::compare
