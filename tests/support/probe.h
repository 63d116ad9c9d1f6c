// Renders a scene given as text, for the probes of the specifications.
#pragma once

#include <string>
#include <vector>

#include "parser/parse.h"
#include "tracer/render/render.h"

namespace verisim::test {

// Parses and renders without anti-aliasing on one thread, as `povray -A +WT1`; throws std::runtime_error with the first
// message when parsing fails.
render::Framebuffer render_text(const std::string& text, int width, int height, const render::Options& options = {},
                                render::Statistics* statistics = nullptr);

// Colour of a pixel in linear code values 0..65535 after clipping, as `+FN16 File_Gamma=1` writes it with
// assumed_gamma 1.
std::vector<double> lin16(const render::Framebuffer& picture, int x, int y);

}  // namespace verisim::test
