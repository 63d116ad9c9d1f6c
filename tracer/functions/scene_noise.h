// Functions whose noise is that of the scene's generator when they are asked (spec 05 5.4): while a scene is read it
// may still change, by #version and global_settings.
#pragma once

#include <functional>

#include "tracer/functions/function.h"

namespace verisim::functions {

// `generator` is 1, 2 or 3, and constant once the scene is read; `make` gives the function of one of them.
FunctionPtr follow_generator(std::shared_ptr<const int> generator, std::function<FunctionPtr(int)> make);

}  // namespace verisim::functions
