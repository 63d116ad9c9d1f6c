#include "tracer/shapes/blob/sphere_order.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace verisim::shapes::blob {
namespace {

constexpr std::size_t kLeafSize = 4;  // ranges of so few spheres are not divided

// A sphere with the parts below it, from left to right.
struct Node {
  BoundingSphere sphere;
  std::vector<std::uint32_t> parts;
};

// The smallest sphere around two.
BoundingSphere around(const BoundingSphere& a, const BoundingSphere& b) {
  const Vec3 way = b.center - a.center;
  const double distance = length(way);
  if (distance + b.radius <= a.radius) return a;
  if (distance + a.radius <= b.radius) return b;
  const double radius = 0.5 * (distance + a.radius + b.radius);
  return {a.center + (radius - a.radius) / distance * way, radius};
}

Node node_of(std::span<Node> range) {
  Node all = std::move(range[0]);
  for (Node& node : range.subspan(1)) {
    all.sphere = around(all.sphere, node.sphere);
    all.parts.insert(all.parts.end(), node.parts.begin(), node.parts.end());
  }
  return all;
}

// That in which the centres lie farthest apart.
int longest_axis(std::span<const Node> range) {
  Vec3 low = range[0].sphere.center, high = low;
  for (const Node& node : range)
    for (int a = 0; a < 3; ++a)
      low[a] = std::min(low[a], node.sphere.center[a]), high[a] = std::max(high[a], node.sphere.center[a]);
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
  return axis;
}

// How many spheres of a sorted range go to the left; all: it is not divided.
std::size_t left_part(std::span<const Node> range) {
  const std::size_t n = range.size();
  if (n <= kLeafSize) return n;
  const auto square = [](const BoundingSphere& s) { return s.radius * s.radius; };
  std::vector<double> right(n);
  BoundingSphere sphere = range[n - 1].sphere;
  for (std::size_t i = n; i-- > 0;) {
    sphere = around(sphere, range[i].sphere);
    right[i] = square(sphere);
  }
  double least = right[0] * (static_cast<double>(n) - 3);
  std::size_t best = n;
  sphere = range[0].sphere;
  for (std::size_t i = 1; i < n; ++i) {
    sphere = around(sphere, range[i - 1].sphere);
    const double cost = static_cast<double>(i) * square(sphere) + static_cast<double>(n - i) * right[i];
    if (cost < least) least = cost, best = i;
  }
  return best;
}

void split(std::span<Node> range, std::vector<Node>& nodes) {
  const int axis = longest_axis(range);
  std::stable_sort(range.begin(), range.end(),
                   [axis](const Node& a, const Node& b) { return a.sphere.center[axis] < b.sphere.center[axis]; });
  const std::size_t left = left_part(range);
  if (left == range.size()) return nodes.push_back(node_of(range));
  split(range.first(left), nodes);
  split(range.subspan(left), nodes);
}

}  // namespace

std::vector<std::uint32_t> order_of(const std::vector<BoundingSphere>& spheres) {
  std::vector<Node> level;
  // POV-Ray sorts stably what it keeps from the last to the first.
  for (std::size_t i = spheres.size(); i-- > 0;) level.push_back({spheres[i], {static_cast<std::uint32_t>(i)}});
  do {
    std::vector<Node> next;
    split(level, next);
    level = std::move(next);
  } while (level.size() > 1);
  return level[0].parts;
}

}  // namespace verisim::shapes::blob
