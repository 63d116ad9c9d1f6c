#include "compare/report/display.h"
#include "compare/regression/passes.h"

#include <algorithm>
#include <cmath>

#include "compare/metrics/values.h"
#include "tracer/image/picture_rows.h"

namespace verisim::compare {

SceneRequest request_of_pass(const SceneRequest& scene, const Pass& pass) {
  SceneRequest out = scene;
  out.passes.clear();
  out.switches.insert(out.switches.end(), pass.switches.begin(), pass.switches.end());
  out.switches.push_back("+FE");
  return out;
}

void PassSum::add(const Picture& render, const Pass& pass) {
  const Values values(render);
  if (sums_.empty())
    width_ = render.width, height_ = render.height,
    sums_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
  if (render.width != width_ || render.height != height_) throw PictureMismatch("the passes of a scene differ in size");
  std::size_t at = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x, at += 3) {
      const Rgb linear = values.linear_float(x, y);
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t channel = 0; channel < 3; ++channel)
          sums_[at + row] += pass.matrix[row][channel] * linear[channel];
    }
}

Picture PassSum::picture() const {
  Picture out;
  out.width = width_, out.height = height_, out.channels = 3, out.bits = 16;
  out.samples.reserve(sums_.size());
  for (double v : sums_)
    out.samples.push_back(static_cast<float>(std::round(65535 * linear_to_srgb(std::clamp(v, 0.0, 1.0))) / 65535));
  return out;
}

std::filesystem::path keep_exactly(const Picture& picture, std::filesystem::path path) {
  if (!picture.is_float || picture.channels == 2 || picture.channels == 4) {
    path += ".png";
    const bool fine = !picture.is_float && picture.bits > 8;
    fine ? write_16_bits(picture, path) : image::write_picture(displayable(picture), path);
    return path;
  }
  path += ".exr";
  const Values values(picture);
  std::vector<render::PixelColor> row(static_cast<std::size_t>(picture.width));
  image::OutputOptions options;
  options.format = image::Format::exr;
  image::write({picture.width, picture.height,
                [&](int y) {
                  for (int x = 0; x < picture.width; ++x) {
                    const Rgb v = values.linear_float(x, y);
                    row[static_cast<std::size_t>(x)] =
                        Color(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
                  }
                  return row.data();
                }},
               path, options);
  return path;
}

void write_16_bits(const Picture& picture, const std::filesystem::path& path) {
  const std::size_t n = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
  image::write_rows(
      picture.width, picture.height, picture.channels,
      [&](int y, float* row) { std::copy_n(picture.samples.data() + n * static_cast<std::size_t>(y), n, row); }, path,
      16);
}

}  // namespace verisim::compare
