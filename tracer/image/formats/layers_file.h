// OpenEXR files with named channels, as compositors expect them: R G B A, Z, N.X N.Y N.Z, albedo.R albedo.G albedo.B,
// id.
#pragma once

#include "tracer/film/layers.h"
#include "tracer/image/output.h"

namespace verisim::image {

// Colours are linear and multiplied by alpha; they are half floats, the rest is of single precision. `beauty`: with the
// picture itself (and its alpha when options.alpha). Throws std::runtime_error naming the file and the reason.
void write_layers(const render::Framebuffer& framebuffer, const render::Layers& layers, bool beauty,
                  const std::filesystem::path& path, const OutputOptions& options);

}  // namespace verisim::image
