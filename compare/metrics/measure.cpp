#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "compare/metrics/ciede2000.h"
#include "compare/metrics/rounding.h"
#include "compare/metrics/edges.h"
#include "compare/metrics/flip.h"
#include "compare/metrics/metrics.h"
#include "compare/metrics/patches.h"
#include "compare/metrics/row_window.h"
#include "compare/metrics/ssim.h"
#include "compare/metrics/systematic.h"
#include "compare/metrics/values.h"
#include "tracer/base/parallel.h"

namespace verisim::compare {
namespace {

struct Sum {
  double squares = 0;
  std::uint64_t count = 0;
  void add(double d) { squares += d * d, ++count; }
  void add(const Sum& other) { squares += other.squares, count += other.count; }
  std::optional<double> rms() const {
    return count ? std::optional(std::sqrt(squares / static_cast<double>(count))) : std::nullopt;
  }
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
  std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(static_cast<std::size_t>(kBins));
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

std::array<double, 4> rgba(const Values& v, const Values& other, int x, int y) {
  const Rgb c = judged(v, other, x, y);
  return {c[0], c[1], c[2], v.alpha(x, y)};
}

// Keeps the largest differences that lie apart from each other.
class WorstPixels {
 public:
  explicit WorstPixels(int wanted) : wanted_(static_cast<std::size_t>(std::max(0, wanted))) {}
  void add(const Values& a, const Values& b, int x, int y, double error) {
    if (wanted_ == 0 || error <= 0.5 || (candidates_.size() >= kMany && error <= floor_)) return;
    candidates_.push_back({x, y, error, rgba(a, b, x, y), rgba(b, a, x, y)});
    if (candidates_.size() >= 2 * kMany) trim();
  }
  std::vector<WorstPixel> take() {
    trim();
    std::vector<WorstPixel> out;
    for (const WorstPixel& p : candidates_) {
      if (out.size() == wanted_) break;
      if (std::none_of(out.begin(), out.end(),
                       [&](const WorstPixel& q) { return std::abs(p.x - q.x) < 3 && std::abs(p.y - q.y) < 3; }))
        out.push_back(p);
    }
    return out;
  }

 private:
  static constexpr std::size_t kMany = 4096;
  void trim() {
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const WorstPixel& a, const WorstPixel& b) { return a.error > b.error; });
    if (candidates_.size() > kMany) candidates_.resize(kMany);
    if (!candidates_.empty()) floor_ = candidates_.back().error;
  }
  std::size_t wanted_;
  double floor_ = 0;
  std::vector<WorstPixel> candidates_;
};

// What one row adds; rows are worked on by several threads and added in their order, so that sums do not depend on
// threads.
struct RowFigures {
  double absolute = 0, signed_sum = 0, max_abs = 0, alpha_max = 0;
  std::uint64_t edge_count = 0, nan_pixels = 0, within_1 = 0, within_2 = 0;
  Sum all, edge, interior, alpha;
  std::array<SignTest, 3> signs;
  std::array<std::vector<signed char>, 3> sides;
  std::vector<double> color;   // CIEDE2000; negative: not a number
  std::vector<float> largest;  // difference of the channels
};

RowFigures row_figures(const Values& a, const Values& b, int y, const unsigned char* edges, bool alpha) {
  RowFigures out;
  const auto width = static_cast<std::size_t>(a.width());
  out.color.assign(width, -1), out.largest.assign(width, 0);
  for (auto& sides : out.sides) sides.assign(width, 0);
  for (std::size_t i = 0; i < width; ++i) {
    const int x = static_cast<int>(i);
    out.edge_count += edges[i];
    if (!a.finite(x, y) || !b.finite(x, y)) {
      ++out.nan_pixels;
      continue;
    }
    double largest = 0;
    const Rgb apart = difference(a, b, x, y), told = told_difference(a, b, x, y);
    for (std::size_t c = 0; c < 3; ++c)
      out.signs[c].add(told[c]), out.sides[c][i] = static_cast<signed char>(SignTest::side(told[c]));
    for (const double d : apart) {
      largest = std::max(largest, std::fabs(d));
      out.absolute += std::fabs(d), out.signed_sum += d;
      out.all.add(d);
      (edges[i] ? out.edge : out.interior).add(d);
    }
    out.max_abs = std::max(out.max_abs, largest);
    out.color[i] = largest > 0 ? ciede2000(srgb_to_lab(a.rgb(x, y)), srgb_to_lab(b.rgb(x, y))) : 0;
    if (alpha) {
      const double d = std::fabs(b.alpha(x, y) - a.alpha(x, y));
      out.alpha_max = std::max(out.alpha_max, d);
      out.alpha.add(d);
      largest = std::max(largest, d);
    }
    out.within_1 += largest <= 1 + kRounding;
    out.within_2 += largest <= 2 + kRounding;
    out.largest[i] = static_cast<float>(largest);
  }
  return out;
}

// The figures of two pictures of which only some rows are seen at a time.
class Measurement {
 public:
  Measurement(int width, int height, bool alpha, const std::optional<Exposures>& exposures,
              const MetricOptions& options)
      : options_(options),
        alpha_(alpha),
        exposures_(exposures),
        flip_(options.flip_pixels_per_degree),
        worst_(options.worst_pixels) {
    m_.width = width, m_.height = height, m_.ssim_block_min = 1;
  }

