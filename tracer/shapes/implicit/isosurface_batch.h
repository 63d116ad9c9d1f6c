// The search for intersections of an isosurface along eight rays in step: every ray visits the nodes that it visits
// alone (isosurface.cpp), in the same order, but for those of which it is known beforehand what comes of them. So it
// finds the same, and the steepest slope of all rays is the same.
#pragma once

#include <cstdint>

#include "tracer/functions/program.h"
#include "tracer/math/ray_batch.h"
#include "tracer/scene/object.h"
#include "tracer/shapes/implicit/curvature_map.h"

namespace verisim::shapes {

inline constexpr int kMaxHalvings = 50;

// The nodes that eight rays are at, and the way to them. A search of lane k is set up in begin ... sign; `slope` is the
// slope bound along its ray. What it finds is in `hit`, where meanwhile lanes that home in have the end of their node.
struct alignas(64) SearchPacket {
  static constexpr int kCount = RayPacket::kCount;
  double origin[3][kCount], direction[3][kCount];  // in object space
  double begin[kCount], end[kCount], width[kCount], value0[kCount], value1[kCount], slope[kCount], sign[kCount];
  double root_width[kCount], hit[kCount];
  double steepest[kCount];  // change of the function over a node, for its width: the largest that any ray is known to
                            // have met
  std::int64_t place[kCount], unit[kCount];  // where the node begins and how long it is, in 2^-50 of the root
  std::int64_t depth[kCount], active[kCount], found[kCount];  // the last two: 0 or -1
  // The ray in cells of the map, the most cells along an axis for a distance, its speed squared, and the largest second
  // derivative along it anywhere.
  double cell_origin[3][kCount], cell_step[3][kCount], reach[kCount], speed2[kCount], bend_anywhere[kCount];
  // Lanes that look for the only intersection in their node, closer and closer: limits of it and of the distance in
  // which the function falls by one, the next place to look at and the last one.
  std::int64_t homing[kCount], tries[kCount],
      lost[kCount];  // lost: is to be searched again without a map and with exact values
  double low[kCount], high[kCount], fewest[kCount], most[kCount], bend[kCount], grain[kCount];
  double probe[kCount], last[kCount], last_value[kCount];
  double begins[kMaxHalvings + 1][kCount],
      ends[kMaxHalvings + 1][kCount];  // of the nodes above: where they begin, and the value where they end
  double accuracy = 0, threshold = 0;
  const CurvatureMap* map = nullptr;  // what is known of the function's second derivatives; null: nothing
  // How far values are at most from exact ones. Lanes that would have to know them better are lost, too.
  double doubt = 0;
};

// Where rays enter and leave the container, and through which faces (ContainerSpan); the length of their directions.
// The interval to be searched, and the values at its ends.
struct alignas(64) EntryPacket {
  double enter[SearchPacket::kCount], leave[SearchPacket::kCount], speed[SearchPacket::kCount];
  std::int64_t enter_face[SearchPacket::kCount], leave_face[SearchPacket::kCount];
  double begin[SearchPacket::kCount], end[SearchPacket::kCount], at_begin[SearchPacket::kCount],
      at_end[SearchPacket::kCount];
};

// Sets of lanes. What values are like: below zero, below what counts as near the surface, so on either side, not known
// well enough to say.
struct Judged {
  unsigned negative, below, close, doubtful;
};
// What intervals are like: begin at the accuracy or before it, begin before it, are as long as it, can be searched by
// lanes.
struct Intervals {
  unsigned within, before, enough, usual;
};

struct IsosurfaceKernels {
  // Sets up the rays in object space, where they are in the map, and the slopes they may have and are known to have;
  // those that meet the container. The matrix may be null.
  unsigned (*enter)(SearchPacket& packet, EntryPacket& entry, const RayPacket& rays, const scene::Contained& container,
                    const Affine* to_object, double max_gradient, double steepest);
  Intervals (*intervals)(const SearchPacket& packet, const EntryPacket& entry);
  // The points at distances t; and what is found there: of the lanes that were asked for it is kept.
  void (*place)(const SearchPacket& packet, const double* t, double* points);
  Judged (*judge)(const SearchPacket& packet, const double* found, double near_zero, unsigned active_mask,
                  double* values);
  // Sets up a search of the intervals.
  void (*set_up)(SearchPacket& packet, const EntryPacket& entry, unsigned active_mask, bool open);
  // Where nodes want to know the value: mostly in the middle.
  void (*middles)(const SearchPacket& packet, double* points);
  // Begins at the roots; the lanes that want the value in the middle of their node.
  unsigned (*start)(SearchPacket& packet, unsigned active_mask);
  // Goes on with the values in the middles. A lane that ends has found the surface at `hit`, or nothing.
  unsigned (*advance)(SearchPacket& packet, const double* values);
  // Unit normals in the world, not inverted, from the values at points and at a step along each axis from there: eight
  // each.
  void (*normals)(const double* values, const Affine* to_object, double* normals);
};

// Those of the best instruction set of this machine.
const IsosurfaceKernels& isosurface_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const IsosurfaceKernels* isosurface_kernels(int instruction_set);

// A function evaluated at eight points, again and again.
class FieldPacket {
 public:
  static constexpr std::size_t kMaxRegisters = 256;
  // Programs for which this is worth while.
  static const functions::Program* suitable(const Function* function);
  explicit FieldPacket(const functions::Program& program);
  // x, y and z of the points, eight each.
  double* points() { return registers_; }
  // The values at the points of the lanes that are active; or approximately, as ProgramKernels::approximate.
  const double* evaluate(unsigned active_mask, bool approximate);

 private:
  const functions::Program& program_;
  alignas(64) double registers_[kMaxRegisters * SearchPacket::kCount];
};

// The values at eight points, x, y and z, and at a step from them along each axis: eight each. The program is suitable.
void evaluate_around(const functions::Program& program, const double (&points)[3][SearchPacket::kCount], double step,
                     unsigned active_mask, double* values);

// The lanes of `active` that find the surface; where is `hit`. Those that are lost found nothing, which means
// nothing.
unsigned find_intersections(FieldPacket& field, SearchPacket& packet, unsigned active_mask);

}  // namespace verisim::shapes
