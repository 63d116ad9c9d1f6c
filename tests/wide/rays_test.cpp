// Eight rays at once find what each finds alone, to the last bit, whatever their numbers are.
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <memory>
#include <random>

#include "parser/parse.h"
#include "parser/source/diagnostic.h"
#include "tests/wide/each_instruction_set.h"
#include "tracer/bvh/shaft.h"
#include "tracer/world/world.h"

namespace verisim::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPacketRays = RayPacket::kCount;

// A solid or a sheet about as large as the unit ball; M: the modifiers of a variant.
struct ObjectLine {
  const char *name, *sdl;
};
constexpr ObjectLine kObjectLines[] = {
    {"sphere", "sphere { <.1,-.2,.3>, .9 M() }"},
    {"inside-out sphere", "sphere { 0, -.5 M() }"},
    {"box", "box { <-1,-.7,-.5>, <.8,.9,1> M() }"},
    {"flat box", "box { <-1,0,-1>, <1,0,1> M() }"},
    {"cylinder", "cylinder { -y, .8*y, .6 M() }"},
    {"tube", "cylinder { -y, .8*y, .6 open M() }"},
    {"cone", "cone { -y, 1, y, .4 M() }"},
    {"open cone", "cone { -y, 1, y, .4 open M() }"},
    {"double cone", "cone { <-.5,.3,0>, -.4, <1,0,.2>, .8 M() }"},
    {"plane", "plane { <1,2,-.5>, .3 M() }"},
    {"disc", "disc { <.1,.2,0>, <1,2,-.5>, 1, .3 M() }"},
    {"quadric", "quadric { <1,.5,1.5>, <.2,-.1,.3>, <.1,-.2,0>, -1 M() }"},
    {"paraboloid", "quadric { <1,-1,0>, 0, z, 0 M() }"},
    {"triangle", "triangle { <-1.3,-.8,.4>, <1.2,-.9,-.3>, <.2,1.4,.1> M() }"},
    {"smooth triangle", "smooth_triangle { <.3,-1.2,-1>, x, <.2,1.3,-.8>, <1,.2,0>, <-.3,.2,1.5>, <1,.1,-.3> M() }"},
    {"polygon", "polygon { 6, <-1,-1>, <1,-1>, <1,1>, <.2,0>, <-1,1>, <-1,-1> rotate 20*x M() }"},
    {"bicubic patch",
     "bicubic_patch { type 1 flatness .01 u_steps 3 v_steps 3 <-1,0,-1>, <-.3,1,-1>, <.3,-1,-1>, <1,0,-1>, <-1,.5,-.3>,"
     " <-.3,1,-.3>, <.3,0,-.3>, <1,.5,-.3>, <-1,-.5,.3>, <-.3,0,.3>, <.3,1,.3>, <1,0,.3>, <-1,0,1>, <-.3,-1,1>,"
     " <.3,.7,1>, <1,0,1> M() }"},
    {"torus", "torus { .9, .35 M() }"},
    {"spindle torus", "torus { .3, .6 M() }"},
    {"ovus", "ovus { .6, .3 translate -.3*y M() }"},
    {"superellipsoid .4 .8", "superellipsoid { <.4,.8> M() }"},
    {"superellipsoid 1 1", "superellipsoid { 1 M() }"},
    {"superellipsoid 2 .15", "superellipsoid { <2,.15> M() }"},
    {"superellipsoid 1.3 2", "superellipsoid { <1.3,2> M() }"},
    {"superellipsoid 2.5 1", "superellipsoid { <2.5,1> M() }"},
    {"polynomial 2", "polynomial { 2, xyz(2,0,0): 1, xyz(0,2,0): 2, xyz(0,0,1): 1, xyz(0,0,0): -.5 M() }"},
    {"polynomial 3",
     "polynomial { 3, xyz(3,0,0): 1, xyz(0,3,0): 1, xyz(0,0,2): 1, xyz(0,1,1): .5, xyz(0,0,0): -.3 M() }"},
    {"polynomial 4",
     "polynomial { 4, xyz(4,0,0): 1, xyz(0,4,0): 1, xyz(0,0,4): 1, xyz(2,0,0): -1, xyz(0,2,0): -1,"
     " xyz(0,0,2): -1, xyz(0,0,0): .4 M() }"},
    {"polynomial 5", "polynomial { 5, xyz(5,0,0): 1, xyz(0,4,0): 1, xyz(0,0,2): 1, xyz(0,0,0): -.2 sturm M() }"},
    {"polynomial 6",
     "polynomial { 6, xyz(6,0,0): 1, xyz(1,2,3): -.7, xyz(0,4,1): 2, xyz(0,0,5): .3, xyz(2,1,0): 1,"
     " xyz(0,0,0): -1 M() }"},
    {"polynomial 14", "polynomial { 14, xyz(14,0,0): 1, xyz(0,4,0): 1, xyz(0,0,2): 1, xyz(0,0,0): -.5 M() }"},
    {"blob",
     "blob { threshold .5 sphere { -.4*x, .9, 1 } sphere { <.5,.2,0>, .8, 1 } sphere { .4*y, .4, -1.5 }"
     " cylinder { <-.5,-.6,.2>, <.6,.5,0>, .5, 1 } M() }"},
    {"blob of moved parts",
     "blob { threshold .3 cylinder { 0, .6*y, .7, 1 scale <.7,1.3,1> rotate <30,10,50> }"
     " sphere { .3*x, .8, .6 scale <.7,1.3,1> rotate <30,10,50> } M() }"},
    {"cloud",
     "#declare S = seed(4); blob { threshold .5 #for (I, 1, 120) sphere { 1.6*(<rand(S),rand(S),rand(S)>-.5),"
     " .3, #if (mod(I,7)) 1 #else -.5 #end } #end M() }"},
    {"crowd",
     "#declare S = seed(5); blob { threshold 100 #for (I, 1, 220)"
     " sphere { 1.6*(<rand(S),rand(S),rand(S)>-.5), 2.5, 1 } #end scale .4 M() }"},
    {"sor", "sor { 6, <.2,-1.2>, <.4,-.8>, <.8,-.2>, <.3,.3>, <.5,.8>, <.6,1> M() }"},
    {"open sor", "sor { 6, <.2,-1.2>, <.4,-.8>, <.8,-.2>, <.3,.3>, <.5,.8>, <.6,1> open M() }"},
    {"linear lathe", "lathe { linear_spline 4, <0,-1>, <.8,-.5>, <.3,.4>, <.9,1> M() }"},
    {"quadratic lathe", "lathe { quadratic_spline 5, <0,-1.2>, <.5,-1>, <.9,0>, <.4,.5>, <0,.9> M() }"},
    {"cubic lathe", "lathe { cubic_spline 6, <.3,-1>, <.7,-.8>, <.4,-.2>, <.9,.5>, <0,.9>, <-.4,1> M() }"},
    {"Bezier lathe",
     "lathe { bezier_spline 8, <.4,-1>, <1.2,-.6>, <.1,-.2>, <.3,.3>, <.3,.3>, <.5,.5>, <.2,.7>,"
     " <.7,.9> M() }"},
    {"long lathe", "lathe { linear_spline 40 #for (I, 0, 39) , <.5+.3*sin(I),-1+I/20> #end M() }"},
    {"prism",
     "prism { linear_sweep linear_spline -.9, .8, 7, <1.3,.1>, <.2,.3>, <-1,1.1>, <-.4,-.2>, <-.9,-1.2>,"
     " <.3,-.4>, <1.3,.1> M() }"},
    {"conic prism",
     "prism { conic_sweep cubic_spline -1, 1, 8, <.5,-1>, <1,0>, <0,1>, <-1,0>, <0,-1>, <1,0>, <0,1>,"
     " <-1,0> M() }"},
    {"linear sweep", "sphere_sweep { linear_spline 3, <-1,0,0>, .3, <.3,.8,.2>, .2, <.8,-.3,.2>, .5 M() }"},
    {"b-spline sweep", "sphere_sweep { b_spline 4, <-1,0,0>, .6, <-.3,.8,.2>, .8, <.6,-.7,.2>, .9, <1,.8,0>, .4 M() }"},
    {"cubic sweep",
     "sphere_sweep { cubic_spline 6, <-1,-1,0>, .2, <-.7,.4,.1>, .3, <0,-.3,.4>, .4, <.5,.6,-.3>, .2,"
     " <.9,-.2,0>, .3, <1,-1,.5>, .2 M() }"},
    {"mesh", "mesh { Folded(24) M() }"},
    {"solid mesh", "mesh { Folded(9) inside_vector y M() }"},
    {"mesh without a tree", "mesh { Folded(7) hierarchy off M() }"},
    {"text", "text { ttf \"timrom.ttf\" \"Rg\" .4, 0 scale 1.6 translate <-.8,-.5,-.3> M() }"},
    {"hills", "height_field { function 300, 200 { .5+.3*sin(30*x)*cos(20*y) } translate -.5 scale 1.7 M() }"},
    {"terraces",
     "height_field { function 37, 21 { floor(4*f_noise(x*9,y*9,0))/4 } water_level .3 translate -.5"
     " scale 1.7 M() }"},
    {"rough", "height_field { function 23, 31 { f_noise(x*40,y*40,0) } smooth translate -.5 scale 1.7 M() }"},
    {"isosurface",
     "isosurface { function { x*x+y*y+z*z-.8+.2*sin(6*x)*sin(6*y)*sin(6*z) } max_gradient 5 accuracy"
     " .002 contained_by { box { -1.2, 1.2 } } M() }"},
    {"isosurface of several",
     "isosurface { function { x*x+y*y+z*z-.8+.9*sin(6*x)*sin(6*y)*sin(6*z) } threshold .1"
     " max_gradient 1.1 accuracy .05 all_intersections contained_by { sphere { 0, .9 } } M() }"},
    {"open isosurface",
     "isosurface { function { x*x+y*y+tanh(z)-.5 } open max_gradient 3 max_trace 3"
     " contained_by { box { -1, 1 } } M() }"},
    {"isosurface of noise",
     "isosurface { function { x*x+y*y+z*z-.8+f_noise(x*5,y*5,z*5)*.3 } max_gradient 6"
     " contained_by { box { -1, 1 } } M() }"},
    {"fine isosurface", "isosurface { function { x*x+y*y+z*z-.8 } accuracy 1e-300 max_gradient 5 M() }"},
    {"julia", "julia_fractal { <-.162,.163,-.56,.1> max_iteration 7 precision 20 slice <.1,.2,-.1,.97>, .05 M() }"},
    {"julia of cubes", "julia_fractal { <-.2,.3,-.5,.1> quaternion cube max_iteration 6 precision 30 M() }"},
    {"hypercomplex julia", "julia_fractal { <-.162,.163,-.56,.1> hypercomplex max_iteration 7 precision 20 M() }"},
    {"hypercomplex julia of cubes",
     "julia_fractal { <-.2,.3,-.5,.1> hypercomplex cube max_iteration 6 precision 30 M()"
     " }"},
    {"union", "union { object { Ball } object { Ring } object { Tube } plane { <.2,1,0>, -.9 } M() }"},
    {"union of many", "union { #for (I, 0, 39) sphere { <.1*I-2,.5*sin(I),.5*cos(2*I)>, .2 } #end M() }"},
    {"union of twenty",
     "union { julia_fractal { <-.2,.3,-.5,.1> max_iteration 4 } #for (I, 0, 18) sphere {"
     " <.15*I-1.4,.5*sin(I),.5*cos(2*I)>, .2 } #end M() }"},
    {"union in the same place",
     "union { object { Ball } object { Ball } union { object { Ball } object { Ring } } M() }"},
    {"solids in the same place",
     "intersection { union { object { Block } object { Block } object { Ring } object { Ring }"
     " } plane { <.2,1,0>, .5 } M() }"},
    {"merge", "merge { object { Ball } object { Ring } object { Body } M() }"},
    {"merged blobs", "merge { object { Two } object { Two scale .9 rotate 40*y } object { Ring } M() }"},
    {"intersection", "intersection { object { Ball } plane { <1,1,.3>, .4 } plane { -y, .7 } M() }"},
    {"waist", "intersection { plane { y, .6 } quadric { <1,-1,1>, 0, 0, -.2 } plane { -y, .7 } M() }"},
    {"infinite intersection", "intersection { plane { y, .6 } plane { <1,1,.3>, .4 } M() }"},
    {"six planes",
     "intersection { plane { y, .6 } plane { -y, .7 } plane { x, .5 } plane { -x, .5 } plane { z, .5 }"
     " plane { -z, .3 } M() }"},
    {"twenty planes", "intersection { #for (I, 0, 19) plane { <sin(I),cos(2*I),sin(3*I)+.2>, .8 } #end M() }"},
    // More than a tree takes.
    {"fifty planes", "intersection { #for (I, 0, 49) plane { <sin(I),cos(2*I),sin(3*I)+.2>, .8 } #end M() }"},
    {"many cuts",
     "difference { object { Body } plane { <1,.3,0>, -.5 } #for (I, 0, 45) sphere { <sin(I),cos(2*I),"
     "sin(3*I)>, .3 } #end M() }"},
    {"difference", "difference { object { Block } object { Tube } object { Ball } M() }"},
    {"difference of a convex",
     "difference { object { Body } object { Ring } difference { object { Tube } object {"
     " Block } } object { Ball } M() }"},
    {"hollow blob", "difference { object { Two } object { Two scale .8 } M() }"},
    {"difference of prisms",
     "difference { prism { -.9, .8, 7, <1.2,0>, <.6,1>, <-.6,1>, <-1.2,0>, <-.6,-1>, <.6,-1>,"
     " <1.2,0> } object { Tube } M() }"},
    {"clipped parts",
     "merge { object { Ball clipped_by { plane { <.2,1,0>, .3 } } } object { Block clipped_by { Tube } }"
     " object { Tube clipped_by { object { Block } } inverse } M() }"},
};

