// The frame-level objects of a scene: what POV-Ray tests rays against one by one (spec 03 2.3, 5.5).
#pragma once

#include <vector>

#include "tracer/scene/scene.h"

namespace verisim::accel {

struct FrameList {
  std::vector<const scene::Object*> objects;  // unions dissolved where POV-Ray dissolves them; no light sources
  std::vector<scene::ObjectPtr> texts;        // unions of letters that stand for them: the scene does not have these
  std::vector<bool> copied;                   // each of the objects, or a union around it, is a copy of a declared one
  std::vector<const scene::Object*> whole;    // of each the dissolved union whose texture it has; null: none
  std::vector<const scene::LightSource*> lights;  // that light the whole scene, in file order
  std::size_t entries = 0;                        // as POV-Ray counts them: light sources included
};

FrameList frame_list(const scene::Scene& scene, bool split_unions);

}  // namespace verisim::accel
