// mesh and mesh2 (spec 04 section 1).
//
// A mesh without inside_vector does not know all its hits: POV-Ray ends the search of the mesh's hierarchy at the first
// box that is entered beyond the hit that was found last (spec 08 C). Who asks for all hits, or would not take the
// nearest one, therefore gets what that search finds; so does a ray that meets two triangles in one place, of which the
// order of the boxes tells the one that is seen, with an inside_vector, too.
#include "tracer/shapes/factories.h"
#include "tracer/shapes/mesh/mesh_packet.h"
#include "tracer/shapes/tree_primitive.h"

namespace verisim::shapes {

namespace {

class Mesh final : public TreePrimitive<Mesh> {
 public:
  Mesh(const scene::Object& description, const scene::Mesh& mesh)
      : TreePrimitive(description, {mesh_vertex_box(*mesh.data), !has_inside(*mesh.data)}),
        geometry_(MeshGeometry::of(mesh.data)) {
    solid_ = has_inside(*mesh.data);
    partial_ = !solid_ && description.hierarchy;
    in_order_ = !description.hierarchy;
    if (solid_) {
      const Vec3 v = *mesh.data->inside_vector;
      inside_direction_ = normalize(has_matrix() ? matrix().inverse_direction(v) : v);
    }
    const Box3& all = tree().bounds();
    for (int k = 0; k < 3; ++k)
      rounding_ = std::max({rounding_, std::fabs(all.min[k]) * 0x1p-22, std::fabs(all.max[k]) * 0x1p-22});
    interior_texture_ = description.interior_texture != nullptr;
    textures_ = mesh.textures.empty() ? mesh.data->textures : mesh.textures;
  }

  const accel::Bvh& tree() const { return geometry_->tree(); }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink, const accel::EntryPoints* entry = nullptr) const {
    if constexpr (Sink::kNearest) {
      const bool two = every_intersection(ray, sink, entry) && !in_order_;
      const double nearest = sink.clipped_from_outside() ? sink.upper() : sink.lower();
      if (!sink.found() || !(two || (partial_ && meets_before(nearest, ray, entry)))) return;
      sink.restart();
    } else if (!partial_) {
      every_intersection(ray, sink, entry);
      return;
    }
    intersections_of_search(ray, sink);
  }

  // The order in which all hits are found is not POV-Ray's.
  void turn_hits() override {}

  bool is_met_like(const Shape& other) const override {
    const auto* mesh = dynamic_cast<const Mesh*>(&other);
    return mesh && geometry_ == mesh->geometry_ && !guards() && !mesh->guards() && in_order_ == mesh->in_order_ &&
           has_matrix() == mesh->has_matrix() &&
           (!has_matrix() || (matrix().m == mesh->matrix().m && matrix().inv == mesh->matrix().inv));
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (guards() || tree().empty()) return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    MeshPacket packet;
    const unsigned found = meet_packet(rays, entry, t_min, t_max, false, packet);
    unsigned searched = found & ((partial_ ? packet.passed_over : 0) | (in_order_ ? 0 : packet.met_two));
    searched |= refused_lanes(packet, found & ~searched);
    each_lane(found & ~searched, [&](int k) {
      hits[k] = {packet.t[k], rays.at(k).at(packet.t[k]), this, static_cast<std::int32_t>(packet.triangle[k]), 0, 0};
    });
    return (found & ~searched) |
           Shape::intersect_packet({rays.rays, rays.first, searched}, entry, kind, t_min, t_max, hits);
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (guards() || tree().empty()) return Shape::occludes_packet(rays, entry, t_min, t_max);
    MeshPacket packet;
    const unsigned found = meet_packet(rays, entry, t_min, t_max, true, packet);
    unsigned searched = refused_lanes(packet, found);
    if (partial_) each_lane(found, [&](int k) { searched |= meets_before(t_min, rays.at(k), entry) ? 1u << k : 0; });
    return (found & ~searched) | Shape::occludes_packet({rays.rays, rays.first, searched}, entry, t_min, t_max);
  }

  bool contains(const Vec3& p) const {
    return solid_ && geometry_->intersections(local(p), inside_direction_) % 2 != 0;
  }
  bool formula(const Vec3& p) const { return solid_ && contains(p) != inverted(); }

  Vec3 geometric_normal(const Hit& hit) const {
    const auto i = static_cast<std::uint32_t>(hit.part);
    // The stored flat normal is used as it is, without making its length exactly 1.
    if (!geometry_->smooth(i))
      return has_matrix() ? world_normal(geometry_->flat_normal(i)) : geometry_->flat_normal(i);
    return world_normal(geometry_->smooth_normal(i, local(hit.point)));
  }
  Vec2 uv(const Hit& hit) const override {
    return geometry_->uv(static_cast<std::uint32_t>(hit.part), local(hit.point));
  }

  std::span<const scene::TexturePtr> extra_textures() const override { return textures_; }
  void texture_shares(const Hit& hit, bool inside_hit, std::vector<TextureShare>& shares) const override {
    const auto i = static_cast<std::uint32_t>(hit.part);
    const auto& t = geometry_->source(i).texture;
    if (t[0] < 0 || (inside_hit && interior_texture_)) return;
    if (t[1] < 0 || t[2] < 0) {
      shares.push_back({t[0], 1});
      return;
    }
    const auto w = geometry_->weights(i, local(hit.point));
    const float sum = w[0] + w[1] + w[2];
    for (std::size_t k = 0; k < 3; ++k) shares.push_back({t[k], w[k] / sum});
  }

