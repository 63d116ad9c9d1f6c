#include "tracer/accel/world.h"

#include <algorithm>
#include <bit>
#include <deque>
#include <limits>

#include "tracer/accel/box_tree.h"
#include "tracer/accel/frame_list.h"
#include "tracer/accel/shaft.h"
#include "tracer/scene/bounds.h"
#include "tracer/shapes/plane.h"
#include "tracer/shapes/scratch_hits.h"

namespace verisim::accel {
namespace {

using shapes::Shape;
using shapes::Surface;

// With fewer frame-level entries than this POV-Ray tests objects one by one, without boxes for most kinds (spec 03 2.3; the shipped povray.ini).
constexpr std::size_t kBoundingThreshold = 3;

enum class Opacity : unsigned char { opaque, transparent, mixed };

// One frame-level object.
struct Entry {
  const Shape* shape = nullptr;
  const scene::Object* object = nullptr;
  unsigned hidden = 0;      // RayKinds that do not see it, as bits
  Opacity opacity = Opacity::opaque;
  bool infinite = false;    // of the kind POV-Ray tests before all others
  bool test_box = false;    // rays that miss `box` miss the object
  bool test_surface = false;  // no box of POV-Ray's decides, but the surface has one of finite size
  Box3 box;                 // POV-Ray's, right or wrong, widened by rounding

  bool may_meet(const Ray& ray, double t_min, double t_max) const {
    double near = t_min, far = t_max;
    return (!test_box || clip_to_box(ray, box, near, far)) && (!test_surface || clip_to_box(ray, shape->bounds(), near, far));
  }
};

// What the tree's walk needs of an entry, densely packed.
struct Candidate {
  const Shape* shape;
  std::uint32_t entry;
  unsigned short hidden;
  Opacity opacity;
  bool has_tree;  // rays may be told where to enter it
};

struct Plane {
  Vec3 normal;
  double distance;
  double distance_along(const Ray& ray) const {
    const double slope = dot(normal, ray.direction), t = (distance - dot(normal, ray.origin)) / slope;
    return shapes::meets_plane(slope, t) ? t : -1;
  }
};
std::optional<Plane> plain_plane(const scene::Object& o) {
  const auto plane = shapes::plain_plane(o);
  return plane ? std::optional(Plane{plane->normal, plane->distance}) : std::nullopt;
}

bool has_tree(const scene::Object& o) {
  return o.as<scene::Mesh>() || o.as<std::shared_ptr<const scene::BicubicPatch>>() || o.as<std::shared_ptr<const scene::Text>>();
}

unsigned bit(RayKind kind) { return 1u << static_cast<unsigned>(kind); }

unsigned hidden_from(const scene::Object& o) {
  unsigned bits = 0;
  if (o.no_image) bits |= bit(RayKind::camera) | bit(RayKind::refracted);
  if (o.no_reflection) bits |= bit(RayKind::reflected);
  if (o.no_radiosity) bits |= bit(RayKind::radiosity);
  if (o.no_shadow) bits |= bit(RayKind::shadow) | bit(RayKind::photon);
  return bits;
}

// A union whose children other than lights are all no_shadow counts as no_shadow (spec 03 5.5).
bool all_children_shadowless(const scene::Object& o) {
  const auto* csg = o.as<scene::Csg>();
  if (!csg || csg->kind != scene::CsgKind::union_) return false;
  bool any = false;
  for (const auto& child : scene::children_of(o)) {
    if (child->as<scene::LightSource>()) continue;
    if (!child->no_shadow) return false;
    any = true;
  }
  return any;
}

// Kinds that POV-Ray tests without their box when there are too few objects for a hierarchy (spec 03 2.1).
bool exempt_from_box_test(const scene::Object& o) {
  return o.as<scene::Sphere>() || o.as<scene::Box>() || o.as<scene::Plane>() || o.as<scene::Triangle>() || o.as<scene::SmoothTriangle>() ||
         o.as<scene::Poly>() || o.as<scene::LightSource>();
}
// Kinds whose own intersection test is as cheap as that of their box.
bool cheaper_than_box_test(const scene::Object& o) {
  return o.as<scene::Sphere>() || o.as<scene::Box>() || o.as<scene::Plane>() || o.as<scene::Triangle>() || o.as<scene::SmoothTriangle>();
}

Box3 widened(const scene::Bounds& b) {
  Vec3 low = scene::low_corner(b), high;
  for (int i = 0; i < 3; ++i) {
    high[i] = low[i] + b.size[i];
    const double pad = 1e-6 * std::max(std::fabs(low[i]), std::fabs(high[i])) + 1e-9;
    low[i] -= pad, high[i] += pad;
  }
  return {low, high};
}

// What the tree keeps of an entry: the true bounds of its surface where POV-Ray's box encloses them. Where it does not, its box decides what is seen.
Box3 tight_box(const Box3& pov, const Box3& surface) {
  const bool encloses = !is_empty(surface) && contains(pov, surface.min) && contains(pov, surface.max);
  return encloses ? surface : pov;
}

// The surface and all that it encloses lie in a finite box.
bool within_finite_box(const Shape& shape) {
  const Box3 surface = shape.bounds();
  const shapes::SolidExtent solid = shape.solid_extent();
  return is_finite(surface) && !is_empty(surface) && !solid.outside && contains(surface, solid.box.min) && contains(surface, solid.box.max);
}

// The next number, for numbers above 0.
double next_above(double x) { return x < std::numeric_limits<double>::infinity() ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1) : x; }

// POV-Ray's sort key: the distance at which a ray enters the box, in binary32.
float entry_distance(const Ray& ray, const Box3& box) {
  double near = 0, far = std::numeric_limits<double>::infinity();
  clip_to_box(ray, box, near, far);
  return static_cast<float>(near);
}

}  // namespace

