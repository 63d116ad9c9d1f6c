#include "tests/fuzz/targets.h"

#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"
#include "tracer/radiosity/irradiance_file.h"

namespace verisim::fuzz {

void radiosity(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] { (void)global::load_samples(file.path(), 1 << 16); });
}

}  // namespace verisim::fuzz
