// All objects of a scene ready for rays: frame-level list, BVH, infinite objects beside it (specs 03 section 2, 06
// section 9).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tracer/world/batch_kernels.h"
#include "tracer/scene/scene.h"
#include "tracer/shapes/shape.h"
#include "tracer/textures/texture.h"

namespace verisim::shapes {

// What one primitive looks like and belongs to.
struct Surface {
  const textures::CompiledTexture* texture = nullptr;           // null: cutaway, see World::cutaway_textures
  const textures::CompiledTexture* interior_texture = nullptr;  // may be null
  const scene::Interior* interior = nullptr;                    // never null
  const scene::Object* object = nullptr;                        // description of the primitive
  // What POV-Ray's shadow cache remembers of a hit that blocks a light, or null, and whether that filters once more
  // what passes here (spec 08 D).
  const Shape* remembered = nullptr;
  // The outermost intersection, difference, merge or clipped union around a primitive; null: none.
  const Shape* cutaway = nullptr;
  // What few have.
  struct Rest {
    std::vector<const scene::LightSource*> group_lights;
    std::vector<const textures::CompiledTexture*> extra_textures;
  };
  const Rest* rest = nullptr;  // null: nothing
  int frame_object = 0;        // index of the frame-level object
  bool opaque = false;         // texture and interior_texture are flagged opaque, or were (spec 06 9.3)
  bool filters_twice = false;
  bool double_illuminate = false, ignore_global_lights = false, uv_mapping = false, no_radiosity = false;

  std::span<const scene::LightSource* const> group_lights() const {
    return rest ? std::span<const scene::LightSource* const>(rest->group_lights)
                : std::span<const scene::LightSource* const>();
  }
  // Of Shape::extra_textures; entries may be null: the object's own.
  std::span<const textures::CompiledTexture* const> extra_textures() const {
    return rest ? std::span<const textures::CompiledTexture* const>(rest->extra_textures)
                : std::span<const textures::CompiledTexture* const>();
  }
  const scene::PhotonFlags& photons() const { return *object->photons; }
  // More than its own texture may show at a hit (World::weighted_textures).
  bool shows_several() const { return !texture || !extra_textures().empty(); }
  // Its own texture on the side that is hit.
  const textures::CompiledTexture* texture_within(bool inside) const {
    return inside && interior_texture ? interior_texture : texture;
  }
};

}  // namespace verisim::shapes

namespace verisim::accel {

using shapes::Hit;
using shapes::RayKind;

inline constexpr double kFarthestHit = 2e10;  // what POV-Ray finds behind it is no hit

class BoxesAlong;
class Bvh;
class Shaft;

// Where the rays of a shaft start in a world's tree, and what is known of them.
struct WorldEntry {
  EntryPoints points;
  bool only_opaque;  // no shadow ray of the shaft meets anything that is not opaque
  // Entries into the trees of shapes that have their own (meshes).
  struct Inner {
    std::uint32_t candidate;  // as the tree counts
    EntryPoints points;
  };
  std::vector<Inner> inner;
  const EntryPoints* inner_of(std::uint32_t candidate) const {
    for (const Inner& i : inner)
      if (i.candidate == candidate) return &i.points;
    return nullptr;
  }
  std::uint32_t last_blocker;  // what blocked the last shadow ray, as the tree counts