constexpr const char* kRaysPrelude = R"(#version 3.7; global_settings { assumed_gamma 1 }
#declare f_noise = function { internal(76) }
#declare Block = box { <-1.2,-.9,-1>, <1.2,.9,1> }
#declare Tube = cylinder { -2*x, 2*x, .7 rotate <0,10,5> }
#declare Ball = sphere { <.3,.2,.1>, .9 }
#declare Ring = torus { .9, .2 }
#declare Body = superellipsoid { <.1,.3> scale <1.2,.8,1> rotate <5,20,0> }
#declare Two = blob { threshold .2 sphere { -.5*x, 1.2, 1 } sphere { <.6,.1,0>, 1.1, 1 } }
#macro P(I, K, N) <2.4*I/N-1.2, .5*sin(12*I/N-6)+.2*cos(17*K/N-8), 2.4*K/N-1.2> #end
#macro Folded(N) #for (I, 0, N-1) #for (K, 0, N-1) triangle { P(I,K,N), P(I,K+1,N), P(I+1,K,N) }
  triangle { P(I,K+1,N), P(I+1,K+1,N), P(I+1,K,N) } #if (I=K) triangle { P(I,K,N), P(I,K+1,N), P(I+1,K,N) } #end
  #end #end #end
#macro Leaf(S)
  #switch (int(7*rand(S)))
    #case (0) sphere { rand(S)-.5, .3+.8*rand(S) #break
    #case (1) box { -.1-rand(S)*<1,.5,.8>, .1+rand(S)*<1,.8,.5> #break
    #case (2) box { <-1,-1,-.5>, <1,.5,1> #break
    #case (3) plane { <rand(S)-.5,rand(S)-.5,.7>, rand(S)-.3 #break
    #case (4) cone { -.8*y, .9*rand(S), .9*y, .5 #if (rand(S)<.3) open #end #break
    #case (5) torus { .8, .3 #break
    #else object { Two
  #end
  #if (rand(S)<.5) rotate 90*<rand(S),rand(S),rand(S)> translate .6*(<rand(S),rand(S),rand(S)>-.5) #end
  #if (rand(S)<.15) clipped_by { sphere { .2, 1.2 } } #end #if (rand(S)<.15) inverse #end }
