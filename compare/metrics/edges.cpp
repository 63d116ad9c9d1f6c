#include "compare/metrics/edges.h"

#include <algorithm>

#include "tracer/base/parallel.h"

namespace verisim::compare {

std::vector<unsigned char> edge_mask(const Values& picture, double step) {
  return edge_mask(picture, 0, picture.height(), step);
}

std::vector<unsigned char> edge_mask(const Values& picture, int begin, int end, double step) {
  const int w = picture.width(), h = picture.height();
  const int first = std::max(0, begin - 2), last = std::min(h, end + 2), seen_first = std::max(0, begin - 1),
            seen_last = std::min(h, end + 1);
  const auto at = [w](int row, int x) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x);
  };
  std::vector<float> luma(at(last - first, 0));
  parallel_for(static_cast<std::size_t>(last - first), 8, [&](std::size_t row) {
    for (int x = 0; x < w; ++x)
      luma[at(static_cast<int>(row), x)] = static_cast<float>(picture.luma(x, first + static_cast<int>(row)));
  });
  std::vector<unsigned char> seen(at(seen_last - seen_first, 0));
  parallel_for(static_cast<std::size_t>(seen_last - seen_first), 8, [&](std::size_t row) {
    const int y = seen_first + static_cast<int>(row);
    const float* rows[3];
    for (int j = 0; j < 3; ++j) rows[j] = &luma[at(std::clamp(y - 1 + j, 0, h - 1) - first, 0)];
    for (int x = 0; x < w; ++x) {
      const int l = std::max(0, x - 1), r = std::min(w - 1, x + 1);
      const double gx = rows[0][r] + 2 * rows[1][r] + rows[2][r] - rows[0][l] - 2 * rows[1][l] - rows[2][l];
      const double gy = rows[2][l] + 2 * rows[2][x] + rows[2][r] - rows[0][l] - 2 * rows[0][x] - rows[0][r];
      seen[at(static_cast<int>(row), x)] =
          !(std::hypot(gx, gy) < 4 * step);  // a straight step of height s answers with 4 s
    }
  });
  std::vector<unsigned char> mask(at(end - begin, 0));
  parallel_for(static_cast<std::size_t>(end - begin), 8, [&](std::size_t row) {
    const int y = begin + static_cast<int>(row);
    for (int j = std::max(seen_first, y - 1); j <= std::min(seen_last - 1, y + 1); ++j)
      for (int x = 0; x < w; ++x) {
        if (!seen[at(j - seen_first, x)]) continue;
        for (int i = std::max(0, x - 1); i <= std::min(w - 1, x + 1); ++i) mask[at(static_cast<int>(row), i)] = 1;
      }
  });
  return mask;
}

}  // namespace verisim::compare
