// The 27 tilings of the x-z plane (spec 05 section 9.1).
#pragma once

#include <array>
#include <vector>

#include "tracer/math/vec.h"

namespace verisim::textures {

// One convex tile of a periodic tiling.
struct Tile {
  // Signed distance to an edge, positive inside, in units of the distance at which the tile is flat: n . p - c.
  struct Edge {
    double nx, nz, c;
  };
  std::vector<Edge> edges;
  double top = 1;      // value where min(1, distance) is 0: (class + 1) / number of classes
  double step = 1;     // 1 / number of classes
  double offset = 0;   // added everywhere in the tile
  double minimum = 0;  // lower bound of the value
  int rank = 0;        // where it shares a border
};

// Tilings 1 .. 24: tiles that cover the cell spanned by two lattice vectors.
struct Tiling {
  double lattice[2][2], inverse[2][2];
  std::vector<Tile> tiles;
  bool mirrored = false;  // tiling 12: folded about the middle of a 6 x 6 cell first
  // Whose a point on a border is: that of the tile in this direction, or, where it is zero, of the tile first listed.
  Vec2 lean{0, 0};
  double border = 0;       // how near to an edge is on it: more than 0 where the lattice has no exact coordinates
  bool ranked = false;     // a point on a border is in the tile of the highest rank
  bool exchanged = false;  // tiling 3: its two classes are, where x is a whole number
  int level_line = 0;      // tilings 19 and 20: the number; on z = 0 they lean either way
  int seams = 0;           // tilings 12 to 14: the number; lines between their cells belong to no tile
  double fold = 0;         // tilings 6, 11, 15 and 18: period to which what lies hardly below 0 is folded
  bool sided = false;      // what lies hardly below z = 0 is in the tile below
  int number = 0;
};

// Built on first use; 1 <= number <= 24. Null for the Penrose tilings 25 .. 27.
const Tiling* periodic_tiling(int number);

double evaluate_tiling(const Tiling& tiling, double x, double z);
// 25 .. 27 (penrose.cpp).
double penrose_tiling(int number, double x, double z);

}  // namespace verisim::textures
