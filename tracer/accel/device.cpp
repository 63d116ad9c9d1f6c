#include "tracer/accel/device.h"

#include <stdexcept>

namespace verisim::accel {

RTCDevice device() {
  // Hierarchies are built while nothing is rendered yet, so Embree may use the task scheduler's threads; it must not pin them.
  static RTCDevice const instance = [] {
    RTCDevice created = rtcNewDevice("set_affinity=0,start_threads=0");
    if (!created) throw std::runtime_error("Embree could not be started");
    return created;
  }();
  return instance;
}

}  // namespace verisim::accel
