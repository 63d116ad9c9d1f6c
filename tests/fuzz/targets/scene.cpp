#include "tests/fuzz/targets.h"

#include <string>

#include "tests/fuzz/limited_parse.h"

namespace verisim::fuzz {

void scene(std::string_view bytes) { parse(std::string(bytes)); }

}  // namespace verisim::fuzz
