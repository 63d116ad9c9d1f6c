#include "tracer/accel/box_tree.h"

#include <stdexcept>

#include "tracer/accel/device.h"

namespace verisim::accel {
namespace {

// Of the diagonal of everything: what rounding a ray to binary32 and following it across the volume can amount to, several times over.
constexpr double kSlack = 2e-6;
constexpr std::size_t kWidth = 4;

// What Embree's builder makes: inner nodes with up to four children, leaves with one box.
struct BuildNode {
  bool leaf = false;
  unsigned count = 0, index = 0;
  RTCBounds bounds[kWidth];
  BuildNode* children[kWidth];
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned count, void*) {
  auto* node = new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
  node->count = count;
  return node;
}
void set_children(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<BuildNode*>(node)->children[i] = static_cast<BuildNode*>(children[i]);
}
void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<BuildNode*>(node)->bounds[i] = *bounds[i];
}
void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t, void*) {
  auto* node = new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
  node->leaf = true;
  node->index = primitives[0].primID;
  return node;
}

void set_box(BoxNode& node, std::size_t k, const RTCBounds& b) {
  const float values[6] = {b.lower_x, b.lower_y, b.lower_z, b.upper_x, b.upper_y, b.upper_z};
  for (int i = 0; i < 6; ++i) node.planes[i][k] = values[i];
}

BoxNode empty_node() {
  BoxNode node;
  for (std::size_t k = 0; k < kWidth; ++k) {
    node.child[k] = 0;
    // A box that no ray meets, without infinities: those would make NaN.
    for (int i = 0; i < 6; ++i) node.planes[i][k] = i < 3 ? 3e37f : -3e37f;
  }
  return node;
}

void flatten(const BuildNode& from, std::uint32_t place, std::vector<BoxNode>& nodes) {
  for (unsigned k = 0; k < from.count; ++k) {
    const BuildNode& child = *from.children[k];
    set_box(nodes[place], k, from.bounds[k]);
    if (child.leaf) {
      nodes[place].child[k] = BoxNode::kLeaf | child.index;
      continue;
    }
    const auto next = static_cast<std::uint32_t>(nodes.size());
    nodes[place].child[k] = next;
    nodes.push_back(empty_node());
    flatten(child, next, nodes);
  }
}

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) {
  if (boxes.empty()) return;
  for (const Box3& box : boxes) bounds_.extendBy(box);
  center_ = bounds_.center();
  slack_ = kSlack * length(bounds_.max - bounds_.min) + std::numeric_limits<float>::min();
  bounds_.min -= Vec3(slack_), bounds_.max += Vec3(slack_);

  std::vector<RTCBuildPrimitive> primitives(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 low = boxes[i].min - center_ - Vec3(slack_), high = boxes[i].max - center_ + Vec3(slack_);
    RTCBuildPrimitive& p = primitives[i];
    p.lower_x = round_down(low.x), p.lower_y = round_down(low.y), p.lower_z = round_down(low.z);
    p.upper_x = -round_down(-high.x), p.upper_y = -round_down(-high.y), p.upper_z = -round_down(-high.z);
    p.geomID = 0;
    p.primID = static_cast<unsigned>(i);
  }
  nodes_.push_back(empty_node());
  if (boxes.size() <= kWidth) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const RTCBuildPrimitive& p = primitives[k];
      set_box(nodes_[0], k, {p.lower_x, p.lower_y, p.lower_z, 0, p.upper_x, p.upper_y, p.upper_z, 0});
      nodes_[0].child[k] = BoxNode::kLeaf | static_cast<std::uint32_t>(k);
    }
    return;
  }

  RTCBVH bvh = rtcNewBVH(device());
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.byteSize = sizeof(arguments);
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = kWidth;
  arguments.maxDepth = 60;  // the walk's stack holds three waiting children per level
  arguments.minLeafSize = arguments.maxLeafSize = 1;
  arguments.bvh = bvh;
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  const auto* root = static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
  if (!root) {
    rtcReleaseBVH(bvh);
    throw std::runtime_error("the bounding hierarchy could not be built");
  }
  nodes_.reserve(boxes.size() / 2 + 1);
  flatten(*root, 0, nodes_);
  rtcReleaseBVH(bvh);
}

}  // namespace verisim::accel
