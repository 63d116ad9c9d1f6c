// Fuzzers of whole scenes: VERISIM_FUZZ_TARGET is `scene`, which reads them, or `render`, which draws them, too.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "tests/fuzz/sdl_mutator.h"
#include "tests/fuzz/targets.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

std::size_t store(const std::string& from, std::uint8_t* out, std::size_t max_size) {
  const std::size_t size = std::min(from.size(), max_size);
  std::memcpy(out, from.data(), size);
  return size;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // Scenes may write below the current folder: the fuzzer moves to one where nothing can be made.
  std::filesystem::current_path("/proc/self");
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, max_size);
  return store(verisim::fuzz::mutate_scene(text(data, size), text(data, size), seed), data, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t a_size, const std::uint8_t* b,
                                                 std::size_t b_size, std::uint8_t* out, std::size_t max_size,
                                                 unsigned int seed) {
  return store(verisim::fuzz::mutate_scene(text(a, a_size), text(b, b_size), seed), out, max_size);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  verisim::fuzz::VERISIM_FUZZ_TARGET(text(data, size));
  return 0;
}
