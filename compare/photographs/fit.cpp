#include "compare/photographs/fit.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/photographs/linear_light.h"
#include "compare/photographs/photograph.h"

namespace verisim::compare {
namespace {

Picture cut(const Picture& picture, const Crop& crop) {
  if (crop.x < 0 || crop.y < 0 || crop.width < 1 || crop.height < 1 || crop.x > picture.width - crop.width ||
      crop.y > picture.height - crop.height)
    throw PictureMismatch(fmt::format("the crop {}, {}, {}, {} is not inside the reference of {}x{}", crop.x, crop.y,
                                      crop.width, crop.height, picture.width, picture.height));
  Picture out = picture;
  out.width = crop.width, out.height = crop.height;
  out.samples.clear();
  for (int y = crop.y; y < crop.y + crop.height; ++y) {
    const auto row =
        picture.samples.begin() + (static_cast<std::ptrdiff_t>(y) * picture.width + crop.x) * picture.channels;
    out.samples.insert(out.samples.end(), row, row + static_cast<std::ptrdiff_t>(crop.width) * picture.channels);
  }
  return out;
}

bool is_alpha(const Picture& p, int channel) {
  return (p.channels == 2 || p.channels == 4) && channel == p.channels - 1;
}

// The share of every source pixel in [from, to) along one axis.
struct Span {
  int first = 0;
  std::vector<double> weights;
};
std::vector<Span> spans(int from, int to) {
  std::vector<Span> out(static_cast<std::size_t>(to));
  const double scale = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double low = i * scale, high = (i + 1) * scale;
    Span& span = out[static_cast<std::size_t>(i)];
    span.first = static_cast<int>(low);
    for (int k = span.first; k < from && k < high; ++k)
      span.weights.push_back((std::min<double>(k + 1, high) - std::max<double>(k, low)) / scale);
  }
  return out;
}

}  // namespace

Picture resampled(const Picture& picture, int width, int height) {
  const std::vector<Span> columns = spans(picture.width, width), rows = spans(picture.height, height);
  Picture out = picture;
  out.width = width, out.height = height;
  if (!out.is_float) out.bits = 16;  // averages are no whole code values
  out.samples.assign(static_cast<std::size_t>(width) * height * picture.channels, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < picture.channels; ++c) {
        const bool plain = picture.is_float || is_alpha(picture, c);
        const Span &across = columns[static_cast<std::size_t>(x)], &down = rows[static_cast<std::size_t>(y)];
        double sum = 0;
        for (std::size_t j = 0; j < down.weights.size(); ++j)
          for (std::size_t i = 0; i < across.weights.size(); ++i) {
            const std::size_t at =
                (static_cast<std::size_t>(down.first) + j) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(across.first) + i;
            sum += down.weights[j] * across.weights[i] *
                   linear_of(
                       picture.samples[at * static_cast<std::size_t>(picture.channels) + static_cast<std::size_t>(c)],
                       plain);
          }
        out.samples[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                        static_cast<std::size_t>(picture.channels) +
                    static_cast<std::size_t>(c)] = sample_of(sum, plain);
      }
  return out;
}

namespace {

// Pixels are square: another shape would squeeze everything. A cut-out is chosen in whole pixels, one more or less in
// either direction is no other shape.
void require_same_shape(const Picture& reference, const Picture& test, bool cut) {
  const double wanted = static_cast<double>(test.width) / test.height;
  if (std::fabs(reference.width - wanted * reference.height) <= 1 + wanted) return;
  throw PictureMismatch(
      fmt::format("the {} of {}x{} has another shape than the picture of {}x{}: to fit, {} would be {}x{}",
                  cut ? "crop" : "reference", reference.width, reference.height, test.width, test.height,
                  cut ? "it" : "a crop", reference.width, std::lround(reference.width / wanted)));
}

// The factors for the test's channels.
Rgb gains(const Picture& reference, const Picture& test, bool each_channel) {
  Rgb product{}, square{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(test.width) * static_cast<std::size_t>(test.height); ++i) {
    const std::optional<Rgb> p = linear_color(reference, i), q = linear_color(test, i);
    if (!p || !q) continue;
    for (std::size_t c = 0; c < 3; ++c) product[c] += (*p)[c] * (*q)[c], square[c] += (*q)[c] * (*q)[c];
  }
  const auto ratio = [](double a, double b) { return a > 0 && b > 0 ? a / b : 1; };
  if (!each_channel) {
    const double all = ratio(product[0] + product[1] + product[2], square[0] + square[1] + square[2]);
    return {all, all, all};
  }
  return {ratio(product[0], square[0]), ratio(product[1], square[1]), ratio(product[2], square[2])};
}

// The standard deviation of the mean gain's logarithm, from what the fit leaves.
double stops_error(const Picture& reference, const Picture& test, const Rgb& gain) {
  double rest = 0, square = 0, scaled = 0, count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(test.width) * static_cast<std::size_t>(test.height); ++i) {
    const std::optional<Rgb> p = linear_color(reference, i), q = linear_color(test, i);
    if (!p || !q) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double apart = (*p)[c] - gain[c] * (*q)[c];
      rest += apart * apart, square += (*q)[c] * (*q)[c], scaled += gain[c] * gain[c] * (*q)[c] * (*q)[c], ++count;
    }
  }
  return count > 1 && scaled > 0 && square > 0 ? std::sqrt(rest / (count - 1) / scaled) / std::log(2.0) : 0;
}

}  // namespace

