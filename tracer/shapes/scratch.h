// A stretch of a list that this thread keeps: queries nest, and each takes the end of one growing list, so nothing is allocated per ray once it has grown.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace verisim::shapes {

// `Tag` keeps lists of the same type apart. Elements may only be added while no later stretch of the same list is in use.
template <class T, class Tag = T>
class Scratch {
 public:
  Scratch() : list_(thread_list()), begin_(list_.size()) {}
  ~Scratch() { list_.resize(begin_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void add(const T& value) {
    list_.push_back(value);
    ++size_;
  }
  // Adds in order while there are at most `few` elements, at the end after that: sort() then.
  void insert_sorted(const T& value, std::size_t few) {
    add(value);
    if (size_ > few) return;
    T* first = &list_[begin_];
    T* place = first + size_ - 1;
    for (; place > first && value < place[-1]; --place) *place = place[-1];
    *place = value;
  }
  void pop() {
    list_.pop_back();
    --size_;
  }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return list_[begin_ + i]; }
  const T& operator[](std::size_t i) const { return list_[begin_ + i]; }
  template <class Less = std::less<>>
  void sort(Less less = {}) {
    std::sort(list_.begin() + static_cast<std::ptrdiff_t>(begin_), list_.begin() + static_cast<std::ptrdiff_t>(begin_ + size_), less);
  }

 private:
  static std::vector<T>& thread_list() {
    thread_local std::vector<T> list;
    return list;
  }
  std::vector<T>& list_;
  const std::size_t begin_;
  std::size_t size_ = 0;
};

}  // namespace verisim::shapes
