// Rays that are traced and shaded together get the bits of rays that go one by one.
#include <gtest/gtest.h>

#include <random>

#include "parser/parse.h"
#include "parser/source/diagnostic.h"
#include "tests/wide/each_instruction_set.h"
#include "tracer/render/prepared_scene.h"
#include "tracer/shading/explain.h"

namespace verisim::test {
namespace {

using shading::RandomSource, shading::Wavefront;

struct PictureLine {
  const char *name, *sdl;
};
// All kinds of surfaces, lights, finishes, media and cameras that rays go together for, and some that they leave alone.
constexpr PictureLine kPictureLines[] = {
    {"surfaces", "View() Lights() Balls() Layers()"},
    {"surfaces in fog", "View() #macro Dim() media_attenuation #end Lights() Balls() Layers() Fogs()"},
    // Where last bits of directions are seen.
    {"fine grain", "View() Lights() Fine() light_source { <1,7,-4>, .4 area_light 2*x, 2*z, 3, 3 circular orient }"},
    {"fine grain through a lens",
     "Lens(5, .6, 6, 9) Fine() light_source { <-4,7,-3>, 2 spotlight point_at 0 radius 5"
     " falloff 40 tightness 1 }"},
    {"glass", "View() Lights() Balls() Layers() Glass()"},
    {"weighted textures", "View() Lights() Balls() Layers() Weighted()"},
    {"cutaways",
     "View() Lights() difference { union { Ball(0) scale 1.5 } box { <-.3,0,-2>, 2 texture { Layered } }"
     " cutaway_textures } intersection { Ball(3) plane { -y, -.2 texture { Veil } } rotate 9 }"
     " mesh { triangle { <-2,1,0>, <2,1,0>, y*3 uv_vectors <0,0>, <1,0>, <0,1> } uv_mapping texture { Layered }"
     " interior_texture { Veil } }"},
    {"spot lights",
     "View() Balls() Layers() light_source { <-4,7,-3>, 2 spotlight point_at 0 radius 8 falloff 16"
     " tightness 2 } light_source { <5,6,0>, 1 cylinder point_at y radius 1 falloff 2 tightness 10 }"
     " light_source { <0,40,9>, <.3,.4,.5> parallel point_at 0 } light_source { -5*z, .4 shadowless }"
     " light_source { <-4,6,2>, <3,2,1> spotlight point_at 0 radius -90 falloff 60 fade_power 1"
     " fade_distance 3 } light_source { <4,3,2>, .5 fade_power 1.5 fade_distance 3 }"},
    {"area lights",
     "View() Balls() Layers() Glass() light_source { <-4,7,-3>, .7 area_light 2*x, 2*z, 3, 4 adaptive 1"
     " } light_source { <4,7,-3>, .7 area_light 2*x, 2*y, 3, 3 circular orient jitter }"},
    {"three lights", "View() Balls() ManyLights(3)"},
    {"many lights", "View() Balls() Layers() ManyLights(140)"},
    {"light groups",
     "View() Lights() Balls() light_group { light_source { <2,4,-3>, <1,.5,.2> } Layers()"
     " global_lights off } light_source { <0,4,1>, .6 looks_like { sphere { 0, .3 } } }"},
    {"sky and rainbow",
     "View() Lights() Balls() Floor() sky_sphere { pigment { gradient y color_map { [0 rgb .2]"
     " [1 rgb <.3,.5,.9>] } } pigment { bozo scale .2 color_map { [0 rgbt 1] [1 rgbt .5] } } }"
     " rainbow { direction z angle 30 width 20 distance 3 jitter .1 color_map { [0 rgbt <1,0,0,.5>]"
     " [1 rgbt <0,0,1,.5>] } }"},
    {"random numbers in branches",
     "global_settings { max_trace_level 2 } View() #macro In() media { Haze(.5) } #end"
     " light_source { <-4,6,-5>, .7 area_light x, y, 2, 2 jitter } Balls() Glass()"},
    {"scattering 1", "View() Lights() Balls() media { scattering { 1, .05 } intervals 3 samples 4 }"},
    {"scattering 2", "View() Lights() Balls() Container(2, 0) media { scattering { 2, <.01,.02,.03> } }"},
    {"scattering 3", "View() Spot() Balls() Floor() media { scattering { 3, .05 } method 3 aa_level 2 }"},
    {"scattering 4",
     "View() Spot() Balls() Floor() media { scattering { 4, .05 } density { Clouds } aa_threshold .01 }"},
    {"scattering 5", "View() Spot() Balls() Container(5, 0) Glass()"},
    {"refined media",
     "View() Spot() Balls() Floor() media { scattering { 1, .05 } aa_level 4 aa_threshold .002 samples 21"
     " intervals 2 }"},
    {"densities",
     "View() Lights() Balls() media { emission .05 density { Clouds } density { Clouds } intervals 2 } media"
     " { absorption .1 scattering { 2, .05 extinction .5 } density { Clouds } }"},
    {"jittered container", "View() Lights() Balls() Container(1, .5)"},
    {"tinted container",
     "View() Lights() Balls() sphere { 0, 15 hollow pigment { rgbf <.9,.5,.7,.8> } interior { media {"
     " Haze(0) } } } sphere { 0, 17 hollow pigment { rgbt 1 } interior { media { Haze(0) } } }"},
    {"media in fog", "View() #macro Dim() media_attenuation #end Lights() Balls() Layers() Fogs() media { Haze(0) }"},
    {"jittered air",
     "View() Lights() Balls() Layers() media { Haze(.5) } light_source { <0,6,-5>, .4 area_light x, y, 2,"
     " 2 jitter }"},
    {"sampled media", "View() Spot() Balls() media { Haze(0) method 2 } media { scattering { 1, .02 } method 1 }"},
    {"radiosity",
     "global_settings { radiosity { count 50 pretrace_start .2 pretrace_end .1 recursion_limit 2 } }"
     " View() Lights() Plain() sky_sphere { pigment { rgb .4 } }"},
    {"radiosity of normals",
     "global_settings { radiosity { recursion_limit 1 count 80 pretrace_start .2 pretrace_end .1 normal on media on"
     " nearest_count 7 } } View() Lights() Plain() media { Haze(0) }"},
    {"radiosity from glass",
     "global_settings { radiosity { count 90 pretrace_start .3 pretrace_end .2 } } camera { location"
     " <0,1.5,-6> direction -z } plane { z, -9 pigment { rgb .8 } normal { bumps .2 } } Lights()"
     " Balls() Layers() Glass() Fogs() light_source { <1,6,-5>, .4 area_light x, y, 3, 3 }"},
    {"photons",
     "global_settings { photons { count 4000 gather 20, 60 } } View() Lights() Plain() Floor() sphere {"
     " <0,1.2,-1.5>, .8 pigment { rgbf <.9,1,.9,.9> } interior { ior 1.5 } photons { target refraction on"
     " reflection on } finish { reflection .2 } }"},
    {"photons in media",
     "global_settings { photons { count 3000 media 60 } } View() Lights() Balls() Floor() media {"
     " Haze(0) } sphere { <0,1.2,-1.5>, .8 pigment { rgbf .9 } interior { ior 1.5 } photons { target"
     " refraction on } }"},
    {"subsurface",
     "global_settings { mm_per_unit 30 subsurface { samples 5, 5 } } View() Lights() Plain() sphere {"
     " <0,1,-1>, .6 pigment { rgb <.8,.7,.6> } finish { subsurface { translucency <.3,.2,.1> } }"
     " interior { ior 1.3 } }"},
    {"orthographic", "camera { orthographic location <0,1.5,-6> right 6*x up 4*y } Lights() Balls() Layers()"},
    {"fisheye", "camera { fisheye angle 80 location <0,1.5,-6> } Lights() Balls() Layers()"},
    {"panoramic", "camera { panoramic angle 80 location <0,1.5,-6> } Lights() Balls() Layers()"},
    {"ultra wide angle", "camera { ultra_wide_angle angle 80 location <0,1.5,-6> } Lights() Balls() Glass()"},
    {"cylinder camera", "camera { cylinder 3 angle 80 location <0,1.5,-6> } Lights() Balls()"},
    {"bumpy camera", "camera { location <0,1.5,-6> normal { bumps .1 scale .3 } } Lights() Balls()"},
    {"mesh camera", "MeshCamera(1) Lights() Balls() Layers()"},
    {"mesh camera of two", "MeshCamera(2) Lights() Balls() Layers()"},
    {"small lens", "Lens(5, .6, 6, 9) Lights() Balls() Layers()"},
    {"large lens", "Lens(5, 8, 2, 5) Lights() Balls() Layers()"},
    {"fine lens", "Lens(40, .6, 40, 19) Lights() Balls() Floor()"},
};

constexpr const char* kPicturesPrelude = R"(#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 }
#macro View() camera { location <0,1.5,-6> } #end
#macro Lens(Focus, A, F, N)
  camera { location <0,1.5,-6> aperture A focal_point <0,1,F-6> blur_samples N variance 1e-3 } #end
#macro MeshCamera(N)
  camera { mesh_camera { N 0 #for (M, 0, N-1) mesh {
    #for (Y, 0, 35-M) #for (X, 0, 47) #local P = <5*X/48-2.5, 2-2.5*Y/36, -6-M>;
      triangle { P, P+.01*y, P+<.01,0,.00002*X> } #end #end } #end } }
#end
#macro Dim() #end #macro In() #end
#macro Lights() light_source { <-4,6,-5>, <.7,.6,.5> } light_source { <4,6,-5>, <.7,.6,.5> fade_power 2 fade_distance 9
  Dim() } #end
#macro Spot() light_source { <-4,7,-3>, <3,2,1> fade_power 2 fade_distance 5 } light_source { <-5,6,0>, 2 spotlight
  point_at <0,0,1> radius 8 falloff 16 tightness 2 } light_source { <0,40,9>, <.3,.4,.5> } #end
#macro ManyLights(N) #declare S = seed(9); #for (I, 1, N) light_source { <8*rand(S)-4,5+rand(S),8*rand(S)-4>,
  <.3,.2,.1+.05*I>/N*3 #if (mod(I,4)=1) fade_power 2 fade_distance 6 #end #if (mod(I,5)=2) spotlight radius 20
  falloff 40 point_at 0 #end #if (mod(I,5)=3) shadowless #end } #end #end
#macro Shine(I) #switch (I)
  #case (1) phong .8 phong_size 10 #break #case (2) reflection { 1 fresnel } conserve_energy brilliance 3 #break
  #case (4) specular .5 phong .5 #break #case (5) irid { .4 thickness .3 turbulence .7 } specular .5 #break
  #case (6) reflection .4 #break #case (7) diffuse .6, .5 phong .8 phong_size 70 #break #case (8) specular .7 metallic
  #break #case (9) brilliance 3 #break #case (10) reflection { <.1,.3,.2>, .6 exponent 1.5 } irid { .4 thickness .3 }
  #break #case (11) crand .2 specular .5 roughness .002 metallic #break #end #end
#macro Ball(I) sphere { <mod(I,4)*1.2-1.8,.4+div(I,4),.3*mod(I,3)>, .55 pigment { rgbt
  <.2+.06*I,.5,.4,select(I-8,0,.5,0)> }
  finish { Shine(I) } interior { ior 1.2 In() } hollow } #end
