// Two folders of pictures, of whatever renderers: nothing is rendered, every picture is compared with the one of its
// name.
#pragma once

#include "compare/compare.h"

namespace verisim::compare {

struct FolderOptions {
  MetricOptions metric;
  Thresholds thresholds;  // empty: the rules of docs/comparison.md
  std::vector<LayerRule> layers = {};
  bool antialiased = false;
};

// One scene for each picture below either folder, in the order of their names. A picture that is in one of them alone
// is `new` or `removed`, which are failures. Throws std::runtime_error when a folder cannot be read or neither holds a
// picture, std::invalid_argument for an unknown threshold.
Run run_of_folders(const std::filesystem::path& reference, const std::filesystem::path& test,
                   const FolderOptions& options);

}  // namespace verisim::compare
