#include "compare/report/place.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace verisim::compare {
namespace {

constexpr int kReach = 2;  // of the 5x5 mean

std::vector<float> errors(const Values& reference, const Values& test) {
  std::vector<float> out;
  out.reserve(static_cast<std::size_t>(reference.width()) * static_cast<std::size_t>(reference.height()));
  for (int y = 0; y < reference.height(); ++y)
    for (int x = 0; x < reference.width(); ++x) {
      double largest = reference.finite(x, y) && test.finite(x, y) ? 0 : 255;
      for (const double d : difference(reference, test, x, y)) largest = std::max(largest, std::fabs(d));
      out.push_back(static_cast<float>(largest));
    }
  return out;
}

// Sums over the neighbours in a row of `count` values that lie `step` apart; beyond the ends there is nothing.
void smooth(const float* in, float* out, int count, std::ptrdiff_t step) {
  float sum = 0;
  for (int i = -kReach; i < count; ++i) {
    if (i + kReach < count) sum += in[(i + kReach) * step];
    if (i - kReach - 1 >= 0) sum -= in[(i - kReach - 1) * step];
    if (i >= 0) out[i * step] = sum;
  }
}

std::vector<float> smoothed(const std::vector<float>& values, int width, int height) {
  std::vector<float> rows(values.size()), out(values.size());
  for (int y = 0; y < height; ++y) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * width;
    smooth(values.data() + at, rows.data() + at, width, 1);
  }
  for (int x = 0; x < width; ++x) smooth(rows.data() + x, out.data() + x, height, width);
  return out;
}

}  // namespace

std::optional<Place> worst_place(const Values& reference, const Values& test) {
  const int width = reference.width(), height = reference.height();
  std::vector<float> mean = smoothed(errors(reference, test), width, height);
  const auto worst = std::max_element(mean.begin(), mean.end());
  constexpr float kNothing = 1e-4f;  // what rounding leaves of running sums
  if (worst == mean.end() || *worst <= kNothing) return std::nullopt;
  const float limit = *worst / 2;
  std::vector<int> reached{static_cast<int>(worst - mean.begin())};
  int left = width, right = 0, top = height, bottom = 0;
  *worst = 0;
  while (!reached.empty()) {
    const int x = reached.back() % width, y = reached.back() / width;
    reached.pop_back();
    left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    for (const auto& [i, j] : {std::pair(x - 1, y), std::pair(x + 1, y), std::pair(x, y - 1), std::pair(x, y + 1)}) {
      if (i < 0 || j < 0 || i >= width || j >= height) continue;
      float& value = mean[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
      if (value < limit) continue;
      value = 0;  // seen
      reached.push_back(j * width + i);
    }
  }
  return Place{left, top, right - left + 1, bottom - top + 1};
}

}  // namespace verisim::compare
