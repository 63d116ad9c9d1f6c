#include "tracer/textures/lookup/image_lookup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tracer/math/constants.h"
#include "tracer/math/luma.h"

namespace verisim::textures {
namespace {

double wrap(double v, double size) {
  v = std::fmod(v, size);
  if (v < 0) v += size;
  return v >= size ? 0 : v;
}

// Angle of (x, z) from +x towards +z, as a fraction of a full turn.
double turn(double x, double z) {
  const double radius = std::sqrt(x * x + z * z);
  if (radius == 0) return 0;
  const double angle = std::acos(std::clamp(x / radius, -1.0, 1.0));
  return (z < 0 ? kTwoPi - angle : angle) / kTwoPi;
}

bool planar(const ImageLookup& l, const Vec3& p, double& u, double& v) {
  if (l.once && (p.x < 0 || p.x > 1 || p.y < 0 || p.y > 1)) return false;
  u = std::fmod(p.x * l.width, l.width);
  v = std::fmod(p.y * l.height, l.height);
  return true;
}

bool spherical(const ImageLookup& l, const Vec3& p, double& u, double& v) {
  const double distance = length(p);
  if (distance == 0) return false;
  u = turn(p.x, p.z) * l.width;
  v = (0.5 + std::asin(std::clamp(p.y / distance, -1.0, 1.0)) / std::numbers::pi) * l.height;
  return true;
}

bool cylindrical(const ImageLookup& l, const Vec3& p, double& u, double& v) {
  if (l.once && (p.y < 0 || p.y > 1)) return false;
  if (p.x == 0 && p.z == 0) return false;
  u = turn(p.x, p.z) * l.width;
  v = std::fmod(p.y * l.height, l.height);
  return true;
}

bool torus(const ImageLookup& l, const Vec3& p, double& u, double& v) {
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  if (radius == 0) return false;
  const double x = radius - 1, rho = std::sqrt(x * x + p.y * p.y);
  double phi = rho == 0 ? 0 : std::acos(std::clamp(-x / rho, -1.0, 1.0)) / kTwoPi;
  if (p.y > 0) phi = 1 - phi;
  u = turn(p.x, p.z) * l.width;
  v = phi * l.height;
  return true;
}

// Up to 16 pixels with their weights.
struct Samples {
  int count = 0;
  int x[16], y[16];
  double weight[16];
};

int inside(int i, int size, bool clamp_to_edge) {
  if (i >= 0 && i < size) return i;
  if (clamp_to_edge) return i < 0 ? 0 : size - 1;
  i %= size;
  return i < 0 ? i + size : i;
}

Samples samples_at(const ImageLookup& l, double u, double v) {
  const Image& image = *l.image;
  Samples s;
  const auto add = [&](int x, int y, double weight) {
    s.x[s.count] = inside(x, image.width, l.once);
    s.y[s.count] = inside(y, image.height, l.once);
    s.weight[s.count++] = weight;
  };
  if (l.interpolate == 0) {
    add(static_cast<int>(std::floor(u)), static_cast<int>(std::floor(v)), 1);
    return s;
  }
  u += 0.5;
  v += 0.5;
  const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
  const double p = u - i, q = v - j;
  switch (l.interpolate) {
    case 3: {
      const auto cubic = [](double t, double* w) {
        const double r = 1 - t;
        w[0] = -0.5 * t * r * r;
        w[1] = 0.5 * r * (r * (3 * t + 1) + 1);
        w[2] = 0.5 * t * (t * (3 * r + 1) + 1);
        w[3] = -0.5 * r * t * t;
      };
      double wx[4], wy[4];
      cubic(p, wx);
      cubic(q, wy);
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) add(i - 2 + x, j - 2 + y, wx[x] * wy[y]);
      break;
    }
    case 4: {
      const auto inverse = [](double a, double b) { return 1 / std::max(a * a + b * b, 1e-300); };
      const double w[4] = {inverse(1 - p, 1 - q), inverse(p, 1 - q), inverse(1 - p, q), inverse(p, q)};
      const double sum = w[0] + w[1] + w[2] + w[3];
      add(i, j, w[0] / sum);
      add(i - 1, j, w[1] / sum);
      add(i, j - 1, w[2] / sum);
      add(i - 1, j - 1, w[3] / sum);
      break;
    }
    default:  // 2; POV-Ray's weights for other numbers are undefined, we take them as bilinear
      add(i - 1, j - 1, (1 - p) * (1 - q));
      add(i, j - 1, p * (1 - q));
      add(i - 1, j, (1 - p) * q);
      add(i, j, p * q);
      break;
  }
  return s;
}

// The interpolated colour as stored: premultiplied data stay premultiplied.
Color raw_color(const ImageLookup& l, double u, double v) {
  const Samples s = samples_at(l, u, v);
  return l.image->with_reader([&s](const auto& read) -> Color {
    if (s.count == 1) return read(s.x[0], s.y[0]);
    // Summed in double precision: equal neighbours give their own value exactly after rounding, which material_map and
    // steps of maps show.
    double r = 0, g = 0, b = 0, f = 0, t = 0;
    for (int k = 0; k < s.count; ++k) {
      const Color c = read(s.x[k], s.y[k]);
      const double weight = s.weight[k];
      r += weight * c.r, g += weight * c.g, b += weight * c.b, f += weight * c.f, t += weight * c.t;
    }
    return {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b), static_cast<float>(f),
            static_cast<float>(t)};
  });
}