#macro Balls() #for (I, 0, 11) Ball(I) #end Floor() #end
#macro Plain() #for (I, 0, 11) #if (mod(I,4)) sphere { <mod(I,4)*1.2-1.8,.4+div(I,4),.3*mod(I,3)>, .55
  pigment { granite color_map { [0 rgb <.9,.4,.2>] [1 rgb I/12] } } normal { bumps .3 scale .2 } finish { diffuse .7
  phong .2 } } #end #end plane { y, -.5 pigment { checker rgb .8, rgb <.3,.5,.2> } } #end
#macro Fine() #declare Grain = pigment { granite scale 1e-12 color_map { [0 rgbf 1] [1 rgbf <.2,.5,1,.9>] } }
  plane { y, 4 hollow pigment { Grain } } sphere { y, 1 double_illuminate pigment { Grain } } plane { y, -.5 pigment {
  granite scale 1e-12 } } #end
#macro Floor() plane { y, -.5 pigment { rgb <.6,.6,.5> } finish { reflection .3 } } #end
#declare Clouds = density { bozo scale 2 color_map { [0 rgb 0] [.5 rgb 0] [1 rgb <1.9,1.7,2.3>] } }
#declare Opaque = texture { pigment { granite scale .3 color_map { [.2 rgb <.9,.3,.2>] [.7 rgb <.2,.4,.8>] } }
  finish { phong .6 } }
