// The parts of a blob along one ray, and along eight at once. Compiled for several instruction sets.
#pragma once

#include "tracer/scene/sharing.h"
#include "tracer/shapes/packet_kernels.h"

namespace verisim::accel {
class Bvh;
}

namespace verisim::shapes {

enum class BlobPartKind : unsigned char { sphere, cylinder, base, apex };

struct BlobPart {
  BlobPartKind kind;
  bool moved = false;  // `transform` counts: always, but for spheres
  std::int32_t component = 0;
  Vec3 center;                                 // in the part's own space, where the axis of cylinders is z
  double length = 0;                           // of a cylinder, from z = 0
  double radius2 = 0, k0 = 0, k1 = 0, k2 = 0;  // field = k0 D^2 + k1 D + k2 of the squared distance D
  scene::Rare<Transform> transform;            // shared by the parts of a capsule
};

// A part is within reach for t0 < t < t1 along rays; no more than `peak` does it add to the field, but for rounding.
// `scale2` is the squared length of the direction beside the squared radius, `whole_end` where the line of a ray leaves
// the sphere or the endless cylinder that the part is cut from. Half spheres may lie behind rays: then t0 is negative.
struct alignas(64) PiecePacket {
  using Lane = double[RayPacket::kCount];
  Lane t0, t1, scale2, peak, whole_end;
  const BlobPart* part;
  unsigned met, behind;  // by these lanes; of these
};

// The same of the endless line along one ray: any part may lie behind the ray's start, or around it.
struct RayPiece {
  double t0, t1, scale2, peak, whole_end;
};

// Spheres around eight parts; behind the last part stand spheres that nothing meets.
struct alignas(64) PartSpheres {
  double x[8] = {}, y[8] = {}, z[8] = {}, radius[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
};

inline constexpr double kShortestInterval = 1e-10;  // of the way of a ray through a blob

// Where the pieces of eight rays may have roots: the field less the threshold, in powers of a place between 0 and 1.
struct alignas(64) IntervalPacket {
  using Lane = double[RayPacket::kCount];
  Lane from, to, power[5];
  unsigned lanes;  // those that have this interval
};
// A place u is at (u span + start) / scale, in the world.
struct alignas(64) IntervalLists {
  static constexpr std::size_t kMaxPieces = 24;
  IntervalPacket::Lane start, span;
  std::size_t count = 0;
  IntervalPacket intervals[2 * kMaxPieces];  // from near to far in each lane
};
// What is looked for.
struct IntervalQuery {
  double threshold;
  double too_near;          // in the world: what ends before is of no interest, what begins before needs care
  const double *from, *to;  // of each lane, in the world: what lies beyond may be left out
  bool first;               // of each lane the first one will do
};

struct BlobKernels {
  // The parts, as bits, that rays may meet: they start within `apart` of the origin, and their directions are within
  // `bent` of the direction, in proportion to its length.
  std::uint64_t (*near)(const PartSpheres* spheres, std::size_t blocks, const Vec3& origin, const Vec3& direction,
                        double apart, double bent);
  // The parts, as bits, that may reach a point.
  std::uint64_t (*around)(const PartSpheres* spheres, std::size_t blocks, const Vec3& p);
  // Fills `pieces` with those of `near` that any lane of `active` meets; how many.
  std::size_t (*pieces)(const BlobPart* parts, std::uint64_t near, const LocalPacket& rays, unsigned active,
                        PiecePacket* pieces);
  // The same for all parts, which are found by a tree; more than `most`: there is no room for all of them.
  std::size_t (*pieces_in_tree)(const BlobPart* parts, const accel::Bvh& tree, const LocalPacket& rays, unsigned active,
                                PiecePacket* pieces, std::size_t most);
  // Whether the line of one ray comes within reach of a part, and where.
  bool (*piece)(const BlobPart& part, const Vec3& origin, const Vec3& direction, RayPiece& piece);
  // The intervals of some lanes that lie in front of their rays, of kMaxPieces pieces at most, in the order of parts.
  void (*intervals)(const PiecePacket* const* pieces, std::size_t count, const LocalPacket& rays, unsigned lanes,
                    const IntervalQuery& query, IntervalLists& found);
  // The place of each of some numbers, which are none of them NaN, among all in order; equal ones keep theirs. Numbers
  // are read and places written eight at a time.
  void (*ranks)(const double* numbers, int count, double* places);
};

// Those of the best instruction set of this machine.
const BlobKernels& blob_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const BlobKernels* blob_kernels(int instruction_set);

}  // namespace verisim::shapes
