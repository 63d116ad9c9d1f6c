// Objects that copies share are copied before they change.
#pragma once

#include "tracer/scene/object.h"

namespace verisim::scene {

// What `object` points to, which is its own from now on.
inline Object& writable(ObjectPtr& object) {
  if (object.use_count() > 1) object = copy(*object);
  return const_cast<Object&>(*object);
}

}  // namespace verisim::scene
