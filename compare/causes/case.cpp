#include "compare/causes/case.h"

#include <set>

namespace verisim::compare {
namespace {

constexpr double kMaxCasePixels = 1e6;
constexpr double kFineLimit = 0.1, kCoarseLimit = 0.75;  // code values: with more than 8 bits, and with 8

// The mean of a square of pixels.
Pixel mean_of(const Values& v, int x0, int y0, int side) {
  Pixel sum{};
  int n = 0;
  for (int y = y0; y < std::min(y0 + side, v.height()); ++y)
    for (int x = x0; x < std::min(x0 + side, v.width()); ++x, ++n) {
      const Rgb p = v.finite(x, y) ? v.rgb(x, y) : Rgb{};
      for (std::size_t c = 0; c < 3; ++c) sum[c] += static_cast<float>(p[c]);
    }
  for (float& s : sum) s /= static_cast<float>(n);
  return sum;
}

// Whether the pixels that are wrong by a good part of the largest difference are few, or had, or have, hardly more than
// one colour.
bool few_to_fit(const Case& c) {
  constexpr std::size_t kFew = 4;
  constexpr std::ptrdiff_t kFewPixels = 24;
  constexpr float kGoodPart = 0.01f;  // of the squared difference
  const float most = c.squared.empty() ? 0 : *std::max_element(c.squared.begin(), c.squared.end());
  if (std::ranges::count_if(c.squared, [&](float v) { return v > kGoodPart * most; }) < kFewPixels) return true;
  const auto few = [&](const Pixels& picture) {
    std::set<std::array<int, 3>> colors;
    for (std::size_t i = 0; i < c.size() && colors.size() < kFew; ++i)
      if (c.squared[i] > kGoodPart * most)
        colors.insert({static_cast<int>(picture[i][0] + 0.5f), static_cast<int>(picture[i][1] + 0.5f),
                       static_cast<int>(picture[i][2] + 0.5f)});
    return colors.size() < kFew;
  };
  return few(c.reference) || few(c.test);
}

}  // namespace

Case::Case(const Picture& a, const Picture& b, const Tags& known)
    : tags(known), full_width_(a.width), full_height_(a.height) {
  require_same_size(a, b);
  for (const PixelTags* side : {known.reference, known.test})
    if (side) require_fitting(*side, a.width, a.height);
  const Values p(a), q(b);
  reduced =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(a.width) * a.height / kMaxCasePixels))));
  width = (a.width + reduced - 1) / reduced, height = (a.height + reduced - 1) / reduced;
  limit = p.bits() > 8 && q.bits() > 8 ? kFineLimit : kCoarseLimit;
  const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  reference.reserve(n), test.reserve(n), squared.reserve(n), wrong.reserve(n);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int fx = x * reduced, fy = y * reduced;
      reference.push_back(mean_of(p, fx, fy, reduced)), test.push_back(mean_of(q, fx, fy, reduced));
      const bool finite = p.finite(fx, fy) == q.finite(fx, fy);
      nan_count += !finite;
      squared.push_back(finite ? squared_distance(reference.back(), test.back()) : 3 * 255.0f * 255.0f);
      float largest = 0;
      for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::fabs(reference.back()[c] - test.back()[c]));
      wrong.push_back(!finite || largest > limit);
      wrong_count += wrong.back(), total += squared.back();
    }
  constexpr double kUntested = 0.25;
  if (tags.any() && !tags.both() && few_to_fit(*this)) tested = kUntested;
}

Suspicion Case::repaired(std::string what, std::string detail, const Pixels& predicted, double weight) const {
  double left = 0;
  std::size_t foreseen = 0, right = 0;
  Mask explained(size());
  const auto least = static_cast<float>(limit);
  for (std::size_t i = 0; i < size(); ++i) {
    const float rest = squared_distance(predicted[i], test[i]);
    left += rest;
    float change = 0;
    for (std::size_t c = 0; c < 3; ++c) change = std::max(change, std::fabs(predicted[i][c] - reference[i][c]));
    if (change <= least) continue;
    ++foreseen, right += wrong[i];
    explained[i] = wrong[i] && rest < 0.25f * squared[i];
  }
  Suspicion s{std::move(what), std::move(detail)};
  s.explained = total > 0 ? 1 - left / total : 0;
  s.precision = foreseen ? static_cast<double>(right) / static_cast<double>(foreseen) : 0;
  // What is foreseen and not there is left over, too, and so counts in both.
  s.sure = tested * weight * std::max(0.0, s.explained) * (0.8 + 0.2 * s.precision);
  s.pixels = full_size(explained);
  return s;
}

Suspicion Case::repaired(std::string what, std::string detail, const std::function<Pixel(std::size_t)>& predict,
                         double weight, const Mask* within) const {
  Pixels predicted = reference;
  for (std::size_t i = 0; i < size(); ++i) {
    if (within && !(*within)[i]) continue;
    predicted[i] = predict(i);
    for (float& v : predicted[i]) v = std::clamp(std::isfinite(v) ? v : 0.0f, 0.0f, 255.0f);
  }
  return repaired(std::move(what), std::move(detail), predicted, weight);
}

