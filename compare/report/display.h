// Pictures made to be looked at.
#pragma once

#include <filesystem>
#include <string>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

// 8-bit values: floats are clipped and sRGB encoded, grey is widened. Alpha is kept.
Picture displayable(const Picture& picture);

// The largest channel difference of each pixel as a colour: black for none, then a scale of increasing lightness that
// ends in white at 255 / gain code values.
Picture heat_map(const Picture& reference, const Picture& test, double gain);

// No larger than the given size, by averaging.
Picture thumbnail(const Picture& picture, int max_width, int max_height);
// The largest channel difference of the pixels behind each one of the thumbnail, so that one wrong pixel is seen, as a
// colour of heat_map's scale; the scale is logarithmic: black for none, white at 255 code values.
Picture difference_thumbnail(const Picture& reference, const Picture& test, int max_width, int max_height);

// Pictures of more pixels are shown reduced.
inline constexpr double kMaxShown = 1 << 24;
// How many pixels of a picture of this size become one on either side; 1: none.
int reduction(int width, int height);
// A file as it is shown, without alpha when it is reduced. Throws std::runtime_error.
Picture shown(const std::filesystem::path& path);

// As an 8-bit PNG file in memory; base64 as in RFC 4648.
std::string png_bytes(const Picture& picture);
std::string base64(const std::string& bytes);

}  // namespace verisim::compare
