#include "tests/fuzz/targets.h"

#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"
#include "tracer/image/density_file.h"

namespace verisim::fuzz {

void density(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] { (void)load_density_file(file.path()); });
}

}  // namespace verisim::fuzz
