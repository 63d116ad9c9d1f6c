// Textures of many points at once are those of each point alone, to the last bit.
#include <gtest/gtest.h>

#include <random>

#include "parser/parse.h"
#include "parser/source/diagnostic.h"
#include "tests/wide/each_instruction_set.h"
#include "tracer/functions/function.h"
#include "tracer/noise/noise.h"
#include "tracer/textures/point_batch.h"
#include "tracer/textures/texture.h"

namespace verisim::test {
namespace {

using textures::PointBatch, textures::SurfacePoint;

constexpr const char* kPatterns[] = {
    "agate agate_turb .7",
    "aoi",
    "boxed",
    "bozo",
    "brick Dark, Light brick_size .7 mortar .1",
    "bumps",
    "cells",
    "checker Dark, Light",
    "crackle",
    "crackle metric 1 offset .2",
    "crackle form <1,.3,-.2> metric 3",
    "crackle solid",
    "cylindrical",
    "dents",
    "granite",
    "gradient <1,.2,0>",
    "gradient y",
    "hexagon Dark, Light, Bright",
    "julia <.353,.288>, 50 interior 1, .7",
    "leopard",
    "magnet 1 mandel 90 exterior 1, 3",
    "magnet 2 julia <.1,.4>, 40 exterior 3, .2",
    "mandel 200 exterior 4, .3 interior 6, .7",
    "mandel 30 exponent 4 exterior 8, 2",
    "mandel 20 exponent 33",
    "marble",
    "object { Ball Dark, Light }",
    "onion",
    "pavement number_of_sides 6 number_of_tiles 3 pattern 2 exterior 1",
    "pigment_pattern { Leaf }",
    "pigment_pattern { pigment_pattern { Deep } color_map { [0 Dark] [1 Light] } scale .9 }",
    "planar",
    "quilted control0 .3 control1 .7",
    "radial",
    "ripples",
    "slope { <0,1,.2>, .1, .8 altitude y, -2, 2 }",
    "spherical",
    "spiral1 3",
    "spiral2 5",
    "spotted",
    "square Dark, Light, Bright, Dark",
    "tiling 7",
    "triangular Dark, Light, Bright,"
    " Dark, Light, Bright",
    "waves",
    "wood",
    "wrinkles",
    "image_map { function 16, 16 { Grid(x,y,z) } interpolate 2 }",
    "image_map { function 9, 7 { Grid(x,y,z) } map_type 1 once interpolate 4 }",
    "image_pattern { function 16, 16 { Grid(x,y,z) } }",
    "function { sin(3*x)*cos(2*y)+f_noise(x,y,z)*abs(z) }",
    "function { Asked(x*.9, y*1.2, z).gray }",
    "function { pattern { granite scale .4 } }",
    "function { select(sin(x*9), 0, f_ridged(x,y,z,.5,2,5,.6,.7,2), exp(-abs(y))) }"};
// Colours, maps and what changes a point on its way; those of patterns with a list have no map.
constexpr const char* kModifiers[] = {
    "Few",
    "Map frequency 2.5 phase .3 sine_wave",
    "Map turbulence <.5,.3,.7> octaves 3 ramp_wave noise_generator 1",
    "Map turbulence .4 lambda 2.3 omega .6 octaves 10 triangle_wave scale <.4,.5,.6> rotate <10,20,30>",
    "Many warp { turbulence <.5,.3,.7> octaves 4 } scallop_wave translate <3,.4,-.2> noise_generator 3",
    "Few warp { repeat x offset .2*y flip z } warp { black_hole 0, .7 strength 2 falloff 2 } noise_generator 1",
    "Many warp { spherical } warp { turbulence .2 } cubic_wave scale .3",
    "Blend scale <.9,1.2,.8> poly_wave 2",
    "Map warp { planar y, .3 } turbulence 1e-3 scale 1e-4"};
constexpr const char* kNormals[] = {"bumps",
                                    "dents",
                                    "wrinkles",
                                    "granite",
                                    "bozo",
                                    "crackle",
                                    "leopard",
                                    "ripples",
                                    "waves",
                                    "quilted",
                                    "slope { y }",
                                    "facets coords .6",
                                    "marble",
                                    "onion",
                                    "agate",
                                    "bump_map { function 16, 16 { Grid(x,y,z) } bump_size 2 interpolate 2 }",
                                    "function { sin(3*x)*y }",
                                    "average normal_map { [bumps] [2 wrinkles scale .3] }",
                                    "gradient x normal_map { [.2 bumps .4] [.8 ripples 2] }"};
constexpr const char* kNormalModifiers[] = {"",
                                            "no_bump_scale scale .2",
                                            "scale <1.3,.4,.9> rotate <20,-30,40>",
                                            "turbulence <.4,.5,.6> accuracy .01",
                                            "frequency 3 phase .4 sine_wave",
                                            "no_bump_scale scale <2,.5,1> bump_size -1.5",
                                            "slope_map { [.1 <0,1>] [.5 <1,0>] [.8 <.3,-1>] } scale .6"};
constexpr const char* kPointsPrelude = R"(#version 3.7; global_settings { assumed_gamma 1 }
#declare f_noise = function { internal(76) } #declare f_ridged = function { internal(59) }
#declare Dark = rgb <.1,.2,.3>; #declare Light = rgbft <1,.5,.25,.1,.3>; #declare Bright = rgb <2,1.5,.1>;
#declare Leaf = pigment { granite color_map { [0 Dark] [.4 Light] [1 Bright] } frequency 3 }
#declare Deep = pigment { Leaf } #for (I, 0, 11) #declare Deep = pigment { pigment_pattern { Deep } color_map { [0 Dark]
  [1 Light] } scale .9 } #end
