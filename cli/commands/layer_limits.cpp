#include "cli/commands/layer_limits.h"

#include <stdexcept>

#include "cli/settings/options.h"

namespace verisim::cli {

std::vector<compare::LayerRule> layer_options(const std::vector<std::string>& given) {
  std::vector<compare::LayerRule> out;
  try {
    for (const std::string& text : given) out.push_back(compare::layer_rule(text));
  } catch (const std::invalid_argument& error) {
    throw OptionError(std::string("--layer: ") + error.what());
  }
  return out;
}

}  // namespace verisim::cli
