// A CSG object with all that it is made of as one flat tree: eight rays, or one, go through its solids together, and
// hits are tested against the others in place. Finds what spec 03 section 5 says: the nearest of the children's hits
// that pass the inside tests, of those at equal distance the last.
//
// Simple solids are computed here, with the operations of the shapes themselves in the same order; what else the object
// is made of is asked.
#pragma once

#include <memory>
#include <vector>

#include "tracer/shapes/convex.h"
#include "tracer/shapes/csg/interior_proxy.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/swept/straight_prism.h"

namespace verisim::shapes {

// In preorder. Spans of other lists are first index and count.
struct CsgNode {
  enum class Kind : std::uint8_t {
    intersection,
    sum,
    simple,
    prism,
    core,  // a solid that rays cross once, and of which only what is within it shows
    run,   // some children of the node above, for the box around them
    other
  };
  Kind kind = Kind::other;
  bool plain = false;        // simple, without clips
  bool boxed = false;        // worth a look at its box first
  bool boxed_solid = false;  // of everything outside `solid` it is known whether it is inside:
  bool far_is_inside = false;
  bool turned = false;                          // of equally near hits of its own the first wins
  unsigned hidden = 0;                          // from kinds of rays, as bits
  std::uint32_t end = 0;                        // the node behind it and what is below it
  std::uint32_t children = 0, child_count = 0;  // CsgTree::children: those of CSG objects, cheap ones first
  std::uint32_t clips = 0, clip_count = 0;      // CsgTree::children: what is not inside all of these is cut away
  std::uint32_t tests = 0, test_count = 0;      // CsgTree::tests: what hits have to pass
  SimpleSolid simple;
  Box3 box;    // where its surface is, a little larger
  Box3 solid;  // not of simple solids
  const Shape* shape = nullptr;
  const Convex* convex = nullptr;               // of the core
  const StraightPrism::Walls* walls = nullptr;  // of a prism
};

// A hit survives if it is inside (or outside) of another node.
struct CsgTest {
  std::uint32_t node;
  bool inside;
  unsigned hidden = 0;  // from kinds of rays that need not pass
};

struct CsgQuery {
  RayKind kind;
  double t_min;
  const double* t_max;   // of each lane
  const Guards* guards;  // of the object, or null
  const Clips* outer;    // of the unions around it, or null

  bool clipped() const { return (guards && !guards->clips.empty()) || outer; }
  bool within_clips(const Vec3& p) const { return (!guards || guards->contain(p)) && (!outer || outer->contain(p)); }
};

class CsgTree;

// `hits`: null if any hit will do. The lanes that are hit, or whether the ray is.
struct CsgKernels {
  unsigned (*eight)(const CsgTree& tree, const RayPacket& rays, const CsgQuery& query, Hit* hits);
  bool (*one)(const CsgTree& tree, const Ray& ray, const CsgQuery& query, Hit* hit);
};
// Those of the best instruction set of this machine.
const CsgKernels& csg_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const CsgKernels* csg_kernels(int instruction_set);

class CsgTree {
 public:
  static constexpr int kBest = -1;
  static constexpr int kMin = 2;  // rays that are worth being asked together

  // Of an object whose children are compiled; null if it has too many parts.
  // `limit`: outside of it nothing shows; may be infinite. `proxies`: rooms that are cut out of it. `instruction_set`:
  // the best, or any for tests (null: not on this machine).
  static std::unique_ptr<const CsgTree> of(const Shape& csg, std::span<const std::unique_ptr<Shape>> children,
                                           const Box3& limit, std::span<const InteriorProxy> proxies,
                                           int instruction_set = kBest);
  // Of a simple solid and its clips, for rays that its bounds admit; null: the shape is none.
  static std::unique_ptr<const CsgTree> of_guarded(const Shape& shape);

  // Lanes that are hit, and where.
  unsigned nearest(const RayPacket& rays, const CsgQuery& query, Hit* hits) const;
  bool nearest(const Ray& ray, const CsgQuery& query, Hit& hit) const;
  // Lanes with any hit.
  unsigned occluded(const RayPacket& rays, const CsgQuery& query) const;
  bool occluded(const Ray& ray, const CsgQuery& query) const;

  // For the kernels.
  std::vector<CsgNode> nodes;  // behind the end of the first: clip objects, which are not part of the object
  std::vector<std::uint32_t> children;
  std::vector<CsgTest> tests;
  std::vector<InteriorProxy> proxies;
  Box3 limit;
  bool bounded = false;  // by `limit`
  bool any_boxed = false, any_other = false;
  std::uint32_t core = 0;  // its node, 0: none

 private:
  struct Builder;
  explicit CsgTree(const CsgKernels& kernels) : kernels_(kernels) {}
  const CsgKernels& kernels_;
};

// Which kinds of rays do not see a child of an undissolved union or of a merge (spec 03 5.5), as bits.
unsigned hidden_from(const scene::Object& child, bool merge);

}  // namespace verisim::shapes
