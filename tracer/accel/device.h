// The one Embree device of the process.
#pragma once

#include <embree3/rtcore.h>

namespace verisim::accel {

// Made at first use, kept until the process ends; safe from any thread. Throws std::runtime_error if Embree cannot start.
RTCDevice device();

}  // namespace verisim::accel
