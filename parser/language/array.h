// Arrays of SDL (spec 01 section 13): 1 to 5 dimensions, elements of one type, which the first assignment fixes.
#pragma once

#include <vector>

#include "parser/language/value.h"

namespace verisim::parser {

inline constexpr int kMaxDimensions = 5;

// Two values have the same type exactly when their keys are equal; 0 is "no value". Floats, 2-, 3-, 4-vectors and
// colours differ.
int type_key(const Value& value);

struct Array {
  std::vector<int> sizes;
  std::vector<Value> elements;  // row by row; an element without a value is empty
  int type = 0;                 // type_key of the elements; 0: not known yet
  int nesting = 1;              // 1 + that of the deepest array it contains
};

// Assigned arrays are copies, all the way down.
std::shared_ptr<Array> deep_copy(const Array& array);

}  // namespace verisim::parser
