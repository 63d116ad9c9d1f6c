#include "compare/verdict/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace verisim::compare {

TruthError truth_error(const Picture& picture, const Truth& truth) {
  TruthError out;
  double squares = 0;
  for (const TruthPoint& point : truth.points) {
    if (point.x < 0 || point.y < 0 || point.x >= picture.width || point.y >= picture.height)
      throw PictureMismatch(fmt::format("the point {}, {} of the known answer is outside the picture of {}x{}", point.x,
                                        point.y, picture.width, picture.height));
    const std::size_t at = (static_cast<std::size_t>(point.y) * static_cast<std::size_t>(picture.width) +
                            static_cast<std::size_t>(point.x)) *
                           static_cast<std::size_t>(picture.channels);
    std::array<double, 3>& value = out.values.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      value[c] = picture.samples[at + (picture.channels > 2 ? c : 0)];
      const double d = std::isfinite(value[c]) ? std::fabs(value[c] - point.value[c]) : 1;
      squares += d * d;
      if (d > out.max) out.max = d, out.worst_x = point.x, out.worst_y = point.y;
    }
  }
  if (!truth.points.empty()) out.rms = std::sqrt(squares / (3 * static_cast<double>(truth.points.size())));
  return out;
}

}  // namespace verisim::compare
