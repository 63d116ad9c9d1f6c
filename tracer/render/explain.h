// Single samples through the centres of pixels, with somebody watching.
#pragma once

#include <memory>

#include "tracer/render/render.h"
#include "tracer/shading/explain.h"

namespace verisim::render {

// A scene made ready once, to be asked for pixels in any order. The colours are those of a render without
// anti-aliasing. Serial; the passes before the picture (photons, radiosity) are made as for one. The scene must outlive
// it. Throws Unsupported.
class Explainer {
 public:
  Explainer(const scene::Scene& scene, const Options& options);
  ~Explainer();
  // `observer` is told about the compiled scene first.
  Color pixel(int x, int y, shading::Observer& observer);

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

// One pixel of a scene.
Color explain(const scene::Scene& scene, const Options& options, int x, int y, shading::Observer& observer);

}  // namespace verisim::render
