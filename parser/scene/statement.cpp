// Statements at the top level of a scene, and blocks as values of #declare.
#include "parser/scene/atmosphere.h"
#include "parser/scene/camera.h"
#include "parser/scene/common/common.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/global_settings.h"
#include "parser/scene/interior.h"
#include "parser/scene/textures/maps.h"
#include "parser/scene/textures/pattern.h"
#include "parser/scene/textures/texture.h"
#include "tracer/scene/bounds.h"
#include "tracer/scene/parts.h"

namespace verisim::parser {

namespace {

void add_camera(Parser& parser) {
  scene::Scene& scene = parser.scene();
  const bool again = scene.camera_given;
  // From 3.5 on the last camera counts and each starts afresh; before, a second one modifies the first (spec 02 1.1).
  const bool modifies = again && parser.version() < 350;
  if (again && !modifies)
    parser.warning(Code::duplicate, "More than one camera in scene. Ignoring previous camera(s).");
  scene.camera = modifies ? parse_camera(parser, scene.camera) : parse_camera(parser);
  scene.camera_given = true;
}

// What only matters in objects that are rendered: a normal may be declared without a pattern, but not used so; bounds
// may be of no use.
class ObjectCheck {
 public:
  explicit ObjectCheck(Parser& p) : parser(p) {}

  // `in_frame`: a part of the scene itself, as members of plain unions are, not of a solid.
  void object(const scene::Object& o, bool in_frame = true) {
    if (in_frame && !o.bounded_by.empty()) bounds(o);
    textures(o);
    const auto* csg = o.as<scene::Csg>();
    if (csg && csg->children.postponed())
      postponed(o, o.texture != nullptr);
    else
      for (const scene::ObjectPtr& child : scene::children_of(o))
        object(*child, in_frame && o.bounded_by.empty() && (!csg || splittable(o)));
  }

 private:
  // A text is the union of its letters.
  static bool is_union(const scene::Object& o) {
    const auto* csg = o.as<scene::Csg>();
    return (csg && csg->kind == scene::CsgKind::union_) || (is_text(o) && !o.inverted);
  }
  static bool is_text(const scene::Object& o) { return o.as<std::shared_ptr<const scene::Text>>(); }
  static bool splittable(const scene::Object& o) { return is_union(o) && o.split_union && o.clipped_by.empty(); }

  Parser& parser;
  scene::TexturePtr last;  // children often share one texture
  scene::SharedLists seen;

  void textures(const scene::Object& o) {
    if (const auto* light = o.as<scene::LightSource>(); light && !light->looks_like) return;  // shows none
    for (const scene::TexturePtr* texture : {&o.texture, &o.interior_texture}) {
      if (*texture && *texture != last) check(**texture);
      if (*texture) last = *texture;
    }
  }

  // What the children of a copy will be: they have no bounds, and what has no texture will have its parent's or the
  // default one.
  void postponed(const scene::Object& parent, bool textured) {
    if (!seen.first(parent, textured)) return;
    for (const scene::ObjectPtr& child : scene::declared_children(parent)) {
      textures(*child);
      const bool has_texture = textured || child->texture;
      if (!has_texture && scene::declared_children(*child).empty() && !child->as<scene::LightSource>())
        check(*parser.default_texture());
      postponed(*child, has_texture);
    }
  }

  void bounds(const scene::Object& o) {
    if (scene::bounds_are_removed(o)) return parser.warning(Code::no_effect, "Unnecessary bounding object removed.");
    // The parts of a union are bounded one by one.
    if (!splittable(o)) return;
    for (const scene::ObjectPtr& child : scene::children_of(o))
      if (scene::is_infinite(*child)) return;
    parser.warning(Code::no_effect, "CSG union unnecessarily bounded.");
  }

  void check(const scene::Texture& texture) {
    for (const scene::TextureLayer& layer : texture.layers) {
      if (layer.normal) check(*layer.normal);
    }
    if (!texture.texture_map) return;
    for (const auto& entry : *texture.texture_map) check(*entry.value);
  }

