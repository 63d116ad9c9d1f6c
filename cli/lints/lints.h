// Lints: what is allowed and yet mostly a mistake. Each has a name that never changes, by which `verisim check --lint`
// switches it on and `--explain` tells of it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source/diagnostic.h"
#include "tracer/base/whole_file.h"
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

// What `--explain` prints.
std::string explanation(const Lint& lint);

// As a message: `file:line:column: lint: text [name]` with the line and what is meant underlined.
std::string format(const LintFinding& finding);

// The lints of --lint NAME, given again for several; "all", "none". Throws OptionError with the names there are.
std::set<std::string_view> wanted_lints(const std::vector<std::string>& names);

// The text of a file; nothing: it cannot be read.
using ReadText = std::function<std::optional<std::string>(const std::filesystem::path&)>;

// What was read: `files` are all files of the scene, the scene's own first.
struct LintedScene {
  const scene::Scene& scene;
  std::vector<std::filesystem::path> files;
  ReadText text = whole_file;
};

// What is found, each once, in the order of the table. `stop` is polled; nothing: it said so.
std::optional<std::vector<LintFinding>> find_lints(const LintedScene& linted, const std::set<std::string_view>& wanted,
                                                   const std::function<bool()>& stop = {});

// Of the names in a scene's files; those below `standard` folders are looked at for uses only.
std::vector<LintFinding> lint_names(const LintedScene& linted, const std::vector<std::filesystem::path>& standard);
// Of the objects and textures of a scene.
std::vector<LintFinding> lint_scene(const scene::Scene& scene, const std::function<bool()>& stop);

}  // namespace verisim::cli
