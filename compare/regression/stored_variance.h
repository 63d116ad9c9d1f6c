// What several runs of a noisy scene looked like: a mean, which is the stored picture, and a standard deviation beside
// it (NAME.deviation-of-4.png, 16 bits). A later render is held against both by itself, as Mitsuba 3 does it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

struct StoredVariance {
  Picture mean, deviation;
  int runs = 0;
};

// Of a stored picture; empty when it is one of a single run. Throws std::runtime_error for damaged files.
std::optional<StoredVariance> read_stored_variance(const std::filesystem::path& picture);
// Of two runs or more: the mean takes the place of the picture. Throws PictureMismatch and std::runtime_error.
void write_stored_variance(const std::vector<Picture>& runs, const std::filesystem::path& picture);
// The file beside a picture that holds its deviation; empty: there is none.
std::filesystem::path deviation_file(const std::filesystem::path& picture);

// For each pixel's luma a prediction by Student's distribution: the render is one more run like the stored ones. A
// variance is at least that of rounding, 1/12. Noise has tails that no four runs know: the render is refused when more
// than 0.25 % of the pixels have a p-value below 0.01, corrected for their number (Sidak); or when the mean of its
// 16x16 blocks is improbable in more than 2 % of the blocks at the same level.
struct ZTest {
  bool rejected = false;
  double pixels_refused = 0, blocks_refused = 0;  // 0..1
  std::vector<float> p;                           // of each pixel, not corrected
  std::string text() const;
};
ZTest z_test(const StoredVariance& stored, const Picture& render);

}  // namespace verisim::compare
