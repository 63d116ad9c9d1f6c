// Transformations in the order in which an object's modifiers name them, applied in one walk over its tree: most
// objects have two or three in a row.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "tracer/scene/object.h"

namespace verisim::scene {

// One of them.
struct TransformStep {
  using Step = Postponed::Step;
  Step step;
  Vec3 v;  // of translate, scale, rotate
  Transform t;
  bool uniform_scale() const { return step == Step::scale && v.x == v.y && v.x == v.z; }
};

class TransformSteps {
 public:
  static constexpr std::size_t kMax = 4;

  std::size_t size() const { return size_; }
  bool full() const { return size_ == kMax; }
  const TransformStep& operator[](std::size_t i) const { return *steps_[i]; }

  void translate(const Vec3& v) {
    steps_[size_++] = TransformStep{TransformStep::Step::translate, v, Transform::translation(v)};
  }
  void scale(const Vec3& s) { steps_[size_++] = TransformStep{TransformStep::Step::scale, s, Transform::scaling(s)}; }
  void rotate(const Vec3& degrees) {
    steps_[size_++] = TransformStep{TransformStep::Step::rotate, degrees, Transform::rotation(degrees)};
  }
  void transform(const Transform& t) { steps_[size_++] = TransformStep{TransformStep::Step::matrix, Vec3(0), t}; }

  // For Transforms; points into these steps.
  struct Chain {
    std::array<const Transform*, kMax> steps;
    std::size_t size = 0;
    Transforms span() const { return {steps.data(), size}; }
  };
  Chain transforms() const {
    Chain chain;
    for (; chain.size < size_; ++chain.size) chain.steps[chain.size] = &steps_[chain.size]->t;
    return chain;
  }

  // The texture, moved; objects of a tree that share one share what becomes of it. Null stays null.
  TexturePtr moved(const TexturePtr& texture) const;
  // Appends the moves from `first` on to what an object was moved by so far.
  void add_to(Rare<Transform>& total, std::size_t first) const;

 private:
  Transform product(const Transform& before, std::size_t first) const;

  std::array<std::optional<TransformStep>, kMax> steps_;
  std::size_t size_ = 0;
  // The objects of a tree that came the same way so far share one matrix: the last one seen and what became of it are
  // kept.
  mutable std::array<Rare<Transform>, kMax> alone_;
  mutable Rare<Transform> before_, after_;
  mutable std::size_t after_first_ = 0;
  // Textures that were moved last, and what became of them: a few, and where there are more, many.
  struct Moved {
    TexturePtr before, after;
  };
  mutable std::array<Moved, 4> few_textures_;
  mutable std::size_t next_texture_ = 0;
  mutable std::vector<Moved> many_textures_;  // each in the place that its address names
};

// As POV-Ray does: absorbed into the shape's numbers where it can, else into the matrix; also moves clips, bounds,
// textures (unless uv-mapped), the interior's media and CSG children.
void apply(Object& object, const TransformSteps& steps);

}  // namespace verisim::scene