  void check(const scene::Normal& normal) {
    if (normal.pattern.kind == scene::PatternKind::none) parser.error(Code::missing_item, "No normal type given.");
    if (!normal.normal_map) return;
    for (const auto& entry : *normal.normal_map) {
      if (entry.value) check(*entry.value);
    }
  }
};

void add_object(Parser& parser, const std::shared_ptr<scene::Object>& object) {
  scene::finish_statement(*object, parser.default_texture());
  ObjectCheck(parser).object(*object);
  parser.scene().objects.push_back(object);
}

}  // namespace

bool parse_statement(Parser& parser) {
  scene::Scene& scene = parser.scene();
  switch (word_at(parser)) {
    case Word::camera:
      add_camera(parser);
      return true;
    case Word::global_settings:
      parse_global_settings(parser);
      return true;
    case Word::background:
      scene.background = parse_background(parser);
      scene.background_given = true;
      scene.background_fades = parser.effective_version() >= 370;
      return true;
    case Word::fog:
      scene.fogs.push_back(parse_fog(parser));
      return true;
    case Word::rainbow:
      scene.rainbows.push_back(parse_rainbow(parser));
      return true;
    case Word::sky_sphere:
      if (scene.sky_sphere) parser.warning(Code::duplicate, "Only one sky-sphere allowed (last one will be used).");
      scene.sky_sphere = parse_sky_sphere(parser);
      return true;
    case Word::media:
      scene.atmosphere.push_back(parse_media(parser));
      return true;
    case Word::max_trace_level:
      if (parser.version() >= 350)
        parser.possible_error(Code::misplaced_keyword, "'max_trace_level' should be in global_settings block.");
      parse_max_trace_level(parser);
      return true;
    case Word::max_intersections:
      parse_max_intersections(parser);
      return true;
    default:
      break;
  }
  if (const std::shared_ptr<scene::Object> object = parse_object(parser)) {
    add_object(parser, object);
    return true;
  }
  return false;
}

namespace {

// Further texture{} blocks are layers of the same value; a directive or macro ends the list (spec 01 section 4, B6).
Value parse_layered_texture(Parser& parser) {
  scene::TexturePtr texture = parse_texture(parser);
  const Parser::FurtherLayer further(parser);
  while (parser.at(Word::texture)) add_layers(parser, texture, parse_texture(parser));
  return texture;
}

template <class T>
Shared<T> shared(T value) {
  return std::make_shared<const T>(std::move(value));
}

}  // namespace

std::optional<Value> parse_block_value(Parser& parser) {
  switch (word_at(parser)) {
    case Word::none:
      return std::nullopt;  // identifiers are copied by #declare itself
    case Word::pigment:
      return parse_pigment(parser);
    case Word::normal:
      return parse_normal(parser);
    case Word::finish:
      return shared(parse_finish(parser, default_layer(parser).finish));
    case Word::texture:
      return parse_layered_texture(parser);
    case Word::density:
      return parse_density(parser);
    case Word::media:
      return shared(parse_media(parser));
    case Word::interior:
      return Shared<scene::Interior>(parse_interior(parser));
    case Word::material:
      return shared(parse_material(parser));
    case Word::color_map:
      return ColorMapValue{parse_color_map(parser)};
    case Word::pigment_map:
      return PigmentMapValue{parse_pigment_map(parser, false)};
    case Word::normal_map:
      return NormalMapValue{parse_normal_map(parser, false)};
    case Word::slope_map:
      return SlopeMap{parse_slope_map(parser)};
    case Word::texture_map:
      return TextureMapValue{parse_texture_map(parser, false)};
    case Word::density_map:
      return DensityMapValue{parse_density_map(parser, false)};
    case Word::transform:
      return shared(parse_transform(parser));
    case Word::camera:
      return shared(parse_camera(parser));
    case Word::fog:
      return shared(parse_fog(parser));
    case Word::rainbow:
      return shared(parse_rainbow(parser));
    case Word::sky_sphere:
      return shared(parse_sky_sphere(parser));
    default:
      break;
  }
  if (std::shared_ptr<scene::Object> object = parse_object(parser)) return scene::ObjectPtr(object);
  return std::nullopt;
}

void finish_scene(Parser& parser) {
  finish_radiosity_settings(parser, parser.scene().settings.radiosity);
  if (parser.scene().objects.empty()) parser.warning(Code::no_objects, "No objects in scene.");
  check_object_count(parser, scene::objects_of(parser.scene().objects));
}

}  // namespace verisim::parser
