#include "tracer/shapes/csg/csg_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "tracer/bvh/bvh.h"

namespace verisim::shapes {
namespace {

constexpr std::size_t kMaxNodes = 512, kMaxTests = 1 << 15;
constexpr std::size_t kMaxAbreast = 160;  // children of one node
// Nodes are looked at one after another. Of many parts side by side, every so many have a box around them, below which
// nothing is looked at that no ray meets.
constexpr std::size_t kRun = 8, kMaxWithoutRuns = 12;

bool bounded(const Shape& shape) { return !shape.object->bounded_by.empty(); }
// CSG objects without bounds.
bool takes_apart(const Shape& shape) { return shape.object->as<scene::Csg>() && !bounded(shape); }
bool is_simple(const Shape& shape) { return !bounded(shape) && shape.simple().form != SimpleSolid::Form::other; }
double surface(const Box3& b) {
  const Vec3 d = b.max - b.min;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}
// Parts so many that only their order could make it worth looking at them run by run, and it does not: the hierarchy of
// a union (ChildIndex) finds those on the way sooner. What is not simple gains more from eight rays together.
bool scattered(std::span<const std::unique_ptr<Shape>> shapes) {
  constexpr std::size_t kFew = 5 * kRun;
  if (shapes.size() <= kFew) return false;
  if (shapes.size() > kMaxAbreast) return true;
  if (2 * std::ranges::count_if(shapes, [](const auto& shape) { return is_simple(*shape); }) < std::ssize(shapes))
    return false;
  Box3 all;
  double of_runs = 0;
  for (std::size_t i = 0; i < shapes.size(); i += kRun) {
    Box3 run;
    for (const auto& shape : shapes.subspan(i, std::min(kRun, shapes.size() - i))) run.extendBy(shape->bounds());
    all.extendBy(run);
    of_runs += surface(run) * static_cast<double>(kRun);
  }
  return !(of_runs < 0.5 * surface(all) * static_cast<double>(shapes.size()));
}
// Nodes of these shapes; no further than to more than kMaxNodes, which are too many.
std::size_t count_nodes(std::span<const std::unique_ptr<Shape>> shapes) {
  if (scattered(shapes)) return kMaxNodes + 1;
  std::size_t count = 0;
  for (auto shape = shapes.begin(); shape != shapes.end() && count <= kMaxNodes; ++shape) {
    ++count;
    if (takes_apart(**shape)) count += count_nodes((*shape)->children());
    if (takes_apart(**shape) || is_simple(**shape)) count += count_nodes((*shape)->clips());
  }
  return count;
}

}  // namespace

struct CsgTree::Builder {
  CsgTree& tree;
  const Shape* admitted = nullptr;             // rays are known to meet its bounds
  std::vector<double> cost{};                  // of an inside test, by node
  std::vector<std::uint32_t> clipped_nodes{};  // whose clips are still to be added

