// Dithering: ordered by Bayer matrices, and by diffusion of the rounding error (spec 02 section 4.4).
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "tracer/image/output.h"

namespace verisim::image {

// Bayer matrices, ranks listed per x, then y (spec 02 section 4.4).
inline constexpr int kBayer2[2][2] = {{1, 3}, {4, 2}};
inline constexpr int kBayer3[3][3] = {{3, 7, 4}, {6, 1, 9}, {2, 8, 5}};
inline constexpr int kBayer4[4][4] = {{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}};

// What is added to a value in units of one code.
inline float bayer_offset(Dither dither, int x, int y) {
  switch (dither) {
    case Dither::bayer2:
      return static_cast<float>(kBayer2[x % 2][y % 2]) / 4 - 0.5f;
    case Dither::bayer3:
      return static_cast<float>(kBayer3[x % 3][y % 3]) / 9 - 0.5f;
    case Dither::bayer4:
      return static_cast<float>(kBayer4[x % 4][y % 4]) / 16 - 0.5f;
    default:
      return 0;
  }
}

// Error diffusion with POV-Ray's quirk: a row's first pixel takes its accumulated error from the buffer of the row
// before (spec 02 section 4.4).
class Diffusion {
 public:
  Diffusion(Dither dither, int width, int channels)
      : dither_(dither),
        channels_(channels),
        here_(static_cast<std::size_t>(width + 2) * channels),
        below_(here_.size()),
        carried_(channels) {}

  float take(int x, int channel) {
    if (dither_ == Dither::diffusion1d) return carried_[channel];
    const float error = here_[index(x, channel)];
    if (x == 0 && channel == channels_ - 1) next_row();
    return error;
  }
  void give(int x, int channel, float error) {
    if (dither_ == Dither::diffusion1d) {
      carried_[channel] = error;
    } else if (dither_ == Dither::diffusion2d) {
      here_[index(x + 1, channel)] += error / 2;
      below_[index(x, channel)] += error / 4;
      below_[index(x + 1, channel)] += error / 4;
    } else {
      here_[index(x + 1, channel)] += error * 7 / 16;
      below_[index(x - 1, channel)] += error * 3 / 16;
      below_[index(x, channel)] += error * 5 / 16;
      below_[index(x + 1, channel)] += error * 1 / 16;
    }
  }

 private:
  std::size_t index(int x, int channel) const { return static_cast<std::size_t>(x + 1) * channels_ + channel; }
  void next_row() {
    std::swap(here_, below_);
    std::fill(below_.begin(), below_.end(), 0.0f);
  }
  Dither dither_;
  int channels_;
  std::vector<float> here_, below_, carried_;
};

inline bool diffuses(Dither d) {
  return d == Dither::diffusion1d || d == Dither::diffusion2d || d == Dither::floyd_steinberg;
}

}  // namespace verisim::image
