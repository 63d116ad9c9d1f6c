// `verisim --version`, for people and for programs.
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "compare/json_text.h"
#include "tracer/base/library_versions.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::cli {
namespace {

const char* name(simd::InstructionSet set) {
  switch (set) {
    case simd::kAvx2:
      return "avx2";
    case simd::kAvx512:
      return "avx512";
    default:
      return "baseline";
  }
}

}  // namespace

std::string version_text(bool json) {
  if (!json) return "verisim " VERISIM_VERSION " (renders scenes of POV-Ray 3.7)\n";
  nlohmann::ordered_json report{{"program", "verisim"}, {"version", VERISIM_VERSION}, {"language", "POV-Ray 3.7"}};
  report["compiler"] = __VERSION__;
  report["libraries"] = nlohmann::ordered_json::object();
  for (const auto& [library, version] : library_versions()) report["libraries"][library] = version;
  // All give the same pictures; the last one is used here.
  report["instruction_sets"] = nlohmann::ordered_json::array();
  for (int set = simd::kBaseline; set <= simd::best_instruction_set(); ++set)
    report["instruction_sets"].push_back(name(static_cast<simd::InstructionSet>(set)));
  return compare::json_text(report, 2) + "\n";
}

}  // namespace verisim::cli
