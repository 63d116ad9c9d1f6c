// Colours as a file of 8 bits holds them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/settings/options.h"
#include "compare/metrics/metrics.h"
#include "tracer/image/output.h"
#include "tracer/math/color.h"
#include "tracer/scene/scene.h"

namespace verisim::cli {

// A picture as a file of 8 bits holds it, without dithering.
image::Quantised quantised(const render::Framebuffer& picture, const scene::Scene& scene, const Options& options);
// The same as values from 0 to 1 of three channels, as the comparison takes them.
compare::Picture stored_picture(const render::Framebuffer& picture, const scene::Scene& scene, const Options& options);
// Red, green and blue, 0 to 255.
std::array<int, 3> stored(const Color& color, const scene::Scene& scene, const Options& options);
// The least values of a channel that are stored as 1, 2 ... 255: what a viewer needs to show the same.
std::vector<float> stored_steps(const scene::Scene& scene, const Options& options);

}  // namespace verisim::cli
