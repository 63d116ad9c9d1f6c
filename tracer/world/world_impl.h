// What a World is made of, for its own files: world.cpp makes it, world_surfaces.cpp tells what shows and blocks light
// on it, world_search.cpp follows one ray, world_batches.cpp eight.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>

#include "tracer/bvh/bvh.h"
#include "tracer/bvh/hierarchy.h"
#include "tracer/bvh/slab_test.h"
#include "tracer/textures/compile/ready_maps.h"
#include "tracer/world/frame_list.h"
#include "tracer/world/world.h"
#include "tracer/shapes/quadrics/box_set.h"
#include "tracer/shapes/csg/interior_proxy.h"
#include "tracer/shapes/half_spaces.h"
#include "tracer/shapes/implicit/last_miss.h"
#include "tracer/shapes/quadrics/plane.h"

namespace verisim::accel {

using shapes::kShadowTolerance;
using shapes::Shape;
using shapes::Surface;

enum class Opacity : unsigned char { opaque, transparent, mixed };

// POV-Ray's box with room for rounding.
inline Box3 widened(const scene::Bounds& b) {
  Vec3 low = scene::low_corner(b), high;
  for (int i = 0; i < 3; ++i) {
    high[i] = low[i] + b.size[i];
    const double pad = 1e-6 * std::max(std::fabs(low[i]), std::fabs(high[i])) + 1e-9;
    low[i] -= pad, high[i] += pad;
  }
  return {low, high};
}

// One frame-level object.
struct Entry {
  const Shape* shape = nullptr;
  const scene::Object* object = nullptr;
  unsigned short hidden = 0;  // RayKinds that do not see it, as bits
  Opacity opacity = Opacity::opaque;
  bool infinite = false;      // of the kind POV-Ray tests before all others
  bool test_box = false;      // rays that miss the box miss the object
  bool copied = false;        // of a declared object, or part of such a copy
  bool test_surface = false;  // no box of POV-Ray's decides, but the surface has one of finite size
  bool ranked = false;        // is in POV-Ray's hierarchy
  bool edged = false;         // and its surface may run along edges of its box
  bool cut = false;           // or reach out of its box, which decides what is seen
  bool strays = false;        // hits of some rays may lie out of the box (Shape::strays)
  bool no_box = false;        // its box has negative sides
  // Rays that come from farther meet its box in POV-Ray's hierarchy, if it is there, by rounding: they may be refused,
  // or the box be moved.
  float exact_within = std::numeric_limits<float>::infinity();
  SlabTest slab;                                        // for hits
  Box3 box() const { return widened(object->bounds); }  // POV-Ray's, right or wrong
  // Where hits that count begin to be looked for. POV-Ray has met a box that ends sooner than those of shadow rays do.
  Box3 box_of_hits() const {
    Box3 box = this->box();
    if (cut || strays) box.min -= Vec3(kShadowTolerance), box.max += Vec3(kShadowTolerance);
    return box;
  }
  bool may_meet(const Ray& ray, double t_min, double t_max) const {
    double near = t_min, far = cut || strays ? HUGE_VAL : t_max;
    return (!test_box || clip_to_box(ray, box_of_hits(), near, far)) &&
           (!test_surface || clip_to_box(ray, shape->bounds(), near, far));
  }
  // Hits of the ray may lie out of POV-Ray's box, which decides all the same.
  bool leaves_box(const Ray& ray) const { return ranked && (cut || (strays && shape->strays(ray))); }
  // The rounding of boxes may refuse a ray that meets the surface near an edge of the box, or goes along a face; or one
  // that comes from afar.
  bool in_doubt(const Ray& ray, const Hit& hit) const {
    if (in_doubt_at(hit.t)) return true;
    const Vec3& d = ray.direction;
    const double least = std::min({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    return (edged || (ranked && least <= 1e-6 * (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z)))) &&
           at_edge(ray, hit);
  }
  // Wherever the ray meets it there.
  bool in_doubt_at(double t) const { return ranked && t > exact_within; }
  bool imprecise_from(const Vec3& origin) const {
    const Box3 box = this->box();
    return length(origin - box.center()) > afar(box);
  }
  static double afar(const Box3& box) {
    constexpr double kAfar = 1e4;  // in sizes of the box: nearer, the box has room for the rounding
    return kAfar * length(box.max - box.min);
  }
  // The hit lies before the box. POV-Ray asks objects in the order of their boxes, and not at all where the ray has met
  // something on its way to the box: its search is to be repeated.
  bool before_box(const Ray& ray, const Hit& hit) const {
    double near = -HUGE_VAL, far = HUGE_VAL;
    return clip_to_box(ray, box(), near, far) && hit.t < near + kCoincident * (std::fabs(near) + length(ray.origin));
  }
  // The box is wider than POV-Ray's by less than the slack.
  bool at_edge(const Ray& ray, const Hit& hit) const {
    const Vec3& p = hit.point;
    const Box3 box = this->box();
    const double slack = kCoincident * (hit.t + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z)) + 1e-8;
    const double reach = length(box.max - box.min) / length(ray.direction);
    int faces = 0;
    for (int i = 0; i < 3; ++i)
      if (std::min(p[i] - box.min[i], box.max[i] - p[i]) < slack)
        faces += std::fabs(ray.direction[i]) * reach < slack ? 2 : 1;
    return faces > 1;
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
    double slope, t;
    return shapes::one_ray::plane_intersection(normal, distance, ray.origin, ray.direction, slope, t) ? t : -1;
  }
};

// As far as POV-Ray looks for the boxes of objects: for those of shadow rays to the light, until something is met.
inline double end_of_boxes(RayKind kind, bool found, double limit) {
  return kind == RayKind::shadow && !found ? limit + kShadowTolerance : limit;
}

inline unsigned bit(RayKind kind) { return 1u << static_cast<unsigned>(kind); }

// What a search has to look at when the best hit lies at t: what is in the same place, too.
inline double with_coincident(double t) { return t + kCoincident * t; }

// How a hit of a search stands to the best one before it, if any was found.
struct Standing {
  bool nearer, coincident;  // in the same place