// What the rays of a row meet, before anything is decided.
struct World::RowScratch {
  static constexpr std::size_t kPlanes = 4;  // more are tested one by one
  BoxesMet met;
  alignas(64) double planes[kPlanes][RayRow::kSize];
};

struct World::Impl {
  std::vector<Entry> entries;
  std::vector<std::unique_ptr<Shape>> shapes;
  std::vector<std::uint32_t> unbounded;  // entries beside the tree
  std::vector<std::optional<Plane>> planes;  // of each of them that is one
  std::vector<Candidate> bounded;        // of each box of the tree
  BoxTree tree;
  std::deque<Surface> surfaces;
  std::deque<std::vector<const scene::LightSource*>> group_lights;
  std::vector<const scene::LightSource*> lights;
  Box3 bounds;
  bool in_order = false;  // too few entries for a hierarchy
  bool transparent_shadows = false;    // something that shadow rays see is not opaque
  bool transparent_unbounded = false;  // one of `unbounded` is such

  void add_beside_tree(std::uint32_t index, const Entry& e);
  Box3 add_bounded(std::uint32_t index, const Entry& e);  // the box to keep in the tree
  void add_surfaces(Shape& shape, int frame_object, const Shape* cutaway, textures::Compiler& compiler);
  bool precedes(std::uint32_t a, std::uint32_t b, const Ray& ray) const;
  void meet_planes(const RayRow& rays, int first, int count, RowScratch& scratch) const {
    for (std::size_t k = 0; k < std::min(planes.size(), RowScratch::kPlanes); ++k)
      if (planes[k]) row_kernels().plane(planes[k]->normal, planes[k]->distance, rays, first, count, scratch.planes[k]);
  }
  void mix_cutaway(const Shape& shape, const Vec3& p, float weight, std::vector<textures::WeightedTexture>& out) const;
};