#declare Layered = texture { pigment { wrinkles scale .3 color_map { [.2 rgb <.9,.3,.2>] [.7 rgb <.2,.4,.8>] } } }
  texture { pigment { marble scale .3 color_map { [.2 rgb <.9,.3,.2>] [.7 rgbt <.2,.4,.8,.8>] } } normal { bumps } }
  texture { pigment { bozo scale .3 color_map { [.2 rgbft <.9,.3,.2,.1,.9>] [.7 rgb <.2,.4,.8>] } } normal { bumps } }
#declare Veil = texture { pigment { bozo scale .3 color_map { [.2 rgbft <.9,.3,.2,.06,.6>] [.7 rgbt <.2,.4,.8,.3>] } }
  finish { phong .6 } }
#macro Layers() #for (I, 0, 4) sphere { <I*.9-1.8,2.2,.4>, .5 texture { #switch (I) #case (0) Layered #break
  #case (1) checker texture { Opaque } texture { Layered } scale .2 #break #case (2) average texture_map { [1 Opaque]
  [2 Layered] } #break #case (3) bozo texture_map { [0 Opaque] [1 Layered] } scale .2 #break #case (4) bozo texture_map
  { [0 Opaque] [1 Veil] } scale .2 #end } #if (mod(I,2)) double_illuminate #end } #end #end
