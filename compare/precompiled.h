// See tracer/precompiled.h.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/metrics/metrics.h"
#include "tracer/precompiled.h"
