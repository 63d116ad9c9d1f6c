#include "cli/settings/layers_option.h"

#include <fmt/format.h>

#include "cli/settings/options.h"
#include "cli/settings/text.h"

namespace verisim::cli {

LayerChoice layer_choice(const std::string& list) {
  LayerChoice choice;
  if (list.empty()) return choice;
  choice.any = true;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    const std::string name = list.substr(at, comma - at);
    at = comma + 1;
    if (name == "beauty") {
      choice.beauty = true;
    } else if (name == "depth") {
      choice.layers.depth = true;
    } else if (name == "normal") {
      choice.layers.normal = true;
    } else if (name == "albedo") {
      choice.layers.albedo = true;
    } else if (name == "id") {
      choice.layers.id = true;
    } else if (name == "all") {
      choice.beauty = choice.layers.depth = choice.layers.normal = choice.layers.albedo = choice.layers.id = true;
    } else {
      const std::string advice = nearest(name, {"beauty", "depth", "normal", "albedo", "id", "all"});
      throw OptionError(
          fmt::format("--layers takes beauty, depth, normal, albedo, id or all, separated by commas, not '{}'{}", name,
                      advice.empty() ? "" : "; did you mean " + advice + "?"));
    }
  }
  return choice;
}

}  // namespace verisim::cli
