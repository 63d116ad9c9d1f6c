#include "compare/causes/suspicion.h"

#include <algorithm>

namespace verisim::compare {

PixelRuns runs_of(const std::vector<unsigned char>& mask) {
  PixelRuns out;
  for (auto at = mask.begin(); at != mask.end();) {
    const bool inside = out.size() % 2 == 1;
    const auto end = std::find_if(at, mask.end(), [inside](unsigned char m) { return (m != 0) != inside; });
    out.push_back(static_cast<std::uint32_t>(end - at));
    at = end;
  }
  if (out.size() % 2 == 1) out.pop_back();  // the rest does not belong
  return out;
}

std::vector<unsigned char> mask_of(const PixelRuns& runs, std::size_t pixels) {
  std::vector<unsigned char> out(pixels);
  std::size_t at = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t end = std::min<std::size_t>(pixels, at + runs[i]);
    if (i % 2 == 1)
      std::fill(out.begin() + static_cast<std::ptrdiff_t>(at), out.begin() + static_cast<std::ptrdiff_t>(end), 1);
    at = end;
  }
  return out;
}

}  // namespace verisim::compare
