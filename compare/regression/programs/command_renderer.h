// Any renderer under test: a command line that makes a picture of a scene.
#pragma once

#include <string>

#include "compare/compare.h"

namespace verisim::compare {

// `command` is run by /bin/sh in a private copy of the scene's folder, with our environment. {scene}, {out}, {width},
// {height}, {threads} and {seed} (the number of the run) stand for the request's, quoted for the shell, and {switches}
// for the scene's switches; {{ is a brace. It must end with status 0 and leave the picture, PNG or what the switches
// say, in {out}. Throws std::invalid_argument for an unknown word in braces, and when {scene} or {out} is missing.
NativeRenderer command_renderer(const std::string& command);

}  // namespace verisim::compare
