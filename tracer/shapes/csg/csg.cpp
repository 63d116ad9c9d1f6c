// union and merge (spec 03 section 5), and which class a CSG object gets.
#include "tracer/shapes/csg/csg.h"

#include <algorithm>

#include "tracer/shapes/csg/csg_tree.h"
#include "tracer/shapes/tree_on_demand.h"
#include "tracer/shapes/factories.h"

namespace verisim::shapes {
namespace {

// What union and merge share: a point is inside if any child contains it.
class Sum : public CsgShape {
 public:
  Sum(const scene::Object& description, Children children, bool merge) : CsgShape(description, std::move(children)) {
    Box3 sheet, solid;
    Box3 complement = everywhere();
    bool any_outside = false;
    for (std::uint32_t i = 0; i < children_.size(); ++i) {
      surfaces_.add(i, children_[i]->bounds());
      hidden_.push_back(hidden_from(*children_[i]->object, merge));
      sheet = united(sheet, children_[i]->bounds());
      const SolidExtent extent = children_[i]->solid_extent();
      if (extent.outside) {
        any_outside = true;
        complement = common(complement, extent.box);
        outside_in_.push_back(i);
      } else {
        solid = united(solid, extent.box);
        solids_.add(i, extent.box);
      }
    }
    surfaces_.build();
    solids_.build();
    set_extent(sheet, any_outside ? SolidExtent{complement, true} : SolidExtent{solid, false});
  }