double raw_index(const ImageLookup& l, double u, double v) {
  const Samples s = samples_at(l, u, v);
  double sum = 0;
  for (int k = 0; k < s.count; ++k) sum += s.weight[k] * l.image->index(s.x[k], s.y[k]);
  return std::floor(std::max(static_cast<float>(sum), 0.0f));
}

// POV-Ray looks at the pixels: neither an alpha channel nor an entry of a palette counts that none of them uses.
void look_for_transparency(const Image& image, ImageLookup& l) {
  if (!image.has_alpha && std::ranges::none_of(image.palette, [](const Color& c) { return c.f != 0 || c.t != 0; }))
    return;
  image.with_reader([&](const auto& read) {
    for (int y = 0; y < image.height && !l.transmits; ++y)
      for (int x = 0; x < image.width && !l.transmits; ++x) {
        const Color c = read(x, y);
        l.transmits = c.t != 0;
        l.transparent |= l.transmits || c.f != 0;
      }
    return Color();
  });
}

}  // namespace

ImageLookup compile_image(const scene::ImageParams& params) {
  if (!params.image || params.image->width <= 0 || params.image->height <= 0)
    throw std::invalid_argument("an image pattern without image");
  ImageLookup l;
  l.image = params.image;
  const Image& image = *l.image;
  l.map_type = params.map_type;
  l.interpolate = params.interpolate;
  l.once = params.once;
  l.use_alpha = params.use_alpha;
  l.use_index = params.use_index;
  l.width = static_cast<float>(image.width * params.repeat.x);
  l.height = static_cast<float>(image.height * params.repeat.y);
  l.offset_u = params.offset.x * image.width;
  l.offset_v = params.offset.y * image.height;
  look_for_transparency(image, l);
  if (!image.indexed()) {
    l.filter_all = params.filter_all;
    l.transmit_all = params.transmit_all;
    l.transparent |= params.filter_all != 0 || params.transmit_all != 0;
  }
  return l;
}

bool locate(const ImageLookup& l, const Vec3& p, double& u, double& v) {
  bool hit;
  switch (l.map_type) {
    case 1:
      hit = spherical(l, p, u, v);
      break;
    case 2:
      hit = cylindrical(l, p, u, v);
      break;
    case 5:
      hit = torus(l, p, u, v);
      break;
    default:
      hit = planar(l, p, u, v);
      break;
  }
  if (!hit) return false;
  const double w = l.image->width, h = l.image->height;
  u += kEpsilon - l.offset_u;
  v += kEpsilon - l.offset_v;
  if (l.once && (u < 0 || u >= w || v < 0 || v >= h)) return false;
  u = wrap(u, w);
  v = wrap(-v, h);
  return std::isfinite(u) && std::isfinite(v);
}

Color map_color(const ImageLookup& l, double u, double v) {
  Color c = raw_color(l, u, v);
  if (l.image->premultiplied) {
    const float alpha = 1 - c.t;
    if (std::fabs(alpha) > kEpsilon) c.r /= alpha, c.g /= alpha, c.b /= alpha;
  }
  c.f += l.filter_all;
  c.t += l.transmit_all;
  return c;
}

double image_pattern(const ImageLookup& l, const Vec3& p) {
  double u, v;
  if (!locate(l, p, u, v)) return 0;
  const Color c = raw_color(l, u, v);
  const double opaque = l.image->indexed() ? 0.0 : c.r;  // (sic) what use_alpha finds where there is none
  const double value = l.use_alpha ? (l.image->has_alpha ? c.t : opaque) : luma(c);
  return std::clamp(value, 0.0, 1.0);
}

double bump_height(const ImageLookup& l, double u, double v) {
  if (l.use_index && l.image->indexed()) return raw_index(l, u, v);
  return luma(raw_color(l, u, v));
}

int material_number(const ImageLookup& l, const Vec3& p) {
  double u, v;
  if (!locate(l, p, u, v)) return 0;
  const double number = l.image->indexed() ? raw_index(l, u, v) : 255 * static_cast<double>(raw_color(l, u, v).r);
  return static_cast<int>(std::clamp(number, 0.0, 65535.0));
}

}  // namespace verisim::textures
