// How a part of the reference has moved in the test: by Gauss and Newton, from coarse to fine.
#pragma once

#include "compare/causes/case.h"

namespace verisim::compare {

// A pixel at (x, y) from the middle shows what the reference has at (x, y) - motion(x, y), where
// motion = (dx + zoom_x x - turn y + parallax_x n, dy + zoom_y y + turn x + parallax_y n), n being how near it is.
struct Motion {
  double dx = 0, dy = 0, zoom_x = 0, zoom_y = 0, turn = 0;  // pixels; parts; radians
  double parallax_x = 0, parallax_y = 0;                    // pixels, where n is 1
};
struct Freedom {
  bool shift = true, zoom = false, stretch = false, turn = false;  // zoom: both axes alike
  bool parallax = false;
};
struct Registered {
  Motion motion;
  double explained =
      0;         // of the squared difference within the mask; edges count as a lens would see them: blurred a little
  Pixels moved;  // the reference after the motion, sharp
};
// `middle`: what zoom and turn are about. `mask`: the pixels that are looked at; empty: all. `nearness`: of each pixel,
// in proportion to one by its depth; for parallax only.
Registered registered(const Case& c, const Freedom& freedom, double middle_x, double middle_y, const Mask& mask = {},
                      const std::vector<float>& nearness = {});

Pixels blurred(const Case& c, const Pixels& picture, double sigma);

}  // namespace verisim::compare
