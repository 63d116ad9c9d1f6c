// A vector of plain values that grows where it lies, if it can, instead of moving into twice the memory: for lists of
// millions that nothing else is allocated beside.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
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
    void* const moved = resized(data_.get(), capacity_ * sizeof(T), count * sizeof(T));
    static_cast<void>(data_.release());  // it is freed
    data_ = Data(static_cast<T*>(moved), Free{count * sizeof(T)});
    capacity_ = count;
  }

 private:
  static constexpr std::size_t kFirst = 256;
  // Blocks of so many bytes have pages of their own, which the kernel moves to where there is room for more: several
  // lists that grow side by side on the heap would have to be copied past each other, again and again.
  static constexpr std::size_t kOwnPages = std::size_t{1} << 20;

  struct Free {
    std::size_t bytes = 0;
    void operator()(T* p) const {
      if (bytes < kOwnPages)
        std::free(p);
      else
        ::munmap(p, bytes);
    }
  };
  using Data = std::unique_ptr<T, Free>;

  static void* resized(void* old, std::size_t old_bytes, std::size_t bytes) {
    const bool had_pages = old && old_bytes >= kOwnPages, wants_pages = bytes >= kOwnPages;
    if (!had_pages && !wants_pages) {
      void* const block = std::realloc(old, bytes);
      return block ? block : throw std::bad_alloc();
    }
    void* block;
    if (had_pages && wants_pages) {
      block = ::mremap(old, old_bytes, bytes, MREMAP_MAYMOVE);
    } else {
      block = wants_pages ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)
                          : std::malloc(bytes);
    }
    if (!block || block == MAP_FAILED) throw std::bad_alloc();
    if (had_pages != wants_pages && old) {
      std::memcpy(block, old, std::min(old_bytes, bytes));
      Free{old_bytes}(static_cast<T*>(old));
    }
    return block;
  }

  Data data_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace verisim