#declare Asked = function { pigment { Deep } } #declare Grid = function(x,y,z) { .5+.5*sin(19*x)*cos(17*y) }
#declare Ball = sphere { .2, .8 }
#macro Map() color_map { [0 Dark] [.3 Light] [.6 Bright] [1 Dark] } #end
#macro Few() color_map { [0 Dark] [.1 Dark] [.2 Dark] [.9 Light] [1 Dark] } #end
#macro Many() color_map { #for (I, 0, 14) [I/15 rgbt <sin(I),.2,cos(I),abs(sin(3*I))>] #end } #end
#macro Blend() pigment_map { [.1 Leaf] [.3 Dark] [.5 bozo scale .2 color_map { [0 Light] [1 Dark] }] [.9 Leaf] } #end
)";

scene::Scene scene_of_points(const std::string& sdl) {
  parser::ParseResult result = parser::parse_text(kPointsPrelude + sdl, "line.pov", {});
  if (!result.errors.empty() || !result.scene) throw std::runtime_error(parser::format(result.errors.front()));
  return std::move(*result.scene);
}

// Points as they lie in a picture: neighbours, close together or far apart, some of them beyond all lattices.
class RandomPoints {
 public:
  explicit RandomPoints(int round) : random_(static_cast<unsigned>(round)), count(1 + round * 13 % PointBatch::kMax) {
    const double step = std::pow(10.0, round % 5 - 3 + (round == 11 ? 12 : 0));
    const Vec3 from = vector(3), along = vector(step);
    for (int i = 0; i < count; ++i) {
      points.set(i, round % 4 == 3 ? vector(2) : from + static_cast<double>(i) * along);
      together[i].point = points.at(i), together[i].ray_direction = normalize(vector(1));
      together[i].normal = i % 3 == 0 ? Vec3(0, 1, 0) : normalize(vector(1));
      alone[i] = together[i], surfaces[i] = &together[i];
    }
    points.fill_up(count);
  }
  Vec3 vector(double size) { return Vec3(unit_(random_), unit_(random_), unit_(random_)) * size; }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{-1, 1};

 public:
  const int count;
  PointBatch points;
  SurfacePoint together[PointBatch::kMax], alone[PointBatch::kMax], *surfaces[PointBatch::kMax];
};

void expect_the_same(const textures::CompiledPigment& pigment, int round, Journal& journal) {
  RandomPoints p(round);
  Color colors[PointBatch::kMax], color;
  bool colored[PointBatch::kMax];
  textures::evaluate(pigment, p.count, p.points, p.surfaces, colors, colored);
  for (int i = 0; i < p.count; ++i) {
    ASSERT_EQ(colored[i], textures::evaluate(pigment, p.points.at(i), &p.alone[i], color)) << round << ' ' << i;
    ASSERT_EQ(colors[i], color) << round << ' ' << i << " of " << p.count;
    journal.add(color.r), journal.add(color.g), journal.add(color.b), journal.add(color.f), journal.add(color.t);
  }
}

