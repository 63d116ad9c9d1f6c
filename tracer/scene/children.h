// The objects below a CSG object or a light_group. A copy of a declared object shares them with the original, and what
// is done to the copy is noted only: they are made when somebody asks for them (children_of in object.h). Scenes have
// tens of thousands of copies, and nobody looks below their roots before rendering.
#pragma once

#include <optional>
#include <vector>

#include "tracer/scene/texture.h"

namespace verisim::scene {

class TransformSteps;
struct TransformStep;

// What the children of a copy have not seen yet, in this order: the moves, then the end of the copy's statement.
struct Postponed {
  enum class Step : std::uint8_t { translate, scale, rotate, matrix };
  struct Motion {
    Step step;
    Vec3 v;
    Rare<Transform> matrix;  // of Step::matrix only; the others are computed again
  };
  std::vector<Motion> motions;
  TexturePtr default_texture;  // at the end of the statement; null: it has not ended
};

// How large a description is once the copies in it are written out (parts.h).
struct Parts {
  double objects = 1;  // itself, all below it, their bounds and clips and what lights look like; 2^1000 is one, too
  int levels = 1;      // of objects within objects
};

class Children {
 public:
  void push_back(ObjectPtr child);
  // As the original has them: enough for what moves and a parent's properties do not change.
  const std::vector<ObjectPtr>& declared() const;
  bool postponed() const { return static_cast<bool>(postponed_); }
  bool shared() const { return objects_.use_count() > 1; }
  // The parent with all that is below it, once somebody has counted; copies know it, too.
  const std::optional<Parts>& parts() const { return parts_; }
  void set_parts(const Parts& parts) const { parts_ = parts; }
  // Either all that follows is postponed or nothing; the first form belongs to children that are shared or postponed
  // already.
  void postpone(const TransformSteps& steps);
  void postpone_end(const TexturePtr& default_texture);
  // The objects, theirs alone, with everything done that was postponed. `parent`: the object whose children these are.
  std::vector<ObjectPtr>& own(Object& parent);

 private:
  std::shared_ptr<std::vector<ObjectPtr>> objects_;
  Rare<Postponed> postponed_;
  mutable std::optional<Parts> parts_;
};

}  // namespace verisim::scene
