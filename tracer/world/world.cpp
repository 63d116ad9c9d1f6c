#include "tracer/world/world.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <utility>

#include "tracer/world/frame_list.h"
#include "tracer/bvh/shaft.h"
#include "tracer/world/world_impl.h"
#include "tracer/scene/bounds.h"
#include "tracer/shapes/csg/csg.h"

namespace verisim::accel {
namespace {

std::optional<Plane> plain_plane(const scene::Object& o) {
  const auto plane = shapes::plain_plane(o);
  return plane ? std::optional(Plane{plane->normal, plane->distance}) : std::nullopt;
}

bool has_tree(const scene::Object& o) {
  return o.as<scene::Mesh>() || o.as<std::shared_ptr<const scene::BicubicPatch>>() ||
         o.as<std::shared_ptr<const scene::Text>>();
}

unsigned hidden_by_flags(const scene::Object& o) {
  unsigned bits = 0;
  if (o.no_image)
    bits |= bit(RayKind::camera) | bit(RayKind::refracted) | bit(RayKind::radiosity_refracted) | bit(RayKind::photon);
  if (o.no_reflection) bits |= bit(RayKind::reflected) | bit(RayKind::radiosity_reflected);
  if (o.no_radiosity)
    bits |= bit(RayKind::radiosity) | bit(RayKind::radiosity_refracted) | bit(RayKind::radiosity_reflected);
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

// The RayKinds that do not see an object, as bits.
unsigned hidden_from(const scene::Object& o) {
  unsigned bits = hidden_by_flags(o);
  if (all_children_shadowless(o)) bits |= bit(RayKind::shadow) | bit(RayKind::photon);
  if (const auto* light = o.as<scene::LightSource>(); light && light->looks_like)
    bits |= hidden_by_flags(*light->looks_like);
  return bits;
}

// Kinds that POV-Ray tests without their box when there are too few objects for a hierarchy (spec 03 2.1).
bool exempt_from_box_test(const scene::Object& o) {
  return o.as<scene::Sphere>() || o.as<scene::Box>() || o.as<scene::Plane>() || o.as<scene::Triangle>() ||
         o.as<scene::SmoothTriangle>() || o.as<scene::Poly>() || o.as<scene::LightSource>();
}
// Kinds whose own intersection test is as cheap as that of their box.
bool cheaper_than_box_test(const scene::Object& o) {
  return o.as<scene::Sphere>() || o.as<scene::Box>() || o.as<scene::Plane>() || o.as<scene::Triangle>() ||
         o.as<scene::SmoothTriangle>();
}

// Of its box. Round surfaces touch no edge, or in a point.
bool may_run_along_edges(const scene::Object& o) {
  return o.as<scene::Box>() || o.as<scene::Csg>() || o.as<scene::Mesh>() || o.as<scene::Polygon>() ||
         o.as<scene::Triangle>() || o.as<scene::SmoothTriangle>() || o.as<std::shared_ptr<const scene::Prism>>() ||
         o.as<std::shared_ptr<const scene::HeightField>>() || o.as<std::shared_ptr<const scene::Isosurface>>() ||
         o.as<std::shared_ptr<const scene::Text>>();
}

// As many sizes of a box away the last bits of single precision are as large as it, with room for three operations.
constexpr float kFewLastBits = 1e6f;

bool encloses(const Box3& pov, const Box3& surface) {
  return !is_empty(surface) && contains(pov, surface.min) && contains(pov, surface.max);
}

// The surface and all that it encloses lie in a finite box.
bool within_finite_box(const Shape& shape) {
  const Box3 surface = shape.bounds();
  const shapes::SolidExtent solid = shape.solid_extent();
  return is_finite(surface) && !is_empty(surface) && !solid.outside && contains(surface, solid.box.min) &&
         contains(surface, solid.box.max);
}

std::uint32_t hash_of(const scene::Bounds& box) {
  std::uint64_t hash = 0;
  for (const auto& corner : {box.low, box.size})
    for (const float v : corner)
      hash = (hash ^ std::bit_cast<std::uint32_t>(v)) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29;
  return static_cast<std::uint32_t>(hash);
}

// A shadow ray may meet something there that is not opaque.
bool lets_light_through(const Entry& e) { return e.opacity != Opacity::opaque && !(e.hidden & bit(RayKind::shadow)); }

}  // namespace

World::World(const scene::Scene& scene, textures::Compiler& compiler, const Arrangement& arrangement)
    : impl_(std::make_unique<Impl>()) {
  Impl& w = *impl_;
  FrameList list = frame_list(scene, arrangement.split_unions);
  w.lights = std::move(list.lights);
  w.texts = std::move(list.texts);
  w.in_order = std::cmp_less(list.entries, arrangement.bounding_threshold);
  w.entries.reserve(list.objects.size()), w.shapes.reserve(list.objects.size());
  Impl::Places places;
  for (std::uint32_t i = 0; i < list.objects.size(); ++i) {
    w.add_entry(list, i, arrangement.remove_bounds, compiler);
    w.find_place(i, places);
  }
  w.find_where_all_are_precise();
  w.set_apart(places.in_tree, places.beside);
  w.find_enclosures();
  w.build_trees(places);
  w.find_twins(places.copies);
}

void World::Impl::add_entry(const FrameList& list, std::uint32_t index, bool remove_bounds,
                            textures::Compiler& compiler) {
  const scene::Object& o = *list.objects[index];
  shapes.push_back(shapes::compile(o, {remove_bounds}));
  Shape& shape = *shapes.back();
  const std::size_t first_surface = surfaces.size();
  if (index == 0 || list.whole[index] != list.whole[index - 1]) hand_down(list.whole[index], compiler);
  add_surfaces(shape, static_cast<int>(index), nullptr, compiler);
  find_twice_filtering(first_surface);

  Entry e;
  e.shape = &shape;
  e.object = &o;
  e.copied = list.copied[index];
  e.hidden = static_cast<unsigned short>(hidden_from(o));
  e.opacity = opacity_of(first_surface);
  e.infinite = scene::is_infinite(o);
  find_box_tests(e);
  find_rounding(e);
  entries.push_back(e);
  if (lets_light_through(e)) transparent_shadows = true;
  if (o.interior) interiors = true;
  if (!e.infinite && !e.no_box) bounds.extendBy(e.box());
  if (!is_never_met(e) && imprecise_afar(first_surface)) imprecise.push_back(index);
}

bool World::Impl::needs_no_box(const scene::Object& o) const { return in_order && exempt_from_box_test(o); }

bool World::Impl::is_never_met(const Entry& e) const { return e.no_box && !needs_no_box(*e.object); }

void World::Impl::find_box_tests(Entry& e) const {
  const scene::Object& o = *e.object;
  e.no_box = is_empty(e.box());
  e.test_box = !e.no_box && (e.infinite || in_order) && !cheaper_than_box_test(o) && !needs_no_box(o) &&
               volume(o.bounds) < 7e30f;
  if (!e.no_box && !exempt_from_box_test(o)) e.slab = slab_test(o.bounds);
  // Some of those without a box have a surface of finite size all the same, as solids cut out by planes do.
  e.test_surface = !is_never_met(e) && is_boxless(e) && !cheaper_than_box_test(o) && within_finite_box(*e.shape);
}

bool World::Impl::is_boxless(const Entry& e) const { return e.infinite || e.no_box || needs_no_box(*e.object); }

void World::Impl::find_place(std::uint32_t index, Places& places) const {
  const Entry& e = entries[index];
  if (is_never_met(e)) return;
  if (e.copied && e.object->as<scene::Mesh>()) places.copies.push_back({index, hash_of(e.object->bounds)});
  if (e.test_surface && !in_order)
    places.perhaps_in_tree.push_back(index);
  else if (is_boxless(e) || in_order)
    places.beside.push_back(index);
  else
    places.in_tree.push_back(index);
}

void World::Impl::build_trees(const Places& places) {
  for (const std::uint32_t i : places.beside) add_beside_tree(i, entries[i]);
  bounded.reserve(places.in_tree.size() + places.perhaps_in_tree.size());
  for (const std::uint32_t i : places.in_tree) add_bounded(i, entries[i]);
  // The tree may keep those, too, for what it finds is put in order later; but the digits of its boxes are relative to
  // the largest of them.
  constexpr double kOutsized = 4;
  const auto longest = [](const Box3& box) {
    return is_empty(box) ? 0 : std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  };
  for (const std::uint32_t i : places.perhaps_in_tree) {
    if (longest(entries[i].shape->bounds()) <= kOutsized * longest(bounds))
      add_bounded(i, entries[i]);
    else
      add_beside_tree(i, entries[i]);
  }
  // Boxes are asked for again instead of being kept: of many objects they would be memory that nobody needs later.
  const auto box = [&](std::size_t i) { return box_to_keep(entries[bounded[i].entry]); };
  tree = Bvh(bounded.size(), box, 1), deep_tree = Bvh(deep_boxes);
  if (bounded.size() > shapes::BoxSet::kMax) return;
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < bounded.size(); ++i) boxes.push_back(box(i));
  if (std::ranges::none_of(boxes, [](const Box3& b) { return is_empty(b) || !is_finite(b); }))
    few = shapes::BoxSet(boxes);
}

// Programs that show an object in many colours put them all in one place.
void World::Impl::find_twins(const std::vector<Places::Copy>& copies) {
  constexpr std::uint8_t kMany = 4;      // fewer are not worth it
  constexpr std::size_t kMaxKinds = 64;  // more take too long to compare
  // Most scenes have no two boxes alike, which is to cost next to nothing: of hundreds of thousands, too.
  std::vector<std::uint8_t> alike(std::bit_ceil(2 * copies.size() + 1));
  const auto place = [&](const Places::Copy& copy) -> std::uint8_t& { return alike[copy.hash & (alike.size() - 1)]; };
  for (const Places::Copy& copy : copies) place(copy) = static_cast<std::uint8_t>(std::min(place(copy) + 1, +kMany));
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_box;
  for (const Places::Copy& copy : copies)
    if (place(copy) == kMany) by_box[copy.hash].push_back(copy.entry);
  std::uint32_t number = 0;
  for (const auto& [hash, there] : by_box) {
    if (there.size() < kMany) continue;
    twins.resize(entries.size());
    std::vector<std::uint32_t> kinds;  // the first of each
    for (const std::uint32_t i : there) {
      const auto same = std::ranges::find_if(
          kinds, [&](std::uint32_t kind) { return entries[i].shape->is_met_like(*entries[kind].shape); });
      if (same != kinds.end())
        twins[i] = twins[*same];
      else if (kinds.size() < kMaxKinds)
        kinds.push_back(i), twins[i] = ++number;
    }
  }
}

Opacity World::Impl::opacity_of(std::size_t first) {
  std::size_t opaque = 0;
  for (std::size_t s = first; s < surfaces.size(); ++s) opaque += surfaces[s].opaque;
  return opaque == surfaces.size() - first ? Opacity::opaque : opaque == 0 ? Opacity::transparent : Opacity::mixed;
}

void World::Impl::find_rounding(Entry& e) {
  const scene::Object& o = *e.object;
  const Box3 box = e.box();
  e.ranked = !e.infinite && !in_order;
  if (e.ranked) e.exact_within = kFewLastBits * *std::ranges::max_element(o.bounds.size);
  e.edged = e.ranked && may_run_along_edges(o);
  // Rays that hardly rise meet a sor before or behind its box, by the rounding of its formula; and fractals in CSG say
  // that their hits are nearer than they are.
  const bool boxed = !e.infinite && !is_empty(box);
  e.cut = boxed && !encloses(box, e.shape->bounds());
  e.strays = boxed && e.shape->may_stray();
}

// POV-Ray takes hits of these at any distance, where the rounding of their formulas is larger than the object.
bool World::Impl::imprecise_afar(std::size_t first) {
  return any_surface_of<scene::Ovus>(first) || any_surface_of<std::shared_ptr<const scene::SphereSweep>>(first);
}

void World::Impl::find_where_all_are_precise() {
  for (const std::uint32_t i : imprecise)
    imprecise_center += entries[i].box().center() / static_cast<double>(imprecise.size());
  for (const std::uint32_t i : imprecise) {
    const Box3 box = entries[i].box();
    precise_within = std::min(precise_within, Entry::afar(box) - length(box.center() - imprecise_center));
  }
}

template <class Kind>
bool World::Impl::any_surface_of(std::size_t first) {
  for (std::size_t s = first; s < surfaces.size(); ++s)
    if (surfaces[s].object->as<Kind>()) return true;
  return false;
}

void World::Impl::add_beside_tree(std::uint32_t index, const Entry& e) {
  unbounded.push_back(index);
  planes.push_back(e.test_box ? std::nullopt : plain_plane(*e.object));
}

void World::Impl::set_apart(std::vector<std::uint32_t>& finite, std::vector<std::uint32_t>& beside) {
  constexpr std::size_t kMax = 4;
  constexpr double kFar = 3;  // times the size of all others
  std::vector<std::uint32_t> candidates(finite);
  std::copy_if(beside.begin(), beside.end(), std::back_inserter(candidates),
               [&](std::uint32_t i) { return !entries[i].test_box && is_finite(entries[i].shape->bounds()); });
  if (candidates.size() < 2) return;
  const std::size_t most = std::min(kMax, candidates.size() - 1);
  struct Sized {
    double size;
    std::uint32_t entry;
  };
  std::vector<Sized> by_size(candidates.size());
  std::ranges::transform(candidates, by_size.begin(), [&](std::uint32_t i) {
    return Sized{length(entries[i].box().size()), i};
  });
  std::ranges::partial_sort(by_size, by_size.begin() + static_cast<std::ptrdiff_t>(most), std::greater<>(),
                            &Sized::size);
  const auto box = [&](std::size_t k) { return entries[by_size[k].entry].box(); };
  Box3 others;
  for (std::size_t k = most; k < by_size.size(); ++k) others.extendBy(box(k));
  for (std::size_t count = most; count > 0 && around.empty(); others.extendBy(box(--count))) {
    const Vec3 center = 0.5 * (others.min + others.max), reach = 0.5 * kFar * (others.max - others.min);
    const Box3 wide(center - reach, center + reach);
    for (std::size_t k = 0; k < count; ++k) {
      const Entry& e = entries[by_size[k].entry];
      const Box3 surface = e.shape->bounds();
      const auto enclosure = shapes::InteriorProxy::of(*e.object);
      if (enclosure && enclosure->holds(wide) && contains(e.box(), surface.min) && contains(e.box(), surface.max))
        around.push_back({by_size[k].entry, *enclosure});
    }
    if (around.size() < count) around.clear();
  }
  for (const Surrounding& s : around) std::erase(finite, s.entry), std::erase(beside, s.entry);
}

// The true bounds of the surface where POV-Ray's box encloses them.
Box3 World::Impl::box_to_keep(const Entry& e) { return e.cut || e.strays ? e.box_of_hits() : e.shape->bounds(); }

void World::Impl::add_bounded(std::uint32_t index, const Entry& e) {
  bounded.push_back({e.shape, index, static_cast<unsigned short>(e.hidden), e.opacity, has_tree(*e.object)});
  const Box3 box = e.box(), kept = box_to_keep(e);
  const shapes::SolidExtent solid = e.shape->solid_extent();
  const Box3 inside = solid.outside ? box : shapes::common(box, solid.box);
  if (!is_empty(inside) && !(contains(kept, inside.min) && contains(kept, inside.max)))
    deep.push_back(index), deep_boxes.push_back(inside);
}

void World::Impl::find_enclosures() {
  constexpr std::size_t kMax = 8;  // each may be looked at for every shaft
  only_enclosures = true;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (!lets_light_through(entries[i])) continue;
    const auto proxy = shapes::InteriorProxy::of(*entries[i].object);
    const bool is_enclosure = proxy && enclosures.size() < kMax &&
                              std::any_of(lights.begin(), lights.end(), [&](const scene::LightSource* light) {
                                return proxy->holds(light->position);
                              });
    if (is_enclosure) enclosures.push_back({i, *proxy});
    only_enclosures = only_enclosures && is_enclosure;
  }
}

