// verisim's comparison of pictures: metrics, verdicts, runs against POV-Ray, reports (docs/embedding.md).
#pragma once

#include "compare/compare.h"
#include "verisim/tracer.h"
