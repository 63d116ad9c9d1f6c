// Arrays of SDL (spec 01 section 13): 1 to 5 dimensions, elements of one type, which the first assignment fixes.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "parser/language/value.h"

namespace verisim::parser {

inline constexpr int kMaxDimensions = 5;

// Two values have the same type exactly when their keys are equal; 0 is "no value". Floats, 2-, 3-, 4-vectors and
// colours differ.
int type_key(const Value& value);

// The elements of an array, row by row; one without a value is empty. Blocks of them get memory when the first of each
// is written: people declare arrays for the most they may need.
class Elements {
 public:
  Elements() = default;
  Elements(const Elements& from) : size_(from.size_), blocks_(from.blocks_.size()) {
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      if (from.blocks_[b]) std::copy_n(from.blocks_[b].get(), block_size(b), make_block(b));
  }
  Elements& operator=(const Elements&) = delete;

  std::size_t size() const { return size_; }
  // Once, before anything is written.
  void set_size(std::size_t size) {
    size_ = size;
    blocks_.resize((size + kBlock - 1) / kBlock);
  }
  const Value& operator[](std::size_t i) const {
    static const Value empty;
    const Value* const block = blocks_[i / kBlock].get();
    return block ? block[i % kBlock] : empty;
  }
  // For writing. It stays where it is as long as the array lives.
  Value& at(std::size_t i) {
    Value* const block = blocks_[i / kBlock].get();
    return (block ? block : make_block(i / kBlock))[i % kBlock];
  }
  // visit(element) for each that may have a value.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      if (const Value* const block = blocks_[b].get()) std::for_each_n(block, block_size(b), visit);
  }

 private:
  static constexpr std::size_t kBlock = 64;
  std::size_t block_size(std::size_t b) const { return std::min(kBlock, size_ - b * kBlock); }
  Value* make_block(std::size_t b) {
    blocks_[b] = std::make_unique<Value[]>(block_size(b));
    return blocks_[b].get();
  }
  std::size_t size_ = 0;
  std::vector<std::unique_ptr<Value[]>> blocks_;
};

struct Array {
  std::vector<int> sizes;
  Elements elements;
  int type = 0;     // type_key of the elements; 0: not known yet
  int nesting = 1;  // 1 + that of the deepest array it contains
};

// Assigned arrays are copies, all the way down.
std::shared_ptr<Array> deep_copy(const Array& array);

}  // namespace verisim::parser
