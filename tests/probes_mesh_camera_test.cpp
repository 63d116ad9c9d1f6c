// The mesh camera (spec 02 sections 1.7 and 13, P19): which face a pixel looks from, and to which side.
#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

// Twelve small triangles centred on (i, j, 0), i = 0..3, j = 0..2 in row order, facing +z; a wall beyond shows the
// place as a colour.
const char* const kMeshScene = R"(#version 3.7; global_settings { assumed_gamma 1 }
#declare E = 0.03;
camera { mesh_camera { 1 0 mesh {
  #for (J, 0, 2) #for (I, 0, 3) triangle { <I-E,J-E,0>, <I,J+2*E,0>, <I+E,J-E,0> } #end #end
} } location <0,0,0> }
plane { -z,-1 finish { ambient 0 diffuse 0 emission 1 }
  pigment { average pigment_map {
    [1 function { x/8 } color_map { [0 rgb 0] [1 rgb <2,0,0>] }] [1 function { y/8 } color_map { [0 rgb 0] [1 rgb
<0,2,0>] }] } } }
plane { z,-1 finish { ambient 0 diffuse 0 emission 1 } pigment { rgb <0,0,1> } }
)";

TEST(MeshCamera, RowsOfPixelsSeeTheirRowsOfFaces) {
  const auto picture = render_text(kMeshScene, 4, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      const Color c = picture.at(x, y);
      const int row = y == 0 ? 0 : y - 1;  // the first row of faces is used twice, the last never
      EXPECT_NEAR(c.r, x / 8.0, 1e-5) << x << "," << y;
      EXPECT_NEAR(c.g, row / 8.0, 1e-5) << x << "," << y;
      EXPECT_EQ(c.b, 0.0f) << x << "," << y;  // not to the back
    }
  }
}

TEST(MeshCamera, ANegativeDirectionLooksTheOtherWay) {
  std::string scene = kMeshScene;
  scene.insert(scene.find("location <0,0,0>"), "direction -z ");
  EXPECT_EQ(render_text(scene, 4, 3).at(1, 1).b, 1.0f);
}

TEST(MeshCamera, PixelsOnTheSeamOfAUvMapSeeSomething) {
  // Cells of two triangles each: every pixel lies on a diagonal, where both weights may be negative by a rounding.
  const char* const scene = R"(#version 3.7; global_settings { assumed_gamma 1 }
    #declare N = 30; #declare S = 1 / 271;
    camera { mesh_camera { 1 3 mesh {
      #for (I, 0, N) #for (J, 0, N)
        #declare A = I / N - S; #declare B = A + S * 3.3; #declare C = J / N - S; #declare D = C + S * 3.3;
        triangle { <A,D,0>, <A,C,0>, <B,D,0> uv_vectors <A,D>, <A,C>, <B,D> }
        triangle { <B,C,0>, <B,D,0>, <A,C,0> uv_vectors <B,C>, <B,D>, <A,C> }
      #end #end
    } smooth } location <0,0,-.01> }
    sky_sphere { pigment { rgb 1 } })";
  const auto picture = render_text(scene, 30, 30);
  for (int y = 1; y < 30; ++y)
    for (int x = 0; x < 29; ++x) EXPECT_EQ(picture.at(x, y).r, 1.0f) << x << "," << y;
}

TEST(MeshCamera, OfTrianglesThatOverlapInTheUvMapTheFirstIsSeen) {
  const char* const scene = R"(#version 3.7; global_settings { assumed_gamma 1 }
    camera { mesh_camera { 1 3 mesh {
      #for (I, First, 39 - First, (First < 19 ? 1 : -1))
        triangle { <I,0,0>, <I+.5,0,0>, <I,.5,0> uv_vectors <0,0>, <2,0>, <0,2> }
      #end
    } } location <0,0,.01> }
    union { plane { z,-1 } plane { -z,-1 } finish { ambient 0 diffuse 0 emission 1 }
      pigment { function { floor(x)/40 } color_map { [0 rgb 0] [1 rgb 1] } } })";
  for (const int first : {0, 39}) {
    const auto picture = render_text("#declare First = " + std::to_string(first) + ";" + scene, 6, 4);
    for (int y = 1; y < 4; ++y)
      for (int x = 0; x < 5; ++x) EXPECT_NEAR(picture.at(x, y).r, first / 40.0, 1e-6) << x << "," << y;
  }
}

}  // namespace
}  // namespace verisim::test
