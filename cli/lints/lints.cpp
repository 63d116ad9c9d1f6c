#include "cli/lints/lints.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "cli/settings/options.h"
#include "parser/source/standard_includes.h"
#include "parser/source/suggest.h"

namespace verisim::cli {
namespace {

constexpr Lint kLints[] = {
    {"unused-name", "A name of the scene that nothing uses",
     "The identifier or macro is declared in the scene's own file and used nowhere, in no file that the scene reads. "
     "Remove it, or look for the place where a similar name is written. Names that appear within strings are taken as "
     "used, and so are variables of #for."},
    {"shadowed-name", "A local name hides a global one",
     "A parameter of a macro or a #local has the name of a global identifier: within the macro the global one cannot "
     "be "
     "reached, and a #declare there changes the local one. Give one of them another name."},
    {"skipped-directive", "A directive that does not exist, where nothing runs",
     "Behind the '#' stands a word that is no directive. As long as its branch is not taken or its macro not called it "
     "is passed over in silence, and a branch that it was to open never runs; where it is reached it is an error."},
    {"constant-in-loop", "A loop declares again what never changes",
     "The value has no names and no random numbers in it, and nothing else in the loop gives the identifier a value: "
     "the declaration can stand before the loop."},
    {"coincident-surfaces", "Two faces lie in the same plane and look the same way",
     "Which of two faces in the same place is seen is decided by rounding: expect speckles where their textures "
     "differ. Move one of them by a little (0.001), or let one end inside the other."},
    {"light-inside", "A light is inside an opaque object",
     "The light cannot leave the solid around it, so it lights nothing else. Move it out, give the object no_shadow, "
     "or "
     "put the object into the light's looks_like."},
    {"inward-normals", "Normals point to both sides of a triangle",
     "A smooth triangle has normals on both sides of its plane: shading flips along it and looks torn. Turn the "
     "normals "
     "that point inward."},
    {"hidden-texture", "A layer of a texture that can never show",
     "A layer above it is opaque everywhere. Remove the lower layers, or give the upper one filter or transmit."},
    {"ambient-with-radiosity", "ambient has no effect with radiosity",
     "From version 3.7 on the ambient of finishes counts nothing while radiosity is on. Write emission where the "
     "surface shall shine."},
};

// The same line makes many objects, and says the same of each.
void keep_one_of_each(std::vector<LintFinding>& found) {
  std::set<std::tuple<std::string, int, int, std::string>> told;
  std::erase_if(found, [&](const LintFinding& f) { return !told.emplace(f.file, f.line, f.column, f.message).second; });
}

}  // namespace

std::optional<std::vector<LintFinding>> find_lints(const LintedScene& linted, const std::set<std::string_view>& wanted,
                                                   const std::function<bool()>& stop) {
  if (wanted.empty()) return std::vector<LintFinding>{};
  std::vector<LintFinding> found = lint_names(linted, parser::standard_include_folders());
  if (stop && stop()) return std::nullopt;
  for (LintFinding& finding : lint_scene(linted.scene, stop)) found.push_back(std::move(finding));
  if (stop && stop()) return std::nullopt;
  std::erase_if(found, [&](const LintFinding& f) { return !wanted.contains(f.lint->name); });
  keep_one_of_each(found);
  return found;
}

std::span<const Lint> all_lints() { return kLints; }

const Lint* lint_named(std::string_view name) {
  const auto found = std::find_if(std::begin(kLints), std::end(kLints), [&](const Lint& l) { return l.name == name; });
  return found == std::end(kLints) ? nullptr : found;
}

std::string explanation(const Lint& lint) { return fmt::format("{}: {}\n\n{}\n", lint.name, lint.title, lint.text); }

std::string format(const LintFinding& f) {
  std::string out = f.line > 0 ? fmt::format("{}:{}:{}: ", f.file, f.line, f.column) : f.file + ": ";
  out += fmt::format("lint: {} [{}]\n", f.message, f.lint->name);
  if (!f.source_line.empty()) {
    const std::string number = fmt::format("{:>6}", f.line);
    out +=
        fmt::format("{} | {}\n{} | {}^{}\n", number, parser::printable(f.source_line), std::string(number.size(), ' '),
                    std::string(static_cast<std::size_t>(std::max(f.column - 1, 0)), ' '),
                    std::string(static_cast<std::size_t>(std::max(f.length - 1, 0)), '~'));
  }
  if (!f.advice.empty()) out += "         " + f.advice + "\n";
  return out;
}

std::set<std::string_view> wanted_lints(const std::vector<std::string>& names) {
  std::set<std::string_view> wanted;
  for (const std::string& name : names) {
    if (name == "none") {
      wanted.clear();
    } else if (name == "all") {
      for (const Lint& lint : kLints) wanted.insert(lint.name);
    } else if (const Lint* lint = lint_named(name)) {
      wanted.insert(lint->name);
    } else {
      std::string all;
      for (const Lint& one : kLints) all += std::string(one.name) + ", ";
      throw OptionError(fmt::format("--lint {}: there is no such lint; there are {}all and none", name, all));
    }
  }
  return wanted;
}

}  // namespace verisim::cli
