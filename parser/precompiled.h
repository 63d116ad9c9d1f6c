// See tracer/precompiled.h.
#pragma once

#include <fmt/format.h>

#include "parser/language/parser.h"
#include "tracer/precompiled.h"
