#include "tests/fuzz/targets.h"

#include <cstdint>
#include <vector>

#include "tests/fuzz/promise.h"
#include "tracer/shapes/text/truetype.h"

namespace verisim::fuzz {

void font(std::string_view bytes) {
  may_throw([&] {
    const shapes::TrueTypeFont font(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    for (const bool unicode : {false, true})
      for (const char16_t c : u"\0 Aaj\u00e4\u0410\uffff") (void)font.character(c, unicode);
    for (const std::uint16_t index : {0, 1, 2, 255, 65535}) (void)font.glyph(index), (void)font.kerning(index, 1);
  });
}

}  // namespace verisim::fuzz
