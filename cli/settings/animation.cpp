#include "cli/settings/animation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

// A value between 0 and 1 is a fraction of the frames.
int subset(double value, int initial, int final) {
  if (value > 0 && value < 1) return static_cast<int>(std::floor((final - initial + 1.0) * value));
  return static_cast<int>(std::clamp(value, -2e9, 2e9));
}

int digits(int number) { return static_cast<int>(std::to_string(number).size()); }

}  // namespace

Frame Animation::frame(std::size_t index) const {
  if (!on) return {0, single_clock};
  const int number = static_cast<int>(first + static_cast<long>(index) * step);
  // Only one frame: 0 times infinity, as POV-Ray has it.
  return {number, static_cast<double>(static_cast<float>(clock_delta * (number - initial_frame) + initial_clock))};
}

Animation animation(const Options& options) {
  const int given_initial = options.initial_frame.value_or(0), given_final = options.final_frame.value_or(0);
  Animation result;
  result.single_clock = static_cast<double>(static_cast<float>(options.clock.value_or(0)));
  result.clock_on = options.clock.has_value();
  if ((given_initial == 0 && given_final == 0) || (given_initial == 1 && given_final == 1)) return result;
  constexpr int kMaxFrame = 1 << 30;
  if (given_initial > kMaxFrame || given_final > kMaxFrame) throw OptionError("a frame number is too large");
  result.on = result.clock_on = true;
  result.initial_frame = std::max(options.initial_frame.value_or(1), 0);
  const int final = std::max(options.final_frame.value_or(1), result.initial_frame);
  result.final_frame = final + (options.cyclic ? 1 : 0);
  result.initial_clock = options.initial_clock;
  result.final_clock = options.final_clock;
  result.clock_delta = (options.final_clock - options.initial_clock) / (result.final_frame - result.initial_frame);
  result.first =
      std::max(options.subset_start ? subset(*options.subset_start, result.initial_frame, final) : result.initial_frame,
               result.initial_frame);
  result.last =
      std::max(options.subset_end ? subset(*options.subset_end, result.initial_frame, final) : final, result.first);
  result.step = options.frame_step;
  result.digits = digits(result.final_frame);
  return result;
}

}  // namespace verisim::cli
