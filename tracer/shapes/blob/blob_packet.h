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
// `scale2` is the squared length of the direction beside the squared radius. Half spheres may lie behind rays: then t0
// is negative, and `whole_end` is where the line leaves the whole sphere.
struct alignas(64) PiecePacket {
  using Lane = double[RayPacket::kCount];
  Lane t0, t1, scale2, peak, whole_end;
  const BlobPart* part;
  unsigned met, behind;  // by these lanes; of these
};

// The same of one ray.
struct RayPiece {
  double t0, t1, scale2, peak;
};

// Of the endless line along a ray, which may lie behind the ray's start. `whole_end`: where it leaves the sphere or the
// endless cylinder that the part is cut from.
struct LinePiece {
  double t0, t1, whole_end;
};

// Spheres around eight parts; behind the last part stand spheres that nothing meets.
struct alignas(64) PartSpheres {
  double x[8] = {}, y[8] = {}, z[8] = {}, radius[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
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
  // Whether one ray comes within reach of a part, and where.
  bool (*piece)(const BlobPart& part, const Vec3& origin, const Vec3& direction, RayPiece& piece);
  bool (*line_piece)(const BlobPart& part, const Vec3& origin, const Vec3& direction, LinePiece& piece);
  // The place of each of some numbers, which are none of them NaN, among all in order; equal ones keep theirs. Numbers
  // are read and places written eight at a time.
  void (*ranks)(const double* numbers, int count, double* places);
};

// Those of the best instruction set of this machine.
const BlobKernels& blob_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const BlobKernels* blob_kernels(int instruction_set);

}  // namespace verisim::shapes
