// spectra cornell_box.json [d65|e]: the box's spectra as linear sRGB, printed as #declare lines for a scene.
// spectra cornell_box.json passes: how renders of wavelength bands add up to linear sRGB, printed as `passes` of a
// manifest.
#include <cstdio>
#include <stdexcept>
#include <string>

#include "tools/spectra/cornell_box.h"

int main(int argc, char** argv) {
  using namespace verisim::spectra;
  const std::string illuminant = argc == 3 ? argv[2] : "d65";
  if (argc < 2 || argc > 3 || (illuminant != "d65" && illuminant != "e" && illuminant != "passes")) {
    std::fprintf(stderr, "usage: %s cornell_box.json [d65|e|passes]\n", argv[0]);
    return 2;
  }
  try {
    if (illuminant == "passes")
      std::fputs(as_passes(band_matrices(argv[1])).c_str(), stdout);
    else
      std::fputs(as_sdl(read_cornell_box(argv[1], illuminant == "e" ? Illuminant::e : Illuminant::d65)).c_str(),
                 stdout);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 5;
  }
}
