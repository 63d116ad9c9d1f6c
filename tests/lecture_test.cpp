// The worked examples of scenes/lecture, computed by the code of the renderer. They take pixel corners: half a pixel up
// and left of the centre.
#include <gtest/gtest.h>

#include "parser/parse.h"
#include "tracer/render/cameras/camera_rays.h"
#include "tracer/render/render.h"
#include "tracer/shapes/shape.h"

namespace verisim {
namespace {

parser::ParseResult parse(const std::string& name, int width, int height, const std::string& levels = "") {
  parser::ParseOptions options;
  options.width = width;
  options.height = height;
  if (!levels.empty()) options.declarations.emplace_back("Levels", levels);
  return parser::parse_file(std::string(VERISIM_SOURCE_DIR "/scenes/lecture/") + name, options);
}

render::Framebuffer rendered(const std::string& name, int width, int height, const std::string& levels = "") {
  const parser::ParseResult result = parse(name, width, height, levels);
  render::Framebuffer picture;
  if (!result.scene) {
    ADD_FAILURE() << name << ": " << (result.errors.empty() ? "" : result.errors[0].message);
    picture.width = width, picture.height = height;
    picture.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Color());
    return picture;
  }
  render::Options options;
  options.width = width;
  options.height = height;
  options.threads = 1;
  render::render(*result.scene, options, picture);
  return picture;
}

// Distances to every surface of the scene that a ray enters, near to far.
std::vector<double> entries(const scene::Scene& scene, const Ray& ray) {
  std::vector<double> distances;
  for (const scene::ObjectPtr& object : scene.objects) {
    shapes::Hit hit;
    const auto shape = shapes::compile(*object);
    if (shape->intersect(ray, shapes::RayKind::query, 1e-6, 1e10, hit)) distances.push_back(hit.t);
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(Lecture, OrthographicCastingFindsTheNearestObject) {
  const parser::ParseResult parsed = parse("orthographic_casting.pov", 1, 5);
  ASSERT_TRUE(parsed.scene);
  const std::vector<std::vector<double>> expected{{7}, {3, 7}, {1, 3}, {1, 6}, {}};
  const std::vector<Rgb> colors{{1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  const render::CameraRays camera(parsed.scene->camera, 1, 5);
  const render::Framebuffer picture = rendered("orthographic_casting.pov", 1, 5);
  for (int i = 0; i < 5; ++i) {
    const auto primary = camera.at(0, i);
    ASSERT_TRUE(primary);
    EXPECT_NEAR(primary->ray.origin.y, 2 - i, 1e-12);
    EXPECT_EQ(entries(*parsed.scene, {primary->ray.origin, normalize(primary->ray.direction)}),
              expected[static_cast<std::size_t>(i)])
        << "ray #" << i + 1;
    EXPECT_EQ(picture.at(0, i).rgb(), colors[static_cast<std::size_t>(i)]) << "ray #" << i + 1;
  }
}

TEST(Lecture, PerspectiveOf30DegreesAndAspect2) {
  const parser::ParseResult parsed = parse("perspective_fov30.pov", 600, 300);
  ASSERT_TRUE(parsed.scene);
  const scene::Camera& camera = parsed.scene->camera;
  EXPECT_NEAR(length(camera.up) / 2, 1.34, 0.005);     // y_max
  EXPECT_NEAR(length(camera.right) / 2, 2.68, 0.005);  // x_max
  const auto primary = render::CameraRays(camera, 600, 300).at(150 - 0.5, 150 - 0.5);
  ASSERT_TRUE(primary);
  const Vec3 point = primary->ray.at(1);  // not normalised: the near plane is at t = 1
  EXPECT_NEAR(point.x, -1.34, 0.005);
  EXPECT_NEAR(point.y, 0, 1e-12);
  EXPECT_NEAR(point.z, -5, 1e-12);
  const Vec3 unit = normalize(primary->ray.direction);
  EXPECT_NEAR(unit.x, -0.26, 0.005);
  EXPECT_NEAR(unit.y, 0, 1e-12);
  EXPECT_NEAR(unit.z, -0.97, 0.005);
}

TEST(Lecture, PerspectiveOf90DegreesMeetsTheWall) {
  const parser::ParseResult parsed = parse("perspective_fov90.pov", 80, 80);
  ASSERT_TRUE(parsed.scene);
  const auto primary = render::CameraRays(parsed.scene->camera, 80, 80).at(40 - 0.5, 10 - 0.5);
  ASSERT_TRUE(primary);
  const Vec3 point = primary->ray.at(1);
  EXPECT_NEAR(point.x, 0, 1e-12);
  EXPECT_NEAR(point.y, 0.75, 1e-12);
  EXPECT_NEAR(point.z, -1, 1e-12);
  const Ray ray{primary->ray.origin, normalize(primary->ray.direction)};
  EXPECT_NEAR(ray.direction.y, 0.6, 1e-12);
  EXPECT_NEAR(ray.direction.z, -0.8, 1e-12);
  shapes::Hit hit;
  const auto wall = shapes::compile(*parsed.scene->objects.at(0));
  ASSERT_TRUE(wall->intersect(ray, shapes::RayKind::query, 1e-6, 1e10, hit));
  EXPECT_NEAR(hit.t, 3.75, 1e-12);
  EXPECT_NEAR(hit.point.x, 0, 1e-12);
  EXPECT_NEAR(hit.point.y, 2.25, 1e-12);
  EXPECT_NEAR(hit.point.z, -3, 1e-12);
}

TEST(Lecture, PixelCornersAreAsInTheFormula) {
  const parser::ParseResult parsed = parse("perspective_fov30.pov", 600, 300);
  ASSERT_TRUE(parsed.scene);
  const render::CameraRays camera(parsed.scene->camera, 600, 300);
  const double x_max = length(parsed.scene->camera.right) / 2, y_max = length(parsed.scene->camera.up) / 2;
  for (const auto& [i, j] : {std::pair(0, 0), {600, 300}, {17, 230}, {599, 1}}) {
    const Vec3 point = camera.at(i - 0.5, j - 0.5)->ray.at(1);
    EXPECT_NEAR(point.x, i / 600.0 * 2 * x_max - x_max, 1e-12);
    EXPECT_NEAR(point.y, (300 - j) / 300.0 * 2 * y_max - y_max, 1e-12);
  }
}

TEST(Lecture, ARayFromPointToPoint) {
  const Vec3 from(1, 2, 3), to(1, 6, 3);
  const Ray ray{from, normalize(to - from)};
  EXPECT_EQ(ray.direction, Vec3(0, 1, 0));
  EXPECT_EQ(length(to - from), 4);
  EXPECT_EQ(ray.at(4), to);
}

TEST(Lecture, APointInShadowGetsAmbientAndEmissionOnly) {
  const render::Framebuffer picture = rendered("shadow.pov", 8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(picture.at(x, y).g, x < 4 ? 0.3 : 0.8, 1e-6) << x << ", " << y;
}

TEST(Lecture, LightArrivesWithinThreeLevels) {
  const render::Framebuffer three = rendered("three_levels.pov", 8, 4, "3"),
                            two = rendered("three_levels.pov", 8, 4, "2");
  // Through glass: half of the light at either side of the pane. Over mirrors: half at each.
  for (const int x : {1, 2, 5, 6}) {
    EXPECT_NEAR(three.at(x, 1).r, 0.25 * 0.2, 1e-6) << x;
    EXPECT_NEAR(three.at(x, 1).g, 0.25 * 0.6, 1e-6) << x;
    EXPECT_NEAR(three.at(x, 1).b, 0.25 * 1.0, 1e-6) << x;
    EXPECT_EQ(two.at(x, 1).rgb(), Rgb()) << x;
  }
}

}  // namespace
}  // namespace verisim
