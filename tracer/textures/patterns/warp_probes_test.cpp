// The values of spec 05 section 15 (warp rows): warped patterns called as functions in POV-Ray.
#include <gtest/gtest.h>

#include "tracer/textures/patterns/probe_test_support.h"

namespace verisim::textures {
namespace {

TEST(PatternProbes, Warps) {
  const Vec3 points[5] = {{0.3, 0.7, -0.4}, {1.25, -2.75, 3.6}, {-3.1, 4.4, 0.9}, {5.5, -0.2, -7.3}, {-0.6, -1.7, 2.2}};
  const Probe probes[] = {
      {"bozo warp{turbulence <0.5,0.3,0.2> octaves 4 lambda 2.2 omega 0.6}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           TurbulenceWarp w;
           w.amount = Vec3(0.5, 0.3, 0.2);
           w.octaves = 4;
           w.lambda = static_cast<float>(2.2);
           w.omega = static_cast<float>(0.6);
           p.prepend(w);
         }
         return p;
       },
       {0.434919861077, 0.462680918169, 0.745892227301, 0.56615677028, 0.57785609052}},
      {"bozo turbulence 0.5 scale 2 translate x",
       [] {
         Pattern p = make(PatternKind::bozo);
         classic(p).amount = Vec3(0.5, 0.5, 0.5);
         p.prepend(Transform::scaling(Vec3(2, 2, 2)));
         p.prepend(Transform::translation(Vec3(1, 0, 0)));
         return p;
       },
       {0.432664786139, 0.576385527858, 0.803731365016, 0.647252904059, 0.577566665364}},
      {"bozo scale 2 translate x turbulence 0.5",
       [] {
         Pattern p = make(PatternKind::bozo);
         p.prepend(Transform::scaling(Vec3(2, 2, 2)));
         p.prepend(Transform::translation(Vec3(1, 0, 0)));
         classic(p).amount = Vec3(0.5, 0.5, 0.5);
         return p;
       },
       {0.432664786139, 0.576385527858, 0.803731365016, 0.647252904059, 0.577566665364}},
      {"bozo warp{turbulence 0.5} scale 2",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           TurbulenceWarp w;
           w.amount = Vec3(0.5, 0.5, 0.5);
           p.prepend(w);
         }
         p.prepend(Transform::scaling(Vec3(2, 2, 2)));
         return p;
       },
       {0.235611976019, 0.485476989559, 0.585548656528, 0.49100164234, 0.484840928857}},
      {"bozo scale 2 warp{turbulence 0.5}",
       [] {
         Pattern p = make(PatternKind::bozo);
         p.prepend(Transform::scaling(Vec3(2, 2, 2)));
         {
           TurbulenceWarp w;
           w.amount = Vec3(0.5, 0.5, 0.5);
           p.prepend(w);
         }
         return p;
       },
       {0.236839281661, 0.488952571571, 0.630950205897, 0.581200211203, 0.494882253203}},
      {"bozo warp{repeat 1.7*y offset <0.3,0.2,-0.1> flip <1,1,0>}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           RepeatWarp w;
           w.axis = 1, w.width = 1.7f;
           w.offset = Vec3(0.3, 0.2, -0.1);
           w.flip = Vec3(1, 1, 0);
           p.prepend(w);
         }
         return p;
       },
       {0.441297273606, 0.556751169027, 0.526272136275, 0.478487841537, 0.371064063859}},
      {"bozo warp{black_hole <0.6,0.6,0.6>,0.6 strength 1.5 repeat <2,2,2> turbulence <0.5,0.6,0.3>}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           BlackHoleWarp w;
           w.center = Vec3(0.6, 0.6, 0.6), w.radius = 0.6;
           w.strength = 1.5;
           w.repeat = Vec3(2, 2, 2), w.repeats = true;
           w.turbulence = Vec3(0.5, 0.6, 0.3), w.turbulent = true;
           p.prepend(w);
         }
         return p;
       },
       {0.441297273606, 0.43681354721, 0.72816197168, 0.576446430772, 0.612436116393}},
      {"bozo warp{black_hole <0.5,0.5,0>,4 strength 1.8 falloff 1.3 inverse}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           BlackHoleWarp w;
           w.center = Vec3(0.5, 0.5, 0), w.radius = 4;
           w.strength = 1.8;
           w.falloff = 1.3;
           w.inverse = true;
           p.prepend(w);
         }
         return p;
       },
       {0.364963382729, 0.43681354721, 0.728173512674, 0.576446430772, 0.62614638795}},
      {"bozo warp{cylindrical orientation y dist_exp 1}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           ProjectionWarp w;
           w.kind = ProjectionWarpKind::cylindrical;
           w.orientation = Vec3(0, 1, 0);
           w.distance_exponent = 1;
           p.prepend(w);
         }
         return p;
       },
       {0.409728938142, 0.405302875806, 0.782541315962, 0.638842321661, 0.402928476399}},
      {"bozo warp{spherical}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           ProjectionWarp w;
           w.kind = ProjectionWarpKind::spherical;
           p.prepend(w);
         }
         return p;
       },
       {0.559625907842, 0.510874759796, 0.32600392773, 0.567557724128, 0.533391270592}},
      {"bozo warp{toroidal orientation y dist_exp 1 major_radius 2}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           ProjectionWarp w;
           w.kind = ProjectionWarpKind::toroidal;
           w.orientation = Vec3(0, 1, 0);
           w.distance_exponent = 1;
           w.major_radius = 2;
           p.prepend(w);
         }
         return p;
       },
       {0.49800480096, 0.47690472351, 0.349043682875, 0.370076713098, 0.463779787826}},
      {"bozo warp{planar y,0.7}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           ProjectionWarp w;
           w.kind = ProjectionWarpKind::planar;
           w.orientation = Vec3(0, 1, 0), w.offset = 0.7;
           p.prepend(w);
         }
         return p;
       },
       {0.473880287499, 0.499383411348, 0.560918150182, 0.468167279469, 0.71711269238}},
      {"bozo warp{cubic}",
       [] {
         Pattern p = make(PatternKind::bozo);
         {
           CubicWarp w;
           p.prepend(w);
         }
         return p;
       },
       {0.581627746638, 0.519999180742, 0.514879266465, 0.570290368775, 0.424425972371}},
  };
  check(probes, points, 2e-12);
}

}  // namespace
}  // namespace verisim::textures