std::string Fit::text() const {
  std::string out;
  if (crop) out += fmt::format("reference cut to {}x{} at {}, {}; ", crop->width, crop->height, crop->x, crop->y);
  if (resampled)
    out += fmt::format("reference of {}x{} averaged to the render's size; ", reference_width, reference_height);
  if (alignment) {
    const auto& [corners, errors, k, k_error] = *alignment;
    double largest = 0;
    out += "corners at";
    for (std::size_t i = 0; i < 4; ++i)
      out += fmt::format(" {:.2f}, {:.2f};", corners[i].x, corners[i].y),
          largest = std::max({largest, errors[i].x, errors[i].y});
    out += fmt::format(" to {:.2f} pixels; ", largest);
    if (k != 0) out += fmt::format("radial distortion {:+.4f} ± {:.4f}; ", k, k_error);
  }
  if (vignetting)
    out += fmt::format("fall-off 1 {:+.3f} r² {:+.3f} r⁴ (± {:.3f}, {:.3f}); ", vignetting->a, vignetting->b,
                       vignetting->a_error, vignetting->b_error);
  if (targets) out += targets->text() + "; ";
  if (noise > 0) out += fmt::format("noise {:.2f} code values; ", noise);
  if (stops != 0) out += fmt::format("exposure {:+.3f} ± {:.3f} stops; ", stops, stops_error);
  if (balance != std::array<double, 3>{1, 1, 1})
    out += fmt::format("white balance {:.4f}, {:.4f}, {:.4f}; ", balance[0], balance[1], balance[2]);
  if (!out.empty()) out.resize(out.size() - 2);
  return out;
}

FittedPair fit_to_reference(const Picture& reference, const Picture& test, const FitOptions& options) {
  Values{reference}, Values{test};  // throw when they are no pictures
  FittedPair out{options.crop ? cut(reference, *options.crop) : reference, test, {}};
  out.fit.crop = options.crop;
  out.fit.reference_width = out.reference.width, out.fit.reference_height = out.reference.height;
  Crop part = options.crop.value_or(Crop{0, 0, reference.width, reference.height});
  std::vector<double> where;
  if (options.corners || options.vignetting) out.fit.noise = estimate_noise(out.reference);
  if (options.corners) {
    if (options.crop) throw PictureMismatch("corners and a crop say the same thing: give one of them");
    out.fit.alignment = align(reference, test, *options.corners, options.distortion);
    out.reference = aligned(reference, *out.fit.alignment, test.width, test.height);
    if (options.vignetting) where = distances_from_centre(reference, *out.fit.alignment, test.width, test.height);
  } else if (options.distortion) {
    throw PictureMismatch("distortion is fitted together with the corners: give them");
  } else if (options.vignetting) {
    where = distances_from_centre(reference, part, test.width, test.height);
  }
  if (out.reference.width != test.width || out.reference.height != test.height) {
    require_same_shape(out.reference, test, options.crop.has_value());
    out.reference = resampled(out.reference, test.width, test.height);
    out.fit.resampled = true;
  }
  if (options.vignetting) {
    out.fit.vignetting = fit_vignetting(out.reference, test, where);
    out.reference = without_vignetting(out.reference, *out.fit.vignetting, where);
  }
  if (!options.targets.empty()) {
    out.fit.targets = fit_targets(out.reference, options.targets);
    out.reference = with_mended_colors(out.reference, *out.fit.targets);
  }
  if (!options.exposure && !options.white_balance) return out;
  const Rgb gain = gains(out.reference, test, options.white_balance);
  const double mean = std::cbrt(gain[0] * gain[1] * gain[2]);
  out.fit.stops = std::log2(mean), out.fit.stops_error = stops_error(out.reference, test, gain);
  for (std::size_t c = 0; c < 3; ++c) out.fit.balance[c] = options.white_balance ? gain[c] / mean : 1;
  const bool grey = test.channels < 3;
  for (std::size_t i = 0; i < out.test.samples.size(); ++i) {
    const int c = static_cast<int>(i % static_cast<std::size_t>(test.channels));
    if (is_alpha(test, c) || !std::isfinite(out.test.samples[i])) continue;
    float& v = out.test.samples[i];
    v = sample_of((grey ? mean : gain[static_cast<std::size_t>(c)]) * linear_of(v, test.is_float), test.is_float);
  }
  if (!out.test.is_float) out.test.bits = 16;
  return out;
}

}  // namespace verisim::compare