  Standing(bool found, const Hit& best, const Hit& hit)
      : nearer(!found || hit.t < best.t), coincident(found && (!nearer || best.t <= with_coincident(hit.t))) {}
};

// Which entries rays were found to meet in one place, and where: for most rays none.
class Coincidences {
 public:
  struct Met {
    int lane;
    std::uint32_t entry;
    Hit hit;
  };
  void add(int lane, std::uint32_t entry, const Hit& hit) {
    std::vector<Met>& list = scratch();
    if (!any_) list.clear();
    any_ = true;
    list.push_back({lane, entry, hit});
  }
  std::span<const Met> all() const { return any_ ? std::span<const Met>(scratch()) : std::span<const Met>(); }

 private:
  static std::vector<Met>& scratch();  // of this thread; a search does not begin another

  bool any_ = false;
};

// Whether something opaque of a shape that is so in parts lies on a ray, from `near` to before `far`.
bool blocks_partly(const Shape& shape, const Ray& ray, double near, double far);

// The next number, for numbers above 0.
inline double next_above(double x) {
  return x < std::numeric_limits<double>::infinity() ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1) : x;
}

// A large object far around all others, as a sky is. Rays begin within it, so that a tree would ask it first, about
// what is last on their way.
struct Surrounding {
  std::uint32_t entry;
  shapes::InteriorProxy enclosure;
};

// Within a transparent object in which a light stands, as a container of media around a scene: most shadow rays towards
// that light stay there.
struct Enclosure {
  std::uint32_t entry;
  shapes::InteriorProxy proxy;
};

// Surfaces by number, which stay where they are: in pieces that fit into the gaps which reading a scene leaves on the
// heap, where objects had transformations for a while.
class SurfaceList {
 public:
  Surface& add() {
    if (size_ % kPiece == 0) pieces_.push_back(std::make_unique<Piece>());
    return (*this)[size_++];
  }
  std::size_t size() const { return size_; }
  Surface& operator[](std::size_t i) { return (*pieces_[i / kPiece])[i % kPiece]; }

 private:
  static constexpr std::size_t kPiece = 3;
  using Piece = std::array<Surface, kPiece>;
  std::vector<std::unique_ptr<Piece>> pieces_;
  std::size_t size_ = 0;
};

