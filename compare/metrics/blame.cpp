// Every tag divides the pixels in two, and so does "is wrong": the phi coefficient (Pearson's correlation of two
// yes-or-no variables) says how well the two divisions agree. It is 1 when exactly the bad pixels have the tag, and 0
// when the tag is as frequent among the good ones.
#include "compare/metrics/blame.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compare/metrics/rounding.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

constexpr double kSmallLimit = 0.05, kFewBad = 1e-4, kWorthNaming = 0.1;

struct Sums {
  double squares = 0, difference = 0;
  std::uint64_t pixels = 0, bad = 0;
  double worst = 0;
  int x = 0, y = 0;
};

struct PixelError {
  double largest = 0, squares = 0, difference = 0;
};

PixelError error_at(const Values& a, const Values& b, int x, int y) {
  const bool known = a.finite(x, y), finite = known && b.finite(x, y);
  PixelError e;
  if (!finite) return {255, 3 * 255.0 * 255.0, 0};
  for (const double d : difference(a, b, x, y)) {
    e.largest = std::max(e.largest, std::fabs(d)), e.squares += d * d, e.difference += d;
  }
  return e;
}

}  // namespace

void require_fitting(const PixelTags& tags, int width, int height) {
  if (tags.width != width || tags.height != height || tags.step < 1)
    throw PictureMismatch(
        fmt::format("the tags are those of a picture of {}x{}, not {}x{}", tags.width, tags.height, width, height));
  const int columns = (width + tags.step - 1) / tags.step, rows = (height + tags.step - 1) / tags.step;
  if (tags.set_of.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
    throw PictureMismatch("the tags do not fit their size");
}

Blame blame(const Picture& reference, const Picture& test, const PixelTags& tags, double limit) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  require_fitting(tags, a.width(), a.height());
  const int columns = (tags.width + tags.step - 1) / tags.step, rows = (tags.height + tags.step - 1) / tags.step;

  std::vector<PixelError> errors;
  errors.reserve(tags.set_of.size());
  std::uint64_t beyond = 0;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      errors.push_back(error_at(a, b, i * tags.step, j * tags.step));
      beyond += errors.back().largest > limit + kRounding;
    }
  Blame out;
  out.limit = static_cast<double>(beyond) <= kFewBad * static_cast<double>(errors.size()) ? kSmallLimit : limit;

  const std::size_t count = tags.tags.size();
  std::vector<std::uint64_t> bad_with(count), good_with(count);
  std::map<int, Sums> objects;
  double squares = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const PixelError& e = errors[i];
    const bool bad = e.largest > out.limit + kRounding;
    ++(bad ? out.bad : out.good);
    squares += e.squares;
    const int set = tags.set_of[i];
    if (set < 0 || static_cast<std::size_t>(set) >= tags.sets.size()) continue;
    for (int tag : tags.sets[static_cast<std::size_t>(set)]) {
      if (tag < 0 || static_cast<std::size_t>(tag) >= count) continue;
      ++(bad ? bad_with : good_with)[static_cast<std::size_t>(tag)];
      if (tags.tags[static_cast<std::size_t>(tag)].kind != "object") continue;
      Sums& sums = objects[tag];
      ++sums.pixels, sums.bad += bad, sums.squares += e.squares, sums.difference += e.difference;
      if (e.largest >= sums.worst) {
        sums.worst = e.largest;
        sums.x = static_cast<int>(i % static_cast<std::size_t>(columns)) * tags.step,
        sums.y = static_cast<int>(i / static_cast<std::size_t>(columns)) * tags.step;
      }
    }
  }

  for (const auto& [tag, sums] : objects) {
    const double n = static_cast<double>(sums.pixels);
    out.objects.push_back({tags.tags[static_cast<std::size_t>(tag)].name, 100 * n / static_cast<double>(errors.size()),
                           100 * static_cast<double>(sums.bad) / n, std::sqrt(sums.squares / (3 * n)),
                           sums.difference / (3 * n), sums.worst, squares > 0 ? sums.squares / squares : 0, sums.x,
                           sums.y});
  }
  std::stable_sort(out.objects.begin(), out.objects.end(),
                   [](const ObjectError& x, const ObjectError& y) { return x.share > y.share; });

  if (out.bad == 0 || out.good == 0) return out;
  const double bad = static_cast<double>(out.bad), good = static_cast<double>(out.good);
  for (std::size_t tag = 0; tag < count; ++tag) {
    const double with = static_cast<double>(bad_with[tag] + good_with[tag]), without = bad + good - with;
    if (with == 0 || without == 0) continue;
    const double wb = static_cast<double>(bad_with[tag]), wg = static_cast<double>(good_with[tag]);
    const double phi = (wb * (good - wg) - wg * (bad - wb)) / std::sqrt(bad * good * with * without);
    if (phi >= kWorthNaming)
      out.common.push_back({tags.tags[tag].kind, tags.tags[tag].name, 100 * wb / bad, 100 * wg / good, phi});
  }
  std::stable_sort(out.common.begin(), out.common.end(),
                   [](const CommonTag& x, const CommonTag& y) { return x.correlation > y.correlation; });
  return out;
}

}  // namespace verisim::compare
