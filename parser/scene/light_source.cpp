// light_source { ... } (spec 06 section 7.1, 8).
#include <cmath>
#include <limits>

#include "parser/scene/common/common.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/global_settings.h"
#include "parser/scene/objects.h"
#include "parser/scene/common/transform.h"

namespace verisim::parser {

using scene::LightKind;
using scene::LightSource;

namespace {

class LightReader {
 public:
  LightReader(Parser& p, scene::Object& o) : parser(p), object(o) {}

  void read() {
    while (parse_item() || parse_object_transform(parser, object)) {
    }
    finish();
  }

 private:
  Parser& parser;
  scene::Object& object;
  bool circular = false, orient = false;

  LightSource& light() { return *object.as<LightSource>(); }

  [[noreturn]] void error_standard(const char* keyword) {
    parser.error(Code::misplaced_keyword,
                 std::string("Keyword '") + keyword + "' cannot be used with standard light source.");
  }

  void set_kind(LightKind kind, double radius, double falloff) {
    parser.next();
    light().kind = kind;
    light().radius = radius;
    light().falloff = falloff;
    light().tightness = 0;
  }

  void cone_number(double LightSource::*field, const char* keyword) {
    if (!light().has_beam()) error_standard(keyword);
    parser.next();
    light().*field = parser.parse_float();
  }

  void parse_area() {
    parser.next();
    LightSource& l = light();
    l.area = true;
    l.axis1 = parser.parse_vec3();
    parser.optional_comma();
    l.axis2 = parser.parse_vec3();
    parser.optional_comma();
    l.size1 = parser.parse_int();
    parser.optional_comma();
    l.size2 = parser.parse_int();
    if (l.size1 == 0 || l.size2 == 0) parser.error(Code::bad_value, "Illegal area light specification: a size is 0.");
    // Negative sizes have no meaning that is known; treat them as their magnitude rather than loop without end.
    for (int* size : {&l.size1, &l.size2}) *size = std::abs(std::max(*size, -std::numeric_limits<int>::max()));
  }

  // `place`: where the object is moved before the modifiers that follow it in the braces; null: nowhere.
  scene::ObjectPtr parse_attached(const scene::ObjectPtr& previous, const char* keyword, const Vec3* place) {
    if (previous) parser.error(Code::duplicate, std::string("Only one ") + keyword + " allowed per light source.");
    parser.next();
    parser.expect('{');
    std::shared_ptr<scene::Object> attached = parse_object(parser);
    if (!attached) parser.error_expected("object");
    if (place) {
      scene::TransformSteps steps;
      steps.translate(*place);
      move_while_read(*attached, steps);
    }
    parse_object_modifiers(parser, *attached);
    check_nesting(parser, *attached);
    return attached;
  }

  void parse_projected_through() {
    scene::ObjectPtr attached = parse_attached(light().projected_through, "projected_through", nullptr);
    auto& through = const_cast<scene::Object&>(*attached);
    if (through.texture || through.interior_texture)
      parser.warning(Code::no_effect, "Texture of projected_through object is removed.");
    if (through.interior) parser.warning(Code::no_effect, "Interior of projected_through object is removed.");
    through.texture = through.interior_texture = nullptr;
    through.interior = nullptr;
    through.no_shadow = true;
    light().projected_through = attached;
  }

  void parse_looks_like() {
    scene::ObjectPtr attached = parse_attached(light().looks_like, "looks_like", &light().position);
    auto& shape = const_cast<scene::Object&>(*attached);
    shape.no_shadow = true;
    let_photons_pass(parser, shape);
    light().looks_like = attached;
  }

  bool parse_area_item() {
    const auto flag = [&](bool& target) {
      parser.next();
      target = true;
      return true;
    };
    switch (word_at(parser)) {
      case Word::area_light:
        parse_area();
        return true;
      case Word::adaptive:
        parser.next();
        light().adaptive = parser.parse_int();
        return true;
      case Word::jitter:
        return flag(light().jitter);
      case Word::circular:
        circular = true;
        return flag(light().circular);
      case Word::orient:
        orient = true;
        return flag(light().orient);
      case Word::area_illumination:
        parser.next();
        light().area_illumination = parser.parse_flag();
        if (!light().area) parser.warning(Code::incompatible, "'area_illumination' is meant for area lights.");
        return true;
      default:
        return false;
    }
  }

