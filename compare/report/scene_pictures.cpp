#include "compare/report/scene_pictures.h"

#include <half.h>

#include <algorithm>

#include <fmt/format.h>

#include "compare/metrics/ssim.h"
#include "compare/report/display.h"

namespace verisim::compare {
namespace {

constexpr int kThumbnailWidth = 168, kThumbnailHeight = 126;  // twice the size it is shown at
constexpr double kSeenIn8Bits = 2;                            // code values: smaller differences are rounding to them

// Without alpha: a browser's canvas would lose the colours of transparent pixels. Or alpha alone.
Picture channels_of(const Picture& picture, bool alpha) {
  Picture out;
  out.width = picture.width, out.height = picture.height, out.channels = alpha ? 1 : 3;
  const auto step = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < picture.samples.size(); i += step) {
    if (alpha)
      out.samples.push_back(picture.samples[i + step - 1]);
    else
      out.samples.insert(out.samples.end(), picture.samples.begin() + static_cast<std::ptrdiff_t>(i),
                         picture.samples.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  return out;
}

Picture grey(int width, int height, const std::vector<float>& values) {
  Picture out;
  out.width = width, out.height = height, out.channels = 1;
  out.samples = values;
  return out;
}

// 16 bits a value, as two pictures of 8 one above the other.
Picture bytes_of(const Picture& picture) {
  const Values values(picture);
  Picture out;
  out.width = picture.width, out.height = 2 * picture.height, out.channels = 3;
  const std::size_t half = 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  out.samples.resize(2 * half);
  const std::size_t channels = static_cast<std::size_t>(picture.channels), step = channels > 2 ? 1 : 0;
  for (std::size_t i = 0; i < half; ++i) {
    const float v = picture.samples[i / 3 * channels + i % 3 * step];
    const unsigned bits = picture.is_float ? imath_float_to_half(v)
                                           : static_cast<unsigned>(std::lround(65535 * std::clamp(v, 0.0f, 1.0f)));
    out.samples[i] = static_cast<float>(bits >> 8) / 255, out.samples[half + i] = static_cast<float>(bits & 255) / 255;
  }
  return out;
}

}  // namespace

void ScenePictures::add(char side, const std::filesystem::path& path, Picture& exact, Picture& for_people) {
  if (path.empty()) return;
  try {
    for_people = shown(path);
    exact = image::read_picture(path);
    if (reduction(exact.width, exact.height) > 1) exact = {};
    keys_.emplace_back(1, side);
    if (for_people.channels == 4) keys_.push_back(std::string(1, side) + 'a');
    if (for_people.width > kThumbnailWidth || for_people.height > kThumbnailHeight)
      keys_.push_back(std::string("t") + side);
  } catch (const std::exception&) {
    for_people = exact = {};  // the file went away: the report says "no picture" in its place
  }
}

void ScenePictures::add_difference(const SceneResult& scene) {
  same_ = shown_reference_.channels == shown_test_.channels &&
          std::equal(shown_reference_.samples.begin(), shown_reference_.samples.end(), shown_test_.samples.begin(),
                     [](float a, float b) { return std::lround(255 * a) == std::lround(255 * b); });
  const Picture &a = reference_.width ? reference_ : shown_reference_, &b = test_.width ? test_ : shown_test_;
  place_ = worst_place(Values(a), Values(b));
  if (!place_) return;
  keys_.insert(keys_.end(), {"td", "flip", "ssim"});
  const bool floats = reference_.is_float && test_.is_float,
             fine = std::min(reference_.bits, test_.bits) > 8 && !reference_.is_float && !test_.is_float;
  fine_ = reference_.width && test_.width &&
          (floats || (fine && (!scene.metrics || scene.metrics->max_abs < kSeenIn8Bits)));
  if (fine_) keys_.insert(keys_.end(), {"of", "nf"});
}

ScenePictures::ScenePictures(const SceneResult& scene)
    : p_map_(scene.p_map), pixels_per_degree_(scene.request.flip_pixels_per_degree) {
  add('o', scene.oracle_picture, reference_, shown_reference_);
  add('n', scene.judged_picture.empty() ? scene.native_picture : scene.judged_picture, test_, shown_test_);
  if (shown_reference_.width && shown_reference_.width == shown_test_.width &&
      shown_reference_.height == shown_test_.height)
    add_difference(scene);
  if (!p_map_.empty()) keys_.emplace_back("p");
}

const char* ScenePictures::fine() const { return !fine_ ? nullptr : reference_.is_float ? "half" : "integer"; }

std::optional<Exposures> ScenePictures::exposures() const {
  if (!place_ || !reference_.is_float || !test_.is_float) return std::nullopt;
  return hdr_flip_exposures(reference_);
}

Picture ScenePictures::picture(const std::string& key) const {
  if (std::find(keys_.begin(), keys_.end(), key) == keys_.end())
    throw std::runtime_error(fmt::format("there is no picture '{}'", key));
  const auto small = [](const Picture& p) { return thumbnail(p, kThumbnailWidth, kThumbnailHeight); };
  const auto colors = [](const Picture& p) { return p.channels == 4 ? channels_of(p, false) : p; };
  const bool test = key.find('n') != std::string::npos;
  const Picture& side = test ? shown_test_ : shown_reference_;
  if (key == "o" || key == "n") return colors(side);
  if (key == "oa" || key == "na") return channels_of(side, true);
  if (key == "to" || key == "tn") return small(colors(side));
  if (key == "of" || key == "nf") return bytes_of(test ? test_ : reference_);
  const Picture &a = reference_.width ? reference_ : shown_reference_, &b = test_.width ? test_ : shown_test_;
  if (key == "td") return difference_thumbnail(a, b, kThumbnailWidth, kThumbnailHeight);
  if (key == "flip")
    return grey(a.width, a.height,
                a.is_float && b.is_float ? hdr_flip(a, b, pixels_per_degree_) : ldr_flip(a, b, pixels_per_degree_));
  if (key == "ssim") {
    std::vector<float> values = ssim_map(Values(a), Values(b));
    for (float& v : values) v = 1 - v;
    return grey(a.width, a.height, values);
  }
  return image::read_picture(p_map_);
}

std::string ScenePictures::png(const std::string& key) const { return png_bytes(picture(key)); }

}  // namespace verisim::compare
