#include "tests/fuzz/targets.h"

#include <iterator>
#include <string>

#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"
#include "tracer/image/image.h"

namespace verisim::fuzz {

void image(std::string_view bytes) {
  if (bytes.empty()) return;
  constexpr const char* kEndings[] = {".gif", ".png", ".tga", ".ppm", ".pgm", ".bmp", ".jpg", ".hdr", ".tif", ".exr"};
  const std::string ending = kEndings[static_cast<unsigned char>(bytes[0]) % std::size(kEndings)];
  const NamedBytes file(bytes.substr(1), ending);
  may_throw([&] {
    const auto loaded = load_image(file.path(), image_type_from_extension(file.path().string()), {});
    for (const int x : {0, loaded->width - 1})
      for (const int y : {0, loaded->height - 1}) (void)loaded->at(x, y);
  });
}

}  // namespace verisim::fuzz
