// Small holders for what most objects of a scene do not have: one pointer wide instead of the value, because a scene
// has hundreds of thousands of objects.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace verisim::scene {

// A value that may be absent and that copies share until one of them is written. An absent value reads as a default
// one.
template <class T>
class Rare {
 public:
  Rare() = default;
  Rare(T value)
      : block_(new Block(std::move(value))) {}  // NOLINT(google-explicit-constructor): assigned like the value itself
  Rare(const Rare& other) : block_(other.block_) {
    if (block_) block_->uses.fetch_add(1, std::memory_order_relaxed);
  }
  Rare(Rare&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  Rare& operator=(const Rare& other) {
    Rare copy(other);
    std::swap(block_, copy.block_);
    return *this;
  }
  Rare& operator=(Rare&& other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  // Whatever the value can be assigned from.
  template <class U>
  requires(!std::is_same_v<std::remove_cvref_t<U>, Rare> && std::is_constructible_v<T, U>) Rare& operator=(U&& value) {
    return *this = Rare(T(std::forward<U>(value)));
  }
  ~Rare() { reset(); }

  explicit operator bool() const { return block_ != nullptr; }
  bool has_value() const { return block_ != nullptr; }
  const T& operator*() const { return block_ ? block_->value : absent(); }
  const T* operator->() const { return &**this; }
  operator const T&() const { return **this; }  // NOLINT(google-explicit-constructor): read like the value itself
  T value_or(const T& other) const { return block_ ? block_->value : other; }

  // For writing: an absent value is made first, a shared one is copied.
  T& edit() {
    if (!block_) {
      block_ = new Block(T{});
    } else if (block_->uses.load(std::memory_order_acquire) > 1) {
      auto* own = new Block(block_->value);
      reset();
      block_ = own;
    }
    return block_->value;
  }
  void reset() {
    if (block_ && block_->uses.fetch_sub(1, std::memory_order_acq_rel) == 1) delete block_;
    block_ = nullptr;
  }
  friend bool operator==(const Rare& a, const Rare& b) {
    return a.has_value() == b.has_value() && (a.block_ == b.block_ || *a == *b);
  }

 private:
  struct Block {
    explicit Block(T v) : value(std::move(v)) {}
    std::atomic<std::uint32_t> uses{1};
    T value;
  };
  static const T& absent() {
    static const T value{};
    return value;
  }
  Block* block_ = nullptr;
};

// A value on the heap that is never absent and is copied with its owner.
template <class T>
class Boxed {
 public:
  Boxed(T value = {})
      : value_(std::make_unique<T>(std::move(value))) {
  }  // NOLINT(google-explicit-constructor): assigned like the value itself
  Boxed(const Boxed& other) : Boxed(*other) {}
  Boxed(Boxed&& other) noexcept = default;  // leaves nothing behind: only to be assigned or destroyed
  Boxed& operator=(const Boxed& other) { return *this = Boxed(other); }
  Boxed& operator=(Boxed&& other) noexcept = default;
  ~Boxed() = default;

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }

 private:
  std::unique_ptr<T> value_;
};

// A vector that is nearly always empty.
template <class T>
class List {
 public:
  using value_type = T;
  using const_iterator = const T*;
  using iterator = T*;
  List() = default;
  List(std::vector<T> items)
      : items_(items.empty() ? nullptr : std::make_unique<std::vector<T>>(std::move(items))) {
  }  // NOLINT: like a vector
  List(std::initializer_list<T> items) {
    for (const T& item : items) push_back(item);
  }
  List(const List& other) : items_(other.empty() ? nullptr : std::make_unique<std::vector<T>>(*other.items_)) {}
  List(List&&) noexcept = default;
  List& operator=(const List& other) { return *this = List(other); }
  List& operator=(List&&) noexcept = default;
  ~List() = default;

  bool empty() const { return !items_ || items_->empty(); }
  std::size_t size() const { return items_ ? items_->size() : 0; }
  const T* begin() const { return items_ ? items_->data() : nullptr; }
  const T* end() const { return begin() + size(); }
  T* begin() { return items_ ? items_->data() : nullptr; }
  T* end() { return begin() + size(); }
  const T& operator[](std::size_t i) const { return (*items_)[i]; }
  T& operator[](std::size_t i) { return (*items_)[i]; }
  const T& front() const { return items_->front(); }
  T& front() { return items_->front(); }
  void push_back(T item) { edit().push_back(std::move(item)); }
  void prepend(T item) { edit().insert(edit().begin(), std::move(item)); }
  void clear() { items_.reset(); }
  std::vector<T>& edit() {
    if (!items_) items_ = std::make_unique<std::vector<T>>();
    return *items_;
  }
  friend bool operator==(const List& a, const List& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

 private:
  std::unique_ptr<std::vector<T>> items_;
};

}  // namespace verisim::scene
