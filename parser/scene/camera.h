// A camera statement that modifies an earlier camera.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

scene::Camera parse_camera(Parser& parser, const scene::Camera& start);

}  // namespace verisim::parser
