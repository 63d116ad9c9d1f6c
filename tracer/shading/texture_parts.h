// What a patterned texture shows at a point, and the frames that normals are perturbed in (spec 05 10.1).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tracer/textures/texture.h"

namespace verisim::shading {

// The patterned textures that were looked into since the outermost one of a point, in this order: those around a plain
// texture, and those of entries before it, which POV-Ray does not forget (spec 05 10.1).
class TextureFrames {
 public:
  void push(const textures::CompiledTexture& texture) {
    if (size_ < first_.size())
      first_[size_] = &texture;
    else
      more_.push_back(&texture);
    ++size_;
  }
  std::size_t size() const { return size_; }
  const textures::CompiledTexture& operator[](std::size_t i) const {
    return i < first_.size() ? *first_[i] : *more_[i - first_.size()];
  }

 private:
  std::size_t size_ = 0;
  std::array<const textures::CompiledTexture*, 6> first_;
  std::vector<const textures::CompiledTexture*> more_;
};

// The perturbed normal in world space; every evaluation leaves its trace in the texture point (spec 05 3.4).
inline Vec3 perturb_in_frames(const textures::CompiledNormal& normal, const Vec3& p, const Vec3& geometric_normal,
                              textures::SurfacePoint& surface, const TextureFrames* frames) {
  Vec3 n = geometric_normal;
  const std::size_t count = frames ? frames->size() : 0;
  for (std::size_t i = 0; i < count; ++i) n = textures::enter_frame((*frames)[i], n);
  n = textures::perturb(normal, p, n, surface);
  for (std::size_t i = count; i-- > 0;) n = textures::leave_frame((*frames)[i], n);
  return n;
}

// The textures that show at a point of a patterned one, with their weights, the point that is theirs and their frames.
class TextureParts {
 public:
  using Stack = std::vector<textures::WeightedTexture>;
  // They are kept at the end of the stack, to which those of nested textures are added meanwhile.
  TextureParts(Stack& stack, const textures::CompiledTexture& texture, const Vec3& p,
               const textures::SurfacePoint& surface, TextureFrames* outer)
      : frames(outer ? *outer : own_), stack_(stack), end_(stack.size()) {
    frames.push(texture);
    stack.resize(end_ + std::max<std::size_t>(texture.map.size(), 2));
    const auto found = textures::select(texture, p, &surface, std::span(stack).subspan(end_), point);
    size_ = found.size(), first_ = static_cast<std::size_t>(found.data() - stack.data());
  }
  ~TextureParts() { stack_.resize(end_); }
  TextureParts(const TextureParts&) = delete;
  TextureParts& operator=(const TextureParts&) = delete;

  std::size_t size() const { return size_; }
  textures::WeightedTexture operator[](std::size_t i) const { return stack_[first_ + i]; }

  Vec3 point;
  TextureFrames& frames;

 private:
  TextureFrames own_;  // of the outermost
  Stack& stack_;
  std::size_t end_, first_, size_;
};

}  // namespace verisim::shading
