// Whose picture is most like the photograph: each renderer's own, fitted to it by itself, so that none gains from
// another one's exposure.
#pragma once

#include "compare/regression/renders.h"

namespace verisim::compare {

// Of the judged picture, whose figures are known already, and of those of request.beside, in this order. What goes
// wrong with one of them is told in its place.
std::vector<Likeness> likenesses(const SceneRequest& request, const Picture& photograph, const Metrics& judged,
                                 const RunOptions& options, const Renders& renders);

}  // namespace verisim::compare
