// One picture from its scene: parse, render, write. What `verisim render` does for every frame.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/settings/animation.h"
#include "cli/console/console.h"
#include "cli/console/interrupt.h"
#include "cli/settings/options.h"
#include "cli/settings/output_name.h"
#include "cli/console/exit_status.h"
#include "cli/settings/region.h"
#include "cli/settings/scene_source.h"
#include "cli/frame/scene_reuse.h"
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

struct FrameReport {
  ExitStatus status = kOk;
  bool scene_reused = false;     // from an earlier frame, not parsed again
  bool skipped = false;          // +C and the picture is there
  std::string message;           // the first error, as one line
  std::filesystem::path output;  // empty: none was written
  double seconds_parse = 0, cpu_parse = 0, seconds_render = 0, cpu_render = 0, seconds_write = 0;
  int warnings = 0;
  render::Statistics statistics;
  std::vector<std::string> stochastic_features;
  std::vector<std::filesystem::path> files_read;
};

FrameReport render_frame(const Job& job, const Frame& frame);

// The limits of the process that the options ask for.
Watch watch(const Options& options, const Console& console);

// Parses the job's scene, from its file or from the text of its stream.
parser::ParseResult parse_scene(const Job& job, const parser::ParseOptions& options);

// The parser's options for one frame.
parser::ParseOptions parse_options(const Job& job, const Frame& frame);

// The renderer's options for a part of the picture.
render::Options render_options(const Job& job, const Region& part);

// Seconds of user and system time this process has used.
double cpu_seconds();

}  // namespace verisim::cli
