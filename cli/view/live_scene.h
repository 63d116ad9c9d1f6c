// The text of a scene as somebody turns its knobs: numbers that the scene marks take other values, the file stays as it
// is.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace verisim::cli {

// `#declare Name = 1.5; // @range 0 10` or `// @range 0 10 0.5`.
struct Knob {
  std::string name;
  double value = 0, low = 0, high = 1, step = 0;  // step 0: any
  std::size_t begin = 0, length = 0;              // of the number in the text
};

std::vector<Knob> knobs_of(const std::string& text);
// Each number that `values` names is replaced by its value.
std::string turned(const std::string& text, const std::vector<Knob>& knobs,
                   const std::map<std::string, double>& values);

}  // namespace verisim::cli
