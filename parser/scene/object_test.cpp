// Objects: what their statements put into the description (spec 03, 04).
#include <fmt/format.h>

#include "parser/scene/test_support.h"
#include "tracer/image/image.h"
#include "tracer/scene/bounds.h"

namespace verisim::parser {
namespace {

using testing::first_error;
using testing::object_of;
using testing::parse;
using testing::scene_of;
using testing::sphere_with;

template <class T>
const T& payload(const scene::ObjectPtr& object) {
  return **object->as<std::shared_ptr<const T>>();
}

TEST(Shapes, SimpleOnesKeepTheirNumbers) {
  const auto sphere = *object_of("sphere{<1,2,3>,4}")->as<scene::Sphere>();
  EXPECT_EQ(sphere.center, Vec3(1, 2, 3));
  EXPECT_EQ(sphere.radius, 4);
  const auto box = *object_of("box{<1,-2,3>,<-1,2,-3>}")->as<scene::Box>();
  EXPECT_EQ(box.low, Vec3(-1, -2, -3));
  EXPECT_EQ(box.high, Vec3(1, 2, 3));
  const auto plane = *object_of("plane{2*y,3}")->as<scene::Plane>();
  EXPECT_EQ(plane.normal, Vec3(0, 1, 0));
  EXPECT_EQ(plane.distance, 3);
  const auto cone = *object_of("cone{0,1,y,.5 open}")->as<scene::Cone>();
  EXPECT_EQ(cone.base_radius, 1);
  EXPECT_EQ(cone.cap_radius, .5);
  EXPECT_TRUE(cone.open);
  const auto torus = *object_of("torus{2 .5}")->as<scene::Torus>();
  EXPECT_EQ(torus.major, 2);
  EXPECT_EQ(torus.minor, .5);
  const auto disc = *object_of("disc{0,y,2,1}")->as<scene::Disc>();
  EXPECT_EQ(disc.radius, 2);
  EXPECT_EQ(disc.hole, 1);
}

TEST(Shapes, PolynomialTermsGoToTheirPlaces) {
  // x^2, xy, xz, x, y^2, yz, y, z^2, z, 1
  const auto poly = *object_of(
                         "polynomial{2, xyz(2,0,0):1, xyz(1,1,0):2, xyz(1,0,1):3, xyz(1,0,0):4, xyz(0,2,0):5, "
                         "xyz(0,1,1):6, xyz(0,1,0):7,"
                         " xyz(0,0,2):8, xyz(0,0,1):9, xyz(0,0,0):10}")
                         ->as<scene::Poly>();
  EXPECT_EQ(poly.coefficients, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  const auto sextic = *object_of("polynomial{6, xyz(0,6,0):3, xyz(0,0,0):7, xyz(6,0,0):5}")->as<scene::Poly>();
  ASSERT_EQ(sextic.coefficients.size(), 84u);
  EXPECT_EQ(sextic.coefficients.front(), 5);
  EXPECT_EQ(sextic.coefficients.back(), 7);
  EXPECT_EQ(sextic.coefficients[84 - 28], 3);  // behind all terms with x
}

TEST(Shapes, SpheresOfABlobAbsorbWhatTheyCan) {
  const auto object = object_of(
      "blob{sphere{x,1,2 translate y scale -2 rotate 90*z} sphere{x,1,2 scale <1,2,1> translate y} "
      "sphere{x,1,2 matrix<1,0,0,0,1,0,0,0,1,0,1,0>}}");
  const auto& blob = payload<scene::Blob>(object);
  EXPECT_FALSE(blob.components[0].transform.has_value());
  EXPECT_EQ(blob.components[0].radius, 2);
  EXPECT_LT(length(blob.components[0].a - Vec3(2, -2, 0)), 1e-12);
  EXPECT_EQ(blob.components[1].a, Vec3(1, 0, 0));
  EXPECT_EQ(blob.components[1].transform->point({1, 0, 0}), Vec3(1, 1, 0));
  EXPECT_TRUE(blob.components[2].transform.has_value());
}

TEST(Shapes, BlobComponentsHaveTheirOwnTexturesAndTransforms) {
  const auto object = object_of(
      "blob{threshold .6 sphere{x,1,2} cylinder{0,y,.5,strength -1 pigment{rgb 1} scale 2} component 3 4 <5,6,7>}");
  const auto& blob = payload<scene::Blob>(object);
  ASSERT_EQ(blob.components.size(), 3u);
  EXPECT_EQ(blob.threshold, .6);
  EXPECT_FALSE(blob.components[0].texture);
  EXPECT_TRUE(blob.components[1].cylinder);
  EXPECT_EQ(blob.components[1].strength, -1);
  EXPECT_TRUE(blob.components[1].texture);
  EXPECT_TRUE(blob.components[1].transform.has_value());
  EXPECT_EQ(blob.components[2].strength, 3);
  EXPECT_EQ(blob.components[2].radius, 4);
  EXPECT_EQ(blob.components[2].a, Vec3(5, 6, 7));
}

TEST(Shapes, DefaultsOfImplicitSurfaces) {
  const auto isosurface_object = object_of("isosurface{function{x}}");
  const auto& isosurface = payload<scene::Isosurface>(isosurface_object);
  EXPECT_EQ(isosurface.accuracy, .001);
  EXPECT_EQ(isosurface.max_gradient, 1.1);
  EXPECT_EQ(isosurface.max_trace, 1);
  EXPECT_FALSE(isosurface.open);
  EXPECT_EQ(isosurface.container.low, Vec3(-1, -1, -1));
  const auto all = object_of("isosurface{function{x} all_intersections contained_by{sphere{y,2}}}");
  EXPECT_EQ(payload<scene::Isosurface>(all).max_trace, 10);
  EXPECT_TRUE(payload<scene::Isosurface>(all).container.sphere);
  const auto julia_object = object_of("julia_fractal{<1,2,3,4> hypercomplex pwr(.5,.25) slice <0,0,0,2>,.5}");
  const auto& julia = payload<scene::JuliaFractal>(julia_object);
  EXPECT_EQ(julia.parameter, (std::array<double, 4>{1, 2, 3, 4}));
  EXPECT_EQ(julia.slice[3], 1);
  EXPECT_EQ(julia.exponent, Vec2(.5, .25));
  EXPECT_EQ(julia.max_iteration, 20);
}

TEST(Meshes, VerticesAreRoundedAndSmoothnessFollowsTheNormals) {
  const auto object = object_of(
      "mesh2{vertex_vectors{4,<.1,0,0>,x,y,z} normal_vectors{4,z,z,z,<0,1,1>} face_indices{2,<0,1,2>,<1,2,3>}}");
  const scene::MeshData& mesh = *object->as<scene::Mesh>()->data;
  EXPECT_EQ(mesh.vertices[0].x, static_cast<double>(.1f));
  EXPECT_FALSE(mesh.triangles[0].smooth);  // three equal normals
  EXPECT_TRUE(mesh.triangles[1].smooth);
  EXPECT_EQ(mesh.triangles[1].vertex, (std::array<std::uint32_t, 3>{1, 2, 3}));
  EXPECT_FALSE(mesh.inside_vector.has_value());
}

TEST(Meshes, TexturesOfFaces) {
  const auto object = object_of(
      "mesh2{vertex_vectors{3,0,x,y} texture_list{2 texture{pigment{rgb 1}} texture{pigment{rgb 0}}} "
      "face_indices{3,<0,1,2>,1,<0,1,2>,0,1,0,<0,1,2>}}");
  const scene::MeshData& mesh = *object->as<scene::Mesh>()->data;
  EXPECT_EQ(mesh.triangles[0].texture, (std::array<std::int32_t, 3>{1, -1, -1}));
  EXPECT_EQ(mesh.triangles[1].texture, (std::array<std::int32_t, 3>{0, 1, 0}));
  EXPECT_EQ(mesh.triangles[2].texture, (std::array<std::int32_t, 3>{-1, -1, -1}));
}

TEST(Meshes, DegenerateTrianglesOfMeshVanish) {
  const auto object =
      object_of("mesh{triangle{0,x,x} triangle{0,x,y uv_vectors <0,0>,<.5,0>,<0,1>} inside_vector 2*z}");
  const scene::MeshData& mesh = *object->as<scene::Mesh>()->data;
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.uvs[mesh.triangles[0].uv[1]], Vec2(.5, 0));
  EXPECT_EQ(*mesh.inside_vector, Vec3(0, 0, 1));
}

TEST(Meshes, ErrorsNameTheProblem) {
  EXPECT_EQ(first_error("mesh2{vertex_vectors{3,0,x,y} face_indices{1,<0,1,3>}}"), "Mesh face index out of range.");
  EXPECT_EQ(first_error("mesh2{vertex_vectors{0}}"), "No vertices in triangle mesh.");
  EXPECT_EQ(first_error("mesh2{vertex_vectors{3,0,x,y} normal_vectors{1,z} face_indices{1,<0,1,2>}}"),
            "Missing normal_indicies section in mesh2.");
  EXPECT_EQ(first_error("mesh{triangle{0,x,x}}"), "No triangles in triangle mesh.");
}

TEST(Meshes, HugeCountsTakeNoMemory) {
  EXPECT_NE(first_error("mesh2{vertex_vectors{2000000000,0}"), "");
  EXPECT_NE(first_error("polygon{1e18,0"), "");
  EXPECT_NE(first_error("height_field{function 1e5,1e5{x}}"), "");
}

// POV-Ray's heights at <1557, 1957> / 2000: the value is rounded to binary32 and multiplied there before it is cut off.
// In double they would be 51018 and 64125.
TEST(HeightFields, FunctionsAreSampledInSinglePrecision) {
  const auto object = object_of("height_field{function 2001,2{x}}");
  const scene::HeightMap& map = *(*object->as<std::shared_ptr<const scene::HeightField>>())->map;
  const std::uint16_t* const top = &map.heights[2001];
  EXPECT_EQ(top[1557], 51019);
  EXPECT_EQ(top[1957], 64126);
  EXPECT_EQ(top[1000], 32767);
}
TEST(Images, PigmentsAreSampledInSinglePrecision) {
  const auto object =
      object_of("box{0,1 pigment{image_map{function 2001,2{pigment{gradient x color_map{[0 rgb 0][1 rgb 1]}}}}}}");
  const auto& params = std::get<scene::ImageParams>(*object->texture->layers[0].pigment->pattern.params);
  EXPECT_EQ(params.image->at(1557, 0).r, 51019 / 65535.0f);
  EXPECT_EQ(params.image->at(1957, 0).r, 64126 / 65535.0f);
  EXPECT_EQ(params.image->at(1000, 0).r, 32767 / 65535.0f);
}

TEST(Csg, DifferenceInvertsAllButTheFirst) {
  const auto object = object_of("difference{sphere{0,1} box{0,1} plane{y,0}}");
  const auto& csg = *object->as<scene::Csg>();
  EXPECT_EQ(csg.kind, scene::CsgKind::intersection);
  EXPECT_TRUE(csg.difference);
  const auto& children = scene::children_of(*object);
  ASSERT_EQ(children.size(), 3u);
  EXPECT_FALSE(children[0]->inverted);
  EXPECT_TRUE(children[1]->inverted);
}

TEST(Csg, UntexturedChildrenGetTheParentsTexture) {
  const auto object = object_of("union{sphere{0,1} sphere{0,2 pigment{rgb x}} texture{pigment{rgb y}}}");
  const auto& children = scene::children_of(*object);
  EXPECT_EQ(children[0]->texture, object->texture);
  EXPECT_EQ(children[1]->texture->layers[0].pigment->color, Color(1, 0, 0));
}

TEST(Csg, DefaultTextureIsTheOneAtTheEndOfTheStatement) {
  const auto object = object_of("#declare S=sphere{0,1}; #default{pigment{rgb <0,1,0>}} object{S}");
  EXPECT_EQ(object->texture->layers[0].pigment->color, Color(0, 1, 0));
}

TEST(Csg, CutawayChildrenStayWithoutTexture) {
  const auto object = object_of("difference{union{sphere{0,1 pigment{rgb x}} box{0,1}} sphere{x,1} cutaway_textures}");
  const auto& children = scene::children_of(*object);
  EXPECT_FALSE(children[1]->texture);
  EXPECT_TRUE(scene::children_of(*children[0])[1]->texture);  // a child of a union has the default texture after all
}

TEST(Csg, ChildrenShareTheInteriorAndTheLastHollowWins) {
  const auto object = object_of("union{sphere{0,1 hollow} sphere{x,1} interior{ior 1.5}}");
  const auto& children = scene::children_of(*object);
  EXPECT_EQ(children[0]->interior, object->interior);
  EXPECT_EQ(children[1]->interior, object->interior);
  EXPECT_FALSE(object->interior->hollow);
  EXPECT_TRUE(object_of("union{sphere{0,1} sphere{x,1 hollow}}")->interior->hollow);
  EXPECT_TRUE(object_of("union{sphere{0,1} sphere{x,1} hollow}")->interior->hollow);
  EXPECT_FALSE(object_of("union{sphere{0,1} sphere{x,1 hollow off} hollow}")->interior->hollow);
}

TEST(Objects, SpheresForgetTheirUvWhereNobodyAsksForIt) {
  const auto keeps_uv = [](const std::string& modifiers) {
    return object_of("sphere { 0, 1 " + modifiers + " translate x }")->uv_transform.has_value();
  };
  EXPECT_FALSE(keeps_uv("pigment { rgb x }"));
  EXPECT_FALSE(keeps_uv("pigment { bozo } normal { bumps }"));
  EXPECT_TRUE(keeps_uv("uv_mapping pigment { rgb x }"));
  EXPECT_TRUE(keeps_uv("pigment { uv_mapping checker }"));
  EXPECT_TRUE(keeps_uv("pigment { rgb x } normal { uv_mapping bumps }"));
  EXPECT_TRUE(keeps_uv("pigment { bozo pigment_map { [0 uv_mapping checker] [1 rgb x] } }"));
  EXPECT_TRUE(keeps_uv("texture { bozo texture_map { [0 pigment { uv_mapping checker }] [1 pigment { rgb x }] } }"));
  EXPECT_TRUE(keeps_uv("pigment { rgb x } interior_texture { pigment { uv_mapping checker } }"));
}

TEST(Images, OfFunctionsShareTheirTable) {
  const auto image = [](const std::string& function) {
    const auto object = object_of("box { 0, 1 pigment { image_map { function 3, 3 { " + function + " } } } }");
    return std::get<scene::ImageParams>(*object->texture->layers[0].pigment->pattern.params).image;
  };
  const auto a = image("x"), b = image("y");
  EXPECT_NE(a, b);
  EXPECT_EQ(a->values, b->values);
}

TEST(Csg, CopiesHaveInteriorsOfTheirOwn) {
  const scene::Scene scene = scene_of("#declare S=sphere{0,1 interior{ior 1.5}}; object{S} object{S translate 3*x}");
  EXPECT_NE(scene.objects[0]->interior, scene.objects[1]->interior);
  EXPECT_EQ(scene.objects[1]->interior->ior, 1.5f);
}

TEST(Csg, FlagsRunDownTheTree) {
  const auto object = object_of(
      "union{sphere{0,1} box{0,1} no_shadow no_image radiosity{importance .5} photons{target .5 refraction on collect "
      "off}}");
  for (const auto& child : scene::children_of(*object)) {
    EXPECT_TRUE(child->no_shadow && child->no_image && !child->no_reflection);
    EXPECT_EQ(child->radiosity_importance, .5f);
    EXPECT_TRUE(child->photons->target && !child->photons->collect);
    EXPECT_EQ(child->photons->refraction, scene::Flag::on);
  }
  EXPECT_TRUE(object_of("union{sphere{0,1 no_shadow} box{0,1 no_shadow}}")->no_shadow);
  EXPECT_FALSE(object_of("union{sphere{0,1 no_shadow} box{0,1}}")->no_shadow);
}

TEST(Modifiers, TextureLayersAndParts) {
  const auto object = sphere_with("texture{pigment{rgb x}} texture{pigment{rgbt <0,0,1,.5>}} finish{ambient 1}");
  ASSERT_EQ(object->texture->layers.size(), 2u);
  EXPECT_EQ(object->texture->layers[0].finish->ambient, Rgb(.1f));
  EXPECT_EQ(object->texture->layers[1].finish->ambient, Rgb(1.f));
}

TEST(Modifiers, FilterBecomesTransmitInUpperLayersUpTo310) {
  const scene::Scene scene =
      scene_of("#version 3.1; sphere{0,1 texture{pigment{rgbf <1,1,1,.5>}} texture{pigment{rgbf <1,1,1,.25>}}}");
  const auto& layers = scene.objects[0]->texture->layers;
  EXPECT_EQ(layers[0].pigment->color.f, .5f);
  EXPECT_EQ(layers[1].pigment->color.f, 0);
  EXPECT_EQ(layers[1].pigment->color.t, .25f);
}

TEST(Modifiers, LinkedBoundsAndClips) {
  const auto object = object_of("intersection{sphere{0,1} box{0,1} clipped_by{box{-1,1}} bounded_by{clipped_by}}");
  EXPECT_EQ(object->clipped_by.size(), 1u);
  EXPECT_EQ(object->bounded_by, object->clipped_by);
  EXPECT_EQ(first_error("sphere{0,1 bounded_by{box{0,1}} bounded_by{clipped_by}}"),
            "Cannot link clips with previous bounds.");
  EXPECT_EQ(first_error("sphere{0,1 clipped_by{box{0,1}} bounded_by{clipped_by} clipped_by{box{0,1}}}"),
            "Cannot add clips after linking bounds and clips.");
  EXPECT_EQ(first_error("sphere{0,1 bounded_by{clipped_by} bounded_by{box{0,1}} clipped_by{box{0,1}}}"), "");
  EXPECT_EQ(first_error("sphere{0,1 clipped_by{bounded_by} clipped_by{box{0,1}} clipped_by{box{0,1}}}"), "");
}

TEST(Modifiers, OnePatchDeniesASolidItsInside) {
  const auto asked = [](const std::string& object) {
    return first_error("#declare O=" + object + " #declare V=inside(O,0);");
  };
  EXPECT_EQ(asked("union{disc{0,y,1} sphere{0,1}}"), "");
  EXPECT_EQ(asked("union{sphere{0,1} union{triangle{0,x,y} box{0,1}}}"),
            "inside() needs an object that has an inside.");
  EXPECT_EQ(asked("union{sphere{0,1} light_source{0,1}}"), "inside() needs an object that has an inside.");
}

// A light source is what it shows, and whatever it shines through makes it pass.
TEST(Modifiers, LightSourcesThatShowSolidsHaveAnInside) {
  const auto messages = [](const std::string& light) {
    return parse("#declare O=intersection{sphere{0,1} light_source{0,1 " + light + "}} #declare V=inside(O,0);")
        .messages;
  };
  const std::string solid = "{sphere{0,1}}", patch = "{triangle{0,x,y}}", refusal = "Patch objects not allowed";
  for (const std::string& light : {"looks_like" + solid, "projected_through" + solid, "projected_through" + patch,
                                   "looks_like" + patch + " projected_through" + solid})
    EXPECT_EQ(messages(light).find(refusal), std::string::npos) << light;
  for (const std::string& light : {std::string(), "looks_like" + patch})
    EXPECT_NE(messages(light).find(refusal), std::string::npos) << light;
  EXPECT_EQ(first_error("#declare O=light_source{0,1 looks_like{sphere{0,1}}} #declare V=inside(O,0);"), "");
  EXPECT_EQ(first_error("#declare O=union{sphere{0,1} light_source{0,1 looks_like{sphere{0,1}}}} "
                        "#declare V=inside(O,0);"),
            "");
}

TEST(Modifiers, BoundsCutDownBoxesOfCopiesOfBlobsAndHeightFields) {
  const std::string bound = " bounded_by{box{-1,1}}}";
  for (const std::string& shape :
       {std::string("blob{sphere{0,2,2}"), std::string("height_field{function 9,9{x} scale 3")}) {
    EXPECT_EQ(scene::high_corner(object_of(shape + bound)->bounds).x, shape.starts_with("blob") ? 2 : 3);
    EXPECT_EQ(scene::high_corner(object_of("#declare A=" + shape + bound + " object{A}")->bounds).x, 1);
    EXPECT_EQ(scene::high_corner(object_of("object{" + shape + "}" + bound)->bounds).x, 1);
  }
  EXPECT_EQ(scene::high_corner(object_of("sphere{0,2" + bound)->bounds).x, 1);
}

// The matrix of a height field begins with that of its grid: POV-Ray's bits of hits and normals (spec 04 5.2).
TEST(Objects, HeightFieldsAreHitWherePovRayHitsThem) {
  const auto differs = [](const char* from, const char* along, const std::array<double, 6>& expected) {
    std::string scene =
        "#version 3.7; #declare N=0*x; #declare O=height_field{function 50,20{0.5+0.3*sin(9*x)*cos(7*y)} scale 2 "
        "rotate <10,20,30> translate <0.1,0.2,0.3>} #declare P=trace(O, " +
        std::string(from) + ", " + along + ", N);";
    const char* const kValues[] = {"P.x", "P.y", "P.z", "N.x", "N.y", "N.z"};
    for (std::size_t i = 0; i < 6; ++i)
      scene += fmt::format("#if ({} != {:.17g}) #error \"{}\" #end ", kValues[i], expected[i], kValues[i]);
    return first_error(scene);
  };
  EXPECT_EQ(differs("<0.5,3.1,0.7>", "<0.2,-1,0.1>",
                    {0.75752384419012708, 1.8123807790493649, 0.8287619220950635, -0.43997252295169559,
                     0.46788386413716937, -0.76649127113594107}),
            "");
  EXPECT_EQ(differs("<3.3,1.2,-0.4>", "<-1.1,-0.1,0.7>",
                    {0.69409875009924704, 0.96309988637265875, 1.2583007953913876, -0.92807325384291872,
                     0.028623462921974045, 0.37129601785067945}),
            "");
}

// As max_extent of POV-Ray has them: in binary32, with its roundings on the way.
TEST(Modifiers, BoxesHaveAllBits) {
  const std::pair<std::string, std::array<double, 6>> kProbes[] = {
      {R"(union { sphere { <-2.63, -1.33, 2.81>, 2.34 } sphere { <0.02, 0.78, 2.18>, 1.8 } })",
       {-4.96999979, -3.67000008, 0.379999995, 1.82000017, 2.57999992, 5.1500001}},
      {"difference { sphere { <2.68, 2.3, 1.5>, 0.37 } sphere { <-2.74, -1.68, 0.9>, 2.4 } rotate <-31.8, "
       "-62.7, 27.3> }",
       {-0.714694977, 2.49574566, 1.84787595, 0.281836748, 3.45939827, 2.97275591}},
      {"blob { threshold 0.3 sphere { <1, 1.94, 1>, 1.88, 1 } rotate <-60.9, -40.8, 60.6> translate "
       "<-1.04, 1.48, 0.4> }",
       {-4.55656099, 0.809972823, -3.02569079, 0.828809738, 6.6294837, 3.30244708}},
      {"object { blob { threshold 0.3 sphere { <1, 1.94, 1>, 1.88, 1 } } rotate <-60.9, -40.8, 60.6> "
       "translate <-1.04, 1.48, 0.4> }",
       {-4.55656099, 0.809972823, -3.02569056, 0.828809738, 6.6294837, 3.30244732}},
      {R"(blob { threshold 0.3 cylinder { <2.44, 2.51, -1.35>, <0.88, -2.71, -2.57>, 0.17, 1 } })",
       {-2.57366538, -4.33366537, -6.1936655, 5.89366531, 4.13366556, 2.27366543}},
      {R"(blob { threshold 0.3 sphere { <0.34, 0, 0.41>, 1.18, 1 scale <-2.57, 0.22, -0.81> } })",
       {-3.90639997, -3.03259993, -3.36469984, 2.15879989, 3.03259993, 2.70050001}},
      {R"(union { light_group { light_source { 3, rgb 1 } sphere { 0, 1 } } })",
       {-1e+10, -1e+10, -1e+10, 1e+10, 1e+10, 1e+10}},
      {R"(text { ttf "timrom.ttf" "Ab" 0.83, 0 rotate <-31.8, -62.7, 27.3> })",
       {-0.757902563, -0.00971931033, -0.168239519, 0.513931453, 1.03209805, 1.40653348}},
  };
  for (const auto& [text, extents] : kProbes) {
    const scene::Bounds bounds = object_of(text)->bounds;
    const Vec3 low = scene::low_corner(bounds), high = scene::high_corner(bounds);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(low[i], static_cast<float>(extents[static_cast<std::size_t>(i)])) << text;
      EXPECT_EQ(high[i], static_cast<float>(extents[static_cast<std::size_t>(i + 3)])) << text;
    }
  }
}

// The object that a light shows takes what the CSG object around it has, and is cut out of a solid.
TEST(Modifiers, LightSourcesWithinSolids) {
  const auto shown = [](const std::string& scene, std::size_t child) {
    return scene::children_of(*object_of(scene))[child]->as<scene::LightSource>()->looks_like;
  };
  const std::string light = "light_source{0,1 looks_like{sphere{0,1}}}";
  const auto merge = object_of("merge{sphere{1,1} " + light + " pigment{rgb x} no_image}");
  const auto in_merge = scene::children_of(*merge)[1]->as<scene::LightSource>()->looks_like;
  EXPECT_EQ(in_merge->texture, merge->texture);
  EXPECT_TRUE(in_merge->no_image);
  const auto own =
      shown("merge{sphere{1,1} light_source{0,1 looks_like{sphere{0,1} pigment{rgb y}}} pigment{rgb x}}", 1);
  EXPECT_EQ(own->texture->layers[0].pigment->color, Color(0, 1, 0));
  const auto nested = object_of("merge{sphere{1,1} union{" + light + "} pigment{rgb x}}");
  EXPECT_NE(scene::children_of(*scene::children_of(*nested)[1])[0]->as<scene::LightSource>()->looks_like->texture,
            nested->texture);
  EXPECT_TRUE(shown("difference{sphere{0,2} " + light + "}", 1)->inverted);
  EXPECT_FALSE(shown("difference{" + light + " sphere{0,2}}", 0)->inverted);
}

// Everything is inside of an intersection without parts, and yet it keeps no fog out: it has no interior.
TEST(Modifiers, SolidsWithoutPartsHaveNoInterior) {
  EXPECT_EQ(object_of("intersection{}")->interior, nullptr);
  EXPECT_EQ(object_of("intersection{light_source{0,1}}")->interior, nullptr);
  EXPECT_NE(object_of("intersection{interior{}}")->interior, nullptr);
  EXPECT_NE(object_of("intersection{intersection{}}")->interior, nullptr);
}

TEST(Modifiers, OneObjectIsFewForASolidSinceVersion16) {
  EXPECT_EQ(parse("#version 1.5; difference{sphere{0,1}}").messages.find("at least 2"), std::string::npos);
  EXPECT_NE(parse("#version 1.6; difference{sphere{0,1}}").messages.find("at least 2"), std::string::npos);
}

TEST(Modifiers, AnInvertedSolidHasAnInsideWithPatchesToo) {
  const auto messages = [](const std::string& object) {
    return parse("#declare O=" + object + " #declare V=inside(O,0);").messages;
  };
  const std::string mixed = "union{sphere{0,1} triangle{0,x,y}}", inverse = "object{" + mixed + " inverse}";
  EXPECT_NE(messages(inverse).find("Cannot invert a patch object."), std::string::npos);
  for (const std::string& object :
       {inverse, "difference{sphere{0,2} " + mixed + "}", "intersection{sphere{0,2} " + inverse + "}"})
    EXPECT_EQ(messages(object).find("an inside"), std::string::npos) << object;
  EXPECT_EQ(messages("intersection{sphere{0,2} " + inverse + "}").find("Patch objects"), std::string::npos);
}

TEST(Modifiers, ErrorsHavePovRaysMeaning) {
  EXPECT_EQ(first_error("sphere{0,1 pigment{rgb 1} uv_mapping}"), "uv_mapping must be specified before texture.");
  EXPECT_EQ(first_error("sphere{0,1 interior_texture{pigment{rgb 1}}}"),
            "Interior texture requires an exterior texture.");
  EXPECT_EQ(first_error("box{0,1 sturm}"), "Keyword 'sturm' cannot be used with this object.");
  EXPECT_EQ(first_error("sphere{0,1 foo}"), "Undeclared identifier 'foo'.");
  EXPECT_EQ(first_error("sphere{0,1 mortar}"), "Expected '}' to end 'sphere {', mortar found instead.");
  EXPECT_EQ(first_error("sphere{0,1 texture{checker texture{} texture{}} pigment{rgb 1}}"),
            "Cannot layer over a patterned texture.");
}

TEST(Modifiers, ColorsOutsideOfTexturesWarn) {
  EXPECT_NE(parse("sphere{0,1 rgb 1}").messages.find("Quick color belongs in texture"), std::string::npos);
}

TEST(LightGroups, LightsReachTheGroupsObjectsOnly) {
  const auto object =
      object_of("light_group{light_source{y rgb 1} sphere{0,1} union{box{0,1} sphere{0,2}} global_lights off}");
  const auto& children = scene::children_of(*object);
  EXPECT_EQ(children[1]->group_lights.size(), 1u);
  EXPECT_EQ(scene::children_of(*children[2])[0]->group_lights.size(), 1u);
  EXPECT_TRUE(children[1]->ignore_global_lights);
  EXPECT_FALSE(scene::children_of(*object_of("light_group{sphere{0,1} global_lights on}"))[0]->ignore_global_lights);
}

TEST(LightGroups, InnerGroupsWithLightsInheritOnlyAsCopies) {
  const auto lights_inside = [](const std::string& text) {
    const scene::Scene scene = scene_of(text);
    const auto& outer = scene::children_of(*scene.objects.back());
    return scene::children_of(*outer[1]).back()->group_lights.size();
  };
  EXPECT_EQ(lights_inside("light_group{light_source{y rgb 1} light_group{light_source{x rgb 1} sphere{0,1}}}"), 1u);
  EXPECT_EQ(lights_inside("light_group{light_source{y rgb 1} light_group{sphere{0,1}}}"), 1u);
  EXPECT_EQ(lights_inside("#declare G=light_group{light_source{x rgb 1} sphere{0,1}} light_group{light_source{y rgb 1} "
                          "light_group{G}}"),
            2u);
}

TEST(LightSource, DefaultsAndTypes) {
  const auto light = *object_of("light_source{<1,2,3>, rgb <1,.5,.25>}")->as<scene::LightSource>();
  EXPECT_EQ(light.position, Vec3(1, 2, 3));
  EXPECT_EQ(light.color, Rgb(1, .5f, .25f));
  EXPECT_EQ(light.adaptive, 100);
  EXPECT_TRUE(light.media_interaction && !light.media_attenuation);
  const auto spot = *object_of("light_source{0 rgb 1 spotlight point_at 2*x}")->as<scene::LightSource>();
  EXPECT_EQ(spot.radius, 30);
  EXPECT_EQ(spot.falloff, 45);
  EXPECT_EQ(spot.tightness, 0);
  EXPECT_EQ(spot.direction, Vec3(1, 0, 0));
  const auto cylinder = *object_of("light_source{0 rgb 1 cylinder}")->as<scene::LightSource>();
  EXPECT_TRUE(cylinder.parallel);
  EXPECT_EQ(cylinder.radius, .75);
  EXPECT_EQ(object_of("light_source{0 rgb 1 spotlight shadowless}")->as<scene::LightSource>()->kind,
            scene::LightKind::shadowless);
}

TEST(LightSource, Errors) {
  EXPECT_NE(first_error("light_source{0 rgb 1 radius 5}").find("standard light source"), std::string::npos);
  EXPECT_NE(first_error("light_source{0 rgb 1 spotlight shadowless falloff 5}").find("standard light source"),
            std::string::npos);
  EXPECT_NE(first_error("light_source{0 rgb 1 area_light x,y,0,1}"), "");
  EXPECT_NE(first_error("light_source{0 rgb 1 area_light x,y,1,5 circular}"), "");
  EXPECT_NE(first_error("light_source{0 rgb 1 looks_like{sphere{0,1}} looks_like{sphere{0,1}}}"), "");
}

TEST(LightSource, LooksLikeMovesToTheLight) {
  const auto light =
      *object_of("light_source{<1,2,3> rgb 1 looks_like{sphere{0,1}} translate x}")->as<scene::LightSource>();
  EXPECT_EQ(light.looks_like->as<scene::Sphere>()->center, Vec3(2, 2, 3));
  EXPECT_TRUE(light.looks_like->no_shadow);
  EXPECT_TRUE(light.looks_like->texture);
}

}  // namespace
}  // namespace verisim::parser
