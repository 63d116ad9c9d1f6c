// The iteration of a Julia fractal at several points of a ray, or of a batch of rays, at once. Every lane does what the
// plain code of julia_fractal.cpp does, operation by operation, so the results are the same to the last bit whatever
// the machine's vectors.
#pragma once

#include <cstdint>

#include "tracer/shapes/julia/julia_algebra.h"
#include "tracer/shapes/packet_kernels.h"

namespace verisim::shapes::julia {

inline constexpr int kLanes = 8;
inline constexpr double kFine = 1e-7;  // tolerance of depths

// A ray a lane, in the fractal's space, directions of unit length.
struct alignas(64) Rays {
  double origin[3][kLanes], direction[3][kLanes];
  void set(int lane, const Vec3& o, const Vec3& d) {
    for (int i = 0; i < 3; ++i) origin[i][lane] = o[i], direction[i][lane] = d[i];
  }
};

// Where the march of each ray begins and must end; behind `last` it finds nothing, and behind `limit` it is of no use.
struct alignas(64) Interval {
  double begin[kLanes], end[kLanes], last[kLanes], limit[kLanes];
};

// Where the set can be: cells of a cube.
struct Grid {
  static constexpr int kSide = 32;
  double low = 0, cell = 0;                // the cube's lower corner (in each coordinate) and the side of a cell
  std::uint64_t rows[kSide * kSide] = {};  // bit i of row k kSide + j: cell (i, j, k) may hold points of the set
  Box3 box;                                // encloses all such cells

  void add(int i, int j, int k) { rows[k * kSide + j] |= std::uint64_t{1} << i; }
  bool has(int i, int j, int k) const { return rows[k * kSide + j] >> i & 1; }
};

// A point a lane.
struct alignas(64) Points {
  double at[3][kLanes];
  void set(int lane, const Vec3& p) {
    for (int i = 0; i < 3; ++i) at[i][lane] = p[i];
  }
  Vec3 operator[](int lane) const { return {at[0][lane], at[1][lane], at[2][lane]}; }
};

// Rays on their way through the grid.
struct alignas(64) RaysInGrid {
  Rays rays;
  Interval interval;
};

// Normals at points from which the iteration escapes, of functions and reciprocals: they hang on what a search leaves
// behind the escape. In the fractal's space and of any length, of the lanes whose bits are set.
struct alignas(64) NormalsOfSearch {
  unsigned lanes = 0;
  Points normals;
};

struct Kernels {
  // What the next four halvings of a ray's way from a point may ask for, as a heap of 15 bits: whether the point in the
  // middle survives all iterations; after bit n comes 2 n + 1 for the nearer half, 2 n + 2 for the farther one. Of
  // powers.
  unsigned (*halvings)(const Field& field, const Vec3& from, const Vec3& direction, double width);
  // Bit k: points[k] survives all iterations; and how far a ray of that direction may go from each point (spec 04
  // section 8, step estimates): exact where above the precision, else anything not above it.
  unsigned (*march)(const Field& field, const Points& points, const Vec3& direction, double* estimate);
  // The lanes of `active` that meet cells of the grid within the bounding sphere, each as far as t_max; null: a grid
  // that is full.
  unsigned (*enter)(const Grid* grid, double radius, const LocalPacket& rays, unsigned active, const double* t_max,
                    RaysInGrid& entered);
  // Rays of a packet that march in step, each with the steps it takes alone: the lanes of `active` whose rays cross the
  // surface, the depths and points of their first intersections, and the normals that the search keeps, unless null:
  // these of at most kMostKept iterations.
  static constexpr int kMostKept = 64;
  unsigned (*first_intersections)(const Field& field, const Rays& rays, const Interval& interval, unsigned active,
                                  double* depth, Points& points, NormalsOfSearch* normals);
};

// Those of the best instruction set of this machine.
const Kernels& kernels();
// Those of any set, for tests; null: this machine cannot run it.
const Kernels* kernels(int instruction_set);

}  // namespace verisim::shapes::julia
