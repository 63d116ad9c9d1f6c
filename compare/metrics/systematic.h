// Differences that all go to one side. A finish that is 1 % darker moves no pixel by a code value, and no limit on
// pixels or on their mean sees it on a small or a dark object; but it moves nearly all pixels of the object the same
// way. Last bits and coincident surfaces move some pixels, to either side. That is a sign test.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/metrics/blame.h"
#include "compare/metrics/metrics.h"

namespace verisim::compare {

// The largest group of connected pixels (also by their corners) that go to one side in one channel. A missing bit of an
// outline is such a group, too. Where noise goes to both sides its groups touch those of the other side everywhere:
// half of such contacts are taken off a group's pixels. Takes rows from the top, and remembers one.
class OneSidedGroups {
 public:
  // The side of each pixel of the next row: -1, 0 or 1.
  void add_row(const std::vector<signed char>& sides);
  struct Group {
    std::int64_t pixels = 0, contacts = 0;
    int x = 0, y = 0;  // one of its pixels
    std::int64_t size() const { return pixels - contacts / 2; }
  };
  Group largest() const;

 private:
  std::size_t root(std::size_t group) const;
  void join(std::size_t a, std::size_t b);
  void touch(std::size_t a, std::size_t b) { ++groups_[root(a)].contacts, ++groups_[root(b)].contacts; }
  void meet(std::size_t own, int side, const std::vector<signed char>& sides, const std::vector<std::size_t>& groups,
            int x);
  void forget_finished(std::vector<std::size_t>& of_pixel);

  std::vector<signed char> above_;
  std::vector<std::size_t> of_pixel_;  // the groups of the row above
  std::vector<std::size_t> parents_;
  std::vector<Group> groups_;  // those that touch the row above
  Group finished_;             // the largest of the others
  int y_ = 0;
};

// The object that leans most, of those whose leaning is no chance (SignTest::leans). A pixel's object is the one that
// it shows directly. Throws PictureMismatch when the pictures, or picture and tags, differ in size.
struct LeaningObject {
  std::string name;
  SignTest signs;
};
std::optional<LeaningObject> leaning_object(const Picture& reference, const Picture& test, const PixelTags& tags,
                                            double limit);

}  // namespace verisim::compare
