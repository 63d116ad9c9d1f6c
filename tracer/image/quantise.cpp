// Framebuffer colours become integers: straight alpha, gamma, dithering, rounding (spec 02 sections 4.3 to 4.6).
#include <array>
#include <bit>
#include <limits>
#include <optional>

#include "tracer/image/dither.h"
#include "tracer/image/gamma.h"
#include "tracer/image/in_memory.h"
#include "tracer/image/output.h"
#include "tracer/simd/float4.h"

namespace verisim::image {
namespace {

// NaN becomes 0, as it does in POV-Ray's files.
float clamp01(float x) { return x > 0 ? (x < 1 ? x : 1.0f) : 0.0f; }

int round_to(float encoded, int max_value) {
  return static_cast<int>(std::floor(clamp01(encoded) * static_cast<float>(max_value) + 0.5f));
}

// The smallest float that rounds to each code: exact and faster than a power per sample. For at most 8 bits and no
// dithering. Cells are 128 parts of each octave from 2^-20 to 1, found by the upper half of a float's bits, and one for
// all below: with gammas in use none holds more than one border.
class CodeTable {
 public:
  CodeTable(const OutputCurve& curve, int max_value)
      : first_(static_cast<std::size_t>(max_value) + 1, std::numeric_limits<float>::infinity()) {
    for (int code = 1; code <= max_value; ++code) {
      float low = 0, high = 1;
      if (round_to(curve.encode(high), max_value) < code) break;
      while (std::nextafter(low, high) < high) {
        const float middle = 0.5f * (low + high);
        (round_to(curve.encode(middle), max_value) >= code ? high : low) = middle;
      }
      first_[code - 1] = high;
    }
    int code = 0;
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const float from = i == 0 ? 0 : std::bit_cast<float>((kBelow + i) << 16);
      const float to = std::bit_cast<float>((kBelow + i + 1) << 16);
      while (first_[static_cast<std::size_t>(code)] <= from) ++code;
      cells_[i] = {first_[static_cast<std::size_t>(code)], code};
      if (cells_[i].next < to && first_[static_cast<std::size_t>(code) + 1] < to) one_border_ = false;
    }
  }
  // 0 <= x <= 1. No branch that depends on the picture, but for curves out of use.
  int operator()(float x) const {
    const Cell& cell = cells_[std::max(std::bit_cast<std::uint32_t>(x) >> 16, kBelow) - kBelow];
    int code = cell.code + (x >= cell.next);
    if (!one_border_)
      while (first_[static_cast<std::size_t>(code)] <= x) ++code;
    return code;
  }

 private:
  static constexpr std::uint32_t kBelow = 0x357f, kCells = 0x3f80 - kBelow + 1;  // 2^-20 is 0x35800000, 1 is 0x3f800000
  struct Cell {
    float next;  // where the following code begins
    int code;    // at the lower end of the cell
  };
  std::vector<float> first_;  // of code + 1; the last is infinite
  std::array<Cell, kCells> cells_{};
  bool one_border_ = true;
};

// Codes of more than 8 bits, without dithering: parabolas between 128 places of each octave, and the curve itself where
// those come near to a border.
class FineCodes {
 public:
  FineCodes(const OutputCurve& curve, int max_value) : curve_(curve), max_value_(max_value) {
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const float from = std::bit_cast<float>((kFirst + i) << 16), to = std::bit_cast<float>((kFirst + i + 1) << 16);
      const auto value = [&](float u) {
        return curve.encode(from + u * (to - from)) * static_cast<float>(max_value) + 0.5f;
      };
      const float start = value(0), middle = value(0.5f), end = value(1);
      Cell& cell = cells_[i] = {start, 4 * middle - 3 * start - end, 2 * start + 2 * end - 4 * middle};
      for (const float u : {0.13f, 0.25f, 0.7f, 0.9f})
        if (!(std::fabs(cell.at(u) - value(u)) < kSure / 2)) cell = {0, 0, 0};  // never sure: the knee of sRGB's curve
    }
  }
  // 0 <= x <= 1.
  int operator()(float x) const {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x), cell = (bits >> 16) - kFirst;
    if (cell < kCells) {
      const float value = cells_[cell].at(static_cast<float>(bits & 0xffff) * 0x1p-16f);
      const int code = static_cast<int>(value);
      const float beyond = value - static_cast<float>(code);
      if (beyond > kSure && beyond < 1 - kSure) return code;
    }
    return round_to(curve_.encode(x), max_value_);
  }

 private:
  static constexpr std::uint32_t kFirst = 0x3780, kCells = 0x3f80 - kFirst;  // the upper half of floats from 2^-16 to 1
  static constexpr float kSure = 0.04f;  // several times what rounding of the curve and the parabolas amounts to
  struct Cell {
    float start, slope, bend;
    float at(float u) const { return start + u * (slope + u * bend); }
  };
  const OutputCurve curve_;
  const int max_value_;
  std::array<Cell, kCells> cells_;
};

