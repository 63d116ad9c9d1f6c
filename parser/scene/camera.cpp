// camera { ... } (spec 02 section 1).
#include <cmath>

#include "parser/scene/camera.h"
#include "parser/scene/common/common.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::Camera;
using scene::CameraKind;

namespace {

bool uses_view_angle(CameraKind kind) { return kind == CameraKind::perspective || kind == CameraKind::orthographic; }

// direction := unit(direction) |right| / (2 tan(angle / 2)), step 2 of spec 02 1.3.
void apply_angle(Camera& camera) {
  if (!uses_view_angle(camera.kind) || !(camera.angle > 0)) return;
  const double distance = length(camera.right) / std::tan(camera.angle * (M_PI / 360)) / 2;
  camera.direction = normalize(camera.direction) * distance;
}

// Step 3 of spec 02 1.3.
void apply_look_at(Parser& parser, Camera& camera, const Vec3& target) {
  camera.look_at = target;
  const double direction_length = length(camera.direction), up_length = length(camera.up),
               right_length = length(camera.right);
  const double handedness = dot(cross(camera.up, camera.direction), camera.right);
  const Vec3 towards = target - camera.location;
  if (dot(towards, towards) < kEpsilon)
    parser.error(Code::bad_value, "Camera location and look_at point must be different.");
  const Vec3 d = normalize(towards);
  Vec3 r = cross(camera.sky, d);
  if (std::fabs(r.x) < kEpsilon && std::fabs(r.y) < kEpsilon && std::fabs(r.z) < kEpsilon) {
    if (parser.version() >= 350)
      parser.warning(
          Code::adjusted_value,
          "Camera location to look_at direction and sky direction should be different. Using default/supplied right "
          "vector instead.");
    r = camera.right;
  }
  r = normalize(r);
  camera.up = cross(d, r) * up_length;
  camera.direction = d * direction_length;
  camera.right = r * (handedness > 0 ? right_length : -right_length);
}

// Step 4 of spec 02 1.3: an orthographic view is as large as it appears at look_at.
void scale_orthographic(Camera& camera) {
  const double to_target = length(camera.look_at - camera.location), direction = length(camera.direction);
  if (!(to_target > kEpsilon) || !(direction > kEpsilon)) return;
  camera.right *= to_target / direction;
  camera.up *= to_target / direction;
}

void apply_transform(Camera& camera, const Transform& t) {
  camera.location = t.point(camera.location);
  camera.direction = t.direction(camera.direction);
  camera.up = t.direction(camera.up);
  camera.right = t.direction(camera.right);
}

class CameraReader {
 public:
  CameraReader(Parser& p, Camera& c) : parser(p), camera(c), immediate(p.version() < 350) {}

  void read() {
    if (!immediate) {
      while (parse_type()) {
      }
    }
    while (parse_item() || (immediate && parse_type())) {
    }
    if (!immediate) apply();
    if (camera.focal_distance == 0) camera.focal_distance = 1;
    check_perpendicular();
  }

 private:
  Parser& parser;
  Camera& camera;
  const bool immediate;  // before 3.5 every item acts as soon as it is written (spec 02 1.4)
  bool angle_given = false, look_at_given = false, up_given = false, right_given = false, focal_point_given = false;
  Vec3 look_at{0, 0, 1}, focal_point{0, 0, 0};
  std::optional<Transform> transform;

  bool parse_type() {
    const auto set = [&](CameraKind kind) {
      parser.next();
      camera.kind = kind;
      return true;
    };
    switch (word_at(parser)) {
      case Word::perspective:
        return set(CameraKind::perspective);
      case Word::orthographic:
        set(CameraKind::orthographic);
        if (immediate) scale_orthographic(camera);
        return true;
      case Word::fisheye:
        return set(CameraKind::fisheye);
      case Word::ultra_wide_angle:
        return set(CameraKind::ultra_wide_angle);
      case Word::omnimax:
        return set(CameraKind::omnimax);
      case Word::panoramic:
        return set(CameraKind::panoramic);
      case Word::spherical:
        return immediate ? false : set(CameraKind::spherical);
      case Word::cylinder:
        parse_cylinder();
        return true;
      case Word::mesh_camera:
        if (immediate) return false;
        camera.kind = CameraKind::mesh_camera;
        parse_mesh_camera();
        return true;
      default:
        return false;
    }
  }

