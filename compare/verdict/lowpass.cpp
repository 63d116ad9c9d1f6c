// The comparison of noisy pictures: a Gaussian blur averages the noise of neighbouring pixels and leaves what is
// systematically different.
#include <algorithm>

#include "compare/metrics/values.h"
#include "compare/verdict/verdict.h"

namespace verisim::compare {
namespace {

std::vector<double> gaussian(double sigma) {
  const int r = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> k;
  double sum = 0;
  for (int i = -r; i <= r; ++i) {
    k.push_back(std::exp(-i * i / (2 * sigma * sigma)));
    sum += k.back();
  }
  for (double& v : k) v /= sum;
  return k;
}

// The blur is linear: the difference is blurred, once for each channel, with the border pixels repeated.
std::vector<double> blurred_difference(const Values& a, const Values& b, int channel,
                                       const std::vector<double>& kernel) {
  const int w = a.width(), h = a.height(), r = static_cast<int>(kernel.size() / 2);
  std::vector<double> rows(static_cast<std::size_t>(w) * h), out(rows.size()), line(static_cast<std::size_t>(w));
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) line[x] = difference(a, b, x, y)[channel];
    for (int x = 0; x < w; ++x) {
      double sum = 0;
      for (int i = -r; i <= r; ++i) sum += kernel[i + r] * line[std::clamp(x + i, 0, w - 1)];
      rows[static_cast<std::size_t>(y) * w + x] = sum;
    }
  }
  for (int y = 0; y < h; ++y)
    for (int i = -r; i <= r; ++i) {
      const double k = kernel[i + r];
      const double* from = &rows[static_cast<std::size_t>(std::clamp(y + i, 0, h - 1)) * w];
      double* to = &out[static_cast<std::size_t>(y) * w];
      for (int x = 0; x < w; ++x) to[x] += k * from[x];
    }
  return out;
}

}  // namespace

LowPass low_pass(const Picture& first, const Picture& second, double sigma) {
  const Values a(first), b(second);
  require_same_size(first, second);
  const std::vector<double> kernel = gaussian(sigma);
  LowPass out;
  double squares = 0;
  const double pixels = static_cast<double>(a.width()) * a.height();
  for (int c = 0; c < 3; ++c) {
    double sum = 0;
    for (double d : blurred_difference(a, b, c, kernel)) {
      sum += d;
      out.mad += std::fabs(d);
      squares += d * d;
    }
    out.bias = std::max(out.bias, std::fabs(sum / pixels));
  }
  out.mad /= 3 * pixels;
  out.rmse = std::sqrt(squares / (3 * pixels));
  return out;
}

Picture mean_of(std::span<const Picture> renders) {
  Picture mean = renders.front();
  std::vector<double> sums(mean.samples.begin(), mean.samples.end());
  for (const Picture& p : renders.subspan(1)) {
    require_same_size(mean, p);
    if (p.samples.size() != sums.size()) throw PictureMismatch("renders of one scene differ in their channels");
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += p.samples[i];
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    mean.samples[i] = static_cast<float>(sums[i] / static_cast<double>(renders.size()));
  return mean;
}

}  // namespace verisim::compare
