// The versions of the libraries that the tracer was built with or runs with, for reports of what went wrong where.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace verisim {

// Name and version, in the order of the alphabet.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace verisim
