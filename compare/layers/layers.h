// All layers and parts of two OpenEXR files, each by rules of its kind or by limits of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/verdict/limits.h"
#include "compare/verdict/verdict.h"

namespace verisim::compare {

// What the layers whose names match the shell pattern may have. Without limits: the rules of their kind.
struct LayerRule {
  std::string text;  // as it was given
  std::string pattern;
  bool ignored = false;
  Limits limits = {};  // pixels: in the layer's own units; colours: in code values, as of a picture
};
// "Z:relative=0.001,pixels=10", "id:pixels=5", "diffuse*:max_rmse=1.5", "noisy:ignore". Throws std::invalid_argument.
LayerRule layer_rule(const std::string& text);
inline constexpr const char* kLayerHelp =
    "limits of the layers of OpenEXR files that are named so, as in Z:relative=0.001,pixels=10, diffuse*:max_rmse=2 "
    "or id:ignore; also absolute, in the layer's units (may be given again, the first that fits counts)";

struct LayerResult {
  std::string name;
  std::string kind;  // "color", "depth", "normal", "id", "data"
  Status status = Status::differ;
  std::string reason = {};
  double max_abs = 0;            // largest difference: code values of a colour, else the layer's units
  std::uint64_t wrong = 0;       // pixels beyond the limits of one pixel
  int worst_x = 0, worst_y = 0;  // where
  bool passed() const { return status == Status::exact || status == Status::match; }
};

struct Layers {
  bool picture = true;           // false: what is read from the reference as a picture are no colours, but depth, say
  std::vector<LayerResult> all;  // beside the picture, those of the reference first
};

// None when the files are not both OpenEXR or hold nothing else. The first rule that matches a name counts. Throws
// std::runtime_error for damaged files.
Layers compare_layers(const std::filesystem::path& reference, const std::filesystem::path& test,
                      const std::vector<LayerRule>& rules, bool antialiased);

// The picture's verdict, where there is one, and those of its layers in one.
Verdict with_layers(Verdict picture, const Layers& layers);

}  // namespace verisim::compare
