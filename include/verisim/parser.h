// verisim's reader of POV-Ray's scene language: text in, a scene description or diagnostics out (docs/embedding.md).
#pragma once

#include "parser/parse.h"
#include "parser/scene/shapes/mesh/mesh_arrays.h"
#include "parser/source/standard_includes.h"
#include "verisim/tracer.h"