struct World::Impl {
  std::vector<Entry> entries;
  std::vector<scene::ObjectPtr> texts;  // as unions of letters, which the scene does not have
  std::vector<std::unique_ptr<Shape>> shapes;
  std::vector<std::uint32_t> unbounded;      // entries beside the tree
  std::vector<std::optional<Plane>> planes;  // of each of them that is one
  std::vector<Surrounding> around;           // beside the tree, too
  std::vector<Enclosure> enclosures;
  // Entries whose formulas lose all digits afar: rays from there meet them by rounding where they pass them by.
  std::vector<std::uint32_t> imprecise;
  Vec3 imprecise_center{0, 0, 0};
  double precise_within = HUGE_VAL;  // so far from the center none is
  bool interiors = false;            // some object has one
  bool only_enclosures = false;      // whatever is not opaque has one
  std::vector<Candidate> bounded;    // of each box of the tree
  Bvh tree;
  // While surfaces are added. Of the texture of the CSG around them: whether images in maps reveal it; likewise of
  // those of dissolved unions that were met.
  textures::ReadyMaps ready_maps;
  std::pair<const scene::Texture*, bool> handed_down;
  std::unordered_map<const scene::Object*, bool> dissolved;
  // Entries of the tree that hold more than lies in their surface's box: all on one side of a disc is inside.
  std::vector<std::uint32_t> deep;
  std::vector<Box3> deep_boxes;
  Bvh deep_tree;
  shapes::BoxSet few;  // its boxes, if they are so few that a single ray finds them sooner without it
  SurfaceList surfaces;
  std::deque<Surface::Rest> surface_rests;
  std::vector<const scene::LightSource*> lights;
  Box3 bounds;
  std::vector<std::uint32_t> twins;  // the same number for entries that are met alike, 0: there is none; or empty
  bool in_order = false;             // too few entries for a hierarchy
  mutable std::once_flag hierarchy_made;
  mutable Hierarchy made_hierarchy;
  mutable std::once_flag ranks_made;
  mutable std::vector<std::uint32_t> made_ranks;
  bool transparent_shadows = false;  // something that shadow rays see is not opaque
  bool filters_twice = false;        // some surface does
  bool any_isosurface = false;       // among the surfaces