  // Rows above and below a band that its figures depend on: FLIP's filters, SSIM's window, the edges, patches.
  int margin() const { return std::max(flip_.margin(), kPatchMargin); }
  int band_rows() const {
    constexpr int kStep = 64, kPixels = 1 << 22;
    return options_.band_rows > 0 ? options_.band_rows : std::clamp(kPixels / m_.width / kStep, 1, 16) * kStep;
  }

  void add_band(const Values& a, const Values& b, int begin, int end) {
    add_differences(a, b, begin, end);
    patches_.add(patches(a, b, begin, end));
    m_.fine = a.bits() > 8 && b.bits() > 8;
    ssim_ += ssim_sum(a, b, begin, end);
    m_.ssim_block_min = std::min(m_.ssim_block_min, ssim_block_min(a, b, begin, end));
    std::vector<float> errors(static_cast<std::size_t>(end - begin) * static_cast<std::size_t>(m_.width));
    flip_.ldr(a, b, begin, end, errors.data());
    for (float e : errors) flip_sum_ += e;
    if (exposures_) {
      flip_.hdr(a, b, *exposures_, begin, end, errors.data());
      for (float e : errors) hdr_flip_sum_ += e;
    }
    if (options_.progress) options_.progress(static_cast<double>(end) / m_.height);
  }

  Metrics result() {
    const double pixels = static_cast<double>(m_.width) * m_.height, values = static_cast<double>(all_.count);
    if (values > 0) m_.mae = absolute_ / values, m_.bias = signed_sum_ / values, m_.rmse = *all_.rms();
    m_.psnr = m_.rmse > 0 ? 20 * std::log10(255 / m_.rmse) : kPsnrOfEqualPictures;
    m_.within_1_pct = 100 * static_cast<double>(within_1_) / pixels;
    m_.within_2_pct = 100 * static_cast<double>(within_2_) / pixels;
    m_.edge_pct = 100 * static_cast<double>(edge_count_) / pixels;
    m_.edge_rmse = edge_.rms(), m_.interior_rmse = interior_.rms(), m_.alpha_rmse = alpha_sum_.rms();
    if (alpha_sum_.count) m_.alpha_max_abs = alpha_max_;
    m_.ciede2000_mean = colors_.mean(), m_.ciede2000_p95 = colors_.percentile(0.95);
    m_.worst = worst_.take();
    m_.solid_2_pixels = patches_.solid_2_pixels, m_.solid_4_pixels = patches_.solid_4_pixels,
    m_.solid_x = patches_.solid_x, m_.solid_y = patches_.solid_y;
    m_.drift_max = patches_.drift_max, m_.drift_x = patches_.drift_x, m_.drift_y = patches_.drift_y;
    m_.signs = *std::max_element(signs_.begin(), signs_.end(),
                                 [](const SignTest& a, const SignTest& b) { return a.share() < b.share(); });
    for (const OneSidedGroups& groups : one_sided_)
      if (const OneSidedGroups::Group g = groups.largest(); g.size() > static_cast<std::int64_t>(m_.one_sided_pixels))
        m_.one_sided_pixels = static_cast<std::uint64_t>(g.size()), m_.one_sided_x = g.x, m_.one_sided_y = g.y;
    m_.ssim_mean = ssim_ / ssim_windows(m_.width, m_.height);
    m_.flip_mean = flip_sum_ / pixels;
    if (exposures_) m_.hdr_flip_mean = hdr_flip_sum_ / pixels;
    return m_;
  }

