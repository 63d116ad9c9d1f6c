// A vector of plain values that grows where it lies, if it can, instead of moving into twice the memory: for lists of
// millions that nothing else is allocated beside.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace verisim {

template <class T>
class ReallocVector {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }
  operator std::span<const T>() const { return {data(), size_}; }  // NOLINT(google-explicit-constructor): a view of it

  void push_back(const T& value) {
    if (size_ == capacity_) {
      const T kept = value;  // may lie within
      set_capacity(size_ < kFirst ? kFirst : size_ + size_ / 2);
      data_.get()[size_++] = kept;
    } else {
      data_.get()[size_++] = value;
    }
  }
  void append(std::span<const T> values) {
    reserve(size_ + values.size());
    std::uninitialized_copy(values.begin(), values.end(), end());
    size_ += values.size();
  }
  void reserve(std::size_t count) {
    if (count > capacity_) set_capacity(count);
  }
  // At least the size.
  void set_capacity(std::size_t count) {
    if (count == 0) return;
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_alloc();
    void* const moved = std::realloc(data_.get(), count * sizeof(T));
    if (!moved) throw std::bad_alloc();
    static_cast<void>(data_.release());  // realloc has freed it
    data_.reset(static_cast<T*>(moved));
    capacity_ = count;
  }

 private:
  static constexpr std::size_t kFirst = 256;
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };

  std::unique_ptr<T, Free> data_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace verisim
