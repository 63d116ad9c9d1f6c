#pragma once

#include <atomic>
#include <memory>

namespace verisim::shapes {

class CsgTree;

// The tree of an object, made when the first ray asks: most objects of a large scene are never met, or only as parts of
// others' trees.
class TreeOnDemand {
 public:
  TreeOnDemand() = default;
  TreeOnDemand(const TreeOnDemand&) = delete;
  ~TreeOnDemand();

  // make() is CsgTree::of with the arguments of the object.
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