void World::Impl::add_surfaces(Shape& shape, int frame_object, const Shape* cutaway, textures::Compiler& compiler) {
  const scene::Object& o = *shape.object;
  const bool container = o.as<scene::Csg>() || o.as<scene::LightSource>() || o.as<scene::LightGroup>();
  if (container) {
    const auto* csg = o.as<scene::Csg>();
    if (!cutaway && csg && (csg->kind != scene::CsgKind::union_ || !o.clipped_by.empty())) cutaway = &shape;
    for (const auto& child : shape.children()) add_surfaces(*child, frame_object, cutaway, compiler);
    return;
  }
  static const scene::Interior kNoInterior;
  Surface& s = surfaces.emplace_back();
  s.object = &o;
  s.texture = o.texture ? compiler.texture(o.texture) : nullptr;
  s.interior_texture = o.interior_texture ? compiler.texture(o.interior_texture) : nullptr;
  s.interior = o.interior ? o.interior.get() : &kNoInterior;
  s.frame_object = frame_object;
  s.double_illuminate = o.double_illuminate;
  s.ignore_global_lights = o.ignore_global_lights;
  s.uv_mapping = o.uv_mapping;
  s.no_radiosity = o.no_radiosity;
  s.photons = o.photons;
  s.cutaway = cutaway;
  s.opaque = s.texture && s.texture->opaque && (!s.interior_texture || s.interior_texture->opaque);
  for (const scene::TexturePtr& texture : shape.extra_textures()) {
    s.extra_textures.push_back(texture ? compiler.texture(texture) : s.texture);
    s.opaque = s.opaque && s.extra_textures.back() && s.extra_textures.back()->opaque;
  }
  if (!o.group_lights.empty()) {
    auto& list = group_lights.emplace_back();
    for (const auto& light : o.group_lights) list.push_back(light.get());
    s.group_lights = list;
  }
  shape.surface = &s;
}

World::World(const scene::Scene& scene, textures::Compiler& compiler, bool split_unions, bool remove_bounds) : impl_(std::make_unique<Impl>()) {
  Impl& w = *impl_;
  FrameList list = frame_list(scene, split_unions);
  w.lights = std::move(list.lights);
  w.in_order = list.entries < kBoundingThreshold;

  std::vector<Box3> boxes;
  std::vector<std::uint32_t> finite_after_all;
  for (std::size_t i = 0; i < list.objects.size(); ++i) {
    const scene::Object& o = *list.objects[i];
    std::unique_ptr<Shape> shape = shapes::compile(o, {remove_bounds});
    const std::size_t first_surface = w.surfaces.size();
    w.add_surfaces(*shape, static_cast<int>(i), nullptr, compiler);

    Entry e;
    e.shape = shape.get();
    e.object = &o;
    e.hidden = hidden_from(o);
    if (all_children_shadowless(o)) e.hidden |= bit(RayKind::shadow) | bit(RayKind::photon);
    if (const auto* light = o.as<scene::LightSource>(); light && light->looks_like) e.hidden |= hidden_from(*light->looks_like);
    std::size_t opaque = 0;
    for (std::size_t s = first_surface; s < w.surfaces.size(); ++s) opaque += w.surfaces[s].opaque;
    e.opacity = opaque == w.surfaces.size() - first_surface ? Opacity::opaque : opaque == 0 ? Opacity::transparent : Opacity::mixed;
    if (e.opacity != Opacity::opaque && !(e.hidden & bit(RayKind::shadow))) w.transparent_shadows = true;
    e.infinite = scene::is_infinite(o);
    e.box = widened(o.bounds);

    // Boxes with negative sides (spheres of negative radius and the like) hide what POV-Ray looks for by its box.
    const bool never = is_empty(e.box) && !(w.in_order && exempt_from_box_test(o));
    const bool boxless = e.infinite || is_empty(e.box) || (w.in_order && exempt_from_box_test(o));
    e.test_box = !is_empty(e.box) && (boxless || w.in_order) && !cheaper_than_box_test(o) && !(w.in_order && exempt_from_box_test(o)) && volume(o.bounds) < 7e30f;
    // Some of those have a surface of finite size all the same, as solids cut out by planes do.
    e.test_surface = !never && boxless && within_finite_box(*shape);
    const bool waits = e.test_surface && !w.in_order;
    if (waits) finite_after_all.push_back(static_cast<std::uint32_t>(i));
    else if (!never && (boxless || w.in_order)) w.add_beside_tree(static_cast<std::uint32_t>(i), e);
    else if (!never) boxes.push_back(w.add_bounded(static_cast<std::uint32_t>(i), e));
    if (!e.infinite && !is_empty(e.box)) w.bounds.extendBy(e.box);
    w.entries.push_back(e);
    w.shapes.push_back(std::move(shape));
  }
  // The tree may keep those, too, for what it finds is put in order later; but the digits of its boxes are relative to the largest of them.
  constexpr double kOutsized = 4;
  const auto longest = [](const Box3& box) { return is_empty(box) ? 0 : std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z}); };
  for (const std::uint32_t i : finite_after_all) {
    if (longest(w.shapes[i]->bounds()) <= kOutsized * longest(w.bounds)) boxes.push_back(w.add_bounded(i, w.entries[i]));
    else w.add_beside_tree(i, w.entries[i]);
  }
  w.tree = BoxTree(boxes);
}

