// The textures that an object's statement holds: its own, and those of components, triangles and its inside.
#pragma once

#include "tracer/scene/object.h"

namespace verisim::scene {

// visit(const TexturePtr&), null ones included; not of children (children_of).
template <class Visit>
void visit_textures(const Object& object, Visit&& visit) {
  if (const auto* blob = object.as<std::shared_ptr<const Blob>>())
    for (const BlobComponent& component : (*blob)->components) visit(component.texture);
  if (const auto* mesh = object.as<Mesh>(); mesh && mesh->data)
    for (const TexturePtr& t : mesh->data->textures) visit(t);
  visit(object.texture);
  visit(object.interior_texture);
}

}  // namespace verisim::scene
