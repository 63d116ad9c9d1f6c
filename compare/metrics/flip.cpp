// FLIP imitates a person who flips between two pictures. Two pipelines meet in every pixel:
//   colour:  YCxCz -> contrast sensitivity filters -> L*a*b* with Hunt's adjustment -> HyAB distance, redistributed to
//   0..1 feature: luminance -> edge and point detectors -> difference of their magnitudes
// and the error is colour^(1 - feature). All filters are separable, and a picture is worked on in tiles with a margin
// of the filters' radius: the values do not depend on how it is cut.
#include "compare/metrics/flip.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <numeric>

#include "compare/metrics/values.h"
#include "tracer/base/parallel.h"

namespace verisim::compare {
namespace {

constexpr double kQc = 0.7, kPc = 0.4, kPt = 0.95;  // colour: exponent and redistribution (section 4.1.3)
constexpr double kQf = 0.5, kFeatureWidth = 0.082;  // feature: exponent, width of the detector in degrees (section 4.2)
constexpr int kTileWidth = 256, kTileRows = 64;

// Linear sRGB to CIE XYZ with D65; the rationals are those that follow from the primaries.
constexpr double kXyz[3][3] = {{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                               {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                               {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

struct Colorimetry {
  double white[3], inverse[3][3];
  Colorimetry() {
    for (int i = 0; i < 3; ++i) white[i] = kXyz[i][0] + kXyz[i][1] + kXyz[i][2];
    const auto& m = kXyz;
    const double det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
        inverse[i][j] = (m[a][c] * m[b][d] - m[a][d] * m[b][c]) / det;
      }
  }
};
const Colorimetry kColor;

Rgb linear_to_relative_xyz(const Rgb& c) {
  Rgb out;
  for (int i = 0; i < 3; ++i) out[i] = (kXyz[i][0] * c[0] + kXyz[i][1] * c[1] + kXyz[i][2] * c[2]) / kColor.white[i];
  return out;
}

// The linear relative of L*a*b* that the contrast filters work in.
Rgb linear_to_ycxcz(const Rgb& c) {
  const Rgb v = linear_to_relative_xyz(c);
  return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
}

Rgb ycxcz_to_linear(const Rgb& c) {
  const double y = (c[0] + 16) / 116;
  const double xyz[3] = {(y + c[1] / 500) * kColor.white[0], y * kColor.white[1], (y - c[2] / 200) * kColor.white[2]};
  Rgb out;
  for (int i = 0; i < 3; ++i)
    out[i] = kColor.inverse[i][0] * xyz[0] + kColor.inverse[i][1] * xyz[1] + kColor.inverse[i][2] * xyz[2];
  return out;
}

// CIE 1976 L*a*b*, chroma scaled by lightness (Hunt's effect: chromatic differences show more in bright surroundings).
Rgb linear_to_hunt_lab(const Rgb& c) {
  constexpr double kDelta = 6.0 / 29.0;
  Rgb f = linear_to_relative_xyz(c);
  for (double& v : f) v = v > kDelta * kDelta * kDelta ? std::cbrt(v) : v / (3 * kDelta * kDelta) + 4.0 / 29.0;
  const double lightness = 116 * f[1] - 16;
  return {lightness, 0.01 * lightness * 500 * (f[0] - f[1]), 0.01 * lightness * 200 * (f[1] - f[2])};
}

double hyab(const Rgb& a, const Rgb& b) { return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

// A sum of Gaussians a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees: the contrast sensitivity of one opponent channel,
// in space (table 1 of the paper).
struct Gaussian {
  double a, b;
};
constexpr Gaussian kAchromatic{1, 0.0047}, kRedGreen{1, 0.0053}, kBlueYellow1{34.1, 0.04}, kBlueYellow2{13.5, 0.025};

using Kernel = std::vector<double>;  // 2 radius + 1 weights

}  // namespace

struct FlipKernels {
  int csf_radius, feature_radius;
  Kernel y, cx, cz1, cz2;  // the second Gaussian of Cz is added to the first
  double cz1_weight, cz2_weight;
  Kernel smooth, edge, point;

  explicit FlipKernels(double ppd) {
    const double pi2 = std::numbers::pi * std::numbers::pi;
    csf_radius = static_cast<int>(std::ceil(3 * std::sqrt(kBlueYellow1.b / (2 * pi2)) * ppd));
    const auto gaussian = [&](const Gaussian& g, double& sum) {
      Kernel k;
      for (int i = -csf_radius; i <= csf_radius; ++i) k.push_back(std::exp(-pi2 * (i / ppd) * (i / ppd) / g.b));
      sum = std::accumulate(k.begin(), k.end(), 0.0);
      for (double& v : k) v /= sum;
      return k;
    };
    double sum, sum1, sum2;
    y = gaussian(kAchromatic, sum);
    cx = gaussian(kRedGreen, sum);
    cz1 = gaussian(kBlueYellow1, sum1);
    cz2 = gaussian(kBlueYellow2, sum2);
    // The two Gaussians of Cz keep their relative height; together they sum to one over the square.
    const double w1 = kBlueYellow1.a * std::sqrt(std::numbers::pi / kBlueYellow1.b) * sum1 * sum1;
    const double w2 = kBlueYellow2.a * std::sqrt(std::numbers::pi / kBlueYellow2.b) * sum2 * sum2;
    cz1_weight = w1 / (w1 + w2);
    cz2_weight = w2 / (w1 + w2);

    const double sd = 0.5 * kFeatureWidth * ppd;
    feature_radius = static_cast<int>(std::ceil(3 * sd));
    for (int i = -feature_radius; i <= feature_radius; ++i) {
      const double g = std::exp(-i * i / (2 * sd * sd));
      smooth.push_back(g);
      edge.push_back(-i * g);
      point.push_back((i * i / (sd * sd) - 1) * g);
    }
    const double smooth_sum = std::accumulate(smooth.begin(), smooth.end(), 0.0);
    for (double& v : smooth) v /= smooth_sum;
    balance(edge);
    balance(point);
  }

  // Positive weights sum to 1, negative ones to -1. The factor across is positive, so the square kernel is balanced,
  // too.
  static void balance(Kernel& k) {
    double positive = 0, negative = 0;
    for (double v : k) (v > 0 ? positive : negative) += std::fabs(v);
    for (double& v : k) {
      if (v > 0)
        v /= positive;
      else if (v < 0)
        v /= negative;
    }
  }
  int radius() const { return std::max(csf_radius, feature_radius); }
};

namespace {

struct Plane {
  int width, rows;
  std::vector<double> v;
  Plane(int w, int h) : width(w), rows(h), v(static_cast<std::size_t>(w) * h) {}
  double* row(int y) { return v.data() + static_cast<std::size_t>(y) * width; }
  const double* row(int y) const { return v.data() + static_cast<std::size_t>(y) * width; }
};

// Along rows, from a plane that has `margin` more columns on both sides.
Plane filter_rows(const Plane& in, const Kernel& k, int margin) {
  const int r = static_cast<int>(k.size() / 2), w = in.width - 2 * margin;
  Plane out(w, in.rows);
  for (int y = 0; y < in.rows; ++y) {
    double* to = out.row(y);
    for (std::size_t i = 0; i < k.size(); ++i) {
      const double* from = in.row(y) + margin - r + static_cast<int>(i);
      const double weight = k[i];
      for (int x = 0; x < w; ++x) to[x] += weight * from[x];
    }
  }
  return out;
}

// Down columns, from a plane that has `margin` more rows above and below.
Plane filter_columns(const Plane& in, const Kernel& k, int margin) {
  const int r = static_cast<int>(k.size() / 2), rows = in.rows - 2 * margin;
  Plane out(in.width, rows);
  for (int y = 0; y < rows; ++y)
    for (int i = -r; i <= r; ++i) {
      const double* from = in.row(y + margin + i);
      const double weight = k[i + r];
      double* to = out.row(y);
      for (int x = 0; x < in.width; ++x) to[x] += weight * from[x];
    }
  return out;
}

Plane filter(const Plane& in, const Kernel& across, const Kernel& down, int margin) {
  return filter_columns(filter_rows(in, across, margin), down, margin);
}

using PixelSource = std::function<Rgb(int x, int y)>;  // linear light, 0..1

struct Tile {
  int x, y, width, rows;
};

// The colours of a tile and of a margin around it; the pixels of the picture's border are repeated outwards.
std::vector<Rgb> colors(const PixelSource& source, int width, int height, const Tile& tile, int margin) {
  std::vector<Rgb> out;
  out.reserve(static_cast<std::size_t>(tile.width + 2 * margin) * static_cast<std::size_t>(tile.rows + 2 * margin));
  for (int y = tile.y - margin; y < tile.y + tile.rows + margin; ++y)
    for (int x = tile.x - margin; x < tile.x + tile.width + margin; ++x)
      out.push_back(source(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1)));
  return out;
}

// What one picture contributes to a tile.
struct Seen {
  Plane lightness, a, b;  // after the contrast filters, L*a*b* with Hunt's adjustment
  Plane edges, points;    // magnitudes of the feature vectors
};

Seen look(const std::vector<Rgb>& pixels, const Tile& tile, const FlipKernels& k) {
  const int margin = k.radius();
  Plane y(tile.width + 2 * margin, tile.rows + 2 * margin), cx = y, cz = y, luminance = y;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Rgb c = linear_to_ycxcz(pixels[i]);
    y.v[i] = c[0], cx.v[i] = c[1], cz.v[i] = c[2];
    luminance.v[i] = (c[0] + 16) / 116;
  }
  Seen out{filter(y, k.y, k.y, margin), filter(cx, k.cx, k.cx, margin), filter(cz, k.cz1, k.cz1, margin),
           filter(luminance, k.edge, k.smooth, margin), filter(luminance, k.point, k.smooth, margin)};
  const Plane cz2 = filter(cz, k.cz2, k.cz2, margin), smooth = filter_rows(luminance, k.smooth, margin);
  const Plane edges_down = filter_columns(smooth, k.edge, margin),
              points_down = filter_columns(smooth, k.point, margin);
  for (std::size_t i = 0; i < out.a.v.size(); ++i) {
    Rgb linear = ycxcz_to_linear({out.lightness.v[i], out.a.v[i], k.cz1_weight * out.b.v[i] + k.cz2_weight * cz2.v[i]});
    for (double& v : linear) v = std::clamp(v, 0.0, 1.0);
    const Rgb lab = linear_to_hunt_lab(linear);
    out.lightness.v[i] = lab[0], out.a.v[i] = lab[1], out.b.v[i] = lab[2];
    out.edges.v[i] = std::hypot(out.edges.v[i], edges_down.v[i]);
    out.points.v[i] = std::hypot(out.points.v[i], points_down.v[i]);
  }
  return out;
}

// The largest possible colour difference, between green and blue.
double largest_difference() {
  return std::pow(hyab(linear_to_hunt_lab({0, 1, 0}), linear_to_hunt_lab({0, 0, 1})), kQc);
}

double redistribute(double error, double largest) {
  const double knee = kPc * largest;
  return error < knee ? kPt / knee * error : kPt + (error - knee) / (largest - knee) * (1 - kPt);
}

// One error per pixel of the tile; a row of `out` is `stride` long.
void flip_tile(const Seen& reference, const Seen& test, float* out, int stride) {
  const double largest = largest_difference();
  for (int y = 0; y < reference.a.rows; ++y)
    for (int x = 0; x < reference.a.width; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.a.width) + static_cast<std::size_t>(x);
      const double distance = hyab({reference.lightness.v[i], reference.a.v[i], reference.b.v[i]},
                                   {test.lightness.v[i], test.a.v[i], test.b.v[i]});
      const double color = redistribute(std::pow(distance, kQc), largest);
      const double feature = std::max(std::fabs(reference.edges.v[i] - test.edges.v[i]),
                                      std::fabs(reference.points.v[i] - test.points.v[i]));
      out[static_cast<std::ptrdiff_t>(y) * stride + x] =
          static_cast<float>(std::pow(color, 1 - std::pow(feature / std::numbers::sqrt2, kQf)));
    }
}

// The rows from begin to end, one after the other in `out`.
void flip(const PixelSource& reference, const PixelSource& test, int width, int height, int begin, int end,
          const FlipKernels& kernels, float* out) {
  const int across = (width + kTileWidth - 1) / kTileWidth, down = (end - begin + kTileRows - 1) / kTileRows;
  parallel_for(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), 1, [&](std::size_t i) {
    Tile tile{static_cast<int>(i) % across * kTileWidth, begin + static_cast<int>(i) / across * kTileRows, 0, 0};
    tile.width = std::min(kTileWidth, width - tile.x), tile.rows = std::min(kTileRows, end - tile.y);
    const std::vector<Rgb> a = colors(reference, width, height, tile, kernels.radius()),
                           b = colors(test, width, height, tile, kernels.radius());
    float* to = out + static_cast<std::ptrdiff_t>(tile.y - begin) * width + tile.x;
    if (a != b) return flip_tile(look(a, tile, kernels), look(b, tile, kernels), to, width);
    for (int y = 0; y < tile.rows; ++y)
      std::fill_n(to + static_cast<std::ptrdiff_t>(y) * width, tile.width, 0.0f);  // what is equal looks equal
  });
}

// Decodes the sRGB curve; of values in whole steps of 1/255 by a table.
double decoded(double v) {
  static const std::array<double, 256> kTable = [] {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = srgb_to_linear(static_cast<double>(i) / 255);
    return table;
  }();
  const auto whole = static_cast<std::size_t>(std::clamp(v, 0.0, 255.0));
  return static_cast<double>(whole) == v ? kTable[whole] : srgb_to_linear(v / 255);
}

PixelSource srgb_source(const Values& values) {
  return [&values](int x, int y) {
    Rgb c = values.rgb(x, y);
    for (double& v : c) v = decoded(v);
    return c;
  };
}

// Narkowicz's fit of the ACES curve with its exposure of 0.6 folded in: (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5).
constexpr double kAces[6] = {0.6 * 0.6 * 2.51, 0.6 * 0.03, 0, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14};
double aces(double x) {
  const double denominator = kAces[3] * x * x + kAces[4] * x + kAces[5];
  return std::isinf(denominator) ? 1 : std::clamp((kAces[0] * x * x + kAces[1] * x + kAces[2]) / denominator, 0.0, 1.0);
}

}  // namespace

double pixels_per_degree(double distance_m, double screen_pixels, double screen_width_m) {
  return distance_m * (screen_pixels / screen_width_m) * (std::numbers::pi / 180);
}

struct Flip::State {
  FlipKernels kernels;
};

Flip::Flip(double ppd) {
  if (!(ppd > 0) || ppd > 10000) throw std::invalid_argument("FLIP: the number of pixels per degree must be positive");
  state_ = std::make_unique<State>(State{FlipKernels(ppd)});
}
Flip::~Flip() = default;
int Flip::margin() const { return state_->kernels.radius(); }

void Flip::ldr(const Values& reference, const Values& test, int begin, int end, float* out) const {
  flip(srgb_source(reference), srgb_source(test), reference.width(), reference.height(), begin, end, state_->kernels,
       out);
}

void Flip::hdr(const Values& reference, const Values& test, const Exposures& exposures, int begin, int end,
               float* out) const {
  const std::size_t pixels = static_cast<std::size_t>(end - begin) * static_cast<std::size_t>(reference.width());
  std::vector<float> error(pixels);
  std::fill_n(out, pixels, 0.0f);
  for (int i = 0; i < exposures.count; ++i) {
    const double stops = exposures.start + i * (exposures.stop - exposures.start) / std::max(1, exposures.count - 1),
                 gain = std::exp2(stops);
    const auto exposed = [gain](const Values& values) {
      return [&values, gain](int x, int y) {
        Rgb c = values.linear_float(x, y);
        for (double& v : c) v = aces(gain * std::max(v, 0.0));
        return c;
      };
    };
    flip(exposed(reference), exposed(test), reference.width(), reference.height(), begin, end, state_->kernels,
         error.data());
    for (std::size_t p = 0; p < pixels; ++p) out[p] = std::max(out[p], error[p]);
  }
}

std::vector<float> ldr_flip(const Picture& reference, const Picture& test, double ppd) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  std::vector<float> out(static_cast<std::size_t>(a.width()) * static_cast<std::size_t>(a.height()));
  Flip(ppd).ldr(a, b, 0, a.height(), out.data());
  return out;
}