void World::Impl::add_beside_tree(std::uint32_t index, const Entry& e) {
  unbounded.push_back(index);
  planes.push_back(e.test_box ? std::nullopt : plain_plane(*e.object));
  if (e.opacity != Opacity::opaque && !(e.hidden & bit(RayKind::shadow))) transparent_unbounded = true;
}

Box3 World::Impl::add_bounded(std::uint32_t index, const Entry& e) {
  bounded.push_back({e.shape, index, static_cast<unsigned short>(e.hidden), e.opacity, has_tree(*e.object)});
  return e.test_surface && !e.test_box ? e.shape->bounds() : tight_box(e.box, e.shape->bounds());
}

World::~World() = default;

// Which of two entries hit at the same distance POV-Ray tested first and therefore shows (spec 03 2.3).
bool World::Impl::precedes(std::uint32_t a, std::uint32_t b, const Ray& ray) const {
  const Entry &x = entries[a], &y = entries[b];
  if (!in_order) {
    if (x.infinite != y.infinite) return x.infinite;
    if (!x.infinite) {
      const float dx = entry_distance(ray, x.box), dy = entry_distance(ray, y.box);
      if (dx != dy) return dx < dy;
    }
  }
  return a < b;
}

// The search for the nearest hit of one ray.
class World::Search {
 public:
  Search(const Impl& world, const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit)
      : w_(world), ray_(ray), kind_(kind), mask_(bit(kind)), t_min_(t_min), limit_(t_max), hit_(hit) {}

  bool found() const { return found_; }
  double limit() const { return limit_; }

  // Entries beside the tree; plane_distance(i) is that of the plane of entry i, -1 if it is not met.
  template <class PlaneDistance>
  void test_unbounded(PlaneDistance&& plane_distance) {
    for (std::size_t i = 0; i < w_.unbounded.size(); ++i) {
      const std::uint32_t index = w_.unbounded[i];
      const Entry& e = w_.entries[index];
      if (e.hidden & mask_) continue;
      if (const Plane* plane = w_.planes[i] ? &*w_.planes[i] : nullptr) {
        const double t = plane_distance(i, *plane);
        if (!(t >= t_min_ && (found_ ? t <= limit_ : t < limit_)) || (found_ && t == hit_.t && !w_.precedes(index, owner_, ray_))) continue;
        hit_ = {t, ray_.origin + t * ray_.direction, e.shape, 0, 0, 0};
        accept(index);
        continue;
      }
      if (!e.may_meet(ray_, t_min_, limit_)) continue;
      test(*e.shape, index, nullptr);
    }
  }
  void test_candidate(std::uint32_t i, const WorldEntry* entry) {
    const Candidate& c = w_.bounded[i];
    if (!(c.hidden & mask_)) test(*c.shape, c.entry, entry ? entry->inner_of(i) : nullptr);
  }

 private:
  void accept(std::uint32_t index) {
    found_ = true;
    owner_ = index;
    limit_ = hit_.t;
  }
  void test(const Shape& shape, std::uint32_t index, const EntryPoints* inner) {
    const auto intersect_shape = [&](double far, Hit& out) {
      return inner ? shape.intersect_from(*inner, ray_, kind_, t_min_, far, out) : shape.intersect(ray_, kind_, t_min_, far, out);
    };
    if (!found_) {
      if (!intersect_shape(limit_, hit_)) return;
    } else {
      Hit other;
      if (!intersect_shape(next_above(limit_), other)) return;
      if (other.t == hit_.t && !w_.precedes(index, owner_, ray_)) return;
      hit_ = other;
    }
    accept(index);
  }