bool World::Impl::seems_opaque(std::uint32_t entry, const Shaft& shaft) const {
  if (!lets_light_through(entries[entry])) return true;
  const auto enclosure =
      std::find_if(enclosures.begin(), enclosures.end(), [&](const Enclosure& r) { return r.entry == entry; });
  return enclosure != enclosures.end() && enclosure->proxy.holds(shaft.from()) && enclosure->proxy.holds(shaft.to());
}

World::~World() = default;

std::vector<Coincidences::Met>& Coincidences::scratch() {
  thread_local std::vector<Met> list;
  return list;
}

const Hierarchy& World::Impl::hierarchy() const {
  std::call_once(hierarchy_made, [this] {
    std::vector<Hierarchy::Item> items;
    items.reserve(entries.size());
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      // A light has the box of what it looks like.
      const auto* light = entries[i].object->as<scene::LightSource>();
      const scene::Object& shown = light ? *light->looks_like : *entries[i].object;
      items.push_back({i, shown.bounds, scene::is_infinite(shown)});
    }
    made_hierarchy = Hierarchy(std::move(items));
    made_hierarchy.find_parents();
  });
  return made_hierarchy;
}

bool World::Impl::reaches(const Ray& ray, std::uint32_t index, double best) const {
  // Where a ray runs through the inside of the box for a while, rounding cannot refuse it. Along a face it can: boxes
  // around this one may end a little before it.
  const double slack = kCoincident * length(ray.origin) + 1e-8;
  const Box3 box = entries[index].box(), inside(box.min + Vec3(slack), box.max - Vec3(slack));
  double near = -HUGE_VAL, far = HUGE_VAL;
  if (!is_empty(inside) && clip_to_box(ray, inside, near, far) &&
      far - near > kCoincident * (std::fabs(near) + length(ray.origin)))
    return true;
  return hierarchy().reaches(ray, index, best);
}