  bool parse_item() {
    if (parse_area_item()) return true;
    switch (word_at(parser)) {
      case Word::spotlight:
        set_kind(LightKind::spotlight, 30, 45);
        return true;
      case Word::cylinder:
        set_kind(LightKind::cylinder, 0.75, 1);
        light().parallel = true;
        return true;
      case Word::shadowless:
        parser.next();
        light().kind = LightKind::shadowless;
        return true;
      case Word::parallel:
        parser.next();
        light().parallel = true;
        return true;
      case Word::point_at:
        if (!light().has_beam() && !light().parallel) error_standard("point_at");
        parser.next();
        light().point_at = parser.parse_vec3();
        return true;
      case Word::radius:
        cone_number(&LightSource::radius, "radius");
        return true;
      case Word::falloff:
        cone_number(&LightSource::falloff, "falloff");
        return true;
      case Word::tightness:
        cone_number(&LightSource::tightness, "tightness");
        return true;
      case Word::fade_distance:
        parser.next();
        light().fade_distance = parser.parse_float();
        return true;
      case Word::fade_power:
        parser.next();
        light().fade_power = parser.parse_float();
        return true;
      case Word::media_interaction:
        parser.next();
        light().media_interaction = parser.parse_flag();
        return true;
      case Word::media_attenuation:
        parser.next();
        light().media_attenuation = parser.parse_flag();
        return true;
      case Word::looks_like:
        parse_looks_like();
        return true;
      case Word::projected_through:
        parse_projected_through();
        return true;
      case Word::photons:
        parse_light_photons(parser, light());
        return true;
      default:
        return false;
    }
  }

  void finish() {
    LightSource& l = light();
    // Only where `circular` itself is written: what `orient` makes circular may have one point on an axis.
    if (circular && (l.size1 <= 1 || l.size2 <= 1)) {
      parser.error(Code::too_few, "Circular area lights must have more than one point per axis.");
    }
    if (orient) {
      if (!l.area) parser.warning(Code::incompatible, "'orient' only affects area lights.");
      if (l.area && !l.circular) {
        parser.warning(Code::incompatible, "Orient only affects circular area_lights; circular is switched on.");
        l.circular = l.size1 > 1 && l.size2 > 1;
      }
      if (l.area && l.size1 != l.size2)
        parser.warning(Code::adjusted_value, "When using orient, the two axes should have the same size.");
      if (l.area && std::fabs(length(l.axis1) - length(l.axis2)) > kEpsilon) {
        parser.warning(Code::adjusted_value,
                       "When using orient, the two axes should have the same length; the length of the first is used.");
      }
    }
    const Vec3 axis = l.point_at - l.position;
    l.direction = length(axis) > kEpsilon ? normalize(axis) : Vec3(0, 0, 0);
  }
};

}  // namespace

std::shared_ptr<scene::Object> parse_light_source(Parser& parser) {
  return object_block(
      parser, "light_source",
      [&](scene::Object& object) {
        LightSource light;
        light.position = parser.parse_vec3();
        parser.optional_comma();
        light.color = at_color(parser) || parser.at_number_start() || parser.at('<') ? parser.parse_rgb() : Rgb();
        object.shape = light;
        object.no_shadow = true;
      },
      [&](scene::Object& object) { LightReader(parser, object).read(); });
}

namespace {

bool parse_light_group_item(Parser& parser, scene::Object& object) {
  auto& group = std::get<scene::LightGroup>(object.shape);
  if (parser.accept(Word::global_lights)) {
    group.global_lights = parser.parse_optional_float(1) > 0.5;
    return true;
  }
  if (parser.at(Word::photons)) {
    parse_object_photons(parser, object);
    return true;
  }
  return parse_object_transform(parser, object);
}

}  // namespace

std::shared_ptr<scene::Object> parse_light_group(Parser& parser) {
  return object_block(
      parser, "light_group",
      [&](scene::Object& object) {
        scene::LightGroup group;
        while (std::shared_ptr<scene::Object> child = parse_object(parser)) group.children.push_back(child);
        object.shape = std::move(group);
        check_nesting(parser, object);
      },
      [&](scene::Object& object) {
        while (parse_light_group_item(parser, object)) {
        }
        scene::finish_modifiers(object);
      });
}

}  // namespace verisim::parser