  const Impl& w_;
  const Ray& ray_;
  const RayKind kind_;
  const unsigned mask_;
  const double t_min_;
  double limit_;
  Hit& hit_;
  bool found_ = false;
  std::uint32_t owner_ = 0;
};

namespace {

// The boxes of a mask (BoxesMet) in order of distance, as far as `limit()`: visit(place) for each; it may lower the limit.
template <class Limit, class Visit>
void visit_boxes(const BoxesMet& met, int ray, Limit&& limit, Visit&& visit) {
  for (auto mask = static_cast<std::uint32_t>(met.mask[ray]); mask != 0;) {
    int nearest = std::countr_zero(mask);
    for (std::uint32_t rest = mask & (mask - 1); rest != 0; rest &= rest - 1)
      if (const int place = std::countr_zero(rest); met.near[place][ray] < met.near[nearest][ray]) nearest = place;
    if (met.near[nearest][ray] > limit()) return;
    mask &= ~(1u << nearest);
    visit(nearest);
  }
}

std::uint32_t candidate_at(const EntryPoints& points, int place) { return BoxNode::leaf_first(points.nodes[place / 4].child[place % 4]); }

}  // namespace

bool World::intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit, const WorldEntry* entry) const {
  const Impl& w = *impl_;
  Search search(w, ray, kind, t_min, t_max, hit);
  search.test_unbounded([&](std::size_t, const Plane& plane) { return plane.distance_along(ray); });
  w.tree.traverse(ray, t_min, search.limit(), [&](std::uint32_t i, double) {
    search.test_candidate(i, entry);
    return search.limit();
  }, entry ? &entry->points : nullptr);
  return search.found();
}

void World::intersect_row(const RayRow& rays, int first, int count, RayKind kind, double t_min, const WorldEntry* entry, Hit* hits, bool* found) const {
  const Impl& w = *impl_;
  RowScratch scratch;
  w.meet_planes(rays, first, count, scratch);
  const bool boxes = entry && entry->points.complete;
  if (boxes) row_kernels().boxes(entry->points, w.tree.center(), rays, first, count, t_min, scratch.met);
  for (int i = first; i < first + count; ++i) {
    const Ray ray = rays.at(i);
    Search search(w, ray, kind, t_min, std::numeric_limits<double>::infinity(), hits[i]);
    search.test_unbounded([&](std::size_t k, const Plane& plane) { return k < RowScratch::kPlanes ? scratch.planes[k][i] : plane.distance_along(ray); });
    if (boxes) {
      visit_boxes(scratch.met, i, [&] { return search.limit(); }, [&](int place) { search.test_candidate(candidate_at(entry->points, place), entry); });
    } else {
      w.tree.traverse(ray, t_min, search.limit(), [&](std::uint32_t c, double) {
        search.test_candidate(c, entry);
        return search.limit();
      }, entry ? &entry->points : nullptr);
    }
    found[i] = search.found();
  }
}

// Whether something opaque lies on one ray.
class World::Occlusion {
 public:
  Occlusion(const Impl& world, const Ray& ray, double t_min, double t_max) : w_(world), ray_(ray), above_(next_above(t_min)), t_max_(t_max) {}

  template <class PlaneDistance>
  bool by_unbounded(PlaneDistance&& plane_distance) const {
    for (std::size_t i = 0; i < w_.unbounded.size(); ++i) {
      const Entry& e = w_.entries[w_.unbounded[i]];
      if ((e.hidden & kMask) || e.opacity == Opacity::transparent) continue;
      if (w_.planes[i]) {
        const double t = plane_distance(i, *w_.planes[i]);
        if (t >= above_ && t < t_max_) return true;
        continue;
      }
      if (!e.may_meet(ray_, above_, t_max_)) continue;
      if (blocks(*e.shape, e.opacity, nullptr)) return true;
    }
    return false;
  }
  bool by_candidate(std::uint32_t i, const WorldEntry* entry) const {
    const Candidate& c = w_.bounded[i];
    return !(c.hidden & kMask) && c.opacity != Opacity::transparent && blocks(*c.shape, c.opacity, entry ? entry->inner_of(i) : nullptr);
  }

