// One fuzzer for each kind of file: VERISIM_FUZZ_TARGET names its function (files.h).
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  verisim::fuzz::VERISIM_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
