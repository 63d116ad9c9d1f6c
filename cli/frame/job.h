// One call of the program, and what it asks of the parser, the renderer and the process.
#pragma once

#include "cli/console/console.h"
#include "cli/console/interrupt.h"
#include "cli/frame/scene_reuse.h"
#include "cli/settings/animation.h"
#include "cli/settings/options.h"
#include "cli/settings/region.h"
#include "cli/settings/scene_source.h"
#include "parser/parse.h"
#include "tracer/render/render.h"

namespace verisim::cli {

// What all frames of one call have in common.
struct Job {
  const Options& options;
  Console& console;
  Interrupt& interrupt;
  SceneSource scene;
  Animation animation;
  SharedScene* shared = nullptr;  // where frames leave the scene for the next; null: nowhere
};

// The limits of the process that the options ask for.
Watch watch(const Options& options, const Console& console);

// Parses the job's scene, from its file or from the text of its stream.
parser::ParseResult parse_scene(const Job& job, const parser::ParseOptions& options);

// The parser's options for one frame; those of a job report to its console and look at its interrupts.
parser::ParseOptions parse_options(const Options& options, const std::filesystem::path& scene,
                                   const Animation& animation, const Frame& frame);
parser::ParseOptions parse_options(const Job& job, const Frame& frame);

// The renderer's options for a part of the picture. Throws OptionError for options that exclude each other.
render::Options render_options(const Job& job, const Region& part);

}  // namespace verisim::cli
