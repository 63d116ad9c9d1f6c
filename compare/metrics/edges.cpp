#include "compare/metrics/edges.h"

#include <algorithm>

namespace verisim::compare {

std::vector<unsigned char> edge_mask(const Values& picture, double step) {
  const int w = picture.width(), h = picture.height();
  std::vector<float> luma(static_cast<std::size_t>(w) * h);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) luma[static_cast<std::size_t>(y) * w + x] = static_cast<float>(picture.luma(x, y));
  const auto at = [&](int x, int y) { return luma[static_cast<std::size_t>(std::clamp(y, 0, h - 1)) * w + std::clamp(x, 0, w - 1)]; };
  std::vector<unsigned char> mask(luma.size());
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const double gx = at(x + 1, y - 1) + 2 * at(x + 1, y) + at(x + 1, y + 1) - at(x - 1, y - 1) - 2 * at(x - 1, y) - at(x - 1, y + 1);
      const double gy = at(x - 1, y + 1) + 2 * at(x, y + 1) + at(x + 1, y + 1) - at(x - 1, y - 1) - 2 * at(x, y - 1) - at(x + 1, y - 1);
      if (std::hypot(gx, gy) < 4 * step) continue;  // a straight step of height s answers with 4 s
      for (int j = std::max(0, y - 1); j <= std::min(h - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(w - 1, x + 1); ++i) mask[static_cast<std::size_t>(j) * w + i] = 1;
    }
  return mask;
}

}  // namespace verisim::compare
