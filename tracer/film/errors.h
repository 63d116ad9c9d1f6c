// Why a render may end without a picture.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "tracer/scene/source_location.h"

namespace verisim::render {

// A feature the tracer cannot render; `what` names it. The caller reports exit status 4.
struct Unsupported : std::runtime_error {
  Unsupported(const std::string& what, scene::SourceLocation where)
      : std::runtime_error(what), place(std::move(where)) {}
  scene::SourceLocation place;
};

// A limit of Options was reached; `what` names it and what may be done.
struct LimitExceeded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace verisim::render