#macro Weighted() blob { threshold .4 #for (I, 0, 8) sphere { <.4*I-1.6,1.4,-1.5>, .7, 1 texture { #if (mod(I,3)) Opaque
  translate I #else #if (I=3) Layered #else pigment { rgb I/9 } finish { Shine(I) } #end #end } } #end }
  mesh { #for (I, 0, 15) #local X = .25*I-2.2; triangle { <X,.1,-2>, <X+.3,.1,-2>, <X,.7,-2>
  #if (mod(I,3)) texture_list { T1 T2 T3 } #else texture { T1 } #end } #end } #end
#declare T1 = texture { Opaque } #declare T2 = texture { pigment { rgb .8 } finish { reflection .3 phong 1 } }
#declare T3 = texture { pigment { rgbt .5 } finish { specular .5 } }
#macro Glass() union { sphere { <-1,1,-2.5>, .7 pigment { rgbft <.9,1,.9,.8,.1> } finish { reflection .1 } interior {
  ior 1.5 fade_distance .5 fade_power 2 fade_color <.2,.8,.3> In() } hollow }
  sphere { <-1,1,-2.5>, .4 pigment { rgbt <1,1,1,.9> } finish { reflection .3 conserve_energy } interior { ior 1.1 } }
  box { <.2,.2,-3>, <1.1,1.3,-2> pigment { rgbf <1,.9,.9,.9> } finish { reflection .3 conserve_energy } interior {
  ior 2.4 In() } hollow } sphere { <.3,2,-2.5>, .4 pigment { rgbf .9 } interior { ior 1.4 dispersion 1.05 } }
  box { <-2,-.4,-3.2>, <2,.4,-3.1> pigment { rgbft <.6,.8,1,.5,.4> } } } #end
#macro Fogs() fog { distance 12 color rgbft <.4,.5,.6,.1,.2> } fog { fog_type 2 distance 12 fog_alt 1 turbulence .4
  color rgbft <.4,.5,.6,.1,.2> } #end
#macro Haze(J) emission <.01,.02,.03> absorption .05 scattering { 1, .03 } jitter J #end
#macro Container(T, J) sphere { 0, 15 hollow pigment { rgbt 1 } interior { media { Haze(J) } media { scattering { T, .02
  #if (T=5) eccentricity .4 #end } intervals 3 samples 4 jitter J } } } #end
)";

constexpr int kPictureWidth = 48, kPictureHeight = 36;

