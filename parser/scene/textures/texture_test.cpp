// Pigments, normals, finishes, interiors and media in the description (spec 05, 06, 07).
#include <cmath>

#include "parser/scene/test_support.h"
#include "tracer/image/image.h"

namespace verisim::parser {
namespace {

using scene::PatternKind;
using testing::finish_of;
using testing::first_error;
using testing::normal_of;
using testing::parse;
using testing::pigment_of;
using testing::scene_of;
using testing::sphere_with;

TEST(Pigments, WarpsAreOrderedLastFirst) {
  const auto pigment = pigment_of("bozo turbulence .5 scale 2 translate x warp{repeat x} rotate y");
  ASSERT_EQ(pigment->pattern.warps.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<Transform>(pigment->pattern.warps[0]));
  EXPECT_TRUE(std::holds_alternative<scene::RepeatWarp>(pigment->pattern.warps[1]));
  const auto& first_written = std::get<Transform>(pigment->pattern.warps[2]);
  EXPECT_EQ(first_written.point(Vec3(1, 0, 0)), Vec3(3, 0, 0));  // scale, then translate, in one matrix
  ASSERT_TRUE(pigment->pattern.turbulence.has_value());
  EXPECT_EQ(pigment->pattern.turbulence->amount, Vec3(.5, .5, .5));
}

TEST(Pigments, KeywordsSetTheirDefaultsAndKeepTheRest) {
  EXPECT_EQ(pigment_of("marble")->pattern.wave, scene::Wave::triangle);
  EXPECT_EQ(pigment_of("checker")->pattern.frequency, 0);
  EXPECT_EQ(pigment_of("checker frequency 2")->pattern.frequency, 2);
  const auto copied = pigment_of("P onion", "#declare P=pigment{marble frequency 3 color_map{[0 rgb 0][1 rgb 1]}}");
  EXPECT_EQ(copied->pattern.kind, PatternKind::onion);
  EXPECT_EQ(copied->pattern.wave, scene::Wave::triangle);
  EXPECT_EQ(copied->pattern.frequency, 3);
  EXPECT_TRUE(copied->color_map);
}

TEST(Pigments, UnchangedIdentifiersAreShared) {
  const scene::Scene scene = scene_of("#declare P=pigment{bozo}; sphere{0,1 pigment{P}} sphere{x,1 pigment{P}}");
  EXPECT_EQ(scene.objects[0]->texture->layers[0].pigment, scene.objects[1]->texture->layers[0].pigment);
}

TEST(Pigments, ListsAreFilledFromTheBuiltInColors) {
  const auto checker = pigment_of("checker rgb <1,0,0>");
  ASSERT_EQ(checker->color_map->size(), 2u);
  EXPECT_EQ((*checker->color_map)[1].value, Color(0, 1, 0));
  const auto hexagon = pigment_of("hexagon")->color_map;  // which a later pattern takes as its map
  ASSERT_EQ(hexagon->size(), 3u);
  EXPECT_EQ((*hexagon)[2].value, Color(1, 0, 0));
  EXPECT_EQ(pigment_of("brick pigment{rgb 1} pigment{bozo}")->pigment_map->size(), 2u);
}

TEST(Pigments, ColorMapEntries) {
  const auto map = pigment_of("bozo color_map{[.5 rgb x][0, 1 color rgb y color rgbt <0,0,1,.5>]}")->color_map;
  ASSERT_EQ(map->size(), 3u);
  EXPECT_EQ((*map)[0].position, .5f);
  EXPECT_EQ((*map)[2].position, 1);
  EXPECT_EQ((*map)[2].value, Color(0, 0, 1, 0, .5f));
}

TEST(Pigments, AverageWeights) {
  const auto map = pigment_of("average pigment_map{[3 rgb 1][bozo][P]}", "#declare P=pigment{rgb 0};")->pigment_map;
  ASSERT_EQ(map->size(), 3u);
  EXPECT_EQ((*map)[0].position, 3);
  EXPECT_EQ((*map)[1].position, 1);
  EXPECT_EQ((*map)[2].value->pattern.kind, PatternKind::plain);
}

TEST(Pigments, UvMappingWrapsTheRest) {
  const auto pigment = pigment_of("uv_mapping checker rgb 1 rgb 0 scale 2");
  EXPECT_EQ(pigment->pattern.kind, PatternKind::uv_mapping);
  EXPECT_TRUE(pigment->pattern.warps.empty());
  EXPECT_EQ((*pigment->pigment_map)[0].value->pattern.warps.size(), 1u);
}

TEST(Pigments, ParametersOfPatterns) {
  const auto params = [](const char* text) { return pigment_of(text)->pattern.params.value_or({}); };
  EXPECT_EQ(std::get<scene::CrackleParams>(params("crackle form <1,2,3> metric <4,5,6> offset 7 solid")).metric, 4);
  EXPECT_EQ(std::get<scene::BrickParams>(params("brick brick_size 2 mortar .25")).mortar, .25f);
  EXPECT_EQ(std::get<scene::FractalParams>(params("magnet 2 julia <.1,.2>,30 exterior 3,.5")).exterior_factor, .5);
  EXPECT_EQ(std::get<scene::SpiralParams>(params("spiral1 3.7")).arms, 3);
  EXPECT_EQ(std::get<scene::PavementParams>(params("pavement number_of_sides 6 number_of_tiles 5 pattern 22")).pattern,
            22);
  EXPECT_EQ(std::get<scene::SlopeParams>(params("slope{y,.1,.2 altitude x,3,4}")).altitude_high, 4);
  EXPECT_EQ(pigment_of("bozo noise_generator 1 noise_generator 2")->pattern.noise_generator, 3);
}

TEST(Pigments, BlackHolesAreFittedIntoTheirBlocks) {
  const auto pigment = pigment_of("bozo warp{black_hole <.1,.6,.6>,.5 repeat <.8,2,0>}");
  const auto& warp = std::get<scene::BlackHoleWarp>(pigment->pattern.warps[0]);
  EXPECT_EQ(warp.center.x, .5);
  EXPECT_EQ(warp.repeat.x, 1);
  EXPECT_EQ(warp.repeat.y, 2);
}

TEST(Pigments, FunctionImagesWrapAround) {
  const auto pigment = pigment_of("image_map{function 3,2{x*2-.3} interpolate 2 once}");
  const auto& params = std::get<scene::ImageParams>(*pigment->pattern.params);
  ASSERT_EQ(params.image->width, 3);
  EXPECT_EQ(params.image->at(0, 0).r, 45876 / 65535.0f);  // -0.3 in 16 bits without a sign
  EXPECT_TRUE(params.once);
  EXPECT_EQ(params.interpolate, 2);
}

TEST(Pigments, FunctionImagesAskForNoSurface) {
  const std::string checks = "pigment{uv_mapping checker rgb x rgb y}";
  EXPECT_NE(first_error("sphere{0,1 pigment{image_map{function 3,2{" + checks + "}}}}").find("no surface"),
            std::string::npos);
  EXPECT_NE(
      first_error("#declare F=function{" + checks + "} height_field{function 3,2{F(x,y,z).red}}").find("no surface"),
      std::string::npos);
  EXPECT_NE(first_error("#declare F=function{" + checks + "} #declare V=F(1,2,3).red;").find("no surface"),
            std::string::npos);
}

TEST(Pigments, AWarpHasOneTurbulence) {
  EXPECT_EQ(first_error("sphere{0,1 pigment{bozo warp{turbulence 1 octaves 2 octaves 3 lambda 2}}}"), "");
  EXPECT_NE(first_error("sphere{0,1 pigment{bozo warp{turbulence 1 octaves 2 turbulence 2}}}"), "");
}

TEST(Pigments, QuickColorAndMessages) {
  EXPECT_EQ(*pigment_of("bozo quick_color rgb x")->quick_color, Rgb(1, 0, 0));
  EXPECT_NE(parse("sphere{0,1 pigment{}}").messages.find("Pigment type unspecified"), std::string::npos);
  EXPECT_EQ(first_error("sphere{0,1 pigment{checker color_map{[0 rgb 1]}}}"),
            "Cannot use color_map with this pattern type.");
  EXPECT_EQ(first_error("sphere{0,1 pigment{bozo mortar 1}}"),
            "Keyword 'mortar' can only be used in a brick statement.");
  EXPECT_EQ(first_error("sphere{0,1 pigment{tiling 28}}"), "Tiling number must be between 1 and 27.");
}

TEST(Normals, AmountAndMaps) {
  EXPECT_EQ(normal_of("bumps")->amount, .5f);
  EXPECT_EQ(normal_of("bumps, .25 scale 2")->amount, .25f);
  EXPECT_EQ(normal_of("bumps bump_size 3 accuracy .1 no_bump_scale")->amount, 3);
  EXPECT_EQ((*normal_of("gradient x slope_map{[0 <0,1>][1 <1,2>]}")->slope_map)[1].value.slope, 2);
  EXPECT_EQ(normal_of("checker normal{bumps} normal{dents}")->normal_map->size(), 2u);
  EXPECT_FALSE(normal_of("checker 1")->normal_map);
  EXPECT_EQ(first_error("sphere{0,1 normal{}}"), "No normal type given.");
  EXPECT_EQ(first_error("#declare N=normal{bump_size 2};"), "");
}

// At the beginning of a texture, and nowhere else.
TEST(Textures, IdentifiersOfTheirParts) {
  const std::string declared =
      "#declare P=pigment{rgb x} #declare Q=pigment{rgb y} #declare F=finish{ambient 1} "
      "#declare N=normal{bumps 2} #declare T=texture{pigment{rgb z}} "
      "texture{pigment{rgbt 1}}; ";
  const auto layer = [&](const std::string& body) {
    return sphere_with("texture{" + body + "}", declared)->texture->layers.back();
  };
  EXPECT_EQ(layer("P Q").pigment->color, Color(0, 1, 0));
  EXPECT_EQ(layer("Q P scale 2").pigment->color, Color(1, 0, 0));
  EXPECT_EQ(layer("F N P").normal->amount, 2);
  EXPECT_EQ(layer("F N P").finish->ambient, Rgb(1, 1, 1));
  EXPECT_EQ(layer("T Q N").pigment->color, Color(0, 1, 0));
  EXPECT_EQ(sphere_with("texture{T Q}", declared)->texture->layers[0].pigment->color, Color(0, 0, 1));
  for (const char* body : {"pigment{rgb 1} P", "P scale 2 P", "P finish{ambient 1} N", "P T", "T T"})
    EXPECT_NE(first_error(declared + "sphere{0,1 texture{" + body + "}}"), "") << body;
}

// Maps may come before the pattern that they belong to: of a normal it must be there where the normal is used.
TEST(Textures, MapsWithoutAType) {
  EXPECT_EQ(normal_of("normal_map{[0 bumps][1 dents]}} normal{wood")->normal_map->size(), 2u);
  EXPECT_EQ(first_error("#declare N=normal{slope_map{[0 <0,1>]}};"), "");
  EXPECT_EQ(first_error("sphere{0,1 normal{normal_map{[0 bumps]}}}"), "No normal type given.");
  const std::string image = "sphere{0,1 normal{bump_map{function 3,3{x}} ";
  EXPECT_EQ(first_error(image + "normal_map{[0 bumps]}}}"),
            "Keyword 'normal_map' cannot be used with this normal type.");
  EXPECT_EQ(first_error(image + "slope_map{[0 <0,1>]}}}"), "Keyword 'slope_map' cannot be used with this normal type.");
  EXPECT_EQ(first_error("#default{normal{}} light_source{0,1}"), "");
  EXPECT_EQ(first_error("#default{normal{}} union{light_source{0,1} sphere{0,1 normal{bumps}}}"), "");
  EXPECT_EQ(first_error("#default{normal{}} light_source{0,1 looks_like{sphere{0,1}}}"), "No normal type given.");
  const std::string media = "sphere{0,1 hollow interior{media{density{";
  const auto sphere = sphere_with("hollow interior{media{density{color_map{[0 rgb 1]}}}}");
  EXPECT_EQ(sphere->interior->media[0].densities[0]->color, Color(0, 0, 0));
  EXPECT_EQ(first_error(media + "color_map{[0 rgb 1]}}}}}"), "");
  EXPECT_EQ(first_error(media + "density_map{[0 rgb 1]}}}}}"), "");
  EXPECT_EQ(first_error(media + "rgb 1 color_map{[0 rgb 1]}}}}}"), "Cannot use color_map with this pattern type.");
}

TEST(Textures, PatternedOnes) {
  const auto texture = sphere_with("texture{tiles{texture{pigment{rgb x}} tile2 texture{pigment{rgb y}}}}")->texture;
  ASSERT_TRUE(texture->patterned());
  EXPECT_EQ((*texture->texture_map)[0].value->layers[0].pigment->color, Color(0, 1, 0));  // a checker in reverse
  EXPECT_EQ(first_error("sphere{0,1 texture{bozo}}"), "Patterned texture must have texture_map.");
  EXPECT_EQ(first_error("sphere{0,1 texture{average}}"), "Average must have map.");
}

TEST(Textures, DeclaredLayersStayTogether) {
  const auto texture =
      sphere_with("texture{T pigment{rgb y}}", "#declare T=texture{pigment{rgb x}} texture{pigment{rgbt 1}};")->texture;
  ASSERT_EQ(texture->layers.size(), 2u);
  EXPECT_EQ(texture->layers[0].pigment->color, Color(1, 0, 0));
  EXPECT_EQ(texture->layers[1].pigment->color, Color(0, 1, 0));  // changes go to the top layer
}

TEST(Textures, ObjectTransformsMoveThem) {
  const auto object = sphere_with("pigment{bozo} translate x");
  EXPECT_EQ(object->texture->layers[0].pigment->pattern.warps.size(), 1u);
  EXPECT_EQ(sphere_with("translate x pigment{bozo}")->texture->layers[0].pigment->pattern.warps.size(), 0u);
  EXPECT_EQ(sphere_with("uv_mapping pigment{bozo} translate x")->texture->layers[0].pigment->pattern.warps.size(), 0u);
}

// Items that stand in the texture itself are taken one by one, transformations of the texture among them (spec 05 13).
TEST(OldTextures, PatternsKeepTheWave) {
  const auto first_layer = [](const char* items) {
    return scene_of(std::string("#version 1.0 sphere { <0 0 0> 1 texture { ") + items + " } }")
        .objects[0]
        ->texture->layers[0];
  };
  EXPECT_EQ(first_layer("marble").pigment->pattern.wave, scene::Wave::ramp);
  EXPECT_EQ(first_layer("pigment { marble }").pigment->pattern.wave, scene::Wave::triangle);
  EXPECT_EQ(first_layer("pigment { bozo sine_wave } wood").pigment->pattern.wave, scene::Wave::sine);
  const auto fractal = std::get<scene::FractalParams>(first_layer("mandel 20").pigment->pattern.params.value_or({}));
  EXPECT_EQ(fractal.exterior_type, 0);
  EXPECT_EQ(fractal.exterior_factor, 0);
  EXPECT_EQ(fractal.interior_factor, 0);
}

TEST(OldTextures, TransformationsReachWhatStandsBeforeThem) {
  const scene::Scene scene = scene_of(
      "#version 1.0 sphere { <0 0 0> 1 "
      "texture { gradient <1 0 0> scale <2 2 2> waves .3 scale <3 3 3> turbulence .4 } }");
  const scene::TextureLayer& layer = scene.objects[0]->texture->layers[0];
  ASSERT_EQ(layer.pigment->pattern.warps.size(), 1u);
  EXPECT_EQ(std::get<Transform>(layer.pigment->pattern.warps[0]).point(Vec3(1, 0, 0)), Vec3(6, 0, 0));
  EXPECT_EQ(std::get<Transform>(layer.normal->pattern.warps[0]).point(Vec3(1, 0, 0)), Vec3(3, 0, 0));
  EXPECT_EQ(layer.pigment->pattern.turbulence->amount, Vec3(.4, .4, .4));
  EXPECT_FALSE(layer.normal->pattern.turbulence.has_value());
}

TEST(OldTextures, ItemsAreTakenOneByOneUpToVersion3) {
  const scene::Scene scene =
      scene_of("#version 2.0; sphere { 0, 1 texture { marble waves .3 turbulence .4 metallic .5 diffuse .3 } }");
  const scene::TextureLayer& layer = scene.objects[0]->texture->layers[0];
  EXPECT_EQ(layer.pigment->pattern.wave, scene::Wave::ramp);
  EXPECT_EQ(layer.pigment->pattern.turbulence->amount, Vec3(.4, .4, .4));
  EXPECT_FALSE(layer.normal->pattern.turbulence.has_value());
  const scene::Finish finish = layer.finish;
  EXPECT_EQ(finish.metallic, 1);
  EXPECT_EQ(finish.crand, .5f);  // the number behind `metallic`
  EXPECT_EQ(finish.raw_diffuse, .3f);
}

TEST(OldTextures, LayersChangeMapsForAllWhoShareThem) {
  const auto filters = [](const char* version) {
    const scene::Scene scene = scene_of(std::string("#version ") + version +
                                        "; global_settings { assumed_gamma 1 }"
                                        "#declare P = pigment { bozo color_map { [0 rgbf 1] [1 rgbf .5] } }; "
                                        "sphere { 0, 1 pigment { P } }"
                                        "sphere { 0, 1 pigment { rgb 1 } texture { pigment { average pigment_map { "
                                        "[1 P] [1 rgbf 1] } } } }");
    const scene::Pigment& other = *scene.objects[0]->texture->layers[0].pigment;
    const scene::Pigment& layer = *scene.objects[1]->texture->layers[1].pigment;
    return (*other.color_map)[0].value.f + (*layer.pigment_map)[1].value->color.f;
  };
  EXPECT_EQ(filters("3.1"), 0);
  EXPECT_EQ(filters("3.5"), 2);
}

TEST(OldTextures, LayersOfLaterVersionsChangeWhereTheyAreUsed) {
  const scene::Scene scene = scene_of(
      "#version 3.5; global_settings { assumed_gamma 1 }"
      "#declare T = texture { pigment { rgbf .7 } } texture { pigment { rgbf .5 } }; #version 3.1; "
      "sphere { 0, 1 texture { T } } #version 3.5; sphere { 0, 1 texture { T } }");
  const auto filter = [&](std::size_t object, std::size_t layer) {
    return scene.objects[object]->texture->layers[layer].pigment->color.f;
  };
  EXPECT_EQ(filter(0, 0), .7f);
  EXPECT_EQ(filter(0, 1), 0);
  EXPECT_EQ(filter(1, 1), .5f);
}

TEST(OldTextures, ColorsHaveOperatorsWhereTheyAreDeclared) {
  const char* text = "#version 1.0 #declare C = color red 1 #declare D = C*.5 sphere { <0 0 0> 1 pigment { color D } }";
  EXPECT_EQ(scene_of(text).objects[0]->texture->layers[0].pigment->color, Color(.5f, 0, 0));
  EXPECT_NE(first_error("#version 1.0 #declare F = .3 #declare D = F*.5"), "");
}

TEST(Pigments, UseColorTakesUseAlphaBack) {
  const auto params = [](const char* items) {
    const auto pigment = pigment_of(std::string("image_pattern { function 5,5 { x } ") + items + " }");
    return std::get<scene::ImageParams>(pigment->pattern.params.value_or({}));
  };
  EXPECT_TRUE(params("use_alpha").use_alpha);
  EXPECT_FALSE(params("use_alpha use_color").use_alpha);
}

TEST(Finishes, Defaults) {
  const auto finish = finish_of("");
  EXPECT_EQ(finish.ambient, Rgb(.1f));
  EXPECT_EQ(finish.diffuse, .6f);
  EXPECT_EQ(finish.phong_size, 40);
  EXPECT_EQ(finish.roughness, .05f);
  EXPECT_EQ(finish.brilliance, 1);
}

TEST(Finishes, AlbedoIsScaledWhenTheBlockEnds) {
  const auto finish =
      finish_of("diffuse albedo .5,.25 brilliance 3 phong albedo .5 phong_size 9 specular albedo .1 roughness .1");
  EXPECT_EQ(finish.diffuse, 1);
  EXPECT_EQ(finish.diffuse_back, .5f);
  EXPECT_EQ(finish.raw_diffuse, .5f);
  EXPECT_EQ(finish.phong, 2.5f);
  EXPECT_FLOAT_EQ(finish.specular, static_cast<float>(.1 * 12 / (4 * (2 - std::pow(2, -5)))));
  EXPECT_EQ(finish_of("F brilliance 7", "#declare F=finish{diffuse albedo .5 brilliance 3};").diffuse,
            1);                                                            // keeps its scaling
  EXPECT_EQ(finish_of("phong albedo .5 phong .2 phong_size 9").phong, 1);  // the word stays, the amount does not
  EXPECT_EQ(finish_of("diffuse albedo .5 brilliance 3 diffuse .25").diffuse, .5f);
  EXPECT_EQ(finish_of("F phong .2 phong_size 9", "#declare F=finish{phong albedo .5};").phong, .2f);
}

TEST(Finishes, Reflection) {
  const auto old_form = finish_of("reflection .5").reflection;
  EXPECT_EQ(old_form.minimum, Rgb(.5f));
  EXPECT_EQ(old_form.maximum, Rgb(.5f));
  const auto two = finish_of("reflection{.1 .9 falloff 2 exponent 3 metallic}").reflection;
  EXPECT_EQ(two.minimum, Rgb(.1f));
  EXPECT_EQ(two.maximum, Rgb(.9f));
  EXPECT_EQ(two.metallic, 1);
  const auto comma = finish_of("reflection{.3, metallic}").reflection;
  EXPECT_EQ(comma.minimum, Rgb(.3f));
  EXPECT_EQ(comma.maximum, Rgb(.3f));
  EXPECT_EQ(comma.metallic, 1);
  const auto fresnel = finish_of("reflection{.8 fresnel}").reflection;
  EXPECT_EQ(fresnel.minimum, Rgb());
  EXPECT_EQ(fresnel.maximum, Rgb(.8f));
  const auto fresnel_before = finish_of("reflection{0, 1 fresnel} reflection{.8}").reflection;
  EXPECT_TRUE(fresnel_before.fresnel);
  EXPECT_EQ(fresnel_before.minimum, Rgb(.8f));
  const auto kept = finish_of("reflection{.5}", "#default{finish{reflection{.1 falloff 4 metallic .3}}}").reflection;
  EXPECT_EQ(kept.falloff, 4);
  EXPECT_EQ(kept.metallic, .3f);
}

TEST(Finishes, OtherItems) {
  const auto finish = finish_of(
      "irid{.3 thickness .2 turbulence <.1,5,5>} metallic crand .1 conserve_energy emission rgb x "
      "subsurface{translucency .2}");
  EXPECT_EQ(finish.irid_turbulence, .1f);
  EXPECT_EQ(finish.metallic, 1);
  EXPECT_TRUE(finish.conserve_energy && finish.subsurface);
  EXPECT_EQ(finish.emission, Rgb(1, 0, 0));
  EXPECT_NE(parse("sphere{0,1 finish{roughness 0}}").messages.find("Zero roughness"), std::string::npos);
}

TEST(Interiors, LegacyFinishKeywordsOverride) {
  const auto object = sphere_with("finish{ior 1.3 caustics 2} interior{ior 2 dispersion 1.2 caustics 1 refraction .5}");
  EXPECT_EQ(object->interior->ior, 1.3f);
  EXPECT_EQ(object->interior->dispersion, 1);
  EXPECT_EQ(object->interior->caustics, 2);
  EXPECT_EQ(object->interior->refraction, 1);
  EXPECT_EQ(sphere_with("interior{caustics 1}")->interior->caustics, 45);
  EXPECT_EQ(sphere_with("interior{dispersion 1.2}")->interior->dispersion, 1);  // needs an ior
  EXPECT_EQ(sphere_with("interior{ior 1 dispersion 1.2}")->interior->dispersion, 1.2f);
}

TEST(Media, DefaultsFollowTheVersion) {
  const scene::Media now = scene_of("media{}").atmosphere[0], then = scene_of("#version 3.1; media{}").atmosphere[0];
  EXPECT_EQ(now.method, 3);
  EXPECT_EQ(now.intervals, 1);
  EXPECT_EQ(now.samples_min, 10);
  EXPECT_EQ(now.aa_level, 3);
  EXPECT_EQ(then.method, 1);
  EXPECT_EQ(then.intervals, 10);
  EXPECT_EQ(then.samples_max, 1);
}

TEST(Media, ItemsAndTransforms) {
  const scene::Media media = scene_of(
                                 "media{samples 4,8 scattering{5,.5 eccentricity .3 extinction .7} density{spherical} "
                                 "scale 2 density{bozo} collect off}")
                                 .atmosphere[0];
  EXPECT_EQ(media.samples_max, 8);
  EXPECT_EQ(media.eccentricity, .3);
  EXPECT_FALSE(media.collect);
  ASSERT_EQ(media.densities.size(), 2u);
  EXPECT_EQ(media.densities[0]->pattern.warps.size(), 1u);
  EXPECT_EQ(media.densities[1]->pattern.warps.size(), 0u);
  EXPECT_EQ(scene_of("media{samples 7}").atmosphere[0].samples_max, 7);
}

}  // namespace
}  // namespace verisim::parser