void World::Impl::settle(const Ray& ray, int lane, double t_max, const Coincidences& coincidences, Hit& hit) const {
  thread_local std::vector<const Coincidences::Met*> there;
  there.clear();
  const double farthest = with_coincident(hit.t);
  for (const Coincidences::Met& met : coincidences.all())
    if (met.lane == lane && met.hit.t <= farthest) there.push_back(&met);
  if (there.size() < 2) return;
  const auto entry_of = [](const Coincidences::Met* met) { return met->entry; };
  std::ranges::sort(there, {}, entry_of);
  if (in_order) {
    double best = t_max;
    for (const Coincidences::Met* met : there)
      if (met->hit.t < best) hit = met->hit, best = hit.t;
    return;
  }
  thread_local std::vector<Hierarchy::Found> hits;
  hits.clear();
  for (const Coincidences::Met* met : there) hits.push_back({met->entry, met->hit.t});
  if (const std::size_t stays = hierarchy().settle(ray, t_max, hits); stays < there.size()) hit = there[stays]->hit;
}

void World::enter(const Shaft& shaft, WorldEntry& entry) const {
  const Impl& w = *impl_;
  entry.last_blocker = WorldEntry::kNoBlocker;
  w.tree.enter(shaft, entry.points);
  const auto each_candidate = [&](auto&& visit) {
    for (int n = 0; n < entry.points.count; ++n) {
      for (const std::uint32_t child : entry.points.nodes[n].child) {
        // Others are subtrees; or none, the last node may not be full.
        if (child & BoxNode::kLeaf) visit(BoxNode::leaf_first(child));
      }
    }
  };
  std::size_t trees = 0;
  each_candidate([&](std::uint32_t index) { trees += w.bounded[index].has_tree; });
  entry.inner.clear(), entry.inner.reserve(trees);  // they are large, and slots keep them
  bool opaque = entry.points.complete;
  each_candidate([&](std::uint32_t index) {
    const Candidate& c = w.bounded[index];
    opaque = opaque && w.seems_opaque(c.entry, shaft);
    if (!c.has_tree) return;
    WorldEntry::Inner& inner = entry.inner.emplace_back();
    inner.candidate = index;
    if (!c.shape->enter(shaft, inner.points)) entry.inner.pop_back();
  });
  for (const std::uint32_t i : w.unbounded) opaque = opaque && w.seems_opaque(i, shaft);
  for (const Surrounding& s : w.around)
    opaque = opaque &&
             (w.seems_opaque(s.entry, shaft) || (s.enclosure.holds(shaft.from()) && s.enclosure.holds(shaft.to())));
  entry.only_opaque = opaque || !w.transparent_shadows;
}

const Bvh& World::tree() const { return impl_->tree; }

std::vector<std::pair<scene::SourceLocation, std::string>> World::findings() const {
  std::vector<std::pair<scene::SourceLocation, std::string>> result;
  for (const Entry& e : impl_->entries)
    if (std::string text = e.copied ? std::string() : e.shape->finding(); !text.empty())
      result.emplace_back(e.object->place, std::move(text));
  return result;
}

bool World::has_transparent_shadows() const { return impl_->transparent_shadows; }
bool World::filters_twice() const { return impl_->filters_twice; }

bool World::only_opaque_between(const Vec3& from, const Vec3& to) const {
  return impl_->only_enclosures &&
         std::all_of(impl_->enclosures.begin(), impl_->enclosures.end(), [&](const Enclosure& enclosure) {
           return enclosure.proxy.holds(from) && enclosure.proxy.holds(to);
         });
}

std::vector<const scene::Object*> World::objects() const {
  std::vector<const scene::Object*> objects;
  for (const Entry& entry : impl_->entries) objects.push_back(entry.object);
  return objects;
}
std::span<const scene::LightSource* const> World::lights() const { return impl_->lights; }
Box3 World::bounds() const { return impl_->bounds; }

}  // namespace verisim::accel
