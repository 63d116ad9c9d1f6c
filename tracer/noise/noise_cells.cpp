#include "tracer/noise/noise_cells.h"

#include <memory>

namespace verisim::textures {

thread_local constinit NoiseMemory* thread_noise_memory = nullptr;

NoiseMemory& make_thread_noise_memory() {
  static thread_local const std::unique_ptr<NoiseMemory> owner = std::make_unique_for_overwrite<NoiseMemory>();
  thread_noise_memory = owner.get();
  return *owner;
}

}  // namespace verisim::textures
