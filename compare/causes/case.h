// Two pictures whose difference is to be explained, with what is known of their pixels; and one way to score a suspect.
//
// A hypothesis either undoes the fault, or rather repeats it: it predicts the test picture from the reference, and
// `explained` is the part of the squared difference that the prediction makes go away. Or it only says where: then it
// is the part that lies there. Either way it predicts that some pixels are wrong, and `precision` is the part of them
// that are. A suspect is as sure as both allow, and a hypothesis that says less about the cause counts less.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "compare/causes/suspicion.h"
#include "compare/metrics/blame.h"
#include "compare/metrics/values.h"

namespace verisim::compare {

using Pixel = std::array<float, 3>;
using Pixels = std::vector<Pixel>;        // row by row
using Mask = std::vector<unsigned char>;  // the same order

// How much a hypothesis says when it holds: factors of `sure`.
namespace weight {
inline constexpr double kKnown = 1;       // what both programs say of their pixels agrees with it
inline constexpr double kRepaired = 0.9;  // the difference is undone by a few numbers
inline constexpr double kPlace = 0.7;     // where, and what is there
inline constexpr double kVague = 0.35;    // where alone
}  // namespace weight

struct Tags {
  const PixelTags* reference = nullptr;  // of the reference's renderer
  const PixelTags* test = nullptr;       // of the judged one
  const PixelTags* any() const { return reference ? reference : test; }
  bool both() const { return reference && test; }
};

class Case {
 public:
  // Throws PictureMismatch when sizes differ, those of the tags, too.
  Case(const Picture& reference, const Picture& test, const Tags& tags = {});

  int width = 0, height = 0;   // of what follows: large pictures are reduced
  int reduced = 1;             // by this factor
  Pixels reference, test;      // code values, 0..255; not a number reads as black
  std::vector<float> squared;  // of the difference, of each pixel
  Mask wrong;                  // beyond `limit`
  double total = 0, limit = 0;
  // Any formula fits few wrong pixels, or those of hardly more than one colour: where what they show is known, formulas
  // count less.
  double tested = 1;
  std::size_t wrong_count = 0, nan_count = 0;
  Tags tags;

  std::size_t size() const { return reference.size(); }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  std::size_t clamped(int x, int y) const { return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1)); }

  // `within`: the fault is known to be in these pixels only, the others stay as the reference has them.
  Suspicion repaired(std::string what, std::string detail, const Pixels& predicted, double weight) const;
  Suspicion repaired(std::string what, std::string detail, const std::function<Pixel(std::size_t)>& predict,
                     double weight, const Mask* within = nullptr) const;
  Suspicion placed(std::string what, std::string detail, const Mask& mask, double weight) const;

  // The index of the tags' set that pixel i belongs to; -1: none.
  int set_of(const PixelTags& tags, std::size_t i) const;
  Mask pixels_with(const PixelTags& tags, const std::function<bool(const PixelTags::Tag&)>& wanted) const;
  // Three numbers of every pixel, of a part's light or of surfaces; zeros where there are none.
  Pixels numbers_of(const PixelTags& tags, const std::vector<float>& numbers) const;

 private:
  PixelRuns full_size(const Mask& mask) const;
  int full_width_ = 0, full_height_ = 0;
};

inline float squared_distance(const Pixel& a, const Pixel& b) {
  const float r = a[0] - b[0], g = a[1] - b[1], c = a[2] - b[2];
  return r * r + g * g + c * c;
}
Mask dilated(const Case& c, const Mask& mask, int radius);
inline bool is_sky(const PixelTags::Tag& tag) { return tag.name.starts_with("sky"); }  // seen directly or in mirrors
double share_of(const Case& c, const Mask& mask);                                      // of the squared difference
double part_of_right(const Case& c, const Mask& mask);  // how many of the pixels that are not wrong
double part_of_wrong(const Case& c, const Mask& mask);
// "sphere (s.pov:3)", which shows nearly all of the mask; empty: several do.
std::string owner_of(const Case& c, const PixelTags& tags, const Mask& mask);
// Pixels that show one surface, or none: what is wrong in a mirror or behind glass may have its cause anywhere. All,
// where few of the wrong ones are such.
Mask directly_seen(const Case& c, const PixelTags& tags);

}  // namespace verisim::compare
