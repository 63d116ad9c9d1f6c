// Eight rays and the parts of a blob: the same bits with every instruction set.
#include "tracer/shapes/blob/blob_packet.h"

#include <algorithm>
#include <numeric>

#include "tracer/shapes/blob/blob_parts.h"
#include "tracer/shapes/packet_test_support.h"

namespace verisim::shapes::testing {
namespace {

class BlobKernel : public EachInstructionSet {};

TEST_P(BlobKernel, MeetsThePartsOfABlobAlike) {
  const BlobKernels *kernels = blob_kernels(GetParam()), &plain = *blob_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::vector<BlobPart> parts(4);
  PartSpheres spheres;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    BlobPart& part = parts[i];
    part.kind = static_cast<BlobPartKind>(i);
    part.center = Vec3(0.2 * double(i), -0.1, 0.3), part.length = 0.7;
    part.radius2 = 0.5, part.k0 = 4, part.k1 = -4, part.k2 = 1;
    part.moved = i == 2, part.transform = Transform::scaling({0.7, 1.2, 0.9});
    spheres.x[i] = part.center.x, spheres.y[i] = part.center.y, spheres.z[i] = part.center.z, spheres.radius[i] = 1.1;
  }
  Rays rays;
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    LocalPacket local;
    packet_kernels(simd::kBaseline)->local(nullptr, {*rays.batches, 0, 255}, local);
    const Ray ray = rays.batches->at(3);
    ASSERT_EQ(kernels->near(&spheres, 1, ray.origin, ray.direction, 0.1, 0.2),
              plain.near(&spheres, 1, ray.origin, ray.direction, 0.1, 0.2));
    const std::uint64_t around = plain.around(&spheres, 1, ray.origin);
    ASSERT_EQ(kernels->around(&spheres, 1, ray.origin), around);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (length(ray.origin - parts[i].center) <= spheres.radius[i]) {
        ASSERT_TRUE(around >> i & 1);
      }
    }
    // What lies near is never left out.
    const std::uint64_t near = plain.near(&spheres, 1, ray.origin, ray.direction, 0, 0);
    PiecePacket a[4], b[4];
    const std::size_t count = kernels->pieces(parts.data(), 15, local, rays.active, a);
    ASSERT_EQ(count, plain.pieces(parts.data(), 15, local, rays.active, b));
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(a[i].part == b[i].part && a[i].met == b[i].met);
      const auto index = static_cast<std::size_t>(a[i].part - parts.data());
      if (a[i].met >> 3 & 1 && !a[i].part->moved) {
        ASSERT_TRUE(near >> index & 1);
      }
      each_lane(a[i].met, [&](int k) {
        ASSERT_TRUE(same(a[i].t0[k], b[i].t0[k]) && same(a[i].t1[k], b[i].t1[k]) && same(a[i].peak[k], b[i].peak[k]) &&
                    same(a[i].scale2[k], b[i].scale2[k]));
        ++met;
      });
    }
  }
  EXPECT_GT(met, 5000);
}

TEST_P(BlobKernel, FindsInATreeWhatRaysMeetOneByOne) {
  const BlobKernels* kernels = blob_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  Rays rays;
  std::uniform_real_distribution<double> u(-1, 1);
  scene::Blob balls;
  for (int i = 0; i < 100; ++i)
    balls.components.push_back({{u(rays.random), u(rays.random), u(rays.random)}, {}, 0.3, 1, false, {}, {}});
  const blob::BlobParts blob(balls);
  std::size_t met = 0;
  for (int round = 0; round < 300; ++round) {
    rays.fill(round, 0);
    LocalPacket local;
    packet_kernels(simd::kBaseline)->local(nullptr, {*rays.batches, 0, 255}, local);
    std::vector<PiecePacket> pieces(blob.parts.size());
    const auto find = [&](std::size_t most) {
      return kernels->pieces_in_tree(blob.parts.data(), blob.tree, local, rays.active, pieces.data(), most);
    };
    const std::size_t count = find(pieces.size());
    unsigned lanes_of[100] = {};
    for (std::size_t i = 0; i < count; ++i) lanes_of[pieces[i].part - blob.parts.data()] = pieces[i].met;
    for (std::size_t i = 0; i < blob.parts.size(); ++i)
      each_lane(rays.active, [&](int k) {
        const Ray ray = rays.batches->at(k);
        RayPiece alone;
        const bool meets = kernels->piece(blob.parts[i], ray.origin, ray.direction, alone);
        ASSERT_EQ(lanes_of[i] >> k & 1, meets) << round << ' ' << i << ' ' << k;
        met += meets;
      });
    if (count > 1) {
      EXPECT_GT(find(count - 1), count - 1) << "no room";
    }
  }
  EXPECT_GT(met, 3000u);
}

TEST_P(BlobKernel, RanksNumbersAsAStableSortDoes) {
  const BlobKernels* kernels = blob_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::mt19937 random(3);
  for (int count = 1; count <= 64; ++count) {
    for (const unsigned different : {1u, 4u, 1000000u}) {
      alignas(64) double numbers[64], places[64];
      for (int i = 0; i < count; ++i) numbers[i] = static_cast<double>(random() % different) - 2;
      kernels->ranks(numbers, count, places);
      std::vector<int> order(static_cast<std::size_t>(count));
      std::iota(order.begin(), order.end(), 0);
      std::ranges::stable_sort(order, {}, [&](int i) { return numbers[i]; });
      for (int place = 0; place < count; ++place)
        ASSERT_EQ(places[order[static_cast<std::size_t>(place)]], place) << count << ' ' << different;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, BlobKernel, all_instruction_sets());

}  // namespace
}  // namespace verisim::shapes::testing