  // With what is below it. `top_child`: all of the object is within it.
  std::uint32_t add(const Shape& shape, bool top_child) {
    const auto index = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.emplace_back();
    cost.push_back(0);
    CsgNode n;
    n.shape = &shape;
    n.box = enlarged(shape.bounds());
    const SolidExtent extent = shape.solid_extent();
    n.solid = extent.box, n.far_is_inside = extent.outside;
    n.boxed_solid = !(extent.box == everywhere());
    double test_cost = 40;
    if (takes_apart(shape)) {
      n.kind = shape.object->as<scene::Csg>()->kind == scene::CsgKind::intersection ? CsgNode::Kind::intersection
                                                                                    : CsgNode::Kind::sum;
      n.boxed = accel::is_finite(n.box);
      test_cost = add_children(n, shape.children(), top_child && n.kind == CsgNode::Kind::intersection);
    } else if (is_simple(shape) || (&shape == admitted && shape.simple().form != SimpleSolid::Form::other)) {
      n.kind = CsgNode::Kind::simple;
      n.simple = shape.simple();
      n.turned = shape.hits_turned() && n.simple.form != SimpleSolid::Form::box;  // boxes turn theirs
      n.plain = shape.clips().empty();
      n.boxed_solid = n.boxed_solid && !n.plain;
      const bool cone = n.simple.form == SimpleSolid::Form::cone, plane = n.simple.form == SimpleSolid::Form::plane;
      n.boxed = (cone || n.simple.form == SimpleSolid::Form::quadric || n.simple.matrix != nullptr) &&
                accel::is_finite(n.box);
      test_cost = (plane ? 1 : cone || n.simple.quadric ? 3 : 2) + (n.simple.matrix ? 2 : 0);
    } else if (const auto* prism = dynamic_cast<const StraightPrism*>(&shape); prism && prism->straight_walls()) {
      n.kind = CsgNode::Kind::prism;
      n.turned = shape.hits_turned();
      n.walls = prism->straight_walls();
      n.boxed = accel::is_finite(n.box);
      test_cost = 10;
    } else if (const auto* convex = dynamic_cast<const Convex*>(&shape);
               convex && top_child && tree.core == 0 && convex->crossed_once()) {
      n.kind = CsgNode::Kind::core;
      n.convex = convex;
      tree.core = index;
    } else {
      n.boxed = accel::is_finite(n.box);
      tree.any_other = true;
    }
    n.end = static_cast<std::uint32_t>(tree.nodes.size());
    if (!shape.clips().empty() && (n.kind != CsgNode::Kind::other)) clipped_nodes.push_back(index);
    if (n.boxed) tree.any_boxed = true;
    tree.nodes[index] = n;
    cost[index] = test_cost;
    return index;
  }
  // Returns what an inside test of all of them costs. `top`: all of the object is within each.
  double add_children(CsgNode& n, std::span<const std::unique_ptr<Shape>> children, bool top) {
    std::uint32_t indices[kMaxAbreast];
    std::uint32_t* end = indices;
    double sum = 0;
    for (std::size_t i = 0; i < children.size(); i += kRun) {
      const auto run = children.subspan(i, std::min(kRun, children.size() - i));
      const std::uint32_t* const first = end;
      const std::optional<std::uint32_t> box =
          children.size() > kMaxWithoutRuns ? std::optional(add_run()) : std::nullopt;
      for (const auto& child : run) {
        *end = add(*child, top);
        sum += cost[*end++];
      }
      if (box) end_run(*box, {first, end});
    }
    cheap_first(indices, end, [](std::uint32_t node) { return node; });
    n.children = static_cast<std::uint32_t>(tree.children.size());
    n.child_count = static_cast<std::uint32_t>(end - indices);
    tree.children.insert(tree.children.end(), indices, end);
    return sum;
  }
  std::uint32_t add_run() {
    tree.nodes.emplace_back();
    tree.nodes.back().kind = CsgNode::Kind::run;
    cost.push_back(0);
    return static_cast<std::uint32_t>(tree.nodes.size() - 1);
  }
  void end_run(std::uint32_t index, std::span<const std::uint32_t> members) {
    CsgNode& run = tree.nodes[index];
    run.end = static_cast<std::uint32_t>(tree.nodes.size());
    for (const std::uint32_t member : members) run.box.extendBy(tree.nodes[member].box);
    run.boxed = accel::is_finite(run.box);
    tree.any_boxed = tree.any_boxed || run.boxed;
  }
  // Those of all nodes, and their own.
  void add_clips() {
    while (!clipped_nodes.empty()) {
      const std::uint32_t node = clipped_nodes.back();
      clipped_nodes.pop_back();
      std::vector<std::uint32_t> clips;
      for (const auto& clip : tree.nodes[node].shape->clips()) clips.push_back(add(*clip, false));
      tree.nodes[node].clips = static_cast<std::uint32_t>(tree.children.size());
      tree.nodes[node].clip_count = static_cast<std::uint32_t>(clips.size());
      tree.children.insert(tree.children.end(), clips.begin(), clips.end());
    }
  }
  // `path`: what hits on this node have to pass on the way up; it is left as it was.
  void add_tests(std::uint32_t index, std::vector<CsgTest>& path) {
    CsgNode& n = tree.nodes[index];
    const std::size_t given = path.size();
    for (std::uint32_t i = 0; i < n.clip_count; ++i) path.push_back({tree.children[n.clips + i], true});
    if (n.kind != CsgNode::Kind::intersection && n.kind != CsgNode::Kind::sum) {
      n.tests = static_cast<std::uint32_t>(tree.tests.size()), n.test_count = static_cast<std::uint32_t>(path.size());
      tree.tests.insert(tree.tests.end(), path.begin(), path.end());
      cheap_first(tree.tests.begin() + n.tests, tree.tests.end(), [](const CsgTest& test) { return test.node; });
      path.resize(given);
      return;
    }
    const bool merge = n.shape->object->as<scene::Csg>()->kind == scene::CsgKind::merge,
               all = n.kind == CsgNode::Kind::intersection;
    const std::span children(tree.children.data() + n.children, n.child_count);
    for (const std::uint32_t child : children)
      tree.nodes[child].hidden = all ? 0 : hidden_from(*tree.nodes[child].shape->object, merge);
    const std::size_t length = path.size();
    for (const std::uint32_t child : children) {
      for (const std::uint32_t other : children)
        if ((all || merge) && other != child) path.push_back({other, all, tree.nodes[other].hidden});
      add_tests(child, path);
      path.resize(length);
    }
    path.resize(given);
  }
  // Sorts by the cost of nodes; equal ones stay as they are. Lists are short.
  template <class Iterator, class NodeOf>
  void cheap_first(Iterator begin, Iterator end, NodeOf&& node_of) const {
    const auto cheaper = [&](const auto& a, const auto& b) { return cost[node_of(a)] < cost[node_of(b)]; };
    for (Iterator i = begin; i != end; ++i) std::rotate(std::upper_bound(begin, i, *i, cheaper), i, i + 1);
  }
  // As BoxSet takes boxes.
  static Box3 enlarged(Box3 box) {
    if (!accel::is_finite(box)) return box;
    for (int axis = 0; axis < 3; ++axis) {
      const double slack =
          2e-6 * length(box.max - box.min) + 1e-9 * std::max(std::fabs(box.min[axis]), std::fabs(box.max[axis]));
      box.min[axis] -= slack, box.max[axis] += slack;
    }
    return box;
  }
};

unsigned hidden_from(const scene::Object& child, bool merge) {
  const auto bit = [](RayKind kind) { return 1u << static_cast<unsigned>(kind); };
  unsigned bits = 0;
  if (child.no_image) bits |= bit(RayKind::refracted) | bit(RayKind::radiosity_refracted);
  if (child.no_image && merge) bits |= bit(RayKind::camera) | bit(RayKind::query);
  if (child.no_reflection) bits |= bit(RayKind::reflected) | bit(RayKind::radiosity_reflected);
  if (child.no_radiosity)
    bits |= bit(RayKind::radiosity) | bit(RayKind::radiosity_refracted) | bit(RayKind::radiosity_reflected);
  if (child.no_shadow) bits |= bit(RayKind::photon);
  return bits;
}

std::unique_ptr<const CsgTree> CsgTree::of(const Shape& csg, std::span<const std::unique_ptr<Shape>> children,
                                           const Box3& limit, std::span<const InteriorProxy> proxies, int set) {
  const CsgKernels* const kernels = set == kBest ? &csg_kernels() : csg_kernels(set);
  if (!kernels) return nullptr;
  const std::size_t count = count_nodes(children);
  if (children.empty() || count > kMaxNodes) return nullptr;
  std::unique_ptr<CsgTree> tree(new CsgTree(*kernels));
  tree->nodes.reserve(1 + count);
  Builder builder{*tree};
  builder.cost.reserve(1 + count);
  tree->nodes.emplace_back();
  builder.cost.push_back(0);
  CsgNode top;
  top.shape = &csg;
  const bool all = csg.object->as<scene::Csg>()->kind == scene::CsgKind::intersection;
  top.kind = all ? CsgNode::Kind::intersection : CsgNode::Kind::sum;
  builder.add_children(top, children, all);
  top.end = static_cast<std::uint32_t>(tree->nodes.size());
  tree->nodes[0] = top;
  builder.add_clips();
  std::vector<CsgTest> path;
  builder.add_tests(0, path);
  if (tree->tests.size() > kMaxTests) return nullptr;
  tree->limit = Builder::enlarged(limit), tree->bounded = !(limit == everywhere());
  tree->proxies.assign(proxies.begin(), proxies.end());
  return tree;
}

std::unique_ptr<const CsgTree> CsgTree::of_guarded(const Shape& shape) {
  const std::size_t count = 2 + count_nodes(shape.clips());
  if (shape.simple().form == SimpleSolid::Form::other || count > kMaxNodes) return nullptr;
  std::unique_ptr<CsgTree> tree(new CsgTree(csg_kernels()));
  tree->nodes.reserve(count);
  Builder builder{.tree = *tree, .admitted = &shape};
  tree->nodes.emplace_back();
  builder.cost.push_back(0);
  const std::uint32_t node = builder.add(shape, false);
  tree->nodes[0].end = static_cast<std::uint32_t>(tree->nodes.size());
  builder.add_clips();
  std::vector<CsgTest> path;
  builder.add_tests(node, path);
  return tree;
}

std::optional<unsigned> Guards::meet(const Shape& shape, const RayPacket& rays, RayKind kind, double t_min,
                                     const double* t_max, Hit* hits) const {
  if (std::popcount(rays.active) < CsgTree::kMin) return std::nullopt;
  // A tree takes longer to make than some hundred rays to ask: not for each of thousands of shapes of few pixels.
  constexpr std::uint8_t kFew = 32;
  if (const std::uint8_t asked = asked_.load(std::memory_order_relaxed); asked < kFew) {
    asked_.store(asked + 1, std::memory_order_relaxed);
    return std::nullopt;
  }
  const CsgTree* const tree = tree_.get([&] { return CsgTree::of_guarded(shape); });
  if (!tree) return std::nullopt;
  const RayPacket admitted{rays.rays, rays.first, bounds.empty() ? rays.active : admit(rays)};
  if (admitted.active == 0) return 0;
  const CsgQuery query{kind, t_min, t_max, nullptr, nullptr};
  return hits ? tree->nearest(admitted, query, hits) : tree->occluded(admitted, query);
}

TreeOnDemand::~TreeOnDemand() { delete tree_.load(std::memory_order_relaxed); }

void TreeOnDemand::keep(std::unique_ptr<const CsgTree> made) const {
  const CsgTree* none = nullptr;
  if (tree_.compare_exchange_strong(none, made.get(), std::memory_order_acq_rel)) made.release();
  known_.store(true, std::memory_order_release);
}

unsigned CsgTree::nearest(const RayPacket& rays, const CsgQuery& query, Hit* hits) const {
  return kernels_.eight(*this, rays, query, hits);
}
bool CsgTree::nearest(const Ray& ray, const CsgQuery& query, Hit& hit) const {
  return kernels_.one(*this, ray, query, &hit);
}
unsigned CsgTree::occluded(const RayPacket& rays, const CsgQuery& query) const {
  return kernels_.eight(*this, rays, query, nullptr);
}
bool CsgTree::occluded(const Ray& ray, const CsgQuery& query) const { return kernels_.one(*this, ray, query, nullptr); }

}  // namespace verisim::shapes
