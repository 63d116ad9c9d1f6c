// PPM and PGM (spec 02 section 4.7).
#pragma once

#include <cstdio>

#include "tracer/image/output.h"

namespace verisim::image {

void write_ppm(std::FILE* file, const Quantised& picture, const OutputOptions& options);
// Reads P2, P3, P5 and P6 with any maxval; throws std::runtime_error.
Picture read_netpbm(std::FILE* file);

}  // namespace verisim::image
