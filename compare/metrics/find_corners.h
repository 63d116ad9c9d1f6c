// Where a render's corners are in a photograph, without anybody's help.
#pragma once

#include "compare/metrics/fit.h"

namespace verisim::compare {

// Near enough for align (photograph.h) to refine. Throws PictureMismatch where the photograph shows the render nowhere.
Corners find_corners(const Picture& photograph, const Picture& render);

}  // namespace verisim::compare
