// Objects and textures that are not what people mean.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>

#include "cli/describe/object_names.h"
#include "cli/lints/lints.h"
#include "tracer/query.h"

namespace verisim::cli {
namespace {

LintFinding finding(std::string_view lint, const scene::Object& object, std::string message) {
  LintFinding f;
  f.lint = lint_named(lint);
  if (object.place.file) f.file = *object.place.file;
  f.line = object.place.line;
  f.column = object.place.column;
  f.message = std::move(message);
  return f;
}

// A layer of one colour that nothing shows through.
bool is_opaque(const scene::TextureLayer& layer) {
  const scene::Pigment& p = *layer.pigment;
  return p.pattern.kind <= scene::PatternKind::plain && !p.color_map && !p.pigment_map && p.color.f == 0 &&
         p.color.t == 0;
}

bool is_plain(const scene::Object& o) {
  return o.texture && o.texture->layers.size() == 1 && is_opaque(o.texture->layers.front()) && !o.interior_texture;
}

// Not on the surface, where light goes out.
bool is_deep_inside(const query::Target& solid, const Vec3& p) {
  constexpr double kDeep = 1e-4;
  const Vec3 steps[] = {{0, 0, 0},      {kDeep, 0, 0}, {-kDeep, 0, 0}, {0, kDeep, 0},
                        {0, -kDeep, 0}, {0, 0, kDeep}, {0, 0, -kDeep}};
  return std::all_of(std::begin(steps), std::end(steps), [&](const Vec3& step) { return solid.inside(p + step); });
}

class Linter {
 public:
  Linter(const scene::Scene& scene, const std::function<bool()>& stop, std::vector<LintFinding>& found)
      : scene_(scene), stop_(stop), found_(found) {}

  void run() {
    for (const scene::ObjectPtr& o : scene_.objects) visit(o, true);
    lights();
    faces();
  }

 private:
  bool stopped() { return is_stopped_ || (is_stopped_ = stop_ && stop_()); }

  // `apart`: a part of the scene itself, not of a solid that is cut.
  void visit(const scene::ObjectPtr& pointer, bool apart) {
    if (stopped()) return;
    const scene::Object& o = *pointer;
    texture(o);
    mesh(o);
    if (const auto* light = o.as<scene::LightSource>()) {
      // Of parallel light and of the lamps of an area light, some begin elsewhere.
      if (!light->parallel && !light->area && light->kind != scene::LightKind::shadowless)
        lights_.emplace_back(light->position, &o);
      return;
    }
    const auto* csg = o.as<scene::Csg>();
    const bool frame = apart && (!csg || (csg->kind == scene::CsgKind::union_ && o.clipped_by.empty()));
    if (frame && !csg && !o.as<scene::LightGroup>()) solids_.push_back(pointer);
    if (frame && o.as<scene::Box>() && !o.transform && o.clipped_by.empty() && !o.inverted) boxes_.push_back(&o);
    for (const scene::ObjectPtr& child : scene::children_of(o)) visit(child, frame);
  }

  void texture(const scene::Object& o) {
    if (!o.texture || !seen_.insert(o.texture.get()).second) return;
    const auto& layers = o.texture->layers;
    for (std::size_t i = 1; i < layers.size(); ++i)
      if (is_opaque(layers[i])) {
        found_.push_back(finding("hidden-texture", o,
                                 fmt::format("Layer {} of the texture of this {} hides the {} below.", i + 1,
                                             object_keyword(o), i == 1 ? "one" : "ones")));
        break;
      }
    if (!scene_.settings.radiosity.enabled || scene_.version < 370) return;
    for (const scene::TextureLayer& layer : layers) {
      const Rgb& ambient = layer.finish->ambient;
      if (std::max({ambient.r, ambient.g, ambient.b}) <= 0.1001f) continue;  // the default
      found_.push_back(
          finding("ambient-with-radiosity", o,
                  fmt::format("The ambient of this {} counts nothing: radiosity is on.", object_keyword(o))));
      break;
    }
  }

  void mesh(const scene::Object& o) {
    if (const auto* t = o.as<scene::SmoothTriangle>()) {
      if (torn(t->p, t->n))
        found_.push_back(finding("inward-normals", o, "Normals of this triangle point to both of its sides."));
      return;
    }
  }

  static bool torn(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& n) {
    const Vec3 plane = cross(p[1] - p[0], p[2] - p[0]);
    constexpr double kGrazing = 1e-3;
    bool above = false, below = false;
    for (const Vec3& normal : n) {
      const double side = dot(plane, normal);
      const double size = length(plane) * length(normal) * kGrazing;
      above |= side > size;
      below |= side < -size;
    }
    return above && below;
  }