 private:
  // The lanes that meet a triangle.
  unsigned meet_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min, const double* t_max,
                       bool any, MeshPacket& packet) const {
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, packet.rays);
    mesh_kernels().meet(*geometry_, entry, rays.active, t_min, t_max, any, packet);
    unsigned found = 0;
    each_lane(rays.active, [&](int k) { found |= packet.triangle[k] >= 0 ? 1u << k : 0; });
    return found;
  }
  // A ray that hardly leaves a plane of coordinates, in which a face of the box of the triangle lies that it meets:
  // rounding decides whether POV-Ray's search lets it into that box, or, where it leaves the plane at all, into those
  // around it (spec 08 C). `t`: in mesh space.
  bool refused(const Ray& ray, double t, std::uint32_t triangle) const {
    constexpr double kLevel = 1e-12, kHardlyOff = 1e-6;
    const Vec3& d = ray.direction;
    const double least = std::min(std::fabs(d.x), std::min(std::fabs(d.y), std::fabs(d.z)));
    if (!(least < kHardlyOff) || in_order_) return false;
    const scene::Bounds box = geometry_->bounds(triangle);
    if (least < kLevel && !accel::Hierarchy::enters(ray, box)) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (const double off = std::fabs(d[k]); off < kLevel || off >= kHardlyOff) continue;
      const double from_low = ray.origin[k] + t * d[k] - static_cast<double>(box.low[k]);
      if (std::min(from_low, static_cast<double>(box.size[k]) - from_low) < rounding_) return true;
    }
    return false;
  }
  unsigned refused_lanes(const MeshPacket& packet, unsigned lanes) const {
    const LocalPacket& l = packet.rays;
    unsigned result = 0;
    each_lane(lanes, [&](int k) {
      const Ray ray{{l.ox[k], l.oy[k], l.oz[k]}, {l.dx[k], l.dy[k], l.dz[k]}};
      if (refused(ray, packet.t[k] * l.scale[k], static_cast<std::uint32_t>(packet.triangle[k]))) result |= 1u << k;
    });
    return result;
  }
  // Whether the nearest hit is one of two in the same place, or in a box that the ray is not let into.
  template <class Sink>
  bool every_intersection(const Ray& ray, Sink& sink, const accel::EntryPoints* entry) const {
    const LocalRay r = local(ray);
    const double lower = std::max(MeshGeometry::kNearest, sink.lower() * r.scale * (1 - 1e-12));
    const auto limit = [&] { return std::min(MeshGeometry::kFarthest, sink.upper() * r.scale * (1 + 1e-12)); };
    double nearest = -1;
    std::uint32_t nearest_triangle = 0;
    bool met_two = false;
    geometry_->tree().traverse_leaves(
        {r.origin, r.direction}, lower, limit(),
        [&](std::uint32_t first, std::uint32_t count, double) {
          for (std::uint32_t i = first; i < first + count; ++i) {
            const double t = geometry_->hit(i, r.origin, r.direction);
            if (t < 0) continue;
            const double world_t = t / r.scale;
            const bool second =
                MeshGeometry::in_one_place(world_t, nearest) && !geometry_->goes_on(nearest_triangle, i);
            met_two |= second;
            // Of triangles hit at the same distance (a ray through a shared edge) the last written is seen, whatever
            // the order of the walk.
            if (Sink::kNearest && world_t == nearest &&
                geometry_->triangle(i).id() < geometry_->triangle(nearest_triangle).id())
              continue;
            const bool accepted = sink.add(
                world_t, [&] { return ray.at(world_t); }, static_cast<std::int32_t>(i));
            if (!Sink::kNearest || !accepted) continue;
            nearest = world_t, nearest_triangle = i;
            met_two = second;
          }
          return limit();
        },
        entry);
    return met_two || (nearest >= 0 && refused({r.origin, r.direction}, nearest * r.scale, nearest_triangle));
  }

  // Whether the mesh has a hit nearer than the one that the caller took: one that is too near for it, or outside the
  // clip objects of a union.
  bool meets_before(double t_max, const Ray& ray, const accel::EntryPoints* entry) const {
    Hit hit;
    NearestHit nearer(*this, guards(), 0, t_max, hit, true);
    every_intersection(ray, nearer, entry);
    return nearer.found();
  }

  template <class Sink>
  void intersections_of_search(const Ray& ray, Sink& sink) const {
    const LocalRay r = local(ray);
    double last = std::numeric_limits<double>::infinity();
    geometry_->hierarchy().search({r.origin, r.direction}, last, [&](std::uint32_t i) {
      const double t = geometry_->hit(i, r.origin, r.direction);
      if (t < 0) return last;
      const double world_t = t / r.scale;
      const Vec3 p = ray.at(world_t);
      if (guards() && !guards()->contain(p)) return last;
      sink.add(
          world_t, [&] { return p; }, static_cast<std::int32_t>(i));
      return partial_ ? last = t : last;
    });
  }

  static bool has_inside(const scene::MeshData& data) {
    if (!data.inside_vector) return false;
    const Vec3& v = *data.inside_vector;
    return std::fabs(v.x) >= kEpsilon || std::fabs(v.y) >= kEpsilon || std::fabs(v.z) >= kEpsilon;
  }

  std::shared_ptr<const MeshGeometry> geometry_;
  bool solid_ = false, partial_ = false, in_order_ = false, interior_texture_ = false;
  Vec3 inside_direction_{0, 0, 0};
  double rounding_ = 0;  // more than what faces of boxes are off by, in binary32
  std::vector<scene::TexturePtr> textures_;
};

}  // namespace

std::unique_ptr<Shape> compile_mesh(const scene::Object& object) {
  return std::make_unique<Mesh>(object, *object.as<scene::Mesh>());
}
Box3 mesh_box(const scene::Mesh& mesh) { return mesh_vertex_box(*mesh.data); }

}  // namespace verisim::shapes