Suspicion Case::placed(std::string what, std::string detail, const Mask& mask, double weight) const {
  std::size_t foreseen = 0, right = 0;
  Mask explained(size());
  for (std::size_t i = 0; i < size(); ++i)
    if (mask[i]) ++foreseen, right += wrong[i], explained[i] = wrong[i];
  Suspicion s{std::move(what), std::move(detail)};
  s.explained = share_of(*this, mask);
  s.precision = foreseen ? static_cast<double>(right) / static_cast<double>(foreseen) : 0;
  s.sure = weight * s.explained * s.precision;
  s.pixels = full_size(explained);
  return s;
}

int Case::set_of(const PixelTags& t, std::size_t i) const {
  const int x = static_cast<int>(i % static_cast<std::size_t>(width)) * reduced,
            y = static_cast<int>(i / static_cast<std::size_t>(width)) * reduced;
  const int columns = (t.width + t.step - 1) / t.step;
  const auto at =
      static_cast<std::size_t>(y / t.step) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x / t.step);
  return at < t.set_of.size() ? t.set_of[at] : -1;
}

Mask Case::pixels_with(const PixelTags& t, const std::function<bool(const PixelTags::Tag&)>& wanted) const {
  Mask of_tag, of_set, out(size());
  for (const PixelTags::Tag& tag : t.tags) of_tag.push_back(wanted(tag));
  for (const std::vector<int>& set : t.sets)
    of_set.push_back(std::any_of(set.begin(), set.end(), [&](int tag) {
      return tag >= 0 && static_cast<std::size_t>(tag) < of_tag.size() && of_tag[static_cast<std::size_t>(tag)];
    }));
  for (std::size_t i = 0; i < size(); ++i)
    if (const int set = set_of(t, i); set >= 0 && static_cast<std::size_t>(set) < of_set.size())
      out[i] = of_set[static_cast<std::size_t>(set)];
  return out;
}

Pixels Case::numbers_of(const PixelTags& t, const std::vector<float>& numbers) const {
  Pixels out(size());
  const int columns = (t.width + t.step - 1) / t.step;
  for (std::size_t i = 0; i < size(); ++i) {
    const int x = static_cast<int>(i % static_cast<std::size_t>(width)) * reduced,
              y = static_cast<int>(i / static_cast<std::size_t>(width)) * reduced;
    const auto at = 3 * (static_cast<std::size_t>(y / t.step) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(x / t.step));
    if (at + 2 < numbers.size()) out[i] = {numbers[at], numbers[at + 1], numbers[at + 2]};
  }
  return out;
}

PixelRuns Case::full_size(const Mask& mask) const {
  if (reduced == 1) return runs_of(mask);
  Mask full(static_cast<std::size_t>(full_width_) * static_cast<std::size_t>(full_height_));
  for (int y = 0; y < full_height_; ++y)
    for (int x = 0; x < full_width_; ++x)
      full[static_cast<std::size_t>(y) * static_cast<std::size_t>(full_width_) + static_cast<std::size_t>(x)] =
          mask[at(x / reduced, y / reduced)];
  return runs_of(full);
}

Mask dilated(const Case& c, const Mask& mask, int radius) {
  Mask rows(mask.size()), out(mask.size());
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      for (int i = std::max(0, x - radius); i <= std::min(c.width - 1, x + radius) && !rows[c.at(x, y)]; ++i)
        rows[c.at(x, y)] = mask[c.at(i, y)];
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      for (int j = std::max(0, y - radius); j <= std::min(c.height - 1, y + radius) && !out[c.at(x, y)]; ++j)
        out[c.at(x, y)] = rows[c.at(x, j)];
  return out;
}

double part_of_right(const Case& c, const Mask& mask) {
  std::size_t with = 0;
  for (std::size_t i = 0; i < c.size(); ++i) with += mask[i] && !c.wrong[i];
  const std::size_t right = c.size() - c.wrong_count;
  return right > 0 ? static_cast<double>(with) / static_cast<double>(right) : 0;
}

double part_of_wrong(const Case& c, const Mask& mask) {
  std::size_t with = 0;
  for (std::size_t i = 0; i < c.size(); ++i) with += mask[i] && c.wrong[i];
  return c.wrong_count > 0 ? static_cast<double>(with) / static_cast<double>(c.wrong_count) : 0;
}

std::string owner_of(const Case& c, const PixelTags& tags, const Mask& mask) {
  constexpr double kNearlyAll = 0.95;
  const auto count = [](const Mask& m) { return static_cast<double>(std::count(m.begin(), m.end(), 1)); };
  for (const PixelTags::Tag& tag : tags.tags) {
    if (tag.kind != "object") continue;
    Mask both = c.pixels_with(tags, [&](const PixelTags::Tag& other) { return &other == &tag; });
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] && mask[i];
    if (count(both) > kNearlyAll * count(mask)) return tag.name;
  }
  return "";
}

Mask directly_seen(const Case& c, const PixelTags& tags) {
  constexpr double kLeastPart = 0.2, kLeast = 12;
  Mask out = c.pixels_with(tags, [](const PixelTags::Tag& tag) { return tag.kind == "secondary object"; });
  for (unsigned char& v : out) v = !v;
  const double part = part_of_wrong(c, out);
  return part < kLeastPart || part * static_cast<double>(c.wrong_count) < kLeast ? Mask(c.size(), 1) : out;
}

double share_of(const Case& c, const Mask& mask) {
  double sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += mask[i] ? c.squared[i] : 0;
  return c.total > 0 ? sum / c.total : 0;
}

}  // namespace verisim::compare
