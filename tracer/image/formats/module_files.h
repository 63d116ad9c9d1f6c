// The file types that go through the OpenImageIO module: TGA, BMP, JPEG, EXR, HDR, TIFF (spec 02 section 4.7).
#pragma once

#include "tracer/image/output.h"

namespace verisim::image {

// The picture's date as TIFF and Exif have it, blank when it is not to be told: OpenImageIO writes the time of day into
// TIFF and OpenEXR files that are given none.
std::string date_text(const OutputOptions& options);
// `path` must end in the format's extension. Throws std::runtime_error.
void write_through_module(const ColorRows& rows, const std::filesystem::path& path, const OutputOptions& options);
Picture read_through_module(const std::filesystem::path& path);

}  // namespace verisim::image
