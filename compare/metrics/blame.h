// What the wrong pixels of a picture have in common: which objects, textures, lights and features they show more often
// than the right ones do.
#pragma once

#include <string>
#include <vector>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

// What a renderer says about the pixels of a scene: for each pixel a set of tags.
struct PixelTags {
  struct Tag {
    std::string kind;  // "object", "copy" (an object with its place), "parent" (a CSG object
                       // around it, with its place), "shape", "texture", "light", "feature",
                       // "coincidence" (objects that a ray meets in one place), "passed object" (whose box it crosses),
                       // "caster" (what stands between the point and a light)
    std::string name;  // "torus (scene.pov:12)", "granite", "lit by light at <0, 5, 0>", "reflection" ...
  };
  int width = 0, height = 0;  // of the picture
  int step = 1;               // every step-th pixel of every step-th row, from the upper left corner
  std::vector<Tag> tags;
  std::vector<std::vector<int>> sets;  // indices into tags
  std::vector<int> set_of;             // index into sets, row by row: ceil(width / step) of them a row
  struct Tree {
    int x = 0, y = 0;
    std::string text;  // `verisim explain` of this pixel
  };
  std::vector<Tree> trees;  // of the pixels that were asked for
  // A term of the pixels' colour, in linear light: what one light adds, what is seen in mirrors, ... Terms overlap.
  struct Part {
    // "light", "highlights", "own light", "reflection", "transparency", "radiosity", "fog" ...; "light elsewhere": the
    // part of the light of that name that mirrors and glass show
    std::string kind;
    std::string name;          // "light at <0, 5, 0>"
    std::vector<float> light;  // red, green and blue of each pixel of set_of
  };
  std::vector<Part> parts = {};
  // What is seen first at each pixel of set_of, three numbers each; zeros where that is nothing. Empty: not known.
  struct Surfaces {
    std::vector<float> point, normal;  // in the scene's space; the perturbed normal, towards the viewer, of length 1
    std::vector<float> diffuse;        // what its layers make of white light from straight above
  };
  Surfaces surfaces = {};
};

// Throws PictureMismatch when these are the tags of a picture of another size.
void require_fitting(const PixelTags& tags, int width, int height);

// One object of the scene, by what is seen of it directly.
struct ObjectError {
  std::string name;
  double pixels_pct = 0;                   // of the picture
  double bad_pct = 0;                      // of its pixels: beyond the limit
  double rmse = 0, bias = 0, max_abs = 0;  // 8-bit units, over its pixels
  double share = 0;                        // 0..1: its part of the squared difference of the picture
  int worst_x = 0, worst_y = 0;
};

// A tag that bad pixels have more often than good ones.
struct CommonTag {
  std::string kind, name;
  double bad_pct = 0, good_pct = 0;  // of the bad (good) pixels: those that have it
  double correlation = 0;            // phi coefficient of "has the tag" and "is bad", 0..1
};

struct Blame {
  std::uint64_t bad = 0, good = 0;   // pixels that were looked at
  double limit = 0;                  // difference from which a pixel is bad, 8-bit units
  std::vector<ObjectError> objects;  // largest share first
  std::vector<CommonTag> common;     // largest correlation first, those of at least 0.1
};

// A pixel is bad when a channel differs by more than `limit`. When no more than one pixel in 10,000 does, the
// difference is smaller than that but may be everywhere: the limit is then 0.05 code values. Throws PictureMismatch
// when the pictures, or picture and tags, differ in size.
Blame blame(const Picture& reference, const Picture& test, const PixelTags& tags, double limit = 1);

}  // namespace verisim::compare
