// Radiance HDR files as POV-Ray writes them: linear light, mantissas truncated (spec 02 section 4.7).
#pragma once

#include <cstdio>

#include "tracer/image/output.h"

namespace verisim::image {

void write_hdr(std::FILE* file, const ColorRows& rows, const OutputOptions& options);

}  // namespace verisim::image