  void lights() {
    for (const scene::ObjectPtr& o : solids_) {
      if (lights_.empty() || stopped() || o->no_shadow || o->is_hollow() || !is_plain(*o) || scene::is_infinite(*o))
        continue;
      std::optional<query::Target> solid;
      for (auto& [position, light] : lights_) {
        if (!light) continue;  // told
        const auto& b = o->bounds;
        const double p[3] = {position.x, position.y, position.z};
        bool near = true;
        for (std::size_t i = 0; i < 3; ++i) near &= p[i] >= b.low[i] && p[i] <= double{b.low[i]} + b.size[i];
        if (!near) continue;
        if (!solid) solid.emplace(o);
        if (!solid->has_inside() || !is_deep_inside(*solid, position)) continue;
        if (scene_.camera_given && solid->inside(scene_.camera.location)) break;  // a room
        found_.push_back(finding("light-inside", *light, fmt::format("This light is inside the {}.", object_name(*o))));
        light = nullptr;
      }
    }
  }

  static std::pair<int, int> places(const scene::Object& a, const scene::Object& b) {
    return std::minmax({a.place.line, b.place.line});
  }

  // Whether two objects certainly look different: speckles of one colour are not seen. What one line makes several
  // times mostly looks the same.
  static bool differ(const scene::Object& a, const scene::Object& b) {
    if (a.place.line == b.place.line || !a.texture || !b.texture || a.texture == b.texture) return false;
    if (a.texture->layers.size() != 1 || b.texture->layers.size() != 1) return false;
    const scene::Pigment &p = *a.texture->layers.front().pigment, &q = *b.texture->layers.front().pigment;
    if (p.pattern.kind != q.pattern.kind) return true;
    return is_opaque(a.texture->layers.front()) && is_opaque(b.texture->layers.front()) &&
           (p.color.r != q.color.r || p.color.g != q.color.g || p.color.b != q.color.b);
  }

  // Whether the camera is on the side that a face of a box looks to: nobody sees speckles on what stands on the floor.
  bool may_show(int axis, bool upper, double at) const {
    const scene::Camera& camera = scene_.camera;
    if (!scene_.camera_given || camera.kind == scene::CameraKind::mesh_camera) return true;
    const auto along = [axis](const Vec3& v) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
    const double side =
        camera.kind == scene::CameraKind::orthographic ? -along(camera.direction) : along(camera.location) - at;
    return upper ? side > 0 : side < 0;
  }

  // Boxes with faces in one plane that look the same way and overlap.
  void faces() {
    struct Face {
      const scene::Object* object;
      double low[2], high[2];
    };
    std::map<std::tuple<int, bool, double>, std::vector<Face>> planes;
    for (const scene::Object* o : boxes_) {
      const auto& box = *o->as<scene::Box>();
      const double low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
      for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const bool upper : {false, true})
          if (const double at = upper ? high[axis] : low[axis]; may_show(axis, upper, at))
            planes[{axis, upper, at}].push_back({o, {low[u], low[v]}, {high[u], high[v]}});
      }
    }
    std::set<std::pair<int, int>> told;  // once for each two lines
    for (const auto& [plane, all] : planes) {
      if (stopped()) return;
      constexpr std::size_t kMax = 200;  // of many boxes in one plane the first will do
      for (std::size_t i = 0; i < std::min(all.size(), kMax); ++i)
        for (std::size_t j = i + 1; j < std::min(all.size(), kMax); ++j) {
          const Face &a = all[i], &b = all[j];
          const bool overlap = std::min(a.high[0], b.high[0]) > std::max(a.low[0], b.low[0]) &&
                               std::min(a.high[1], b.high[1]) > std::max(a.low[1], b.low[1]);
          if (!overlap || !differ(*a.object, *b.object) || !told.insert(places(*a.object, *b.object)).second) continue;
          found_.push_back(finding("coincident-surfaces", *b.object,
                                   fmt::format("A face of this box lies in that of the {} and looks the same way.",
                                               object_name(*a.object))));
        }
    }
  }

  const scene::Scene& scene_;
  const std::function<bool()>& stop_;
  bool is_stopped_ = false;
  std::vector<LintFinding>& found_;
  std::vector<std::pair<Vec3, const scene::Object*>> lights_;
  std::vector<scene::ObjectPtr> solids_;
  std::vector<const scene::Object*> boxes_;
  std::unordered_set<const void*> seen_;
};

}  // namespace

std::vector<LintFinding> lint_scene(const scene::Scene& scene, const std::function<bool()>& stop) {
  std::vector<LintFinding> found;
  Linter(scene, stop, found).run();
  return found;
}

}  // namespace verisim::cli
