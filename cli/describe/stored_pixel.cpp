#include "cli/describe/stored_pixel.h"

#include <cmath>

namespace verisim::cli {
image::Quantised quantised(const render::Framebuffer& picture, const scene::Scene& scene, const Options& options) {
  image::OutputOptions output;
  output.working = scene.settings.gamma;
  output.working_gamma = scene.settings.assumed_gamma;
  output.file_srgb = options.file_srgb;
  output.file_gamma = options.file_gamma;
  return image::quantise(picture, output);
}

compare::Picture stored_picture(const render::Framebuffer& picture, const scene::Scene& scene, const Options& options) {
  constexpr float kMax = 255;
  compare::Picture result;
  result.width = picture.width, result.height = picture.height, result.channels = 3;
  const image::Quantised q = quantised(picture, scene, options);
  result.samples.reserve(q.samples.size());
  for (const std::uint16_t sample : q.samples) result.samples.push_back(static_cast<float>(sample) / kMax);
  return result;
}

namespace {

image::Quantised quantised(std::vector<Color> pixels, const scene::Scene& scene, const Options& options) {
  render::Framebuffer row;
  row.width = static_cast<int>(pixels.size()), row.height = 1;
  row.pixels = std::move(pixels);
  return quantised(row, scene, options);
}

}  // namespace

std::array<int, 3> stored(const Color& color, const scene::Scene& scene, const Options& options) {
  const image::Quantised q = quantised({color}, scene, options);
  return {q.samples[0], q.samples[1], q.samples[2]};
}

// By bisection, all at once: the values between 0 and 1 are in the order of their bits.
std::vector<float> stored_steps(const scene::Scene& scene, const Options& options) {
  constexpr int kSteps = 255;
  std::vector<float> low(kSteps, 0.0f), high(kSteps, 2.0f), middle(kSteps);
  for (int round = 0; round < 40; ++round) {
    std::vector<Color> row;
    for (int i = 0; i < kSteps; ++i) {
      middle[i] = round < 10 ? std::sqrt(std::max(low[i], 1e-12f) * high[i]) : 0.5f * (low[i] + high[i]);
      row.emplace_back(middle[i], middle[i], middle[i], 0.0f, 0.0f);
    }
    const image::Quantised q = quantised(std::move(row), scene, options);
    for (int i = 0; i < kSteps; ++i) (q.samples[static_cast<std::size_t>(i) * 3] > i ? high : low)[i] = middle[i];
  }
  return high;
}

}  // namespace verisim::cli
