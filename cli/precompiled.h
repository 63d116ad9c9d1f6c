// See tracer/precompiled.h.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "cli/settings/options.h"
#include "tracer/precompiled.h"
