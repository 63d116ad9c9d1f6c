// `verisim explain SCENE`: what the wrong pixels of a scene have in common; `--reduce`: after it was made as small as
// it can be without losing the difference.
#pragma once

#include <string>
#include <vector>

namespace verisim::cli {

struct SceneExplanation {
  bool replay = false;
  std::string oracle, native;  // programs; empty: povray in PATH, and this one
  bool reduce = false;
  std::string reduce_to;  // empty: SCENE.reduced.pov beside the scene
  double seconds = 60;    // for the reduction and the suspects together
};

// `words`: a scene and switches. Returns the exit status.
int explain_scene(const std::vector<std::string>& words, const SceneExplanation& options);

}  // namespace verisim::cli
