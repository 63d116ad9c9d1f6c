// PNG through libpng, with the chunks POV-Ray writes (spec 02 section 4.7).
#pragma once

#include <cstdio>

#include "tracer/image/output.h"

namespace verisim::image {

// Writes `picture` (8 or 16 bits) to an open stream; throws std::runtime_error.
void write_png(std::FILE* file, const Quantised& picture, const OutputOptions& options);
// Reads any PNG as 8- or 16-bit samples with 1..4 channels; palettes are expanded. Throws std::runtime_error on anything corrupt or huge.
Quantised read_png(std::FILE* file);

}  // namespace verisim::image
