#include "tests/fuzz/targets.h"

#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"
#include "tracer/image/output.h"

namespace verisim::fuzz {

void picture(std::string_view bytes) {
  const NamedBytes file(bytes, ".png");
  may_throw([&] { (void)image::read_picture(file.path()); });
}

}  // namespace verisim::fuzz
