#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "compare/metrics/ciede2000.h"
#include "compare/metrics/edges.h"
#include "compare/metrics/flip.h"
#include "compare/metrics/metrics.h"
#include "compare/metrics/ssim.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

// 16-bit and float values are not whole numbers in 8-bit units: a difference of one code value may come out a rounding error above 1.
constexpr double kRounding = 1e-3;

struct Sum {
  double squares = 0;
  std::uint64_t count = 0;
  void add(double d) { squares += d * d, ++count; }
  std::optional<double> rms() const { return count ? std::optional(std::sqrt(squares / static_cast<double>(count))) : std::nullopt; }
};

// CIEDE2000 of every pixel as a histogram of fine bins: mean and percentile without keeping the values.
class ColorDifferences {
 public:
  void add(double e) { sum_ += e, ++count_, ++bins_[static_cast<std::size_t>(std::min(e / kBin, kBins - 1.0))]; }
  double mean() const { return count_ ? sum_ / static_cast<double>(count_) : 0; }
  double percentile(double p) const {  // the upper end of the bin that holds it; 0 stays 0
    const double wanted = p * static_cast<double>(count_);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      seen += bins_[i];
      if (seen && static_cast<double>(seen) >= wanted) return i == 0 ? 0 : static_cast<double>(i + 1) * kBin;
    }
    return 0;
  }

 private:
  static constexpr double kBin = 0.001, kBins = 200000;
  std::vector<std::uint32_t> bins_ = std::vector<std::uint32_t>(static_cast<std::size_t>(kBins));
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

// Keeps the largest differences that lie apart from each other.
class WorstPixels {
 public:
  explicit WorstPixels(int wanted) : wanted_(static_cast<std::size_t>(std::max(0, wanted))) {}
  void add(int x, int y, double error) {
    if (wanted_ == 0 || error <= 0.5 || (candidates_.size() >= kMany && error <= floor_)) return;
    candidates_.push_back({x, y, error, {}, {}});
    if (candidates_.size() >= 2 * kMany) trim();
  }
  std::vector<WorstPixel> take() {
    trim();
    std::vector<WorstPixel> out;
    for (const WorstPixel& p : candidates_) {
      if (out.size() == wanted_) break;
      if (std::none_of(out.begin(), out.end(), [&](const WorstPixel& q) { return std::abs(p.x - q.x) < 3 && std::abs(p.y - q.y) < 3; })) out.push_back(p);
    }
    return out;
  }

 private:
  static constexpr std::size_t kMany = 4096;
  void trim() {
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const WorstPixel& a, const WorstPixel& b) { return a.error > b.error; });
    if (candidates_.size() > kMany) candidates_.resize(kMany);
    if (!candidates_.empty()) floor_ = candidates_.back().error;
  }
  std::size_t wanted_;
  double floor_ = 0;
  std::vector<WorstPixel> candidates_;
};

std::array<double, 4> rgba(const Values& v, int x, int y) {
  const Rgb c = v.rgb(x, y);
  return {c[0], c[1], c[2], v.alpha(x, y)};
}

}  // namespace

std::uint64_t measure_bytes(std::uint64_t pixels, int channels) {
  constexpr std::uint64_t kFloat = 4, kMasksAndErrors = 16;
  return pixels * (3 * kFloat * static_cast<std::uint64_t>(channels) + kMasksAndErrors);  // both pictures, a copy for the report
}

std::uint64_t available_bytes() {
  std::ifstream in("/proc/meminfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("MemAvailable:")) return std::strtoull(line.c_str() + 13, nullptr, 10) * 1024;
  return 0;
}

void require_memory(std::uint64_t pixels, int channels, std::uint64_t limit) {
  const std::uint64_t available = limit ? limit : available_bytes(), needed = measure_bytes(pixels, channels);
  if (available && needed > available)
    throw PictureMismatch(fmt::format("two pictures of {:.1f} million pixels take about {:.1f} GiB to compare, and {:.1f} GiB are available", 1e-6 * static_cast<double>(pixels),
                                      static_cast<double>(needed) / (1 << 30), static_cast<double>(available) / (1 << 30)));
}

Metrics measure(const Picture& reference, const Picture& test, const MetricOptions& options) {
  const Values a(reference), b(test);
  require_same_size(reference, test);
  Metrics m;
  m.width = a.width(), m.height = a.height();
  const bool alpha = options.alpha && (a.has_alpha() || b.has_alpha());
  const std::vector<unsigned char> edges = edge_mask(a);

  double absolute = 0, signed_sum = 0;
  std::uint64_t within_1 = 0, within_2 = 0, edge_count = 0;
  Sum all, edge, interior, alpha_sum;
  ColorDifferences colors;
  WorstPixels worst(options.worst_pixels);
  for (int y = 0; y < m.height; ++y)
    for (int x = 0; x < m.width; ++x) {
      const bool on_edge = edges[static_cast<std::size_t>(y) * m.width + x];
      edge_count += on_edge;
      if (!a.finite(x, y) || !b.finite(x, y)) {
        ++m.nan_pixels;
        continue;
      }
      const Rgb p = a.rgb(x, y), q = b.rgb(x, y);
      double largest = 0;
      for (int c = 0; c < 3; ++c) {
        const double d = q[c] - p[c];
        largest = std::max(largest, std::fabs(d));
        absolute += std::fabs(d), signed_sum += d;
        all.add(d);
        (on_edge ? edge : interior).add(d);
      }
      m.max_abs = std::max(m.max_abs, largest);
      if (largest > 0) colors.add(ciede2000(srgb_to_lab(p), srgb_to_lab(q)));
      else colors.add(0);
      if (alpha) {
        const double d = std::fabs(b.alpha(x, y) - a.alpha(x, y));
        m.alpha_max_abs = std::max(m.alpha_max_abs.value_or(0), d);
        alpha_sum.add(d);
        largest = std::max(largest, d);
      }
      within_1 += largest <= 1 + kRounding;
      within_2 += largest <= 2 + kRounding;
      ++m.histogram[static_cast<std::size_t>(std::lround(std::min(largest, 255.0)))];
      worst.add(x, y, largest);
    }

  const double pixels = static_cast<double>(m.width) * m.height, values = static_cast<double>(all.count);
  if (values > 0) m.mae = absolute / values, m.bias = signed_sum / values, m.rmse = *all.rms();
  m.psnr = m.rmse > 0 ? 20 * std::log10(255 / m.rmse) : std::numeric_limits<double>::infinity();
  m.within_1_pct = 100 * static_cast<double>(within_1) / pixels;
  m.within_2_pct = 100 * static_cast<double>(within_2) / pixels;
  m.edge_pct = 100 * static_cast<double>(edge_count) / pixels;
  m.edge_rmse = edge.rms(), m.interior_rmse = interior.rms(), m.alpha_rmse = alpha_sum.rms();
  m.ciede2000_mean = colors.mean(), m.ciede2000_p95 = colors.percentile(0.95);
  m.worst = worst.take();
  for (WorstPixel& p : m.worst) p.reference = rgba(a, p.x, p.y), p.test = rgba(b, p.x, p.y);
  m.ssim_mean = ssim_mean(a, b), m.ssim_block_min = ssim_block_min(a, b);
  m.flip_mean = mean(ldr_flip(reference, test, options.flip_pixels_per_degree));
  if (reference.is_float && test.is_float) m.hdr_flip_mean = mean(hdr_flip(reference, test, options.flip_pixels_per_degree));
  return m;
}

}  // namespace verisim::compare
