#include "tests/fuzz/limited_parse.h"

#include "tests/fuzz/promise.h"

namespace verisim::fuzz {

using namespace parser;

namespace {

ParseOptions limited() {
  ParseOptions options;
  options.limits.max_steps = 20000;
  options.limits.max_depth = 100;
  options.limits.max_tokens = 1 << 20;
  options.limits.max_memory_bytes = std::size_t{2} << 30;
  options.allow_read = {"/nonexistent"};
  options.message = [](const Diagnostic& d) { (void)format(d); };
  options.debug = [](const std::string&) {};
  return options;
}

}  // namespace

ParseResult parse(const std::string& text) {
  ParseResult result = parse_text(text, "fuzz.pov", limited());
  require(result.scene.has_value() == result.errors.empty(), "a scene, or errors that say why not");
  for (const Diagnostic& error : result.errors) require(!error.message.empty(), "every error has a text");
  return result;
}

}  // namespace verisim::fuzz
