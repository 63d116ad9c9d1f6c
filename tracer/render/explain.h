// Single samples through the centres of pixels, with somebody watching.
#pragma once

#include <memory>

#include "tracer/render/render.h"
#include "tracer/shading/explain.h"

namespace verisim::render {

class PreparedScene;
struct Window;

// A scene made ready once, to be asked for pixels in any order. The colours are those of a render without
// anti-aliasing. Serial; the passes before the picture (photons, radiosity) are made as for one. The scene must outlive
// it. Throws Unsupported.
class Explainer {
 public:
  Explainer(const scene::Scene& scene, const Options& options);
  // Of one that is made ready already, with options it can be rendered with; it must outlive this.
  Explainer(PreparedScene& prepared, const Options& options, const Window& window);
  ~Explainer();
  // (x, y) is a position in pixels, whole numbers are centres. `observer` is told about the compiled scene first.
  Color pixel(double x, double y, shading::Observer& observer);

 private:
  struct Watched;
  std::unique_ptr<PreparedScene> own_;
  std::unique_ptr<Watched> watched_;
};

// One pixel of a scene.
Color explain(const scene::Scene& scene, const Options& options, double x, double y, shading::Observer& observer);

}  // namespace verisim::render