  void parse_cylinder() {
    parser.next();
    const int type = parser.parse_int();
    constexpr CameraKind kKinds[] = {CameraKind::cylinder1, CameraKind::cylinder2, CameraKind::cylinder3,
                                     CameraKind::cylinder4};
    if (type >= 1 && type <= 4) {
      camera.kind = kKinds[type - 1];
    } else if (!immediate) {
      parser.error(Code::bad_value, "Invalid cylinder camera type, valid are types 1 to 4.");
    }
  }

  void parse_mesh_camera() {
    parser.next();
    parser.expect('{');
    parser.warning(Code::experimental, "mesh_camera is an experimental feature of POV-Ray.");
    camera.rays_per_pixel = parser.parse_int();
    if (camera.rays_per_pixel <= 0) parser.error(Code::bad_value, "Rays per pixel may not be 0 or negative.");
    parser.optional_comma();
    camera.distribution = parser.parse_int();
    if (camera.distribution < 0 || camera.distribution > 3)
      parser.error(Code::bad_value, "Unrecognized distribution method: it is 0, 1, 2 or 3.");
    if (camera.distribution >= 2 && camera.rays_per_pixel != 1)
      parser.error(Code::incompatible, "Distributions 2 and 3 need exactly one ray per pixel.");
    parser.optional_comma();
    camera.max_distance = parser.parse_optional_float(0);
    parser.optional_comma();
    camera.meshes.clear();
    camera.mesh_transforms.clear();
    while (std::shared_ptr<scene::Object> object = parse_object(parser)) {
      const auto* mesh = object->as<scene::Mesh>();
      if (!mesh) parser.error_expected("mesh or mesh2");
      camera.meshes.push_back(mesh->data);
      camera.mesh_transforms.push_back(object->transform.value_or(Transform()));
    }
    if (camera.meshes.empty()) parser.error_expected("mesh or mesh2");
    if (camera.distribution == 0 && static_cast<std::size_t>(camera.rays_per_pixel) > camera.meshes.size())
      parser.error(Code::incompatible, "Distribution 0 needs as many meshes as rays per pixel.");
    if (camera.distribution == 3 && camera.meshes.size() > 1)
      parser.warning(Code::incompatible, "Distribution 3 uses the first mesh only.");
    camera.smooth = false;
    if (parser.accept(Word::smooth)) {
      if (camera.distribution != 3)
        parser.error(Code::misplaced_keyword, "'smooth' can only be used with distribution 3.");
      camera.smooth = true;
    }
    close_block(parser);
  }

  void parse_angle() {
    parser.next();
    angle_given = true;
    if (camera.kind == CameraKind::spherical) {
      camera.horizontal_angle = parser.parse_float();
      if (camera.horizontal_angle < 0) parser.error(Code::bad_value, "Negative horizontal angle not allowed.");
      camera.vertical_angle = accept_comma_or_number(parser) ? parser.parse_float() : camera.horizontal_angle / 2;
      if (camera.vertical_angle < 0) parser.error(Code::bad_value, "Negative vertical angle not allowed.");
      return;
    }
    camera.angle = camera.kind == CameraKind::orthographic ? parser.parse_optional_float(0) : parser.parse_float();
    if (camera.angle < 0) parser.error(Code::bad_value, "Negative viewing angle.");
    if (uses_view_angle(camera.kind) && camera.angle >= 180)
      parser.error(Code::bad_value, "Viewing angle has to be smaller than 180 degrees.");
    if (immediate && camera.kind == CameraKind::perspective) apply_angle(camera);
  }

  void parse_blur_samples() {
    parser.next();
    camera.blur_samples = parser.parse_int();
    camera.blur_samples_min = 0;
    if (!immediate && accept_comma_or_number(parser)) {
      const int most = parser.parse_int();
      if (most != 0) {
        camera.blur_samples_min = camera.blur_samples;
        camera.blur_samples = most;
      }
    }
    if (camera.blur_samples <= 0 || camera.blur_samples_min < 0)
      parser.error(Code::bad_value, "Illegal number of focal blur samples.");
    if (camera.blur_samples_min > camera.blur_samples)
      parser.error(Code::bad_value, "The minimum number of focal blur samples is larger than the maximum.");
  }

