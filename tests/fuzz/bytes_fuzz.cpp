// Fuzzers of bytes: VERISIM_FUZZ_TARGET names the function that takes them (targets.h).
#include <cstdint>
#include <filesystem>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // Scenes may write below the current folder: the fuzzer moves to one where nothing can be made.
  std::filesystem::current_path("/proc/self");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  verisim::fuzz::VERISIM_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
