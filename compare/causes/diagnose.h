// What kind of fault makes two pictures differ: hypotheses are fitted to the pair, and the one that explains most of
// the difference is named.
#pragma once

#include <string>
#include <vector>

#include "compare/causes/suspicion.h"
#include "compare/metrics/metrics.h"

namespace verisim::compare {

// Most convincing first; empty when the pictures are equal or nothing explains at least half of the difference. Throws
// PictureMismatch.
std::vector<Suspicion> diagnose(const Picture& reference, const Picture& test);

// The same for a part of the picture (mask: one byte a pixel): only hypotheses about values, not about places.
std::vector<Suspicion> diagnose_part(const Picture& reference, const Picture& test,
                                     const std::vector<unsigned char>& mask);

}  // namespace verisim::compare