// Of those that need no surface.
void expect_the_same(const Function& function, int round, Journal& journal) {
  RandomPoints p(round);
  const std::size_t count = round % 3 == 0 ? 65 : static_cast<std::size_t>(p.count), stride = count + 3;
  std::vector<double> points(3 * stride), values(5 * stride);
  for (double& x : points) x = p.vector(3).x;
  function.evaluate_batch(points.data(), stride, count, values.data());
  for (std::size_t k = 0; k < count; ++k) {
    const double at[3] = {points[k], points[stride + k], points[2 * stride + k]};
    double single[5] = {};
    function.evaluate(at, single);
    for (std::size_t c = 0; c < static_cast<std::size_t>(function.components()); ++c) {
      ASSERT_TRUE(same_bits(values[c * stride + k], single[c])) << k << " of " << count;
      journal.add(single[c]);
    }
  }
}

TEST(WidePoints, HaveThePigmentsOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    for (const std::string pattern : kPatterns) {
      const bool has_list = pattern.find("Dark") != std::string::npos || pattern.starts_with("image_map");
      std::string sdl;
      for (const std::string modifiers : kModifiers) {
        const std::size_t end = modifiers.find(' ');
        const std::string map = modifiers.substr(0, end), rest = end < modifiers.size() ? modifiers.substr(end) : "";
        sdl += "sphere { 0, 1 pigment { " + pattern + ' ' + (has_list ? "" : map + "()") + rest + " } }\n";
      }
      const scene::Scene scene = scene_of_points(sdl);
      textures::Compiler compiler{textures::Settings{}};
      for (std::size_t i = 0; i < std::size(kModifiers); ++i) {
        SCOPED_TRACE(pattern + ' ' + kModifiers[i]);
        journal.begin(pattern + ' ' + kModifiers[i]);
        const scene::PigmentPtr& pigment = scene.objects.at(i)->texture->layers.at(0).pigment;
        for (int round = 0; round < 12; ++round) expect_the_same(*compiler.pigment(pigment), round, journal);
      }
    }
  });
}

TEST(WidePoints, HaveTheFunctionsOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    for (const std::string pattern : kPatterns) {
      if (pattern.find("slope") == 0 || pattern == "aoi") continue;
      SCOPED_TRACE(pattern);
      journal.begin(pattern);
      const scene::Scene scene = scene_of_points("sphere { 0, 1 pigment { " + pattern + " rotate <9,8,7> } }");
      const FunctionPtr function =
          textures::pigment_function(scene.objects.at(0)->texture->layers.at(0).pigment, textures::Settings{});
      for (int round = 0; round < 9; ++round) expect_the_same(*function, round, journal);
    }
  });
}

TEST(WidePoints, HaveTheNormalsOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    for (const std::string pattern : kNormals) {
      for (const std::string modifiers : kNormalModifiers) {
        if (pattern.find("map") != std::string::npos && modifiers.find("map") != std::string::npos) continue;
        SCOPED_TRACE(pattern + ' ' + modifiers);
        journal.begin(pattern + ' ' + modifiers);
        const scene::Scene scene =
            scene_of_points("sphere { 0, 1 pigment { Dark } normal { " + pattern + ' ' + modifiers + " } }");
        textures::Compiler compiler{textures::Settings{}};
        const textures::CompiledNormal& normal = *compiler.normal(scene.objects.at(0)->texture->layers.at(0).normal);
        for (int round = 0; round < 10; ++round) {
          RandomPoints p(round);
          Vec3 normals[PointBatch::kMax];
          textures::perturb(normal, p.count, p.points, p.surfaces, normals);
          for (int i = 0; i < p.count; ++i) {
            const Vec3 alone = textures::perturb(normal, p.points.at(i), p.alone[i]);
            ASSERT_TRUE(same_bits(normals[i], alone)) << round << ' ' << i << " of " << p.count;
            ASSERT_TRUE(same_bits(p.together[i].normal, p.alone[i].normal)) << round << ' ' << i << " of " << p.count;
            journal.add(alone);
          }
        }
      }
    }
  });
}

TEST(WidePoints, HaveTheTurbulenceOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    const textures::Octaves octaves[] = {{6, 2, 0.5}, {10, 2.17, 0.63}, {1, 3, 0.1}};
    for (int round = 0; round < 60; ++round) {
      journal.begin("round " + std::to_string(round));
      const RandomPoints p(round);
      alignas(64) double values[PointBatch::kMax];
      textures::turbulence(1 + round % 3, p.count, p.points, octaves[round / 3 % 3], values);
      for (int i = 0; i < p.count; ++i) {
        const double alone = textures::turbulence(p.points.at(i), octaves[round / 3 % 3], 1 + round % 3);
        ASSERT_EQ(values[i], alone) << round << ' ' << i;
        journal.add(alone);
      }
    }
  });
}

}  // namespace
}  // namespace verisim::test