  static constexpr std::uint32_t kNoBlocker = 0xffffffffu;
};

// How POV-Ray arranges the objects of a scene; it shows where surfaces coincide and where bounds cut.
struct Arrangement {
  bool split_unions = false;   // dissolves bounded unions, too
  bool remove_bounds = true;   // drops bounded_by where POV-Ray finds it unnecessary
  int bounding_threshold = 3;  // fewer frame-level entries are asked in file order, most kinds without their boxes
};

class World {
 public:
  // The scene must outlive the world. Textures are compiled with `compiler`, which must outlive it, too.
  World(const scene::Scene& scene, textures::Compiler& compiler, const Arrangement& arrangement = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // The nearest hit with t_min <= t < t_max among the objects this kind of ray sees. Exact ties: spec 03 2.3.
  // `entry`: of a shaft that holds the ray; null: none known.
  bool intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit,
                 const WorldEntry* entry = nullptr) const;
  // Whether it pays to know at once all boxes that a ray meets and is followed past; if so, they are found.
  bool boxes_along(const Ray& ray, double t_min, double t_max, const WorldEntry* entry, BoxesAlong& boxes) const;
  // intersect() for a ray with the direction of one whose boxes are known, from a point of it at distance `travelled`.
  bool intersect_along(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit, const WorldEntry* entry,
                       const BoxesAlong& boxes, double travelled) const;
  // The objects that a ray meets in one place, at t: POV-Ray's order of them decides which of them shows (spec 08 A).
  // For who explains pixels, not for speed.
  std::vector<const scene::Object*> coincident(const Ray& ray, RayKind kind, double t) const;
  // Objects whose boxes a ray crosses before t_max and that it does not meet there.
  std::vector<const scene::Object*> passed(const Ray& ray, RayKind kind, double t_max) const;
  // True if any *opaque* surface lies in t_min < t < t_max (shadow rays; a cheap any-hit query).
  bool occluded(const Ray& ray, double t_min, double t_max, WorldEntry* entry = nullptr) const;
  // Both for rays first .. first + count - 1 of a batch, all of the shaft of `entry` (null: none known).
  // Eight limits are read at a time: t_max is as long as a batch; null: no limits. What is not blocked is not written.
  void intersect_batch(const RayBatch& rays, int first, int count, RayKind kind, double t_min, const WorldEntry* entry,
                       Hit* hits, bool* found, const double* t_max = nullptr) const;
  void occluded_batch(const RayBatch& rays, int first, int count, double t_min, const double* t_max, WorldEntry* entry,
                      bool* blocked) const;
  bool has_transparent_shadows() const;  // false: `occluded` alone decides every shadow
  bool filters_twice() const;            // some surface does
  // It is known that no shadow ray between these two points meets anything that is not opaque.
  bool only_opaque_between(const Vec3& from, const Vec3& to) const;

  // Interiors of all objects that contain p, in the order of the hierarchy (of few objects: of declaration), for the
  // start of a camera ray (spec 06 2.1).
  void interiors_at(const Vec3& p, std::vector<const scene::Interior*>& interiors) const;
  // The objects, by number, that alone may have interiors around points of the box; and the interiors of those that
  // contain a point of it.
  std::vector<std::uint32_t> holders(const Box3& box) const;
  void interiors_at(const Vec3& p, std::span<const std::uint32_t> holders,
                    std::vector<const scene::Interior*>& interiors) const;
  // The same for the start of a photon: in the order of declaration, and whatever bounds, clips and boxes the objects
  // have (spec 07 3.5).
  std::vector<std::uint32_t> photon_holders(const Box3& box) const;
  void interiors_of_photon(const Vec3& p, std::span<const std::uint32_t> holders,
                           std::vector<const scene::Interior*>& interiors) const;
  // Textures and weights of a hit whose primitive has several (blob components, mesh vertices, cutaway_textures);
  // empty: surface->texture alone. `out` is cleared first.
  void weighted_textures(const Hit& hit, bool inside_hit, std::vector<textures::WeightedTexture>& out) const;

  // What rays are tested against one by one: spec 03 2.3.
  std::vector<const scene::Object*> objects() const;
  std::span<const scene::LightSource* const> lights() const;  // global lights in file order
  Box3 bounds() const;                                        // of all finite objects
  // What shapes at frame level have to say after a render; copies of declared objects say nothing.
  std::vector<std::pair<scene::SourceLocation, std::string>> findings() const;

  // Of the objects with bounds.
  const Bvh& tree() const;
  // What the rays of a shaft may meet.
  void enter(const Shaft& shaft, WorldEntry& entry) const;

 private:
  // intersect() by POV-Ray's own search: objects in the order of their boxes.
  bool intersect_in_turn(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const;

  struct Impl;
  class BatchSearch;
  class Search;
  class Occlusion;
  class BatchOcclusion;
  std::unique_ptr<Impl> impl_;
};

}  // namespace verisim::accel
