// The picture's file: what is asked of it and what it tells of itself, and where it goes.
#pragma once

#include "cli/frame/job.h"
#include "cli/settings/layers_option.h"
#include "cli/settings/output_name.h"
#include "tracer/image/output.h"

namespace verisim::cli {

// Format, gamma, and the words in the file. Warns where the scene leaves its gamma open.
image::OutputOptions output_options(const Job& job, const scene::Scene& scene);

// Writes the picture, with its layers where any are chosen, to the file or the stream. Throws std::runtime_error.
void write_picture(const OutputName& name, const render::Framebuffer& framebuffer, const LayerChoice& choice,
                   const image::OutputOptions& output);

}  // namespace verisim::cli
