// mesh and mesh2 (spec 04 section 1). All hits are reported; POV-Ray's early stop for meshes without inside_vector,
// which loses surfaces in CSG, is not reproduced.
#include "tracer/shapes/factories.h"
#include "tracer/shapes/mesh/mesh_geometry.h"
#include "tracer/shapes/tree_primitive.h"

namespace verisim::shapes {

namespace {

class Mesh final : public TreePrimitive<Mesh> {
 public:
  Mesh(const scene::Object& description, const scene::Mesh& mesh)
      : TreePrimitive(description, {mesh_vertex_box(*mesh.data), !has_inside(*mesh.data)}),
        geometry_(MeshGeometry::of(mesh.data)) {
    solid_ = has_inside(*mesh.data);
    if (solid_) {
      const Vec3 v = *mesh.data->inside_vector;
      inside_direction_ = normalize(has_matrix() ? matrix().inverse_direction(v) : v);
    }
    interior_texture_ = description.interior_texture != nullptr;
    textures_ = mesh.textures.empty() ? mesh.data->textures : mesh.textures;
  }

  const accel::BoxTree& tree() const { return geometry_->tree(); }

  template <class Sink>
  void crossings(const Ray& ray, Sink& sink, const accel::EntryPoints* entry = nullptr) const {
    const LocalRay r = local(ray);
    const double lower = std::max(MeshGeometry::kNearest, sink.lower() * r.scale * (1 - 1e-12));
    const auto limit = [&] { return std::min(MeshGeometry::kFarthest, sink.upper() * r.scale * (1 + 1e-12)); };
    double nearest = -1;
    std::uint32_t nearest_id = 0;
    geometry_->tree().traverse_leaves(
        {r.origin, r.direction}, lower, limit(),
        [&](std::uint32_t first, std::uint32_t count, double) {
          for (std::uint32_t i = first; i < first + count; ++i) {
            const double t = geometry_->hit(i, r.origin, r.direction);
            if (t < 0 || t > MeshGeometry::kFarthest) continue;
            const double world_t = t / r.scale;
            // Of triangles hit at the same distance (a ray through a shared edge) the last written is seen, whatever
            // the order of the walk.
            if (Sink::kNearest && world_t == nearest && geometry_->triangle(i).id() < nearest_id) continue;
            const bool accepted = sink.add(
                world_t, [&] { return ray.at(world_t); }, static_cast<std::int32_t>(i));
            if (Sink::kNearest && accepted) nearest = world_t, nearest_id = geometry_->triangle(i).id();
          }
          return limit();
        },
        entry);
  }

  bool contains(const Vec3& p) const { return solid_ && geometry_->crossings(local(p), inside_direction_) % 2 != 0; }
  bool formula(const Vec3& p) const { return solid_ && contains(p) != inverted(); }

  Vec3 raw_normal(const Hit& hit) const {
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
  static bool has_inside(const scene::MeshData& data) {
    if (!data.inside_vector) return false;
    const Vec3& v = *data.inside_vector;
    return std::fabs(v.x) >= kEpsilon || std::fabs(v.y) >= kEpsilon || std::fabs(v.z) >= kEpsilon;
  }

  std::shared_ptr<const MeshGeometry> geometry_;
  bool solid_ = false, interior_texture_ = false;
  Vec3 inside_direction_{0, 0, 0};
  std::vector<scene::TexturePtr> textures_;
};

}  // namespace

std::unique_ptr<Shape> compile_mesh(const scene::Object& object) {
  return std::make_unique<Mesh>(object, *object.as<scene::Mesh>());
}
Box3 mesh_box(const scene::Mesh& mesh) { return mesh_vertex_box(*mesh.data); }

}  // namespace verisim::shapes