 private:
  static constexpr unsigned kMask = 1u << static_cast<unsigned>(RayKind::shadow);

  bool blocks(const Shape& shape, Opacity opacity, const EntryPoints* inner) const {
    if (opacity == Opacity::opaque) return inner ? shape.occludes_from(*inner, ray_, above_, t_max_) : shape.occludes(ray_, above_, t_max_);
    shapes::ScratchHits hits;
    shape.intersect_all(ray_, RayKind::shadow, hits.list());
    for (std::size_t i = hits.begin(); i < hits.end(); ++i)
      if (hits[i].t >= above_ && hits[i].t < t_max_ && hits[i].shape->surface->opaque) return true;
    return false;
  }

  const Impl& w_;
  const Ray& ray_;
  const double above_, t_max_;
};

bool World::occluded(const Ray& ray, double t_min, double t_max, WorldEntry* entry) const {
  const Impl& w = *impl_;
  const Occlusion occlusion(w, ray, t_min, t_max);
  if (entry && entry->last_blocker != WorldEntry::kNoBlocker && occlusion.by_candidate(entry->last_blocker, entry)) return true;
  if (occlusion.by_unbounded([&](std::size_t, const Plane& plane) { return plane.distance_along(ray); })) return true;
  bool found = false;
  w.tree.traverse(ray, t_min, t_max, [&](std::uint32_t i, double far) {
    if (!occlusion.by_candidate(i, entry)) return far;
    found = true;
    if (entry) entry->last_blocker = i;
    return -HUGE_VAL;
  }, entry ? &entry->points : nullptr);
  return found;
}

void World::occluded_row(const RayRow& rays, int first, int count, const bool* wanted, double t_min, const double* t_max, WorldEntry* entry, bool* blocked) const {
  const Impl& w = *impl_;
  RowScratch scratch;
  w.meet_planes(rays, first, count, scratch);
  const bool boxes = entry && entry->points.complete;
  if (boxes) row_kernels().boxes(entry->points, w.tree.center(), rays, first, count, t_min, scratch.met);
  for (int i = first; i < first + count; ++i) {
    if (!wanted[i]) continue;
    const Ray ray = rays.at(i);
    const Occlusion occlusion(w, ray, t_min, t_max[i]);
    blocked[i] = (entry && entry->last_blocker != WorldEntry::kNoBlocker && occlusion.by_candidate(entry->last_blocker, entry)) ||
                 occlusion.by_unbounded([&](std::size_t k, const Plane& plane) { return k < RowScratch::kPlanes ? scratch.planes[k][i] : plane.distance_along(ray); });
    if (blocked[i]) continue;
    double limit = t_max[i];
    const auto test = [&](std::uint32_t candidate) {
      if ((entry && candidate == entry->last_blocker) || !occlusion.by_candidate(candidate, entry)) return;
      blocked[i] = true;
      if (entry) entry->last_blocker = candidate;
      limit = -HUGE_VAL;
    };
    if (boxes) {
      visit_boxes(scratch.met, i, [&] { return limit; }, [&](int place) { test(candidate_at(entry->points, place)); });
    } else {
      w.tree.traverse(ray, t_min, limit, [&](std::uint32_t candidate, double) {
        test(candidate);
        return limit;
      }, entry ? &entry->points : nullptr);
    }
  }
}

bool World::occluded_by(int frame_object, const Ray& ray, double t_min, double t_max) const {
  const Entry& e = impl_->entries[static_cast<std::size_t>(frame_object)];
  shapes::ScratchHits hits;
  e.shape->intersect_all(ray, RayKind::shadow, hits.list());
  for (std::size_t i = hits.begin(); i < hits.end(); ++i)
    if (hits[i].t > t_min && hits[i].t < t_max && hits[i].shape->surface->opaque) return true;
  return false;
}

