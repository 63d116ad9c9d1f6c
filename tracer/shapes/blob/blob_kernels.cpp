#include "tracer/shapes/blob/blob_packet.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/blob/blob_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/math/packet_vector-inl.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

// What a ray is to a part.
struct Course {
  Packet a, b, c, t0, t1;
};

// The lanes that come within reach; sets the interval between the planes of a cylinder or half sphere.
HWY_INLINE Mask meet(const BlobPart& part, PacketVector<Packet> o, PacketVector<Packet> d, Course& course) {
  if (part.moved) {
    const Mat4& inverse = part.transform->inv;
    o = transform_point(inverse, o), d = transform_direction(inverse, d);
  }
  o.x -= part.center.x, o.y -= part.center.y, o.z -= part.center.z;
  course = {dot(d, d), dot(o, d), dot(o, o), 0.0, HUGE_VAL};
  Mask met = Mask::all();
  if (part.kind != BlobPartKind::sphere) {
    const Packet z0 = dot(o, part.axis), dz = dot(d, part.axis);
    if (part.kind == BlobPartKind::cylinder) course.a -= dz * dz, course.b -= z0 * dz, course.c -= z0 * z0;
    const double low = part.kind == BlobPartKind::base ? -HUGE_VAL : 0;
    const double high = part.kind == BlobPartKind::base       ? 0
                        : part.kind == BlobPartKind::cylinder ? part.length
                                                              : HUGE_VAL;
    const Mask across = abs(dz) < kEpsilon;
    met &= ~(across & ((z0 < low) | (z0 > high)));
    const Packet to_low = (low - z0) / dz, to_high = (high - z0) / dz;
    const Mask swapped = to_low > to_high;
    course.t0 = select(across, course.t0, max(course.t0, select(swapped, to_high, to_low)));
    course.t1 = select(across, course.t1, min(course.t1, select(swapped, to_low, to_high)));
  }
  const Mask slanted = course.a > kEpsilon;
  const Packet discriminant = course.b * course.b - course.a * (course.c - part.radius2);
  return met & ((slanted & (discriminant > 0)) | (~slanted & (course.c < part.radius2)));
}

std::uint64_t near_parts(const PartSpheres* spheres, std::size_t blocks, const Vec3& o, const Vec3& d, double apart,
                         double bent) {
  const double size2 = dot(d, d), inverse2 = 1 / size2;
  std::uint64_t near = 0;
  for (std::size_t n = 0; n < blocks; ++n) {
    const PartSpheres& s = spheres[n];
    const Packet x = load(s.x) - o.x, y = load(s.y) - o.y, z = load(s.z) - o.z, radius = load(s.radius);
    const Packet away2 = x * x + y * y + z * z, along = x * d.x + y * d.y + z * d.z,
                 beside2 = away2 - along * along * inverse2;
    Packet reach = radius + apart;
    if (bent > 0) reach += bent * (sqrt(away2) + apart);
    // What is NaN may be anything.
    near |= std::uint64_t{bits((radius >= 0) & ~(beside2 > reach * reach * (1 + 1e-6) + 1e-9 * away2))} << 8 * n;
  }
  return near;
}

std::uint64_t parts_around(const PartSpheres* spheres, std::size_t blocks, const Vec3& p) {
  std::uint64_t around = 0;
  for (std::size_t n = 0; n < blocks; ++n) {
    const PartSpheres& s = spheres[n];
    const Packet x = load(s.x) - p.x, y = load(s.y) - p.y, z = load(s.z) - p.z, radius = load(s.radius),
                 away2 = x * x + y * y + z * z;
    around |= std::uint64_t{bits((radius >= 0) & ~(away2 > radius * radius * (1 + 1e-6)))} << 8 * n;
  }
  return around;
}

std::size_t find_pieces(const BlobPart* parts, std::uint64_t near, const LocalPacket& rays, unsigned active,
                        PiecePacket* pieces) {
  const PacketVector<Packet> o = {load(rays.ox), load(rays.oy), load(rays.oz)},
                             d = {load(rays.dx), load(rays.dy), load(rays.dz)};
  std::size_t found = 0;
  for (; near != 0; near &= near - 1) {
    const BlobPart& part = parts[__builtin_ctzll(near)];
    Course course;
    const Mask within = meet(part, o, d, course);
    if ((bits(within) & active) == 0) continue;
    const Packet a = course.a, b = course.b, c = course.c;
    const Mask slanted = a > kEpsilon;
    const Packet discriminant = b * b - a * (c - part.radius2);
    const Packet root = sqrt(discriminant);
    const Packet t0 = select(slanted, max(course.t0, (-b - root) / a), course.t0),
                 t1 = select(slanted, min(course.t1, (-b + root) / a), course.t1);
    const unsigned met = bits(within & (t1 > t0) & (t1 < HUGE_VAL)) & active;
    if (met == 0) continue;
    PiecePacket& piece = pieces[found++];
    store(piece.t0, t0), store(piece.t1, t1), store(piece.a, a), store(piece.b, b), store(piece.c, c);
    // The field of a positive part is largest where the ray is closest.
    Packet peak{};
    if (part.k2 > 0) {
      const Packet d2 = max(c - b * b / a, Packet{});
      peak = select(slanted, (part.k0 * d2 + part.k1) * d2 + part.k2, part.k2);
    }
    store(piece.peak, peak);
    piece.part = &part, piece.met = met;
  }
  return found;
}

const BlobKernels kKernels = {near_parts, parts_around, find_pieces};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(BlobKernels, blob_kernels)
}  // namespace verisim::shapes
#endif
