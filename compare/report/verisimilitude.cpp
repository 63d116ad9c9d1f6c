#include "compare/report/verisimilitude.h"

#include <fmt/format.h>

namespace verisim::compare {

std::string verisimilitude(const SceneResult& s, const Run& run) {
  const auto name = [&](const Likeness& l) { return l.renderer.empty() ? run.test_name : l.renderer; };
  const Likeness* nearest = nullptr;
  std::string out;
  for (const Likeness& l : s.verisimilitude) {
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", name(l),
                       l.failed.empty() ? fmt::format("{:.3f}", l.ciede2000_mean) : "failed (" + l.failed + ")");
    if (l.failed.empty() && (!nearest || l.ciede2000_mean < nearest->ciede2000_mean)) nearest = &l;
  }
  if (out.empty() || !nearest) return "";
  return fmt::format("verisimilitude (mean CIEDE2000): {}: {} is nearest", out, name(*nearest));
}

}  // namespace verisim::compare
