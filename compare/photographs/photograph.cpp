#include "compare/photographs/photograph.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "compare/metrics/least_squares.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

double decoded(const Values& values, int x, int y, std::size_t channel) {
  return values.is_float() ? values.linear_float(x, y)[channel] : srgb_to_linear(values.rgb(x, y)[channel] / 255);
}

// Linear light of a whole picture, three values a pixel; what is clipped or not finite is marked by -1.
struct Linear {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;

  explicit Linear(const Picture& picture) : width(picture.width), height(picture.height) {
    const Values values(picture);
    pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        Rgb v{-1, -1, -1};
        const Rgb code = values.rgb(x, y);
        if (values.finite(x, y) && (values.is_float() || *std::max_element(code.begin(), code.end()) <= 254.5))
          for (std::size_t c = 0; c < 3; ++c) v[c] = decoded(values, x, y, c);
        pixels.push_back(v);
      }
  }
  const Rgb& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
  }
  // Bilinear; empty outside, and where a neighbour is clipped.
  std::optional<Rgb> sample(const ImagePoint& p) const {
    const double x = p.x - 0.5, y = p.y - 0.5;
    if (x < -0.5 || y < -0.5 || x > width - 0.5 || y > height - 0.5) return std::nullopt;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const double fx = x - i, fy = y - j;
    Rgb out{};
    for (const auto& [dx, dy, weight] : {std::tuple(0, 0, (1 - fx) * (1 - fy)), std::tuple(1, 0, fx * (1 - fy)),
                                         std::tuple(0, 1, (1 - fx) * fy), std::tuple(1, 1, fx * fy)}) {
      const Rgb& v = at(i + dx, j + dy);
      if (v[0] < 0) return std::nullopt;
      for (std::size_t c = 0; c < 3; ++c) out[c] += weight * v[c];
    }
    return out;
  }
};

double luma(const Rgb& v) { return 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2]; }

// From the unit square to where the lens shows it.
class Lens {
 public:
  Lens(const Corners& corners, double distortion, int width, int height)
      : plane_(corners), distortion_(distortion), x_(0.5 * width), y_(0.5 * height), radius_(std::hypot(x_, y_)) {}
  ImagePoint operator()(double u, double v) const {
    const ImagePoint p = plane_(u, v);
    const double dx = p.x - x_, dy = p.y - y_, scale = 1 + distortion_ * (dx * dx + dy * dy) / (radius_ * radius_);
    return {x_ + scale * dx, y_ + scale * dy};
  }
  double from_centre(double u, double v) const {
    const ImagePoint p = (*this)(u, v);
    return std::hypot(p.x - x_, p.y - y_) / radius_;
  }

 private:
  Homography plane_;
  double distortion_, x_, y_, radius_;
};

// How many samples a side of a pixel takes, so that all of the photograph behind it counts.
int samples_per_side(const Corners& c, int width, int height) {
  const double across =
                   std::max(std::hypot(c[1].x - c[0].x, c[1].y - c[0].y), std::hypot(c[2].x - c[3].x, c[2].y - c[3].y)),
               down =
                   std::max(std::hypot(c[3].x - c[0].x, c[3].y - c[0].y), std::hypot(c[2].x - c[1].x, c[2].y - c[1].y));
  return std::clamp(static_cast<int>(std::ceil(std::max(across / width, down / height))), 2, 16);
}

// The photograph's mean behind a pixel of a grid of width x height; empty where most of it is clipped or outside.
std::optional<Rgb> behind(const Linear& photograph, const Lens& lens, int x, int y, int width, int height,
                          int samples) {
  Rgb sum{};
  int count = 0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const auto v = photograph.sample(lens((x + (i + 0.5) / samples) / width, (y + (j + 0.5) / samples) / height));
      if (!v) continue;
      ++count;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += (*v)[c];
    }
  if (2 * count < samples * samples) return std::nullopt;
  for (double& v : sum) v /= count;
  return sum;
}

// Differences of the square roots of the luma (about what is seen, and of even noise), after the best gain.
struct Residuals {
  const Linear &photograph, &render;
  int step;  // every step-th pixel of every step-th row

