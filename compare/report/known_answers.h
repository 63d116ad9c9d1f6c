// Scenes whose pixels mathematics knows: who is nearer to it.
#pragma once

#include <string>

#include "compare/compare.h"

namespace verisim::compare {

// "off the known answer by 0.00001 (verisim) and 0.00340 (POV-Ray): verisim is nearer"; empty when none is known.
std::string known_answer(const SceneResult& scene, const Run& run);
// "known answers: verisim is nearer in 2 scenes, POV-Ray in 1, both are as near in 18"; empty when none is known.
std::string known_answers(const Run& run);

}  // namespace verisim::compare