// One way to trace a scene's rays; each has a cache of radiosity of its own.
struct TracedWay {
  explicit TracedWay(const scene::Scene& scene, shading::Observer* observer)
      : prepared(scene, options_of()),
        camera(prepared.camera(options_of())),
        tracer(prepared.data(), RandomSource(false, 0)),
        sampler((prepared.run_prepasses(camera, options_of(), 1), camera), tracer) {
    tracer.coherent().set_camera(camera.coherence);
    tracer.set_observer(observer);
    render::begin_block(prepared.effects(), tracer, options_of(), 0);
  }
  static const render::Options& options_of() {
    static const render::Options options = [] {
      render::Options o;
      o.width = kPictureWidth, o.height = kPictureHeight, o.threads = 1;
      return o;
    }();
    return options;
  }
  render::PreparedScene prepared;
  render::CameraModel camera;
  shading::Tracer tracer;
  render::PixelSampler sampler;
};

void expect_the_same_rays(const render::Statistics& a, const render::Statistics& b) {
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.camera_rays, b.camera_rays);
  EXPECT_EQ(a.shadow_rays, b.shadow_rays);
  EXPECT_EQ(a.reflected_rays, b.reflected_rays);
  EXPECT_EQ(a.refracted_rays, b.refracted_rays);
  EXPECT_EQ(a.transmitted_rays, b.transmitted_rays);
}

// Rows of pixels and places anywhere; `watched` does everything one by one, `alone` what hangs on one camera ray.
void expect_the_same(const scene::Scene& scene, Journal& journal) {
  shading::Observer watching;
  TracedWay together(scene, nullptr), alone(scene, nullptr), watched(scene, &watching);
  const auto compare = [&](const Vec2& place, const Color& color) {
    const Color each = watched.sampler(place.x, place.y);
    ASSERT_TRUE(color == each) << place;
    ASSERT_TRUE(alone.sampler(place.x, place.y) == each) << place << " alone";
    journal.add(each.r), journal.add(each.g), journal.add(each.b), journal.add(each.t);
  };
  std::vector<Color> colors(3 * Wavefront::kMax);
  for (int y = 0; y < kPictureHeight; ++y) {
    together.sampler.row(0, y, kPictureWidth, colors.data());
    for (int x = 0; x < kPictureWidth; ++x)
      ASSERT_NO_FATAL_FAILURE(compare(Vec2(x, y), colors[static_cast<std::size_t>(x)]));
  }
  std::mt19937 random{5};
  std::uniform_real_distribution<double> beside(-1.4, 1.4), across(0, kPictureWidth - 1), down(0, kPictureHeight - 1);
  for (int count = 1; count < 3 * Wavefront::kMax; count += 17) {
    const Vec2 near(across(random), down(random));
    std::vector<Vec2> places;
    for (int i = 0; i < count; ++i)
      places.push_back(count % 3 == 0 ? Vec2(across(random), down(random))
                                      : near + Vec2(beside(random), beside(random)));
    together.sampler.points(places.data(), count, colors.data());
    for (std::size_t i = 0; i < places.size(); ++i) ASSERT_NO_FATAL_FAILURE(compare(places[i], colors[i]));
  }
  expect_the_same_rays(together.tracer.statistics(), watched.tracer.statistics());
  expect_the_same_rays(alone.tracer.statistics(), watched.tracer.statistics());
  // They do go together.
  EXPECT_GT(together.tracer.statistics().wavefront_rays, together.tracer.statistics().camera_rays * 3 / 4);
  EXPECT_EQ(watched.tracer.statistics().wavefront_rays, 0u);
}

TEST(WidePictures, AreThoseOfRaysThatGoOneByOne) {
  with_each_instruction_set([](Journal& journal) {
    for (const PictureLine& line : kPictureLines) {
      SCOPED_TRACE(line.name);
      journal.begin(line.name);
      parser::ParseOptions options;
      options.width = kPictureWidth, options.height = kPictureHeight;
      const parser::ParseResult result =
          parser::parse_text(std::string(kPicturesPrelude) + line.sdl, "line.pov", options);
      EXPECT_TRUE(result.errors.empty()) << parser::format(result.errors.front());
      if (result.scene) expect_the_same(*result.scene, journal);
    }
  });
}

}  // namespace
}  // namespace verisim::test