  std::vector<double> operator()(const std::vector<double>& p) const {
    Corners corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = {p[2 * i], p[2 * i + 1]};
    const Lens lens(corners, p.size() > 8 ? p[8] : 0, photograph.width, photograph.height);
    const int samples = samples_per_side(corners, render.width, render.height);
    std::vector<double> seen, ours, out;
    for (int y = step / 2; y < render.height; y += step)
      for (int x = step / 2; x < render.width; x += step) {
        const Rgb& r = render.at(x, y);
        const auto v = behind(photograph, lens, x, y, render.width, render.height, samples);
        const bool usable = v && r[0] >= 0;
        seen.push_back(usable ? std::sqrt(std::max(0.0, luma(*v))) : 0);
        ours.push_back(usable ? std::sqrt(std::max(0.0, luma(r))) : 0);
      }
    const double gain = std::inner_product(seen.begin(), seen.end(), ours.begin(), 0.0) /
                        std::max(1e-12, std::inner_product(ours.begin(), ours.end(), ours.begin(), 0.0));
    for (std::size_t i = 0; i < seen.size(); ++i) out.push_back(seen[i] - gain * ours[i]);
    return out;
  }
};

}  // namespace

Homography::Homography(const Corners& c) {
  for (std::size_t i = 0; i < 4; ++i) {
    const ImagePoint &a = c[i], &b = c[(i + 1) % 4], &d = c[(i + 2) % 4];
    if (!((b.x - a.x) * (d.y - b.y) - (b.y - a.y) * (d.x - b.x) > 0))
      throw PictureMismatch(
          "the corners must be those of the picture in the photograph, from the upper left one clockwise: upper left, "
          "upper right, lower right, lower left");
  }
  // Heckbert, "Fundamentals of Texture Mapping and Image Warping" (1989), section 2.2.3.
  const double sx = c[0].x - c[1].x + c[2].x - c[3].x, sy = c[0].y - c[1].y + c[2].y - c[3].y;
  const double dx1 = c[1].x - c[2].x, dx2 = c[3].x - c[2].x, dy1 = c[1].y - c[2].y, dy2 = c[3].y - c[2].y;
  const double determinant = dx1 * dy2 - dx2 * dy1;
  const double g = (sx * dy2 - dx2 * sy) / determinant, h = (dx1 * sy - sx * dy1) / determinant;
  m_ = {c[1].x - c[0].x + g * c[1].x,
        c[3].x - c[0].x + h * c[3].x,
        c[0].x,
        c[1].y - c[0].y + g * c[1].y,
        c[3].y - c[0].y + h * c[3].y,
        c[0].y,
        g,
        h};
}

Alignment align(const Picture& photograph, const Picture& render, const Corners& start, bool distortion) {
  Homography{start};  // throws
  const Linear photo(photograph), ours(render);
  constexpr double kMaxPixels = 10000;
  const double pixels = static_cast<double>(render.width) * render.height;
  const Residuals residuals{photo, ours, std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMaxPixels))))};
  std::vector<double> parameters, steps;
  for (const ImagePoint& p : start)
    parameters.insert(parameters.end(), {p.x, p.y}), steps.insert(steps.end(), {0.5, 0.5});
  if (distortion) parameters.push_back(0), steps.push_back(0.002);
  const LeastSquares found = gauss_newton(residuals, parameters, steps);
  Alignment out;
  for (std::size_t i = 0; i < 4; ++i) {
    out.corners[i] = {found.parameters[2 * i], found.parameters[2 * i + 1]};
    out.corner_errors[i] = {found.errors[2 * i], found.errors[2 * i + 1]};
  }
  if (distortion) out.distortion = found.parameters[8], out.distortion_error = found.errors[8];
  return out;
}

Picture aligned(const Picture& photograph, const Alignment& alignment, int width, int height) {
  const Linear photo(photograph);
  const Lens lens(alignment.corners, alignment.distortion, photograph.width, photograph.height);
  const int samples = samples_per_side(alignment.corners, width, height);
  Picture out;
  out.width = width, out.height = height, out.channels = 3, out.bits = 16, out.is_float = photograph.is_float;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::optional<Rgb> mean = behind(photo, lens, x, y, width, height, samples);
      for (std::size_t c = 0; c < 3; ++c) {  // clipped stays clipped
        const double v = mean ? (*mean)[c] : 1;
        out.samples.push_back(static_cast<float>(out.is_float ? v : linear_to_srgb(std::clamp(v, 0.0, 1.0))));
      }
    }
  return out;
}

