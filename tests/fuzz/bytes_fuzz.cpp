// Fuzzers of bytes: VERISIM_FUZZ_TARGET names the function that takes them (entry_points.h, files.h).
#include <cstdint>
#include <filesystem>

#include "tests/fuzz/entry_points.h"
#include "tests/fuzz/files.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // Scenes may write below the current folder: the fuzzer moves to one where nothing can be made.
  std::filesystem::current_path("/proc/self");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  verisim::fuzz::VERISIM_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
