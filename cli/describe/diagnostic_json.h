// Messages about a scene as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "parser/source/diagnostic.h"

namespace verisim::cli {

// Its place (file, line, column), severity, message, advice, the line of the source and how the reader came there.
nlohmann::json as_json(const parser::Diagnostic& d);

}  // namespace verisim::cli
