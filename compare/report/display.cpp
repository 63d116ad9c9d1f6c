#include "compare/report/display.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "compare/compare.h"
#include "compare/metrics/row_window.h"
#include "tracer/image/formats/png.h"

namespace verisim::compare {
namespace {

// Anchors of a scale whose lightness rises steadily (after matplotlib's "inferno", CC0), so that it reads in print and
// with colour-blind eyes.
constexpr Rgb kScale[] = {{0, 0, 4},      {51, 10, 95},   {120, 28, 109}, {187, 55, 84},
                          {237, 105, 37}, {251, 181, 26}, {252, 255, 164}};

Rgb scale_color(double t) {
  constexpr int kLast = static_cast<int>(std::size(kScale)) - 1;
  const double at = std::clamp(t, 0.0, 1.0) * kLast;
  const int i = std::min(static_cast<int>(at), kLast - 1);
  Rgb out;
  for (int c = 0; c < 3; ++c) out[c] = kScale[i][c] + (at - i) * (kScale[i + 1][c] - kScale[i][c]);
  return out;
}

Picture blank(int width, int height, int channels) {
  Picture out;
  out.width = width, out.height = height, out.channels = channels;
  out.samples.resize(static_cast<std::size_t>(width) * height * channels);
  return out;
}

void heat_row(const Values& a, const Values& b, int y, double gain, float* to) {
  for (int x = 0; x < a.width(); ++x) {
    double largest = a.finite(x, y) && b.finite(x, y) ? 0 : 255;
    for (const double d : difference(a, b, x, y)) largest = std::max(largest, std::fabs(d));
    for (double v : scale_color(largest * gain / 255)) *to++ = static_cast<float>(v / 255);
  }
}

}  // namespace

Picture displayable(const Picture& picture) {
  const Values values(picture);
  Picture out = blank(picture.width, picture.height, values.has_alpha() ? 4 : 3);
  float* to = out.samples.data();
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      for (double v : values.rgb(x, y)) *to++ = static_cast<float>(v / 255);
      if (values.has_alpha()) *to++ = static_cast<float>(values.alpha(x, y) / 255);
    }
  return out;
}

Picture heat_map(const Picture& reference, const Picture& test, double gain) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  Picture out = blank(a.width(), a.height(), 3);
  for (int y = 0; y < out.height; ++y)
    heat_row(a, b, y, gain, &out.samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) * 3]);
  return out;
}

int reduction(int width, int height) {
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(width) * height / kMaxShown))));
}

Picture shown(const std::filesystem::path& path) {
  RowWindow rows(path);
  const int step = reduction(rows.shape().width, rows.shape().height);
  if (step == 1) return displayable(image::read_picture(path));
  Picture out = blank((rows.shape().width + step - 1) / step, (rows.shape().height + step - 1) / step, 3);
  for (int y = 0; y < out.height; ++y) {
    const int first = y * step, last = std::min(first + step, rows.shape().height);
    const Values values = rows.show(first, last);
    for (int x = 0; x < out.width; ++x) {
      const int left = x * step, right = std::min(left + step, values.width());
      Rgb sum{};
      for (int j = first; j < last; ++j)
        for (int i = left; i < right; ++i)
          for (std::size_t c = 0; c < 3; ++c) sum[c] += values.rgb(i, j)[c];
      for (std::size_t c = 0; c < 3; ++c)
        out.samples[(static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x)) *
                        3 +
                    c] = static_cast<float>(sum[c] / (255.0 * (last - first) * (right - left)));
    }
  }
  return out;
}

namespace {

// Calls `pixel` with each pixel's place in a thumbnail and the block of the picture behind it: x0, x1, y0, y1.
template <typename Pixel>
Picture shrunk(const Picture& picture, int max_width, int max_height, const Pixel& pixel) {
  const double shrink =
      std::max({1.0, static_cast<double>(picture.width) / max_width, static_cast<double>(picture.height) / max_height});
  Picture out = blank(std::max(1, static_cast<int>(picture.width / shrink)),
                      std::max(1, static_cast<int>(picture.height / shrink)), 3);
  float* to = out.samples.data();
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const int x0 = x * picture.width / out.width, x1 = std::max(x0 + 1, (x + 1) * picture.width / out.width);
      const int y0 = y * picture.height / out.height, y1 = std::max(y0 + 1, (y + 1) * picture.height / out.height);
      for (const double v : pixel(x0, x1, y0, y1)) *to++ = static_cast<float>(v / 255);
    }
  return out;
}

}  // namespace

Picture thumbnail(const Picture& picture, int max_width, int max_height) {
  const Values values(picture);
  return shrunk(picture, max_width, max_height, [&](int x0, int x1, int y0, int y1) {
    Rgb sum{};
    for (int j = y0; j < y1; ++j)
      for (int i = x0; i < x1; ++i) {
        const Rgb v = values.rgb(i, j);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += v[c];
      }
    for (double& v : sum) v /= (x1 - x0) * (y1 - y0);
    return sum;
  });
}

Picture difference_thumbnail(const Picture& reference, const Picture& test, int max_width, int max_height) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  return shrunk(reference, max_width, max_height, [&](int x0, int x1, int y0, int y1) {
    double largest = 0;
    for (int j = y0; j < y1; ++j)
      for (int i = x0; i < x1; ++i) {
        if (!a.finite(i, j) || !b.finite(i, j)) largest = 255;
        for (const double d : difference(a, b, i, j)) largest = std::max(largest, std::fabs(d));
      }
    return scale_color(std::log2(1 + largest) / 8);
  });
}

std::string png_bytes(const Picture& picture) {
  image::Quantised q;
  q.width = picture.width, q.height = picture.height, q.channels = picture.channels, q.bits = 8;
  for (float v : picture.samples)
    q.samples.push_back(static_cast<std::uint16_t>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))));
  char* data = nullptr;
  std::size_t size = 0;
  std::FILE* memory = open_memstream(&data, &size);
  if (!memory) throw std::bad_alloc();
  std::string out;
  try {
    image::write_png(memory, q, image::OutputOptions{});
    std::fclose(memory);
    out.assign(data, size);
  } catch (...) {
    std::fclose(memory);
    std::free(data);
    throw;
  }
  std::free(data);
  return out;
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
    };
    const unsigned bits = byte(0) << 16 | byte(1) << 8 | byte(2);
    out += kDigits[bits >> 18], out += kDigits[bits >> 12 & 63];
    out += i + 1 < bytes.size() ? kDigits[bits >> 6 & 63] : '=';
    out += i + 2 < bytes.size() ? kDigits[bits & 63] : '=';
  }
  return out;
}

void write_heat_map(const Picture& reference, const Picture& test, const std::filesystem::path& path, double gain) {
  image::write_picture(heat_map(reference, test, gain), path);
}

void write_heat_map(const std::filesystem::path& reference, const std::filesystem::path& test,
                    const std::filesystem::path& path, double gain) {
  RowWindow a(reference), b(test);
  require_same_size(a.shape(), b.shape());
  image::write_rows(
      a.shape().width, a.shape().height, 3,
      [&](int y, float* row) { heat_row(a.show(y, y + 1), b.show(y, y + 1), y, gain, row); }, path);
}

}  // namespace verisim::compare
