// Building: Embree's parallel SAH builder makes the topology, which is then laid out depth first.
#include "tracer/shapes/box_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <stdexcept>

namespace verisim::shapes {

namespace {

RTCDevice device() {
  static const RTCDevice shared = rtcNewDevice(nullptr);
  return shared;
}

struct BuildNode {
  bool leaf = false;
  std::uint32_t count = 0;
};
struct InnerNode : BuildNode {
  BuildNode* children[4];
  RTCBounds bounds[4];
};
struct LeafNode : BuildNode {
  std::uint32_t ids[BoxTree::kMaxLeaf];
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned count, void*) {
  auto* node = new (rtcThreadLocalAlloc(allocator, sizeof(InnerNode), 16)) InnerNode;
  node->count = count;
  return node;
}
void set_children(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<InnerNode*>(static_cast<BuildNode*>(node))->children[i] = static_cast<BuildNode*>(children[i]);
}
void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<InnerNode*>(static_cast<BuildNode*>(node))->bounds[i] = *bounds[i];
}
void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
  auto* node = new (rtcThreadLocalAlloc(allocator, sizeof(LeafNode), 16)) LeafNode;
  node->leaf = true;
  node->count = static_cast<std::uint32_t>(count);
  for (std::size_t i = 0; i < count; ++i) node->ids[i] = primitives[i].primID;
  return static_cast<BuildNode*>(node);
}

float down(double v) {
  const auto f = static_cast<float>(v);
  return f > v ? std::nextafterf(f, -std::numeric_limits<float>::infinity()) : f;
}
float up(double v) {
  const auto f = static_cast<float>(v);
  return f < v ? std::nextafterf(f, std::numeric_limits<float>::infinity()) : f;
}

}  // namespace

struct BoxTreeBuilder {
  BoxTree& tree;

  std::uint32_t lay_out(const BuildNode* source) {
    if (source->leaf) {
      const auto first = static_cast<std::uint32_t>(tree.order_.size());
      const auto* leaf = static_cast<const LeafNode*>(source);
      tree.order_.insert(tree.order_.end(), leaf->ids, leaf->ids + leaf->count);
      return BoxTree::kLeaf | (leaf->count - 1) << 28 | first;
    }
    const auto* inner = static_cast<const InnerNode*>(source);
    const auto index = static_cast<std::uint32_t>(tree.nodes_.size());
    tree.nodes_.push_back(empty_node());
    for (std::uint32_t i = 0; i < inner->count; ++i) {
      const RTCBounds& b = inner->bounds[i];
      const float corners[6] = {b.lower_x, b.upper_x, b.lower_y, b.upper_y, b.lower_z, b.upper_z};
      for (int p = 0; p < 6; ++p) tree.nodes_[index].bounds[p][i] = corners[p];
      const std::uint32_t child = lay_out(inner->children[i]);
      tree.nodes_[index].child[i] = child;
    }
    return index;
  }

  static BoxTree::Node empty_node() {
    BoxTree::Node node;
    for (int p = 0; p < 6; ++p) {
      for (float& v : node.bounds[p]) v = p % 2 == 0 ? std::numeric_limits<float>::max() : -std::numeric_limits<float>::max();
    }
    for (std::uint32_t& c : node.child) c = 0;
    return node;
  }
};

void BoxTree::build(std::vector<Item>& items, std::uint32_t leaf_size) {
  if (items.empty()) return;
  if (items.size() > kFirstMask) throw std::length_error("too many primitives for one tree");
  // Rounding of the ray's origin and direction to float and of the slab distances shifts planes by at most about a dozen float spacings at the largest
  // coordinate that occurs; 2^-20 of it is 16.
  double largest = 0;
  for (int k = 0; k < 3; ++k) largest = std::max({largest, std::fabs(bounds_.min[k]), std::fabs(bounds_.max[k])});
  const double padding = std::ldexp(largest, -20) + 1e-30;
  bounds_.min -= Vec3(padding), bounds_.max += Vec3(padding);

  static_assert(sizeof(Item) == sizeof(RTCBuildPrimitive) && offsetof(Item, upper) == offsetof(RTCBuildPrimitive, upper_x) &&
                offsetof(Item, id) == offsetof(RTCBuildPrimitive, primID));
  for (Item& item : items) {
    for (int k = 0; k < 3; ++k) item.lower[k] = down(item.lower[k] - padding), item.upper[k] = up(item.upper[k] + padding);
  }
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxBranchingFactor = 4;
  arguments.maxDepth = 48;
  arguments.sahBlockSize = 1;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = std::min(leaf_size, kMaxLeaf);
  arguments.traversalCost = 1;
  arguments.intersectionCost = 1;
  arguments.primitives = reinterpret_cast<RTCBuildPrimitive*>(items.data());
  arguments.primitiveCount = items.size();
  arguments.primitiveArrayCapacity = items.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  const RTCBVH bvh = rtcNewBVH(device());
  arguments.bvh = bvh;
  const auto* root = static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
  if (!root) {
    rtcReleaseBVH(bvh);
    throw std::runtime_error("building a bounding volume hierarchy failed");
  }
  order_.reserve(items.size());
  BoxTreeBuilder builder{*this};
  if (root->leaf) {
    nodes_.push_back(BoxTreeBuilder::empty_node());
    const float corners[6] = {down(bounds_.min.x), up(bounds_.max.x), down(bounds_.min.y), up(bounds_.max.y), down(bounds_.min.z), up(bounds_.max.z)};
    for (int p = 0; p < 6; ++p) nodes_[0].bounds[p][0] = corners[p];
    const std::uint32_t child = builder.lay_out(root);
    nodes_[0].child[0] = child;
  } else {
    builder.lay_out(root);
  }
  nodes_.shrink_to_fit();
  rtcReleaseBVH(bvh);
}

}  // namespace verisim::shapes
