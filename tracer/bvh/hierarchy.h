// POV-Ray's bounding hierarchy, for one purpose: which of several surfaces in the same place is seen (spec 08 A).
//
// POV-Ray keeps objects in a tree of boxes in single precision, takes boxes out of a queue by the distance at which the
// ray enters them, and stops when that distance exceeds the best hit so far. A surface that lies in the face of its own
// box is therefore often never asked, although it is nearer by a rounding error. Rays that meet two surfaces so near to
// each other that this matters repeat that search; all others never come here.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "tracer/math/vec.h"
#include "tracer/scene/object.h"

namespace verisim::accel {

// Surfaces nearer to each other than this part of their distance from the ray's origin are in the same place.
inline constexpr double kCoincident = 1e-5;

class Hierarchy {
 public:
  struct Item {
    std::uint32_t entry;
    scene::Bounds bounds;
    bool infinite;
  };
  Hierarchy() = default;
  explicit Hierarchy(std::vector<Item> items);

  // Calls visit(entry) for entries in POV-Ray's order; it returns the distance of the best hit so far, initially
  // `best`.
  template <class Visit>
  void search(const Ray& ray, double best, Visit&& visit) const {
    Queue queue;
    const Slabs slabs(ray);
    double root_key;
    if (!nodes_.empty() && (nodes_[root_].infinite || slabs.enters(nodes_[root_].bounds, root_key)))
      queue.push({kFirst, root_});
    while (!queue.empty()) {
      const Waiting next = queue.pop();
      if (next.key > best) return;
      const Node& node = nodes_[next.node];
      if (node.count == 0) {
        best = visit(node.first);
        continue;
      }
      for (std::uint32_t i = 0; i < node.count; ++i) {
        const std::uint32_t child = children_[node.first + i];
        double key = kFirst;
        if (nodes_[child].infinite || slabs.enters(nodes_[child].bounds, key)) queue.push({key, child});
      }
    }
  }

  // Whether POV-Ray's test lets a ray into one box.
  static bool enters(const Ray& ray, const scene::Bounds& bounds) {
    double key;
    return Slabs(ray).enters(bounds, key);
  }

  // All entries in the order in which POV-Ray comes to those around a point: into each box as it is met.
  std::vector<std::uint32_t> in_turn() const;

  // The following ask for this once, and entries to be the places of their items.
  void find_parents();
  // Whether a search that finds nothing before `best` comes to `entry`: rounding refuses rays that graze an edge of its
  // box, or moves boxes that are far away behind `best`.
  bool reaches(const Ray& ray, std::uint32_t entry, double best = HUGE_VAL) const;
  struct Found {
    std::uint32_t entry;
    double t;
  };
  // Which of the hits of some entries (two or more), in their order, is left by a search that finds nothing else nearer
  // than `best`; their number: none.
  std::size_t settle(const Ray& ray, double best, std::span<const Found> hits) const;

 private:
  static constexpr double kFirst = -1e7;  // the key of the root and of what has no box

  struct Node {
    scene::Bounds bounds;
    std::uint32_t first = 0;       // of children_; of a leaf: its entry
    std::uint32_t count : 31 = 0;  // none: a leaf
    std::uint32_t infinite : 1 = false;
  };
  struct Waiting {
    double key;
    std::uint32_t node;
  };
  // A binary heap that exchanges equal keys as POV-Ray's does. Searches nest (an entry may search a hierarchy of its
  // own); each has the end of one list that the thread keeps.
  class Queue {
   public:
    Queue() : list_(thread_list()), begin_(list_.size()) {}
    ~Queue() { list_.resize(begin_); }
    Queue(const Queue&) = delete;
    Queue& operator=(const Queue&) = delete;

    bool empty() const { return list_.size() == begin_; }
    void push(const Waiting& item);
    Waiting pop();

   private:
    static std::vector<Waiting>& thread_list();

    std::vector<Waiting>& list_;
    const std::size_t begin_;
  };
  // POV-Ray's test of a box, in single precision.
  class Slabs {
   public:
    explicit Slabs(const Ray& ray);
    bool enters(const scene::Bounds& bounds, double& key) const;

   private:
    float origin_[3], inverse_[3];
    int sign_[3];
  };

  // The largest key on the way from the root to an entry, after which the search asks it; false: it does not come
  // there.
  bool comes_to(const Slabs& slabs, std::uint32_t entry, double& key) const;
  // Whether the nearest are hits at the same distance, in equal boxes.
  bool any_copies(std::span<const Found> hits) const;
  std::size_t settle_by_search(const Ray& ray, double best, std::span<const Found> hits) const;

  // A node and its box, side by side for sorting.
  struct Boxed {
    scene::Bounds bounds;
    std::uint32_t node;
  };
  static std::size_t longest_axis(std::span<const Boxed> range);
  static void sort_by_middle(std::span<Boxed> range, std::size_t axis);
  Boxed add_node(std::span<const Boxed> children);
  void split(std::span<Boxed> range, std::span<double> areas, std::vector<Boxed>& nodes);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> children_, parents_;
  std::uint32_t root_ = 0;
};

}  // namespace verisim::accel
