// Shapes whose files have not landed yet. Each definition disappears with the arrival of the shape's own file.
#include <stdexcept>

#include "tracer/shapes/factories.h"

namespace verisim::shapes {

#define VERISIM_PENDING_FACTORY(name) \
  std::unique_ptr<Shape> compile_##name(const scene::Object&) { throw std::runtime_error("shape is not supported: " #name); }
#define VERISIM_PENDING_BOX(name, type) \
  Box3 name##_box(const scene::type&) { throw std::runtime_error("shape is not supported: " #name); }


VERISIM_PENDING_BOX(blob, Blob)
VERISIM_PENDING_BOX(lathe, Lathe)
VERISIM_PENDING_BOX(sor, Sor)
VERISIM_PENDING_BOX(prism, Prism)


}  // namespace verisim::shapes