#end
#macro Tree(S, Depth)
  #if (Depth = 0 | rand(S) < .15) Leaf(S)
  #else
    #switch (int(4*rand(S)))
      #case (0) union { #break #case (1) merge { #break #case (2) intersection { #break #else difference {
    #end
    #for (I, 0, 1+int(3*rand(S))) Tree(S, Depth-1) #end
    #if (rand(S)<.4) scale <1.3,.9,.8> rotate 90*<rand(S),0,rand(S)> #end #if (rand(S)<.15) inverse #end }
  #end
#end
)";
struct Variant {
  const char *name, *modifiers;
};
constexpr Variant kVariants[] = {{"", ""},
                                 {" moved", "scale <.7,-1.2,.9> rotate <20,70,-40> translate <.2,.1,-.3>"},
                                 {" clipped", "clipped_by { plane { <.1,1,0>, .2 } } bounded_by { sphere { 0, 1.1 } }"},
                                 {" inverse", "rotate 90*y inverse"}};

scene::Scene scene_of(const std::string& sdl) {
  parser::ParseResult result = parser::parse_text(kRaysPrelude + sdl, "line.pov", {});
  if (!result.errors.empty() || !result.scene) throw std::runtime_error(parser::format(result.errors.front()));
  scene::complete(*result.scene);
  return std::move(*result.scene);
}