  template <class Legal>
  void parse_fraction(double& target, const char* name, Legal legal) {
    parser.next();
    const double value = parser.parse_float();
    if (legal(value))
      target = value;
    else
      parser.warning(Code::adjusted_value, std::string("Illegal ") + name + " value. Default is used.");
  }

  void parse_bokeh() {
    parser.next();
    parser.expect('{');
    if (parser.at(Word::pigment))
      camera.bokeh = parse_pigment(parser);
    else if (!parser.at('}'))
      parser.error_expected("pigment");
    close_block(parser);
  }

  bool parse_item() {
    const auto vector = [&](Vec3& target) {
      parser.next();
      target = parser.parse_vec3();
      return true;
    };
    switch (word_at(parser)) {
      case Word::location:
        return vector(camera.location);
      case Word::right:
        right_given = true;
        return vector(camera.right);
      case Word::up:
        up_given = true;
        return vector(camera.up);
      case Word::direction:
        return vector(camera.direction);
      case Word::sky:
        return vector(camera.sky);
      case Word::look_at:
        vector(look_at);
        look_at_given = true;
        if (immediate) apply_look_at(parser, camera, look_at);
        return true;
      case Word::angle:
        parse_angle();
        return true;
      case Word::focal_point:
        vector(focal_point);
        focal_point_given = true;
        if (immediate) camera.focal_distance = length(focal_point - camera.location);
        return true;
      case Word::aperture:
        parser.next();
        camera.aperture = parser.parse_float();
        return true;
      case Word::blur_samples:
        parse_blur_samples();
        return true;
      case Word::confidence:
        parse_fraction(camera.confidence, "confidence", [](double v) { return v > 0 && v < 1; });
        return true;
      case Word::variance:
        parse_fraction(camera.variance, "variance", [](double v) { return v >= 0 && v <= 1; });
        return true;
      case Word::bokeh:
        if (immediate) return false;
        parse_bokeh();
        return true;
      case Word::normal:
        camera.normal = parse_normal(parser, camera.normal ? camera.normal : default_layer(parser).normal);
        if (camera.normal && camera.normal->pattern.kind == scene::PatternKind::none)
          parser.error(Code::missing_item, "No normal type given.");
        return true;
      default:
        break;
    }
    Transform item;
    if (!parse_transform_item(parser, item)) return false;
    if (immediate) {
      apply_transform(camera, item);
    } else {
      transform = transform ? transform->then(item) : item;
    }
    return true;
  }

  // The items in POV-Ray's order, whatever order they were written in (spec 02 1.3).
  void apply() {
    if (angle_given) apply_angle(camera);
    if (look_at_given) apply_look_at(parser, camera, look_at);
    const double direction_length = length(camera.direction);
    if (camera.kind == CameraKind::orthographic && ((!up_given && !right_given) || angle_given))
      scale_orthographic(camera);
    if (focal_point_given)
      camera.focal_distance = length(focal_point - camera.location);
    else
      camera.focal_distance = angle_given || look_at_given ? direction_length : 1;
    if (transform) apply_transform(camera, *transform);
  }

  void check_perpendicular() {
    if (std::fabs(dot(camera.right, camera.up)) > kEpsilon ||
        std::fabs(dot(camera.right, camera.direction)) > kEpsilon ||
        std::fabs(dot(camera.up, camera.direction)) > kEpsilon)
      parser.warning(Code::adjusted_value,
                     "Camera vectors are not perpendicular. Making look_at the last statement may help.");
  }
};

}  // namespace

scene::Camera parse_camera(Parser& parser, const scene::Camera& start) {
  Block block(parser);
  Camera camera = start;
  if (const auto* value = parser.accept_value<Shared<Camera>>()) {
    camera = **value;
    if (parser.version() >= 350) {
      // A copy takes transformations only; those inside the declared camera are in its vectors already.
      Transform item;
      while (parse_transform_item(parser, item)) apply_transform(camera, item);
      block.close();
      return camera;
    }
  }
  CameraReader(parser, camera).read();
  block.close();
  return camera;
}

scene::Camera parse_camera(Parser& parser) { return parse_camera(parser, parser.default_camera()); }

}  // namespace verisim::parser
