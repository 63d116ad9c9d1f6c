// spectra cornell_box.json [d65|e]: the box's spectra as linear sRGB, printed as #declare lines for a scene.
#include <cstdio>
#include <stdexcept>
#include <string>

#include "tools/spectra/cornell_box.h"

int main(int argc, char** argv) {
  using namespace verisim::spectra;
  const std::string illuminant = argc == 3 ? argv[2] : "d65";
  if (argc < 2 || argc > 3 || (illuminant != "d65" && illuminant != "e")) {
    std::fprintf(stderr, "usage: %s cornell_box.json [d65|e]\n", argv[0]);
    return 2;
  }
  try {
    std::fputs(as_sdl(read_cornell_box(argv[1], illuminant == "e" ? Illuminant::e : Illuminant::d65)).c_str(), stdout);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 5;
  }
}