// Rays that go the same way or anywhere, from outside or within, along axes and the lines of grids; every third round
// some of their numbers are strange.
class RandomRays {
 public:
  void fill(int round, int first) {
    const Vec3 eye = vector(round % 2 ? 3.0 : 0.5), aim = vector(0.6), step = vector(round % 4 == 1 ? 0.1 : 0.01);
    for (int k = 0; k < kPacketRays; ++k) {
      const int i = first + k;
      Vec3 from = vector(round % 2 ? 3.0 : 0.5), to = vector(0.6);
      if (round % 5 == 1) from = eye, to = aim + step * double(k);
      if (round % 5 == 2) from = eye + step * double(k), to = aim + step * double(k);
      if (round % 10 == 3) from = to = vector(0.6), from[round % 3] = 3, to[round % 3] = 0;
      if (round % 10 == 8) from = Vec3(k, round % 17, 9) / 8.5 - Vec3(0.5), to = from - Vec3(round % 4 / 17.0, 1, 0);
      rays->origin.set(i, from), rays->direction.set(i, normalize(to - from));
      if (round % 3 == 0) spoil(i);
      limit[k] = round % 6 == 0 ? 2 + std::fabs(normal_(random)) : kInfinity;
    }
    active = round % 4 == 0 ? static_cast<unsigned>(random() & 255) : 255;
  }
  Vec3 vector(double size) { return Vec3(normal_(random), normal_(random), normal_(random)) * size; }

