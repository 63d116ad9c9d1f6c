#include "cli/view/reference.h"

#include <cmath>
#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "cli/sandbox/sandbox.h"
#include "cli/settings/reading/scene_words.h"
#include "compare/metrics/flip.h"

namespace fs = std::filesystem;

namespace verisim::cli {

Reference::Reference(fs::path scene, const Options& options, std::vector<std::string> words, fs::path stored)
    : scene_(std::move(scene)), stored_(std::move(stored)), options_(options), words_(std::move(words)) {}

std::string Reference::keep(compare::Picture picture) {
  if (picture.width != options_.width || picture.height != options_.height)
    throw std::runtime_error(fmt::format("the other picture has {}x{} pixels, this one {}x{}", picture.width,
                                         picture.height, options_.width, options_.height));
  const auto channels = static_cast<std::size_t>(picture.channels);
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  compare::Picture rgb;
  rgb.width = picture.width, rgb.height = picture.height, rgb.channels = 3;
  rgb.samples.reserve(pixels * 3);
  std::string bytes;
  bytes.reserve(pixels * 3);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = picture.samples[i * channels + (channels >= 3 ? c : 0)];
      const int stored = static_cast<int>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
      rgb.samples.push_back(static_cast<float>(stored) / 255);
      bytes += static_cast<char>(stored);
    }
  last_ = std::move(rgb);
  return bytes;
}

std::string Reference::povray(const std::vector<fs::path>& files_read, double clock) {
  if (wants_sandbox())
    throw std::runtime_error(
        "POV-Ray is not run in the sandbox: start the view with --sandbox=off, or give its picture with --against");
  const std::lock_guard lock(mutex_);
  const compare::OracleOptions oracle;
  const compare::OracleProgram program = compare::find_oracle(oracle);
  compare::SceneRequest request;
  request.scene = scene_, request.name = scene_.filename().string();
  request.width = options_.width, request.height = options_.height;
  for (const std::string& word : words_)
    if (is_setting_word(word)) request.switches.push_back(word);
  request.switches.push_back(fmt::format("+K{}", clock));
  compare::OracleRender render = compare::run_oracle(program, oracle, request, 0, files_read);
  if (!render.ok) throw std::runtime_error("POV-Ray failed: " + render.message);
  return keep(std::move(render.picture));
}

std::string Reference::stored() {
  const std::lock_guard lock(mutex_);
  if (stored_.empty()) throw std::runtime_error("no picture was given with --against");
  return keep(image::read_picture(stored_));
}

std::string Reference::flip(const compare::Picture& test) {
  const std::lock_guard lock(mutex_);
  if (last_.samples.empty()) throw std::runtime_error("there is no picture to hold this one against");
  const std::vector<float> errors = compare::ldr_flip(last_, test);
  std::string bytes(errors.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), errors.data(), bytes.size());
  return bytes;
}

}  // namespace verisim::cli