void World::enter(const Shaft& shaft, WorldEntry& entry) const {
  const Impl& w = *impl_;
  entry.last_blocker = WorldEntry::kNoBlocker;
  w.tree.enter(shaft, entry.points);
  entry.inner.clear();
  bool opaque = entry.points.complete && !w.transparent_unbounded;
  for (int n = 0; n < entry.points.count; ++n) {
    const BoxNode& node = entry.points.nodes[n];
    for (int k = 0; k < 4; ++k) {
      if (!(node.child[k] & BoxNode::kLeaf)) continue;  // a subtree; or none, the last node may not be full
      const std::uint32_t index = BoxNode::leaf_first(node.child[k]);
      const Candidate& c = w.bounded[index];
      opaque = opaque && (c.opacity == Opacity::opaque || (c.hidden & bit(RayKind::shadow)));
      if (!c.has_tree) continue;
      WorldEntry::Inner& inner = entry.inner.emplace_back();
      inner.candidate = index;
      if (!c.shape->enter(shaft, inner.points)) entry.inner.pop_back();
    }
  }
  entry.only_opaque = opaque || !w.transparent_shadows;
}

const BoxTree& World::tree() const { return impl_->tree; }

bool World::has_transparent_shadows() const { return impl_->transparent_shadows; }

void World::interiors_at(const Vec3& p, std::vector<const scene::Interior*>& interiors) const {
  const Impl& w = *impl_;
  interiors.clear();
  thread_local std::vector<std::uint32_t> around;
  around.assign(w.unbounded.begin(), w.unbounded.end());
  w.tree.any_around(p, [&](std::uint32_t i) {
    around.push_back(w.bounded[i].entry);
    return false;
  });
  std::sort(around.begin(), around.end());
  for (const std::uint32_t index : around) {
    const Entry& e = w.entries[index];
    if (e.object->interior && contains(e.box, p) && e.shape->inside_unclipped(p)) interiors.push_back(e.object->interior.get());
  }
}

// A hit on an untextured primitive shows what the CSG object around it is made of at that point (spec 03 5.3).
void World::Impl::mix_cutaway(const Shape& shape, const Vec3& p, float weight, std::vector<textures::WeightedTexture>& out) const {
  const auto* csg = shape.object->as<scene::Csg>();
  if (!csg) {
    if (shape.surface && shape.surface->texture) out.push_back({shape.surface->texture, weight});
    return;
  }
  const auto children = shape.children();
  if (csg->difference) {
    if (!children.empty() && children[0]->object == scene::children_of(*shape.object)[0].get() && children[0]->inside_unclipped(p)) mix_cutaway(*children[0], p, weight, out);
    return;
  }
  std::size_t count = 0;
  for (const auto& child : children) count += child->inside_unclipped(p);
  for (const auto& child : children)
    if (child->inside_unclipped(p)) mix_cutaway(*child, p, weight / static_cast<float>(count), out);
}

void World::weighted_textures(const Hit& hit, bool inside_hit, std::vector<textures::WeightedTexture>& out) const {
  out.clear();
  const Surface& surface = *hit.shape->surface;
  if (!surface.texture && surface.cutaway && surface.extra_textures.empty()) {
    impl_->mix_cutaway(*surface.cutaway, hit.point, 1, out);
    return;
  }
  if (surface.extra_textures.empty()) return;
  thread_local std::vector<shapes::TextureShare> shares;
  shares.clear();
  hit.shape->texture_shares(hit, inside_hit, shares);
  for (const shapes::TextureShare& share : shares) {
    const auto* texture = share.texture < 0 ? surface.texture : surface.extra_textures[static_cast<std::size_t>(share.texture)];
    if (texture) out.push_back({texture, share.weight});
  }
}

std::span<const scene::LightSource* const> World::lights() const { return impl_->lights; }
Box3 World::bounds() const { return impl_->bounds; }

}  // namespace verisim::accel
