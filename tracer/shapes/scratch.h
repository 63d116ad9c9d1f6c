// A interval of a list that this thread keeps: queries nest, and each takes the end of one growing list, so nothing is
// allocated per ray once it has grown.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace verisim::shapes {

// `Tag` keeps lists of the same type apart. Elements may only be added while no later interval of the same list is in
// use.
template <class T, class Tag = T>
class Scratch {
 public:
  Scratch() : list_(thread_list()), begin_(list_.end) {}
  ~Scratch() { list_.end = begin_; }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void add(const T& value) { add() = value; }
  // One with any value, to be written where it lies: a copy of what was just put together waits for its parts.
  T& add() {
    if (list_.end == list_.storage.size()) grow();
    ++size_;
    return list_.storage[list_.end++];
  }
  // The same for several in a row.
  T* add_many(std::size_t count) {
    while (list_.end + count > list_.storage.size()) grow();
    T* const first = list_.storage.data() + list_.end;
    list_.end += count, size_ += count;
    return first;
  }
  void pop() {
    --list_.end;
    --size_;
  }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return list_.storage[begin_ + i]; }
  const T& operator[](std::size_t i) const { return list_.storage[begin_ + i]; }
  template <class Less = std::less<>>
  void sort(Less less = {}) {
    const auto first = list_.storage.begin() + static_cast<std::ptrdiff_t>(begin_);
    std::sort(first, first + static_cast<std::ptrdiff_t>(size_), less);
  }

 private:
  struct List {
    std::vector<T> storage;
    std::size_t end = 0;
  };
  static List& thread_list() {
    thread_local List list;
    return list;
  }
  [[gnu::noinline]] void grow() { list_.storage.resize(2 * list_.storage.size() + 64); }

  List& list_;
  const std::size_t begin_;
  std::size_t size_ = 0;
};

}  // namespace verisim::shapes