  // Which entries are asked, and when, is seen: isosurfaces remember it (spec 04 6.3).
  bool searches_in_turn() const { return any_isosurface && shapes::last_miss().kept; }
  // Bvh::traverse, or what does the same.
  template <class Visit>
  void traverse(const Ray& ray, double t_min, double t_max, Visit&& visit, const WorldEntry* entry) const {
    if (entry || few.empty())
      tree.traverse(ray, t_min, t_max, visit, entry ? &entry->points : nullptr);
    else
      few.traverse(ray, t_min, t_max, visit);
  }
  // Of the frame-level object with this index: its shape, its surfaces and what is to be known of it.
  void add_entry(const FrameList& list, std::uint32_t index, bool remove_bounds, textures::Compiler& compiler);
  // Which boxes its rays are to be tested with.
  void find_box_tests(Entry& e) const;
  // Where entries go.
  struct Places {
    std::vector<std::uint32_t> in_tree, beside;
    std::vector<std::uint32_t> perhaps_in_tree;  // POV-Ray has no box for them, but their surfaces are of finite size
    struct Copy {
      std::uint32_t entry, hash;  // of its box
    };
    std::vector<Copy> copies;  // of meshes
  };
  void find_place(std::uint32_t index, Places& places) const;
  void build_trees(const Places& places);
  void find_twins(const std::vector<Places::Copy>& copies);
  std::uint32_t twins_of(std::uint32_t index) const { return twins.empty() ? 0 : twins[index]; }
  // Too few entries for a hierarchy, and of a kind that POV-Ray then tests without its box.
  bool needs_no_box(const scene::Object& o) const;
  // A box with negative sides (spheres of negative radius and the like) hides what POV-Ray looks for by its box.
  bool is_never_met(const Entry& e) const;
  bool is_boxless(const Entry& e) const;
  // Of a frame-level object's surfaces, which are those from `first` on.
  Opacity opacity_of(std::size_t first);
  // How rounding decides whether the entry is met.
  void find_rounding(Entry& e);
  bool imprecise_afar(std::size_t first);
  void find_where_all_are_precise();
  template <class Kind>
  bool any_surface_of(std::size_t first);
  void add_beside_tree(std::uint32_t index, const Entry& e);
  static Box3 box_to_keep(const Entry& e);  // in the tree
  void add_bounded(std::uint32_t index, const Entry& e);
  // Moves what surrounds all others to `around`: from the entries of the tree and those beside it.
  void set_apart(std::vector<std::uint32_t>& finite, std::vector<std::uint32_t>& beside);
  void add_surfaces(Shape& shape, int frame_object, const Shape* cutaway, textures::Compiler& compiler);
  // It is not opaque by images in maps that objects before had.
  bool reveals_images(const scene::Object& object, textures::Compiler& compiler) const;
  bool reveals_images(const scene::TexturePtr& texture, textures::Compiler& compiler) const;
  // For the parts of a dissolved union that have its texture; or null.
  void hand_down(const scene::Object* whole, textures::Compiler& compiler);
  // Surface::filters_twice of a frame-level object's surfaces, which are those from `first` on.
  void find_twice_filtering(std::size_t first);
  void find_enclosures();
  // No shadow ray of the shaft meets what is not opaque of this entry: it is, or the whole shaft lies in its room.
  bool seems_opaque(std::uint32_t entry, const Shaft& shaft) const;
  const Hierarchy& hierarchy() const;  // made at the first ray that needs it: most scenes do not
  // Of each entry, its place among those that POV-Ray finds around a point (spec 06 2.1).
  const std::vector<std::uint32_t>& ranks() const;
  // Whether POV-Ray finds this hit of an entry, too, if nothing lies before `best`; before its box, perhaps.
  enum class Admission { refused, taken, before_box };
  Admission admit(std::uint32_t index, const Ray& ray, const Hit& hit, double best) const {
    const Entry& e = entries[index];
    if (!e.slab.passes(ray)) return Admission::refused;
    const bool leaves = e.leaves_box(ray);
    if ((leaves || e.in_doubt(ray, hit)) && !reaches(ray, index, best)) return Admission::refused;
    return leaves && e.before_box(ray, hit) ? Admission::before_box : Admission::taken;
  }
  // The same for some hit of a shadow ray that is followed to t_max.
  bool admits_blocker(std::uint32_t index, const Ray& ray, double t_max) const {
    const Entry& e = entries[index];
    if (!e.slab.passes(ray)) return false;
    return !(e.in_doubt_at(t_max) || e.leaves_box(ray)) ||
           reaches(ray, index, end_of_boxes(RayKind::shadow, false, t_max));
  }
  bool reaches(const Ray& ray, std::uint32_t index, double best) const;  // whether POV-Ray's hierarchy asks it
  // Calls visit(index, entry) for what a ray may meet before `best` by rounding alone, wherever its box is.
  template <class Visit>
  void each_imprecise(const Ray& ray, double best, Visit&& visit) const {
    if (all_precise_from(ray.origin)) return;
    for (const std::uint32_t i : imprecise) {
      const Entry& e = entries[i];
      if (e.imprecise_from(ray.origin) && e.slab.passes(ray) && (!e.ranked || hierarchy().reaches(ray, i, best)))
        visit(i, e);
    }
  }
  bool all_precise_from(const Vec3& origin) const { return length(origin - imprecise_center) < precise_within; }
  bool any_imprecise_for(const RayBatch& rays, int first, int count) const {
    if (imprecise.empty()) return false;
    for (int k = first; k < first + count; ++k) {
      const Vec3 origin = rays.at(k).origin;
      if (all_precise_from(origin)) continue;
      for (const std::uint32_t i : imprecise)
        if (entries[i].imprecise_from(origin)) return true;
    }
    return false;
  }
  // Of the entries that a ray meets in one place, the one that POV-Ray shows: its search, repeated (spec 08 A).
  void settle(const Ray& ray, int lane, double t_max, const Coincidences& coincidences, Hit& hit) const;
  void add_cutaway(const Shape& shape, const Vec3& p, std::vector<textures::WeightedTexture>& out) const;
};

}  // namespace verisim::accel
