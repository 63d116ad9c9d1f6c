// What a patterned texture shows at a point, and the frames that normals are perturbed in (spec 05 10.1).
#pragma once

#include <span>
#include <vector>

#include "tracer/textures/texture.h"

namespace verisim::shading {

// Enclosing patterned textures, innermost first.
struct TextureFrame {
  const textures::CompiledTexture* texture;
  const TextureFrame* outer;
};

// The perturbed normal in world space; every evaluation leaves its trace in the texture point (spec 05 3.4).
inline Vec3 perturb_in_frames(const textures::CompiledNormal& normal, const Vec3& p, const Vec3& geometric_normal,
                              textures::SurfacePoint& surface, const TextureFrame* frame) {
  const auto enter = [&](const auto& self, const TextureFrame* f) -> Vec3 {  // outermost first
    return f ? textures::enter_frame(*f->texture, self(self, f->outer)) : geometric_normal;
  };
  Vec3 n = textures::perturb(normal, p, enter(enter, frame), surface);
  for (const TextureFrame* f = frame; f; f = f->outer) n = textures::leave_frame(*f->texture, n);
  return n;
}

// The textures that show at a point of a patterned one, with their weights, the point that is theirs and their frame.
class TextureParts {
 public:
  using Stack = std::vector<textures::WeightedTexture>;
  // They are kept at the end of the stack, to which those of nested textures are added meanwhile.
  TextureParts(Stack& stack, const textures::CompiledTexture& texture, const Vec3& p,
               const textures::SurfacePoint& surface, const TextureFrame* outer)
      : frame{&texture, outer}, stack_(stack), end_(stack.size()) {
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
  const TextureFrame frame;

 private:
  Stack& stack_;
  std::size_t end_, first_, size_;
};

}  // namespace verisim::shading