// Straight alpha: highlights brighter than their alpha raise it (spec 02 section 4.5).
void to_straight_alpha(Rgb& color, float& alpha) {
  const float y = color.grey();
  if (y > alpha) alpha = std::min(1.0f, y);
  const float divisor = alpha == 0 ? 1e-6f : alpha;
  color.r /= divisor, color.g /= divisor, color.b /= divisor;
}

// Fewer bits than the file holds: the high bits are repeated below (spec 02 section 4.7).
int expand(int code, int bits, int file_bits) {
  int value = code << (file_bits - bits);
  for (int filled = bits; filled < file_bits; filled += bits) {
    const int shift = file_bits - filled - bits;
    value |= shift >= 0 ? code << shift : code >> -shift;
  }
  return value;
}

struct Depth {
  int bits, file_bits;
};

Depth depth_of(const OutputOptions& options) {
  const int bits = std::clamp(options.bits, 5, 16);
  switch (options.format) {
    case Format::png:
      return options.greyscale ? Depth{16, 16} : Depth{bits, bits <= 8 ? 8 : 16};
    case Format::ppm:
      return {std::max(bits, 8), std::max(bits, 8)};
    default:
      return {8, 8};
  }
}

// Whether colours are told apart from how much they cover; `alpha`: the file has a channel for it.
bool uses_alpha(const OutputOptions& options, bool alpha) {
  return alpha || options.format == Format::tga || options.format == Format::tga_rle;
}

// The samples of one pixel before encoding; alpha, if any, is the last and not gamma encoded.
int samples_of(const render::PixelColor& pixel, const OutputOptions& options, bool alpha, float* out) {
  Rgb color = pixel.rgb();
  float a = 1.0f - pixel.t;
  if (uses_alpha(options, alpha)) to_straight_alpha(color, a);
  int n = 0;
  if (options.greyscale) {
    out[n++] = color.grey();
  } else {
    out[n++] = color.r, out[n++] = color.g, out[n++] = color.b;
  }
  if (alpha) out[n++] = a;
  return n;
}

bool has_alpha_channel(const OutputOptions& options) {
  const Format f = options.format;
  return options.alpha &&
         (f == Format::png || f == Format::tga || f == Format::tga_rle || f == Format::bmp || f == Format::tiff);
}

OutputCurve curve_of(const OutputOptions& options) {
  if (options.format == Format::ppm && options.greyscale) return OutputCurve(scene::Gamma::none, 1, Curve::identity());
  return OutputCurve(options.working, options.working_gamma,
                     options.file_srgb ? Curve::srgb() : Curve::power(options.file_gamma));
}

}  // namespace

struct Quantiser::State {
  State(ColorRows from, const OutputOptions& settings)
      : rows(std::move(from)),
        options(settings),
        depth(depth_of(settings)),
        max_value((1 << depth.bits) - 1),
        alpha(has_alpha_channel(settings)),
        color_channels(settings.greyscale ? 1 : 3),
        curve(curve_of(settings)),
        dither(settings.format == Format::jpeg ? Dither::none : settings.dither),
        diffusion(dither, rows.width, color_channels + alpha) {
    if (dither != Dither::none) return;
    if (depth.bits > 8) {
      fine_codes.emplace(curve, max_value);
      return;
    }
    color_codes.emplace(curve, max_value);
    if (alpha) alpha_codes.emplace(linear, max_value);
  }

