// What most sources include, compiled once for each library (verisim_precompile in cmake/Targets.cmake). Sources
// include what they use all the same: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "tracer/scene/object.h"