std::vector<double> distances_from_centre(const Picture& photograph, const Alignment& alignment, int width,
                                          int height) {
  const Lens lens(alignment.corners, alignment.distortion, photograph.width, photograph.height);
  std::vector<double> out;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out.push_back(lens.from_centre((x + 0.5) / width, (y + 0.5) / height));
  return out;
}

std::vector<double> distances_from_centre(const Picture& photograph, const Crop& part, int width, int height) {
  const double left = part.x, top = part.y, right = left + part.width, bottom = top + part.height;
  return distances_from_centre(
      photograph, Alignment{{{{left, top}, {right, top}, {right, bottom}, {left, bottom}}}, {}, 0, 0}, width, height);
}

Vignetting fit_vignetting(const Picture& photograph, const Picture& render, std::span<const double> where) {
  require_same_size(photograph, render);
  const Linear photo(photograph), ours(render);
  // photo = gain_c render (1 + a r^2 + b r^4): linear in the gains and in the sums gain a, gain b, of which the three
  // channels have their own; a and b by Gauss-Newton, the gains solved for in between.
  const auto residuals = [&](const std::vector<double>& p) {
    std::array<double, 3> product{}, square{};
    const auto fall = [&](std::size_t i) {
      const double r2 = where[i] * where[i];
      return 1 + p[0] * r2 + p[1] * r2 * r2;
    };
    for (std::size_t i = 0; i < where.size(); ++i) {
      if (photo.pixels[i][0] < 0 || ours.pixels[i][0] < 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = ours.pixels[i][c] * fall(i);
        product[c] += expected * photo.pixels[i][c], square[c] += expected * expected;
      }
    }
    std::vector<double> out(3 * where.size());
    for (std::size_t i = 0; i < where.size(); ++i) {
      if (photo.pixels[i][0] < 0 || ours.pixels[i][0] < 0) continue;
      for (std::size_t c = 0; c < 3; ++c)
        out[3 * i + c] =
            photo.pixels[i][c] - (square[c] > 0 ? product[c] / square[c] : 1) * ours.pixels[i][c] * fall(i);
    }
    return out;
  };
  const LeastSquares found = gauss_newton(residuals, {0, 0}, {0.01, 0.01});
  return {found.parameters[0], found.parameters[1], found.errors[0], found.errors[1]};
}

Picture without_vignetting(const Picture& photograph, const Vignetting& vignetting, std::span<const double> where) {
  Picture out = photograph;
  if (!out.is_float) out.bits = 16;
  const auto channels = static_cast<std::size_t>(out.channels);
  const bool alpha = channels == 2 || channels == 4;
  for (std::size_t i = 0; i < where.size(); ++i) {
    const double r2 = where[i] * where[i], fall = std::max(0.05, 1 + vignetting.a * r2 + vignetting.b * r2 * r2);
    for (std::size_t c = 0; c + alpha < channels; ++c) {
      float& v = out.samples[i * channels + c];
      if (out.is_float)
        v = static_cast<float>(v / fall);
      else if (v < 254.5f / 255)  // clipped stays clipped
        v = static_cast<float>(linear_to_srgb(std::min(1.0, srgb_to_linear(static_cast<double>(v)) / fall)));
    }
  }
  return out;
}

double estimate_noise(const Picture& picture) {
  const Values values(picture);
  const int w = values.width(), h = values.height();
  if (w < 3 || h < 3) return 0;
  double sum = 0;
  for (int y = 1; y + 1 < h; ++y)
    for (int x = 1; x + 1 < w; ++x) {
      const auto at = [&](int dx, int dy) { return values.luma(x + dx, y + dy); };
      sum += std::fabs(at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1) -
                       2 * (at(0, -1) + at(0, 1) + at(-1, 0) + at(1, 0)) + 4 * at(0, 0));
    }
  return std::sqrt(0.5 * std::numbers::pi) * sum / (6.0 * (w - 2) * (h - 2));
}

}  // namespace verisim::compare