  // Pixels that other threads have written come from afar, and not every processor fetches them before it is asked to.
  static constexpr int kAhead = 128;
  template <class Codes>
  void colors_alone(const Codes& codes, const render::PixelColor* pixels, std::uint16_t* out) const {
    using accel::Float4;
    alignas(16) float clamped[4];
    for (int x = 0; x < rows.width; ++x, out += 3) {
      __builtin_prefetch(pixels + x + kAhead);
      min(max(Float4(pixels[x].r, pixels[x].g, pixels[x].b, 0), Float4(0)), Float4(1)).store(clamped);  // clamp01
      for (int c = 0; c < 3; ++c) out[c] = static_cast<std::uint16_t>(codes(clamped[c]));
    }
  }
  void by_table(const render::PixelColor* pixels, std::uint16_t* out) const {
    float samples[4];
    for (int x = 0; x < rows.width; ++x) {
      const int n = samples_of(pixels[x], options, alpha, samples);
      for (int c = 0; c < n; ++c) {
        const int code = c < color_channels ? (*color_codes)(clamp01(samples[c])) : (*alpha_codes)(clamp01(samples[c]));
        *out++ = static_cast<std::uint16_t>(expand(code, depth.bits, depth.file_bits));
      }
    }
  }
  void one_by_one(const render::PixelColor* pixels, int y, std::uint16_t* out) {
    float samples[4];
    for (int x = 0; x < rows.width; ++x) {
      const int n = samples_of(pixels[x], options, alpha, samples);
      const float offset = bayer_offset(dither, x, y) / static_cast<float>(max_value);
      int codes[4];
      float errors[4];
      for (int c = 0; c < n; ++c) {
        const OutputCurve& channel_curve = c < color_channels ? curve : linear;
        if (diffuses(dither)) {
          const float value = samples[c] + diffusion.take(x, c);
          codes[c] = round_to(channel_curve.encode(value), max_value);
          errors[c] =
              clamp01(value) - channel_curve.decode(static_cast<float>(codes[c]) / static_cast<float>(max_value));
        } else {
          codes[c] = fine_codes && c < color_channels ? (*fine_codes)(clamp01(samples[c]))
                                                      : round_to(channel_curve.encode(samples[c]) + offset, max_value);
        }
      }
      if (diffuses(dither))
        for (int c = 0; c < n; ++c) diffusion.give(x, c, errors[c]);
      for (int c = 0; c < n; ++c) *out++ = static_cast<std::uint16_t>(expand(codes[c], depth.bits, depth.file_bits));
    }
  }

  const ColorRows rows;
  const OutputOptions& options;
  const Depth depth;
  const int max_value;
  const bool alpha;
  const int color_channels;
  const OutputCurve curve, linear{scene::Gamma::none, 1, Curve::identity()};
  const Dither dither;
  Diffusion diffusion;
  std::optional<CodeTable> color_codes, alpha_codes;
  std::optional<FineCodes> fine_codes;
};

ColorRows rows_of(const render::Framebuffer& framebuffer) {
  return {framebuffer.width, framebuffer.height, [&framebuffer](int y) {
            const auto width = static_cast<std::size_t>(framebuffer.width);
            framebuffer.pixels.done_with(width);  // the rows before
            return framebuffer.pixels.data() + static_cast<std::size_t>(y) * width;
          }};
}

Quantiser::Quantiser(ColorRows rows, const OutputOptions& options)
    : state_(std::make_unique<State>(std::move(rows), options)) {}
Quantiser::~Quantiser() = default;

Quantised Quantiser::shape() const {
  const State& s = *state_;
  return {s.rows.width, s.rows.height, s.color_channels + s.alpha, s.depth.file_bits, {}};
}

void Quantiser::row(int y, std::uint16_t* out) {
  State& s = *state_;
  const render::PixelColor* const pixels = s.rows.row(y);
  const bool alone =
      !s.options.greyscale && !uses_alpha(s.options, s.alpha) && s.depth.bits == s.depth.file_bits;  // most pictures
  if (alone && s.color_codes)
    s.colors_alone(*s.color_codes, pixels, out);
  else if (alone && s.fine_codes)
    s.colors_alone(*s.fine_codes, pixels, out);
  else if (s.color_codes)
    s.by_table(pixels, out);
  else
    s.one_by_one(pixels, y, out);
}

Quantised quantise(const render::Framebuffer& framebuffer, const OutputOptions& options) {
  return quantise(rows_of(framebuffer), options);
}

Quantised quantise(const ColorRows& rows, const OutputOptions& options) {
  Quantiser quantiser(rows, options);
  Quantised out = quantiser.shape();
  const std::size_t n = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.channels);
  out.samples.resize(n * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y) quantiser.row(y, out.samples.data() + n * static_cast<std::size_t>(y));
  return out;
}

OutputOptions output_options(const scene::Scene& scene) {
  OutputOptions options;
  options.working = scene.settings.gamma;
  options.working_gamma = scene.settings.assumed_gamma;
  return options;
}

Picture to_picture(const render::Framebuffer& framebuffer, const OutputOptions& options) {
  Quantiser quantiser(rows_of(framebuffer), options);
  const Quantised shape = quantiser.shape();
  Picture picture{shape.width, shape.height, shape.channels, false, shape.bits, {}};
  const std::size_t row = static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels);
  std::vector<std::uint16_t> codes(row);
  picture.samples.reserve(row * static_cast<std::size_t>(shape.height));
  const auto white = static_cast<float>((1 << shape.bits) - 1);
  for (int y = 0; y < shape.height; ++y) {
    quantiser.row(y, codes.data());
    for (const std::uint16_t code : codes) picture.samples.push_back(static_cast<float>(code) / white);
  }
  return picture;
}

}  // namespace verisim::image
