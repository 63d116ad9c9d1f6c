// Holds the flat tree of a CSG object (csg/csg_tree.h), which is made when the first ray asks for it: most objects of a
// large scene are never met, or only as parts of others' trees. Any number of threads may ask at once.
#pragma once

#include <atomic>
#include <memory>

namespace verisim::shapes {

class CsgTree;

class TreeOnDemand {
 public:
  TreeOnDemand() = default;
  TreeOnDemand(const TreeOnDemand&) = delete;
  ~TreeOnDemand();

  // make() is CsgTree::of with the arguments of the object; null, for good: it gave none.
  template <class Make>
  const CsgTree* get(Make&& make) const {
    if (!known_.load(std::memory_order_acquire)) [[unlikely]]
      keep(make());
    return tree_.load(std::memory_order_relaxed);
  }

 private:
  // Threads that ask at the same time make the same tree; the first is kept.
  void keep(std::unique_ptr<const CsgTree> made) const;

  mutable std::atomic<const CsgTree*> tree_{nullptr};
  mutable std::atomic<bool> known_{false};
};

}  // namespace verisim::shapes
