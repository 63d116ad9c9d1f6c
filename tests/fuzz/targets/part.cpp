#include "tests/fuzz/targets.h"

#include "cli/parts/part_file.h"
#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"

namespace verisim::fuzz {

void part(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] {
    cli::PartFile part(file.path());
    part.check();
  });
}

}  // namespace verisim::fuzz
