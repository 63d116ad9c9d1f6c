#include "compare/photographs/color_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <stdexcept>

#include "compare/metrics/ciede2000.h"
#include "compare/photographs/linear_light.h"

namespace verisim::compare {
namespace {

constexpr Rgb kLuminance = {0.2126, 0.7152, 0.0722};

double dot(const Rgb& a, const Rgb& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rgb times(const std::array<double, 9>& m, const Rgb& v) {
  return {dot({m[0], m[1], m[2]}, v), dot({m[3], m[4], m[5]}, v), dot({m[6], m[7], m[8]}, v)};
}

Rgb linear(const Rgb& srgb) {
  return {srgb_to_linear(srgb[0] / 255), srgb_to_linear(srgb[1] / 255), srgb_to_linear(srgb[2] / 255)};
}
Rgb as_srgb(const Rgb& linear) {
  Rgb out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = 255 * linear_to_srgb(std::clamp(linear[c], 0.0, 1.0));
  return out;
}

// The mean linear colour of the patch with this number, from 1.
Rgb mean_of_patch(const Picture& photograph, const ColorTarget& t, std::size_t number) {
  if (t.x < 0 || t.y < 0 || t.width < 1 || t.height < 1 || t.x > photograph.width - t.width ||
      t.y > photograph.height - t.height)
    throw PictureMismatch(fmt::format("target {} at {}, {}, {}, {} is not inside the picture of {}x{}", number, t.x,
                                      t.y, t.width, t.height, photograph.width, photograph.height));
  Rgb sum{};
  for (int y = t.y; y < t.y + t.height; ++y)
    for (int x = t.x; x < t.x + t.width; ++x) {
      const std::optional<Rgb> v = linear_color(photograph, x, y);
      if (!v) throw PictureMismatch(fmt::format("target {} is clipped in the photograph at {}, {}", number, x, y));
      for (std::size_t c = 0; c < 3; ++c) sum[c] += (*v)[c];
    }
  for (double& v : sum) v /= static_cast<double>(t.width) * t.height;
  if (!(dot(kLuminance, sum) > 0)) throw PictureMismatch(fmt::format("target {} is black in the photograph", number));
  return sum;
}

struct Patch {
  Rgb seen, known;
};

// The inverse of a symmetric matrix by rows; false: it is nearly singular, as of greys alone.
bool inverse(const std::array<double, 9>& m, std::array<double, 9>& out) {
  const double a = m[4] * m[8] - m[5] * m[7], b = m[5] * m[6] - m[3] * m[8], c = m[3] * m[7] - m[4] * m[6];
  const double determinant = m[0] * a + m[1] * b + m[2] * c, size = m[0] * m[4] * m[8];
  constexpr double kNearlySingular = 1e-6;
  if (!(determinant > kNearlySingular * size)) return false;
  out = {a, m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
         b, m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
         c, m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]};
  for (double& v : out) v /= determinant;
  return true;
}

bool fit_matrix(std::span<const Patch> patches, std::array<double, 9>& matrix) {
  constexpr std::size_t kMinPatches = 4;
  if (patches.size() < kMinPatches) return false;
  std::array<double, 9> square{}, product{}, inverted;  // of seen and seen, of known and seen
  for (const auto& [seen, known] : patches)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        square[3 * i + k] += seen[i] * seen[k], product[3 * i + k] += known[i] * seen[k];
  if (!inverse(square, inverted)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      matrix[3 * i + k] = dot({product[3 * i], product[3 * i + 1], product[3 * i + 2]},
                              {inverted[k], inverted[3 + k], inverted[6 + k]});
  return true;
}

std::array<double, 9> factors(std::span<const Patch> patches) {
  Rgb product{}, square{};
  for (const auto& [seen, known] : patches)
    for (std::size_t c = 0; c < 3; ++c) product[c] += seen[c] * known[c], square[c] += seen[c] * seen[c];
  const auto ratio = [&](std::size_t c) { return product[c] > 0 && square[c] > 0 ? product[c] / square[c] : 1; };
  return {ratio(0), 0, 0, 0, ratio(1), 0, 0, 0, ratio(2)};
}

}  // namespace

std::string TargetFit::text() const {
  const auto worst = std::max_element(errors.begin(), errors.end());
  return fmt::format("colours by {} target{} ({}), which are then {:.2f} CIEDE2000 off, at most {:.2f} (target {})",
                     errors.size(), errors.size() == 1 ? "" : "s",
                     whole_matrix ? "a matrix" : "a factor for each channel",
                     std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size()), *worst,
                     worst - errors.begin() + 1);
}

TargetFit fit_targets(const Picture& photograph, std::span<const ColorTarget> targets) {
  std::vector<Patch> patches;
  for (const ColorTarget& t : targets)
    patches.push_back({mean_of_patch(photograph, t, patches.size() + 1), linear(t.srgb)});
  TargetFit fit;
  fit.whole_matrix = fit_matrix(patches, fit.matrix);
  if (!fit.whole_matrix) fit.matrix = factors(patches);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Rgb mended = times(fit.matrix, patches[i].seen);
    fit.errors.push_back(ciede2000(srgb_to_lab(as_srgb(mended)), srgb_to_lab(targets[i].srgb)));
    before += dot(kLuminance, patches[i].seen), after += dot(kLuminance, mended);
  }
  // How bright the chart was lit is not the camera's fault: exposure is fitted by itself.
  for (double& v : fit.matrix) v *= after > 0 ? before / after : 1;
  return fit;
}

Picture with_mended_colors(const Picture& photograph, const TargetFit& fit) {
  Picture out = photograph;
  if (photograph.channels < 3) return out;
  if (!out.is_float) out.bits = 16;
  const auto step = static_cast<std::size_t>(out.channels);
  for (std::size_t i = 0; i + 2 < out.samples.size(); i += step) {
    Rgb v;
    for (std::size_t c = 0; c < 3; ++c) v[c] = linear_of(out.samples[i + c], out.is_float);
    v = times(fit.matrix, v);
    for (std::size_t c = 0; c < 3; ++c) out.samples[i + c] = sample_of(v[c], out.is_float);
  }
  return out;
}

ColorTarget color_target_of(const std::string& text) {
  ColorTarget t;
  int end = 0;
  if (std::sscanf(text.c_str(), "%d,%d,%d,%d=%lf,%lf,%lf%n", &t.x, &t.y, &t.width, &t.height, &t.srgb[0], &t.srgb[1],
                  &t.srgb[2], &end) != 7 ||
      static_cast<std::size_t>(end) != text.size() ||
      !std::all_of(t.srgb.begin(), t.srgb.end(), [](double v) { return v >= 0 && v <= 255; }))
    throw std::invalid_argument(
        fmt::format("{}: expected a target's place and size in the picture's pixels and its known sRGB colour (0 to "
                    "255), like 10,20,8,8=243,243,242",
                    text));
  return t;
}

}  // namespace verisim::compare
