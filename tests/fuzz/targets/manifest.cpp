#include "tests/fuzz/targets.h"

#include "compare/compare.h"
#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"

namespace verisim::fuzz {

void manifest(std::string_view bytes) {
  const NamedBytes file(bytes, ".toml");
  may_throw([&] { (void)compare::load_suite({file.path()}); });
}

}  // namespace verisim::fuzz
