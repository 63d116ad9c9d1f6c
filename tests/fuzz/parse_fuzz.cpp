// Any bytes must end in a scene or in diagnostics, within limits: no crash, no hang, no unbounded memory, no file written.
#include <cstdint>
#include <filesystem>
#include <string>

#include "parser/parse.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // Scenes may write below the current folder: the fuzzer moves to one where nothing can be made.
  std::filesystem::current_path("/proc/self");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace verisim::parser;
  ParseOptions options;
  options.limits.max_steps = 20000;
  options.limits.max_depth = 100;
  options.limits.max_tokens = 1 << 20;
  options.limits.max_memory_bytes = std::size_t{2} << 30;
  options.allow_read = {"/nonexistent"};
  options.message = [](const Diagnostic& d) { (void)format(d); };
  options.debug = [](const std::string&) {};
  const ParseResult result = parse_text({reinterpret_cast<const char*>(data), size}, "fuzz.pov", options);
  if (!result.scene && result.errors.empty()) __builtin_trap();  // a failure without a reason
  return 0;
}
