// Shapes of impossible sizes and broken data: an error that says so, or a picture; never a crash, and soon.
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <fstream>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

const char* const kHostileHead =
    "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1, -6> look_at 0 } light_source { <3, 6, "
    "-8> rgb 1 } #default { pigment { rgb 1 } }\n";

// Renders or throws; either is an answer. True: it rendered.
bool expect_answer(const std::string& objects, double seconds = 10) {
  SCOPED_TRACE(objects.substr(0, 200));
  const std::clock_t begin = std::clock();  // the processor's time: a busy machine is no failure
  bool rendered = false;
  try {
    render_text(kHostileHead + objects, 16, 12);
    rendered = true;
  } catch (const std::exception& error) {
    EXPECT_STRNE(error.what(), "");
  }
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, seconds);
  return rendered;
}

TEST(HostileShapes, ImpossibleSizes) {
  int rendered = 0;
  for (const char* v : {"0", "-1", "1e30", "1e300", "1e-300", "(1e200 * 1e200)", "-(1e200 * 1e200)"}) {
    const std::string n = v;
    for (const std::string& object :
         {"sphere { 0, " + n + " }",
          "sphere { <" + n + ", 0, 0>, 1 }",
          "box { <-1, " + n + ", -1>, 1 }",
          "cylinder { <0, " + n + ", 0>, y, 1 }",
          "cylinder { -y, y, " + n + " }",
          "cone { 0, " + n + ", y, 0.5 }",
          "torus { " + n + ", 0.3 }",
          "torus { 1, " + n + " }",
          "plane { y, " + n + " }",
          "disc { 0, y, " + n + " }",
          "disc { 0, <0, " + n + ", 0>, 1 }",
          "triangle { <" + n + ", 0, 0>, y, z }",
          "smooth_triangle { x, <" + n + ", 0, 0>, y, -z, z, -z }",
          "quadric { <" + n + ", 1, 1>, 0, 0, -1 }",
          "polynomial { 4, xyz(4, 0, 0): " + n + ", xyz(0, 0, 0): -1 }",
          "polynomial { 7, xyz(7, 0, 0): " + n + ", xyz(0, 1, 0): 1 }",
          "superellipsoid { <" + n + ", 1> }",
          "superellipsoid { <1, " + n + "> }",
          "blob { threshold " + n + " sphere { 0, 1, 1 } }",
          "blob { threshold 0.5 sphere { 0, " + n + ", 1 } }",
          "blob { threshold 0.5 sphere { 0, 1, " + n + " } }",
          "ovus { " + n + ", 0.5 }",
          "lathe { cubic_spline 4, <0, -1>, <" + n + ", 0>, <1, 1>, <0, 2> }",
          "sor { 4, <0.5, -1>, <0.5, 0>, <" + n + ", 1>, <0.5, 2> }",
          "prism { " + n + ", 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> }",
          "prism { cubic_spline 0, 1, 6, <0, 0>, <1, 0>, <" + n + ", 1>, <1, 0>, <0, 0>, <1, 0> }",
          "sphere_sweep { cubic_spline 4, 0, 1, x, " + n + ", y, 1, z, 1 }",
          "sphere_sweep { b_spline 4, 0, 1, <" + n + ", 0, 0>, 1, y, 1, z, 1 }",
          "isosurface { function { x * " + n + " } }",
          "isosurface { function { x + y } accuracy " + n + " contained_by { box { -1, 1 } } }",
          "isosurface { function { x + y } max_gradient " + n + " }",
          "isosurface { function { x } contained_by { sphere { 0, " + n + " } } accuracy 1 }",
          "julia_fractal { <" + n + ", 0, 0, 0> precision 10 }",
          "julia_fractal { 0 precision " + n + " }",
          "julia_fractal { 0 max_iteration " + n + " precision 2 }",
          "text { ttf \"timrom.ttf\" \"A\" " + n + ", 0 }",
          "mesh { triangle { <" + n + ", 0, 0>, y, z } triangle { x, y, z } }",
          "bicubic_patch { type 1 u_steps 2 v_steps 2 <" + n +
              ", 0, 0>, x, y, z, x, y, z, x, y, z, x, y, z, x, y, z, x }",
          "bicubic_patch { type 1 u_steps " + n + " v_steps 2 0, x, y, z, x, y, z, x, y, z, x, y, z, x, y, z }",
          "height_field { function 3, 3 { x * " + n + " } }"})
      rendered += expect_answer(object);
  }
  EXPECT_GT(rendered, 150);
}

TEST(HostileShapes, BrokenMeshes) {
  for (const char* object :
       {"mesh { }", "mesh2 { vertex_vectors { 0 } face_indices { 0 } }",
        "mesh2 { vertex_vectors { 3, x, y, z } face_indices { 1, <0, 1, 3> } }",
        "mesh2 { vertex_vectors { 3, x, y, z } face_indices { 1, <0, 1, -1> } }",
        "mesh2 { vertex_vectors { 3, x, y, z } face_indices { 1, <0, 1, 2000000000> } }",
        "mesh2 { vertex_vectors { 2000000000, x, y, z } face_indices { 1, <0, 1, 2> } }",
        "mesh2 { vertex_vectors { 3, x, y, z } face_indices { 2000000000, <0, 1, 2> } }",
        "mesh2 { vertex_vectors { -5, x } face_indices { 1, <0, 1, 2> } }",
        "mesh2 { vertex_vectors { 3, x, y, z } face_indices { -1, <0, 1, 2> } }",
        "mesh2 { vertex_vectors { 3, x, y, z } uv_vectors { 1, <0, 0> } face_indices { 1, <0, 1, 2> } uv_indices { 1, "
        "<0, 0, 7> } }",
        "mesh2 { vertex_vectors { 3, x, y, z } normal_vectors { 2, x, y } face_indices { 1, <0, 1, 2> } }",
        "mesh { triangle { 0, 0, 0 } }"})
    expect_answer(object);
}

TEST(HostileShapes, CountsWithoutData) {
  for (const char* object :
       {"polygon { 2000000000, 0, x, y }", "lathe { 2000000000, <0, 0>, <1, 1> }", "sor { 2000000000, <0, 0>, <1, 1> }",
        "prism { 0, 1, 2000000000, <0, 0> }", "sphere_sweep { linear_spline 2000000000, 0, 1 }",
        "height_field { function 60000, 60000 { x } }", "height_field { function 2000000000, 2 { x } }",
        "poly { 36, <1> }",
        "parametric { function { u } function { v } function { 0 } <0, 0>, <1, 1> precompute 30 x, y, z }"})
    expect_answer(object, 20);
}

TEST(HostileShapes, APolygonOfAHundredThousandSides) {
  const bool rendered = expect_answer(
      "polygon { 100001, #for (I, 0, 99999) <cos(I * pi / 50000), sin(I * pi / 50000)> #end <1, 0> }", 30);
  EXPECT_TRUE(rendered);
}

TEST(HostileShapes, HeightFieldWithAHugeHeaderAndNoPixels) {
  const auto path = std::filesystem::temp_directory_path() / "verisim_huge.pgm";
  std::ofstream(path) << "P5\n60000 60000\n255\nnot enough";
  expect_answer("height_field { pgm \"" + path.string() + "\" }");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace verisim::test