  std::mt19937 random{21};
  std::unique_ptr<RayBatch> rays = std::make_unique<RayBatch>();
  alignas(64) double limit[kPacketRays];
  unsigned active = 255;

 private:
  void spoil(int i) {
    static const double kStrange[] = {
        0.0, -0.0, 5e-324, -1e-310, 1e-11,     -1e-9,      1,
        -1,  1e8,  1e200,  -1e300,  kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
    double* const numbers[] = {rays->origin.x,    rays->origin.y,    rays->origin.z,
                               rays->direction.x, rays->direction.y, rays->direction.z};
    for (auto n = random() % 2; n < 2; ++n) numbers[random() % 6][i] = kStrange[random() % std::size(kStrange)];
    // Directions are of unit length, or nothing that has one.
    const Vec3 strange = rays->direction.at(i), unit = normalize(strange);
    if (length(strange) < kInfinity && length(unit) > 0.5) rays->direction.set(i, unit);
  }
  std::normal_distribution<double> normal_;
};

// What a hit shows; Hit::u and v are the shape's own affair.
bool same_hit(const shapes::Hit& a, const shapes::Hit& b) {
  if (!same_bits(a.t, b.t) || !same_bits(a.point, b.point) || a.shape != b.shape || a.part != b.part) return false;
  const Vec2 uv_a = a.shape->uv(a), uv_b = b.shape->uv(b);
  return same_bits(a.shape->normal(a), b.shape->normal(b)) && same_bits(uv_a.x, uv_b.x) && same_bits(uv_a.y, uv_b.y);
}
void note(Journal& journal, const shapes::Hit& hit) {
  journal.add(hit.t), journal.add(hit.point), journal.add(hit.part), journal.add(hit.shape->normal(hit));
}
using Numbers = std::map<const shapes::Shape*, std::size_t>;
void number(const shapes::Shape& shape, Numbers& numbers) {
  numbers.emplace(&shape, numbers.size());
  for (const auto& child : shape.children()) number(*child, numbers);
}

// Adds to `met` the rays that meet the shape.
void expect_the_same(const shapes::Shape& shape, int rounds, int& met, Journal& journal) {
  using shapes::Hit, shapes::RayKind;
  RandomRays random;
  Numbers numbers;
  number(shape, numbers);
  shapes::HitList all;
  for (int round = 0; round < rounds; ++round) {
    const int first = round % 9;
    random.fill(round, first);
    const RayPacket packet{*random.rays, first, random.active};
    const double t_min = round % 7 == 0 ? 1.5 : round % 7 == 1 ? 0 : 1e-4;
    Hit hits[kPacketRays], alone;
    const unsigned found = shape.intersect_packet(packet, nullptr, RayKind::camera, t_min, random.limit, hits),
                   blocked = shape.occludes_packet(packet, nullptr, t_min, random.limit);
    ASSERT_EQ(found & ~packet.active, 0u);
    for (int k = 0; k < kPacketRays; ++k) {
      if (!(packet.active >> k & 1)) continue;
      const Ray ray = packet.at(k);
      const bool hit = shape.intersect(ray, RayKind::camera, t_min, random.limit[k], alone);
      ASSERT_EQ(found >> k & 1, hit) << round << ' ' << k;
      ASSERT_EQ(blocked >> k & 1, shape.occludes(ray, t_min, random.limit[k])) << round << ' ' << k;
      if (!hit) continue;
      ASSERT_TRUE(same_hit(hits[k], alone)) << round << ' ' << k << ": " << hits[k].t << " is not " << alone.t;
      note(journal, alone), journal.add(numbers[alone.shape]);
      ++met;
    }
    all.clear();
    shape.intersect_all(packet.at(0), RayKind::camera, all);
    for (const Hit& hit : all) note(journal, hit);
    journal.add(shape.inside(packet.rays.origin.at(first)));
  }
}

TEST(WideRays, MeetEachShapeAsTheyMeetItAlone) {
  with_each_instruction_set([](Journal& journal) {
    for (const ObjectLine& line : kObjectLines) {
      for (const Variant& variant : kVariants) {
        SCOPED_TRACE(std::string(line.name) + variant.name);
        journal.begin(std::string(line.name) + variant.name);
        const scene::Scene scene = scene_of(std::string("#macro M() ") + variant.modifiers + " #end " + line.sdl);
        int met = 0;
        expect_the_same(*shapes::compile(*scene.objects.at(0)), 600, met, journal);
        EXPECT_GT(met, 60);
      }
    }
  });
}

TEST(WideRays, MeetRandomTreesOfSolidsAsTheyMeetThemAlone) {
  with_each_instruction_set([](Journal& journal) {
    int met = 0;
    for (int seed = 0; seed < 150; ++seed) {
      SCOPED_TRACE(seed);
      journal.begin("tree " + std::to_string(seed));
      const scene::Scene scene =
          scene_of("#declare R = seed(" + std::to_string(seed) + "); Tree(R, " + std::to_string(1 + seed % 3) + ")");
      expect_the_same(*shapes::compile(*scene.objects.at(0)), 150, met, journal);
    }
    EXPECT_GT(met, 20000);
  });
}

// Batches of rays through one tile of a camera's picture, in a world of all objects, of few, and below skies that let
// light through.
std::string crowd_of(std::size_t from, std::size_t count, int balls, bool skies) {
  std::string sdl = "#macro M() #end #declare S = seed(3); #macro V() 6*(<rand(S),rand(S),rand(S)>-.5) #end\n";
  for (std::size_t i = from; i < from + count; ++i)
    sdl += std::string("union { ") + kObjectLines[i].sdl +
           " rotate 99*V() scale .6 translate V() pigment { rgbt <1,1,1," + (i % 6 == 0 ? ".5" : "0") + "> } }\n";
  sdl += "#for (I, 1, " + std::to_string(balls) +
         ") sphere { V(), .3 pigment { rgbt <1,1,1,select(mod(I,20),0,.5,0)> } } #end\n";
  if (skies) sdl += "sphere { 0, 99 hollow pigment { rgbt .5 } } plane { y, -70 hollow pigment { rgbt .9 } }";
  return sdl;
}

TEST(WideRays, MeetAWorldAsTheyMeetItAlone) {
  constexpr std::size_t kAll = std::size(kObjectLines);
  with_each_instruction_set([](Journal& journal) {
    for (const std::string& sdl : {crowd_of(0, kAll, 0, false), crowd_of(20, 2, 0, false), crowd_of(0, 15, 100, false),
                                   crowd_of(30, 30, 5, true)}) {
      journal.begin("world of " + std::to_string(sdl.size()));
      const scene::Scene scene = scene_of(sdl);
      textures::Compiler compiler{textures::Settings{}};
      const accel::World world(scene, compiler);
      RandomRays random;
      std::uniform_real_distribution<double> u(-1, 1);
      RayBatch& rays = *random.rays;
      int found_rays = 0, blocked_rays = 0, beyond = 0;
      for (int round = 0; round < 300; ++round) {
        const Vec3 eye = normalize(random.vector(1)) * 6.0, size(20 + round % 3 * 100),
                   target = eye + (random.vector(0.3) - eye) * 1e3;  // behind everything: rays end there
        accel::WorldEntry entry;
        world.enter(*accel::Shaft::between(Box3(eye, eye), Box3(target - size, target + size)), entry);
        const int first = round % 5, count = 1 + round % 20;
        double limits[RayBatch::kSize] = {};
        for (int i = first; i < first + count; ++i) {
          const Vec3 to = target + size * Vec3(u(random.random), u(random.random), u(random.random));
          rays.origin.set(i, eye), rays.direction.set(i, normalize(to - eye));
          limits[i] = 3 + 5 * (1 + u(random.random));
        }
        accel::WorldEntry* const known = round % 4 == 0 ? nullptr : &entry;
        constexpr auto kKind = shapes::RayKind::camera;
        shapes::Hit hits[RayBatch::kMax], hits_before[RayBatch::kMax], alone;
        bool found[RayBatch::kMax], found_before[RayBatch::kMax], blocked[RayBatch::kMax] = {};
        world.intersect_batch(rays, first, count, kKind, 1e-4, known, hits, found);
        world.intersect_batch(rays, first, count, kKind, 1e-4, known, hits_before, found_before, limits);
        world.occluded_batch(rays, first, count, 1e-3, limits, known, blocked);
        for (int i = first; i < first + count; ++i) {
          ASSERT_EQ(found[i], world.intersect(rays.at(i), kKind, 1e-4, kInfinity, alone)) << round << ' ' << i;
          if (found[i]) {
            ASSERT_TRUE(same_hit(hits[i], alone)) << round << ' ' << i;
            note(journal, alone);
          }
          ASSERT_EQ(found_before[i], world.intersect(rays.at(i), kKind, 1e-4, limits[i], alone));
          ASSERT_TRUE(!found_before[i] || same_hit(hits_before[i], alone));
          ASSERT_EQ(blocked[i], world.occluded(rays.at(i), 1e-3, limits[i])) << round << ' ' << i;
          journal.add(blocked[i]);
          found_rays += found[i], blocked_rays += blocked[i], beyond += found[i] && !found_before[i];
        }
      }
      EXPECT_GT(found_rays, 80);
      EXPECT_GT(blocked_rays, 50);
      EXPECT_GT(beyond, 10);
    }
  });
}

}  // namespace
}  // namespace verisim::test
