// The outline of an object in one picture, looked for in another.
#pragma once

#include "compare/causes/case.h"

namespace verisim::compare {

// Pairs of neighbours on both sides of a mask's border, where they differ in the picture that has the object.
class Outline {
 public:
  Outline(const Case& c, const Mask& mask, const Pixels& picture);

  struct Place {
    double dx = 0, dy = 0;  // pixels: right, down
    double zoom = 1;        // about the middle of the mask
  };
  // The part of the pairs that are found in a picture at a place: the inner one looks as it did, the outer one does
  // not. 0 where too little of the outline shows to tell.
  double found_at(const Place& place, const Pixels& picture) const;
  // Where most of them are, within `reach` pixels and a third in size.
  Place best(int reach, const Pixels& picture) const;

 private:
  struct Pair {
    double in_x, in_y, out_x, out_y;
    Pixel inside;
    float contrast;  // squared distance of the colours
  };
  const Case& c_;
  double middle_x_ = 0, middle_y_ = 0;
  std::vector<Pair> pairs_;
};

}  // namespace verisim::compare
