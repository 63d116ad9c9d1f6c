// What POV-Ray prints before, between and after the work (spec 02 section 12), and the same as JSON.
#pragma once

#include <string>
#include <vector>

#include "cli/frame/frame.h"

namespace verisim::cli {

std::string banner();
std::string section_bar(const std::string& title);            // ==== [Parsing...] =====...
std::string option_text(const Job& job, const Frame& frame);  // parser, animation, image and information options
std::string render_option_text(const Options& options);
std::string parser_statistics(const scene::Scene& scene, const FrameReport& report);
std::string render_statistics(const Options& options, const scene::Scene& scene, const FrameReport& report);

// The content of --stats F: totals, and one entry a frame.
std::string statistics_json(const Job& job, const std::vector<FrameReport>& frames);

}  // namespace verisim::cli