 private:
  void add_differences(const Values& a, const Values& b, int begin, int end) {
    const std::vector<unsigned char> edges = edge_mask(a, begin, end);
    std::vector<RowFigures> rows(static_cast<std::size_t>(end - begin));
    parallel_for(rows.size(), 1, [&](std::size_t row) {
      rows[row] =
          row_figures(a, b, begin + static_cast<int>(row), &edges[row * static_cast<std::size_t>(m_.width)], alpha_);
    });
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const RowFigures& r = rows[row];
      absolute_ += r.absolute, signed_sum_ += r.signed_sum;
      m_.max_abs = std::max(m_.max_abs, r.max_abs), alpha_max_ = std::max(alpha_max_, r.alpha_max);
      edge_count_ += r.edge_count, m_.nan_pixels += r.nan_pixels, within_1_ += r.within_1, within_2_ += r.within_2;
      for (std::size_t c = 0; c < 3; ++c) signs_[c].add(r.signs[c]), one_sided_[c].add_row(r.sides[c]);
      all_.add(r.all), edge_.add(r.edge), interior_.add(r.interior), alpha_sum_.add(r.alpha);
      for (std::size_t x = 0; x < r.color.size(); ++x) {
        if (r.color[x] < 0) continue;
        colors_.add(r.color[x]);
        ++m_.histogram[static_cast<std::size_t>(std::lround(std::min(r.largest[x], 255.0f)))];
        worst_.add(a, b, static_cast<int>(x), begin + static_cast<int>(row), r.largest[x]);
      }
    }
  }

  const MetricOptions& options_;
  bool alpha_;
  std::optional<Exposures> exposures_;
  Flip flip_;
  Metrics m_;
  double absolute_ = 0, signed_sum_ = 0, alpha_max_ = 0, ssim_ = 0, flip_sum_ = 0, hdr_flip_sum_ = 0;
  std::uint64_t within_1_ = 0, within_2_ = 0, edge_count_ = 0;
  Sum all_, edge_, interior_, alpha_sum_;
  std::array<SignTest, 3> signs_;
  std::array<OneSidedGroups, 3> one_sided_;
  ColorDifferences colors_;
  Patches patches_;
  WorstPixels worst_;
};

}  // namespace

double SignTest::share() const {
  const double net = std::fabs(static_cast<double>(brighter) - static_cast<double>(darker));
  return pixels ? net / static_cast<double>(pixels) : 0;
}

bool SignTest::leans(double limit) const {
  constexpr double kSigmas = 5;
  const double changed = static_cast<double>(brighter + darker), net = share() * static_cast<double>(pixels);
  return share() > limit && net > kSigmas * std::sqrt(changed);
}

std::uint64_t measure_bytes(std::uint64_t pixels, int channels) {
  constexpr std::uint64_t kFloat = 4, kMasksAndErrors = 16;
  return pixels *
         (3 * kFloat * static_cast<std::uint64_t>(channels) + kMasksAndErrors);  // both pictures, a copy for the report
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
    throw PictureMismatch(fmt::format(
        "two pictures of {:.1f} million pixels take about {:.1f} GiB to compare, and {:.1f} GiB are available",
        1e-6 * static_cast<double>(pixels), static_cast<double>(needed) / (1 << 30),
        static_cast<double>(available) / (1 << 30)));
}

Metrics measure(const Picture& reference, const Picture& test, const MetricOptions& options) {
  const Values a(reference), b(test);
  require_same_size(reference, test);
  std::optional<Exposures> exposures;
  if (reference.is_float && test.is_float) exposures = hdr_flip_exposures(reference);
  Measurement out(a.width(), a.height(), options.alpha && (a.has_alpha() || b.has_alpha()), exposures, options);
  for (int begin = 0; begin < a.height(); begin += out.band_rows())
    out.add_band(a, b, begin, std::min(a.height(), begin + out.band_rows()));
  return out.result();
}

Metrics measure_files(const std::filesystem::path& reference, const std::filesystem::path& test,
                      const MetricOptions& options) {
  RowWindow a(reference), b(test);
  require_same_size(a.shape(), b.shape());
  if (a.whole() && b.whole()) return measure(*a.whole(), *b.whole(), options);
  const int height = a.shape().height;
  const auto has_alpha = [](const RowWindow& window) { return window.shape().channels % 2 == 0; };
  Measurement out(a.shape().width, height, options.alpha && (has_alpha(a) || has_alpha(b)), std::nullopt, options);
  for (int begin = 0; begin < height; begin += out.band_rows()) {
    const int end = std::min(height, begin + out.band_rows()), first = std::max(0, begin - out.margin()),
              last = std::min(height, end + out.margin());
    const Values p = a.show(first, last), q = b.show(first, last);
    out.add_band(p, q, begin, end);
  }
  return out.result();
}

}  // namespace verisim::compare
