// Cameras, atmosphere, global settings and defaults in the description (spec 02, 06 section 11, 07).
#include "parser/scene/test_support.h"

namespace verisim::parser {
namespace {

using testing::first_error;
using testing::parse;
using testing::scene_of;

scene::Camera camera_of(const std::string& items) { return scene_of("camera{" + items + "}").camera; }

void expect_near(const Vec3& a, const Vec3& b) {
  for (unsigned i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12) << i;
}

TEST(Cameras, Defaults) {
  const scene::Camera camera = scene_of("sphere{0,1}").camera;
  EXPECT_EQ(camera.right, Vec3(1.33, 0, 0));
  EXPECT_EQ(camera.direction, Vec3(0, 0, 1));
  EXPECT_EQ(camera.confidence, .9);
}

TEST(Cameras, AngleAndLookAtActInPovRaysOrder) {
  const scene::Camera camera = camera_of("angle 90 look_at <0,0,5> right 2*x location <0,0,-5>");
  expect_near(camera.direction, {0, 0, 1});  // |right| / 2 / tan 45
  expect_near(camera.right, {2, 0, 0});
  EXPECT_NEAR(camera.focal_distance, 1, 1e-12);
  expect_near(camera_of("look_at <5,0,0> right -x").right, {0, 0, 1});  // left-handedness survives
}

// Half of the orthographic view, as spec 02 P2 measured it (there at the centre of the outermost of 8 x 6 pixels).
TEST(Cameras, OrthographicScale) {
  const auto corner = [](const std::string& items) {
    const scene::Camera camera = camera_of("orthographic " + items);
    return Vec2(camera.right.x * 3.5 / 8, camera.up.y * 2.5 / 6);
  };
  const auto near = [](const Vec2& a, double x, double y) {
    EXPECT_NEAR(a.x, x, 3e-4);
    EXPECT_NEAR(a.y, y, 3e-4);
  };
  near(corner(""), .5818, .4167);
  near(corner("location <0,0,-5>"), 3.4911, 2.4999);
  near(corner("location <0,0,-5> look_at 0"), 2.9094, 2.0833);
  near(corner("location <0,0,-5> look_at 0 right x*4 up y*3"), 1.7501, 1.2499);
  near(corner("location <0,0,-5> look_at 0 angle 60"), 2.5258, 1.8087);
  near(corner("location <0,0,-5> look_at 0 right x*4 up y*3 angle 60"), 2.5258, 1.8041);
  near(corner("location <0,0,-5> direction 2*z look_at 0"), 1.4546, 1.0417);
  near(corner("angle location <0,0,-5> look_at 0 right x*4 up y*3"), 8.75, 6.2499);
}

TEST(Cameras, BeforeVersion35ItemsActAsWritten) {
  const scene::Camera old = scene_of("#version 3.1; camera{translate x location <0,0,-5> look_at 0}").camera;
  EXPECT_EQ(old.location, Vec3(0, 0, -5));
  EXPECT_EQ(camera_of("translate x location <0,0,-5> look_at 0").location, Vec3(1, 0, -5));
}

TEST(Cameras, FocalDistance) {
  EXPECT_EQ(camera_of("direction 3*z").focal_distance, 1);  // neither angle nor look_at
  EXPECT_EQ(camera_of("location -2*z focal_point <0,0,3>").focal_distance, 5);
  EXPECT_EQ(scene_of("#version 3.1; camera{focal_point 0 location 5*z}").camera.focal_distance, 1);
  const scene::Camera samples = camera_of("blur_samples 10,30 aperture .5 focal_point z");
  EXPECT_EQ(samples.blur_samples_min, 10);
  EXPECT_EQ(samples.blur_samples, 30);
}

TEST(Cameras, TheLastOneCounts) {
  const testing::Parsed parsed = parse("camera{location x} camera{location y}");
  EXPECT_EQ(parsed.scene->camera.location, Vec3(0, 1, 0));
  EXPECT_NE(parsed.messages.find("More than one camera"), std::string::npos);
  EXPECT_EQ(scene_of("#default{camera{location z}} camera{angle 60}").camera.location, Vec3(0, 0, 1));
  EXPECT_EQ(scene_of("#default{camera{location z}} sphere{0,1}").camera.location, Vec3(0, 0, 0));
}

TEST(Cameras, Errors) {
  EXPECT_EQ(first_error("camera{angle -1}"), "Negative viewing angle.");
  EXPECT_EQ(first_error("camera{angle 180}"), "Viewing angle has to be smaller than 180 degrees.");
  EXPECT_EQ(first_error("camera{location 1 look_at 1}"), "Camera location and look_at point must be different.");
  EXPECT_EQ(first_error("camera{cylinder 5}"), "Invalid cylinder camera type, valid are types 1 to 4.");
}

TEST(Atmosphere, FogRainbowSky) {
  const scene::Scene scene = scene_of(
      "fog{distance 10 rgbft <.1,.2,.3,.4,.5> fog_type 2 fog_alt 3 fog_offset 4 up 2*x turbulence .5 turb_depth .25}"
      "rainbow{direction z angle 42 width 5 color_map{[0 rgb 0][1 rgb 1]} arc_angle 120}"
      "sky_sphere{pigment{rgb x} pigment{rgbt y} emission 2 scale 3} background{rgb .5}");
  EXPECT_EQ(scene.fogs[0].up, Vec3(1, 0, 0));
  EXPECT_EQ(scene.fogs[0].color, Color(.1f, .2f, .3f, .4f, .5f));
  EXPECT_EQ(scene.fogs[0].turbulence_depth, .25);
  EXPECT_EQ(*scene.rainbows[0].arc_angle, 120);
  EXPECT_FALSE(scene.rainbows[0].falloff_angle.has_value());
  EXPECT_EQ(scene.sky_sphere->pigments.size(), 2u);
  // Its pigments do not start from the default one, a camera's normal does.
  EXPECT_FALSE(scene_of("#default{pigment{turbulence 1}} sky_sphere{pigment{gradient y}}")
                   .sky_sphere->pigments[0]
                   ->pattern.turbulence);
  EXPECT_TRUE(scene_of("#default{normal{turbulence 1}} camera{normal{ripples}}").camera.normal->pattern.turbulence);
  EXPECT_EQ(scene.sky_sphere->emission, Rgb(2.f));
  EXPECT_EQ(scene.background, Color(.5f, .5f, .5f));
  EXPECT_EQ(first_error("rainbow{angle 42 width 5}"), "Rainbow's direction vector is zero.");
  EXPECT_NE(parse("fog{5 rgb 1}").messages.find("distance"), std::string::npos);
}

TEST(Settings, Ranges) {
  EXPECT_EQ(scene_of("global_settings{max_trace_level 300}").settings.max_trace_level, 256);
  EXPECT_EQ(scene_of("global_settings{max_trace_level 0}").settings.max_trace_level, 1);
  EXPECT_EQ(scene_of("max_trace_level 9").settings.max_trace_level, 9);
  EXPECT_EQ(scene_of("global_settings{number_of_waves -3}").settings.number_of_waves, 1);
  EXPECT_EQ(scene_of("global_settings{assumed_gamma 2}").settings.assumed_gamma, 1);  // the first one counts
  EXPECT_EQ(first_error("global_settings{noise_generator 4}"),
            "Value for noise_generator in global_settings must be 1, 2, or 3.");
  EXPECT_EQ(first_error("#version 3.7; global_settings{assumed_gamma 0}"), "gamma value must be positive.");
  EXPECT_TRUE(scene_of("global_settings{subsurface{samples 10,20}}").settings.subsurface);
}

TEST(Settings, Radiosity) {
  const scene::Radiosity radiosity =
      scene_of("global_settings{radiosity{count 2000 nearest_count 7,3 maximum_reuse .02}}").settings.radiosity;
  EXPECT_TRUE(radiosity.enabled);
  EXPECT_EQ(radiosity.count_directions, 2000);
  EXPECT_EQ(radiosity.adaptive_nearest_count, 3);
  EXPECT_EQ(radiosity.minimum_reuse, .01);  // half of the maximum that was given
  EXPECT_EQ(scene_of("global_settings{radiosity{}}").settings.radiosity.maximum_reuse, .2);
  EXPECT_EQ(scene_of("global_settings{radiosity{count 10,500}}").settings.radiosity.count_directions, 500);
  EXPECT_EQ(scene_of("#default{radiosity{importance .25}}").settings.radiosity.default_importance, .25);
  for (const char* bad : {"count 0", "count 10,5", "nearest_count 21", "nearest_count 5,5", "recursion_limit 0",
                          "gray_threshold 2", "error_bound 0", "pretrace_start .01 pretrace_end .02",
                          "distance_maximum 1", "minimum_reuse .3 maximum_reuse .2"})
    EXPECT_NE(first_error(std::string("global_settings{radiosity{") + bad + "}}"), "") << bad;
}

TEST(Settings, PhotonsStartAfresh) {
  const scene::Photons photons =
      scene_of("global_settings{photons{spacing .5 gather 5,6}} global_settings{photons{count 10 radius .1,2,,3}}")
          .settings.photons;
  EXPECT_EQ(photons.spacing, 1);
  EXPECT_EQ(photons.gather_max, 100);
  EXPECT_EQ(photons.count, 10);
  EXPECT_EQ(photons.radius, .1);
  EXPECT_EQ(photons.radius_gather_multiplier, 2);
  EXPECT_EQ(photons.media_radius, 0);
  EXPECT_EQ(photons.media_radius_gather_multiplier, 3);
  EXPECT_EQ(photons.autostop, .5);
  EXPECT_EQ(photons.expand_min, 35);
  EXPECT_NE(first_error("global_settings{photons{gather 5,4}}"), "");
}

TEST(Defaults, TexturesMustBePlainAndSingle) {
  EXPECT_EQ(first_error("#default{texture{pigment{rgb 1}} finish{ambient 1}}"), "");
  EXPECT_NE(first_error("#default{texture{checker}}"), "");
  EXPECT_NE(first_error("#declare T=texture{pigment{rgb 1}} texture{pigment{rgbt 1}}; #default{texture{T}}"), "");
}

TEST(Transforms, InverseTakesTheWholeBlock) {
  const scene::Scene scene = scene_of("sphere{<1,0,0>,1 transform{translate x inverse rotate 90*z}}");
  const Transform& t = *scene.objects[0]->transform;
  expect_near(t.point({1, 0, 0}), {-1, -1, 0});
  EXPECT_NE(parse("sphere{0,1 scale <0,1,1>}").messages.find("Scale X by 0.0"), std::string::npos);
  EXPECT_NE(first_error("sphere{0,1 matrix<1,2,3,2,4,6,3,6,9,0,0,0>}").find("Singular matrix"), std::string::npos);
}

}  // namespace
}  // namespace verisim::parser