  bool inside_unclipped(const Vec3& p) const final {
    for (const std::uint32_t i : outside_in_)
      if (child(i).inside(p)) return true;
    return solids_.any_around(p, [&](std::uint32_t i) { return child(i).inside(p); });
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const final {
    const CsgTree* tree = asks_all(rays) ? nullptr : this->tree();
    if (!tree || std::popcount(rays.active) < CsgTree::kMin)
      return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    return tree->nearest(rays, {kind, t_min, t_max, guards_.get(), nullptr}, hits);
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const final {
    const CsgTree* tree = asks_all(rays) ? nullptr : this->tree();
    if (!tree || std::popcount(rays.active) < CsgTree::kMin) return Shape::occludes_packet(rays, entry, t_min, t_max);
    return tree->occluded(rays, {RayKind::shadow, t_min, t_max, guards_.get(), nullptr});
  }

 protected:
  // Of few and mostly simple parts (else null): finds the same in less time.
  const CsgTree* tree() const {
    return tree_.get(
        [&] { return CsgTree::of(*this, children_, accel::is_empty(bounds_) ? everywhere() : bounds_, {}); });
  }
  bool hidden(std::uint32_t i, RayKind kind) const { return hidden_[i] >> static_cast<unsigned>(kind) & 1; }
  auto seen_by(RayKind kind) const {
    return [this, kind](std::uint32_t i) { return !hidden(i, kind); };
  }
  // p is inside another child that this kind of ray sees.
  bool inside_another(const Vec3& p, std::uint32_t self, RayKind kind) const {
    for (const std::uint32_t i : outside_in_)
      if (i != self && !hidden(i, kind) && child(i).inside(p)) return true;
    return solids_.any_around(p, [&](std::uint32_t i) { return i != self && !hidden(i, kind) && child(i).inside(p); });
  }
  auto outside_others(RayKind kind) const {
    return [this, kind](const Vec3& p, std::uint32_t self) { return !inside_another(p, self, kind); };
  }

 private:
  std::vector<unsigned> hidden_;
  std::vector<std::uint32_t> outside_in_;  // children that contain everything outside a box
  ChildIndex solids_;                      // the others
  TreeOnDemand tree_;
};

class Union final : public Sum {
 public:
  Union(const scene::Object& description, Children children) : Sum(description, std::move(children), false) {}

  void intersect_all(const Ray& ray, RayKind kind, HitList& hits) const override {
    if (asks_all(ray)) return all_of_children(ray, kind, hits, seen_by(kind), kAny);
    if (guards_ && !guards_->admit(ray)) return;
    const std::size_t begin = hits.size();
    surfaces_.in_order(ray, 0, 2e10, [&](std::uint32_t i) {
      if (!hidden(i, kind)) child(i).intersect_all(ray, kind, hits);
    });
    if (guards_ && !guards_->clips.empty()) filter(hits, begin, [](const Vec3&) { return true; });
  }

  bool intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const override {
    return nearest(ray, kind, t_min, t_max, nullptr, hit);
  }
  bool intersect_clipped(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips& clips,
                         Hit& hit) const override {
    return nearest(ray, kind, t_min, t_max, &clips, hit);
  }
  bool occludes(const Ray& ray, double t_min, double t_max) const override {
    if (asks_all(ray)) return Shape::occludes(ray, t_min, t_max);
    if (const CsgTree* tree = this->tree())
      return tree->occluded(ray, {RayKind::shadow, t_min, &t_max, guards_.get(), nullptr});
    if (guards_ && !guards_->admit(ray)) return false;
    const bool clipped = guards_ && !guards_->clips.empty();
    bool found = false;
    surfaces_.along(ray, t_min, t_max, [&](std::uint32_t i, double limit) {
      Hit hit;
      found = found || (clipped ? child(i).intersect_clipped(ray, RayKind::shadow, t_min, t_max, {*guards_}, hit)
                                : child(i).occludes(ray, t_min, t_max));
      return found ? -HUGE_VAL : limit;
    });
    return found;
  }

 private:
  static constexpr auto kAny = [](const Vec3&, std::uint32_t) { return true; };
  // `clips`: those of the unions around this one, or null.
  bool nearest(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips* clips, Hit& hit) const {
    if (asks_all(ray)) return nearest_of_all(ray, kind, t_min, t_max, clips, hit, seen_by(kind), kAny);
    if (const CsgTree* tree = this->tree()) return tree->nearest(ray, {kind, t_min, &t_max, guards_.get(), clips}, hit);
    if (!guards_) return nearest_of_children(ray, kind, t_min, t_max, t_min, t_max, clips, hit);
    double near = t_min, far = t_max;
    if (!accel::clip_to_box(ray, bounds_, near, far) || !guards_->admit(ray)) return false;
    const Clips all{*guards_, clips};
    return nearest_of_children(ray, kind, t_min, t_max, near, far, guards_->clips.empty() ? clips : &all, hit);
  }
  // Of the children whose boxes are met between `near` and `far`.
  bool nearest_of_children(const Ray& ray, RayKind kind, double t_min, double t_max, double near, double far,
                           const Clips* clips, Hit& hit) const {
    bool found = false;
    std::uint32_t owner = 0;
    surfaces_.along(ray, near, far, [&](std::uint32_t i, double limit) {
      if (hidden(i, kind)) return limit;
      // At equal distance the later child wins.
      const double bound = !found ? t_max : i > owner ? std::nextafter(hit.t, HUGE_VAL) : hit.t;
      if (clips ? !child(i).intersect_clipped(ray, kind, t_min, bound, *clips, hit)
                : !child(i).intersect(ray, kind, t_min, bound, hit))
        return limit;
      found = true;
      owner = i;
      return std::min(hit.t, limit);
    });
    return found;
  }
};

class Merge final : public Sum {
 public:
  Merge(const scene::Object& description, Children children) : Sum(description, std::move(children), true) {}

  void intersect_all(const Ray& ray, RayKind kind, HitList& hits) const override {
    if (asks_all(ray)) return all_of_children(ray, kind, hits, seen_by(kind), outside_others(kind));
    if (guards_ && !guards_->admit(ray)) return;
    surfaces_.in_order(ray, 0, 2e10, [&](std::uint32_t i) {
      if (hidden(i, kind)) return;
      const std::size_t begin = hits.size();
      child(i).intersect_all(ray, kind, hits);
      filter(hits, begin, [&](const Vec3& p) { return !inside_another(p, i, kind); });
    });
  }

  bool intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const override {
    return nearest(ray, kind, t_min, t_max, nullptr, hit);
  }
  bool intersect_clipped(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips& clips,
                         Hit& hit) const override {
    return nearest(ray, kind, t_min, t_max, &clips, hit);
  }
  bool occludes(const Ray& ray, double t_min, double t_max) const override {
    const CsgTree* tree = asks_all(ray) ? nullptr : this->tree();
    return tree ? tree->occluded(ray, {RayKind::shadow, t_min, &t_max, guards_.get(), nullptr})
                : Shape::occludes(ray, t_min, t_max);
  }

 private:
  bool nearest(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips* clips, Hit& hit) const {
    if (asks_all(ray)) return nearest_of_all(ray, kind, t_min, t_max, clips, hit, seen_by(kind), outside_others(kind));
    if (const CsgTree* tree = this->tree()) return tree->nearest(ray, {kind, t_min, &t_max, guards_.get(), clips}, hit);
    if (guards_ && !guards_->admit(ray)) return false;
    ScratchOwners owners;
    ScratchHits hits;
    surfaces_.in_order(ray, t_min, t_max, [&](std::uint32_t i) {
      if (hidden(i, kind)) return;
      const std::size_t before = hits.end();
      child(i).intersect_all(ray, kind, hits.list());
      for (std::size_t n = before; n < hits.end(); ++n) owners.add(i);
    });
    return nearest_surviving(hits, owners, t_min, t_max, hit, [&](const Vec3& p, std::uint32_t self) {
      return !inside_another(p, self, kind) && within_clips(p, clips);
    });
  }
};

// A text is a union of its letters, inverted an intersection, inverted twice a merge: so its flags may count within an
// intersection, which heeds those of no child of its own (spec 03 5.5).
bool is_flagged_text(const scene::Object& child) {
  return child.as<std::shared_ptr<const scene::Text>>() && !child.inverted &&
         hidden_from(child, child.was_inverted) != 0;
}
std::unique_ptr<Shape> as_letters(std::unique_ptr<Shape> text) {
  const auto described = [](scene::CsgKind kind) {
    scene::Object object;
    scene::Csg csg;
    csg.kind = kind;
    object.shape = csg;
    return object;
  };
  static const scene::Object kUnion = described(scene::CsgKind::union_), kMerge = described(scene::CsgKind::merge);
  const bool merge = text->object->was_inverted;
  Children children;
  children.push_back(std::move(text));
  if (merge) return std::make_unique<Merge>(kMerge, std::move(children));
  return std::make_unique<Union>(kUnion, std::move(children));
}

// What tests hits turns those of each child around, so that of equally near ones within a child that is CSG itself the
// first wins, a level deeper the last again (spec 03 5.2): there the children are `turned`. The same holds of the hits
// of one primitive.
std::unique_ptr<Shape> compile_part(const scene::Object& object, bool turned) {
  const scene::CsgKind kind = object.as<scene::Csg>()->kind;
  const bool tests_hits = kind != scene::CsgKind::union_ || !object.clipped_by.empty();
  Children children;
  for (const scene::ObjectPtr& child : scene::children_of(object)) {
    const auto* light = child->as<scene::LightSource>();
    if (light && !light->looks_like) continue;  // not part of any solid (spec 03 5.1)
    const bool turns = turned != tests_hits;
    children.push_back(child->as<scene::Csg>() ? compile_part(*child, turns) : compile(*child));
    children.back()->join_csg();
    if (turns) children.back()->turn_hits();
    if (kind == scene::CsgKind::intersection && is_flagged_text(*child))
      children.back() = as_letters(std::move(children.back()));
  }
  if (turned) std::reverse(children.begin(), children.end());
  switch (kind) {
    case scene::CsgKind::union_:
      return std::make_unique<Union>(object, std::move(children));
    case scene::CsgKind::merge:
      return std::make_unique<Merge>(object, std::move(children));
    default:
      return make_intersection(object, std::move(children));
  }
}

}  // namespace

std::unique_ptr<Shape> compile_csg(const scene::Object& object) { return compile_part(object, false); }

}  // namespace verisim::shapes
