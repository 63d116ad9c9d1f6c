#include "tests/fuzz/targets.h"

#include "cli/settings/reading/ini.h"
#include "tests/fuzz/promise.h"

namespace verisim::fuzz {

void ini(std::string_view bytes) {
  may_throw([&] {
    cli::Options options;
    cli::apply_ini_text(options, bytes, "", "fuzz.ini");
    cli::validate(options);
  });
}

}  // namespace verisim::fuzz
