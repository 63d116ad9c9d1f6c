// Lints: what is allowed and yet mostly a mistake. Each has a name that never changes, by which `verisim check --lint`
// switches it on and `--explain` tells of it.
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source/diagnostic.h"
#include "tracer/scene/scene.h"

namespace verisim::cli {

struct Lint {
  std::string_view name;   // kebab-case
  std::string_view title;  // one line
  std::string_view text;   // what it means and what to do
};

std::span<const Lint> all_lints();
const Lint* lint_named(std::string_view name);  // null: there is none

struct LintFinding : parser::Excerpt {
  const Lint* lint = nullptr;
  std::string message, advice;
};

// As a message: `file:line:column: lint: text [name]` with the line and what is meant underlined.
std::string format(const LintFinding& finding);

// The lints of --lint NAME, given again for several; "all", "none". Throws OptionError with the names there are.
std::set<std::string_view> wanted_lints(const std::vector<std::string>& names);

// Of the names in a scene's files. `files`: all that were read, the scene first; those below `standard` folders are
// looked at for uses only.
std::vector<LintFinding> lint_names(const std::vector<std::filesystem::path>& files,
                                    const std::vector<std::filesystem::path>& standard);
// Of the objects and textures of a scene.
std::vector<LintFinding> lint_scene(const scene::Scene& scene);

}  // namespace verisim::cli
