// Memory for the samples of a picture, in the type that its file stores them in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "tracer/base/huge_pages.h"

namespace verisim::image {

enum class SampleType : std::uint8_t { byte, word, half, real };  // half: the bits of a binary16 in a word

constexpr std::size_t bytes_of(SampleType type) {
  return type == SampleType::byte ? 1 : type == SampleType::real ? 4 : 2;
}

// Copies share the memory.
class Samples {
 public:
  Samples() = default;
  // Not cleared: whoever allocates writes them all. Throws std::bad_alloc.
  Samples(SampleType type, std::size_t count)
      : type_(type), count_(count), memory_(allocate(count * bytes_of(type)), std::free) {}
  Samples(SampleType type, std::size_t count, std::shared_ptr<void> memory)
      : type_(type), count_(count), memory_(std::move(memory)) {}
  explicit Samples(std::vector<float> values) : type_(SampleType::real), count_(values.size()) {
    const auto owner = std::make_shared<std::vector<float>>(std::move(values));
    memory_ = std::shared_ptr<void>(owner, owner->data());
  }

  SampleType type() const { return type_; }
  std::size_t size() const { return count_; }
  std::size_t memory() const { return count_ * bytes_of(type_); }  // in bytes

  // For a type T of the size of the samples.
  template <class T>
  const T* as() const {
    return static_cast<const T*>(memory_.get());
  }
  template <class T>
  T* as() {
    return static_cast<T*>(memory_.get());
  }

 private:
  static void* allocate(std::size_t bytes) {
    void* memory = std::malloc(bytes > 0 ? bytes : 1);
    if (!memory) throw std::bad_alloc();
    fill_by_huge_pages(memory, bytes);
    return memory;
  }

  SampleType type_ = SampleType::byte;
  std::size_t count_ = 0;
  std::shared_ptr<void> memory_;
};

}  // namespace verisim::image
