// Pictures made to be looked at.
#pragma once

#include <string>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

// 8-bit values: floats are clipped and sRGB encoded, grey is widened. Alpha is kept.
Picture displayable(const Picture& picture);

// The largest channel difference of each pixel as a colour: black for none, then a scale of increasing lightness that ends in white at 255 / gain code values.
Picture heat_map(const Picture& reference, const Picture& test, double gain);

// No larger than the given size, by averaging.
Picture thumbnail(const Picture& picture, int max_width, int max_height);

// As an 8-bit PNG file in memory; base64 as in RFC 4648.
std::string png_bytes(const Picture& picture);
std::string base64(const std::string& bytes);

}  // namespace verisim::compare
