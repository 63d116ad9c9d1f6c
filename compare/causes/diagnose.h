// What kind of fault makes two pictures differ: suspects, the surest first (docs/comparison.md).
#pragma once

#include <vector>

#include "compare/causes/suspicion.h"
#include "compare/metrics/blame.h"
#include "compare/metrics/metrics.h"

namespace verisim::compare {

// Empty when the pictures are equal or nothing is convincing. `reference_tags`, `test_tags`: what the pixels show, by
// the word of the reference's renderer and of the judged one; null: not known. Throws PictureMismatch.
std::vector<Suspicion> diagnose(const Picture& reference, const Picture& test,
                                const PixelTags* reference_tags = nullptr, const PixelTags* test_tags = nullptr);

}  // namespace verisim::compare
