// Each description of a texture, pigment, normal or density is compiled once.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace verisim::textures {

// What was compiled from which description. Keeps the descriptions alive, so that an address stands for one description
// only. Scenes may have a texture for each of a million objects: a table of numbers takes little of their memory.
template <class Description, class Compiled>
class CompiledCache {
 public:
  using Ptr = std::shared_ptr<const Description>;
  // make() returns the result of add, or what an equal description was compiled to.
  template <class Make>
  const Compiled* get(const Ptr& description, bool no_bump_scale, Make make) {
    if (const std::uint32_t known = *slot(description.get(), no_bump_scale); known != kFree)
      return kept_[known].compiled;
    const Compiled* const compiled = make();  // may compile others
    if (2 * (kept_.size() + 1) > slots_.size()) grow();
    *slot(description.get(), no_bump_scale) = static_cast<std::uint32_t>(kept_.size());
    kept_.push_back({description, compiled}), no_bump_scale_.push_back(no_bump_scale);
    return compiled;
  }
  const Compiled* add(Compiled compiled) { return &store_.emplace_back(std::move(compiled)); }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffu;
  struct Entry {
    Ptr description;
    const Compiled* compiled;
  };

  // Where the number of a description is, or is to be.
  std::uint32_t* slot(const Description* description, bool no_bump_scale) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t place =
        ((reinterpret_cast<std::uintptr_t>(description) >> 4) + no_bump_scale) * 0x9e3779b97f4a7c15u >> 32;
    for (;; ++place) {
      std::uint32_t& number = slots_[place & mask];
      if (number == kFree) return &number;
      if (kept_[number].description.get() == description && no_bump_scale_[number] == no_bump_scale) return &number;
    }
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < kept_.size(); ++i)
      *slot(kept_[i].description.get(), no_bump_scale_[i]) = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(16, kFree);  // a power of two, at most half of it used
  std::deque<Entry> kept_;
  std::vector<bool> no_bump_scale_;  // of each
  std::deque<Compiled> store_;
};

}  // namespace verisim::textures