Exposures hdr_flip_exposures(const Picture& reference) {
  // The exposure that brings a luminance to the fraction kTarget of the curve's range: the positive root of aces(x) =
  // kTarget.
  constexpr double kTarget = 0.85, kSmallest = 1.1920929e-07;  // single-precision epsilon
  const double a = kAces[0] - kTarget * kAces[3], b = kAces[1] - kTarget * kAces[4], c = kAces[2] - kTarget * kAces[5];
  const double x = -0.5 * b / a + std::sqrt(0.25 * b * b / (a * a) - c / a);
  const Values values(reference);
  std::vector<float>
      luminance;  // single precision, as the published program has it: the number of exposures is rounded up
  luminance.reserve(static_cast<std::size_t>(reference.width) * reference.height);
  for (int j = 0; j < reference.height; ++j)
    for (int i = 0; i < reference.width; ++i) {
      const Rgb v = values.linear_float(i, j);
      luminance.push_back(static_cast<float>(0.2126 * std::max(v[0], 0.0) + 0.7152 * std::max(v[1], 0.0) +
                                             0.0722 * std::max(v[2], 0.0)));
    }
  const std::size_t middle = (luminance.size() - 1) / 2;  // of an even number the lower one, as torch.median takes it
  std::nth_element(luminance.begin(), luminance.begin() + static_cast<std::ptrdiff_t>(middle), luminance.end());
  const double median = luminance[middle],
               brightest = *std::max_element(luminance.begin() + static_cast<std::ptrdiff_t>(middle), luminance.end());
  Exposures out;
  out.start = std::log2(static_cast<float>(x / std::max(brightest, kSmallest)));
  out.stop = std::log2(static_cast<float>(x / std::max(median, kSmallest)));
  out.count = std::max(2, static_cast<int>(std::ceil(out.stop - out.start)));
  return out;
}

std::vector<float> hdr_flip(const Picture& reference, const Picture& test, double ppd) {
  return hdr_flip(reference, test, ppd, hdr_flip_exposures(reference));
}

std::vector<float> hdr_flip(const Picture& reference, const Picture& test, double ppd, const Exposures& exposures) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  std::vector<float> out(static_cast<std::size_t>(a.width()) * static_cast<std::size_t>(a.height()));
  Flip(ppd).hdr(a, b, exposures, 0, a.height(), out.data());
  return out;
}

double mean(const std::vector<float>& values) {
  return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace verisim::compare
