#include "tests/fuzz/targets.h"

#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"
#include "tracer/photons/photon_map.h"

namespace verisim::fuzz {

void photons(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] {
    global::PhotonMap surface, media;
    global::load_photons(file.path(), surface, media);
  });
}

}  // namespace verisim::fuzz
