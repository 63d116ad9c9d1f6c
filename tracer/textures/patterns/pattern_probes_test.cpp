// The values of spec 05 section 15 (probes P3, P4 and the wave and warp rows): patterns called as functions in POV-Ray.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/patterns/fractal_kernels.h"
#include "tracer/simd/instruction_sets.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {
namespace {

using namespace scene;

struct Probe {
  const char* sdl;
  Pattern (*make)();
  double value[5];
};

Pattern make(PatternKind kind) {
  Pattern p;
  p.kind = kind;
  switch (kind) {
    case PatternKind::marble:
    case PatternKind::wood:
    case PatternKind::spiral1:
    case PatternKind::spiral2:
      p.wave = Wave::triangle;
      break;
    case PatternKind::checker:
    case PatternKind::brick:
    case PatternKind::hexagon:
    case PatternKind::cubic:
    case PatternKind::quilted:
      p.frequency = 0;
      break;
    default:
      break;
  }
  return p;
}

Turbulence& classic(Pattern& p) { return p.turbulence.edit(); }

void check(std::span<const Probe> probes, std::span<const Vec3, 5> points, double tolerance) {
  for (const Probe& probe : probes) {
    Compiler compiler{Settings{}};
    const CompiledPattern* pattern = compiler.pattern(probe.make());
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(evaluate(*pattern, points[k], nullptr), probe.value[k], tolerance) << probe.sdl << ", point " << k;
  }
}

TEST(PatternProbes, PatternsAndWarps) {
  const Vec3 points[5] = {{0.3, 0.7, -0.4}, {1.25, -2.75, 3.6}, {-3.1, 4.4, 0.9}, {5.5, -0.2, -7.3}, {-0.6, -1.7, 2.2}};
  const Probe probes[] = {
      {"agate",
       [] {
         Pattern p = make(PatternKind::agate);
         p.params = AgateParams{1};
         return p;
       },
       {0.317193762903, 0.871094185245, 0.270256942109, 0.740347672958, 0.124148200175}},
      {"agate agate_turb 0.5 turbulence 0.3 octaves 4 omega 0.6 lambda 2.3",
       [] {
         Pattern p = make(PatternKind::agate);
         classic(p).amount = Vec3(0.3, 0.3, 0.3);
         classic(p).octaves = 4;
         classic(p).omega = static_cast<float>(0.6);
         classic(p).lambda = static_cast<float>(2.3);
         p.params = AgateParams{0.5f};
         return p;
       },
       {0.98352891999, 0.479543888528, 0.971626112918, 0.109779575344, 0.981254240295}},
      {"agate noise_generator 1",
       [] {
         Pattern p = make(PatternKind::agate);
         p.noise_generator = 1;
         p.params = AgateParams{1};
         return p;
       },
       {0.112015654437, 0.678797786271, 0.100745589207, 0.901801246081, 0.00150075966672}},
      {"agate noise_generator 3",
       [] {
         Pattern p = make(PatternKind::agate);
         p.noise_generator = 3;
         p.params = AgateParams{1};
         return p;
       },
       {0.994132295403, 0.888626569742, 0.403590773208, 0.11845467892, 0.911404882096}},
      {"bozo",
       [] {
         Pattern p = make(PatternKind::bozo);
         return p;
       },
       {0.441297273606, 0.43681354721, 0.728173512674, 0.576446430772, 0.612436116393}},
      {"bozo noise_generator 1",
       [] {
         Pattern p = make(PatternKind::bozo);
         p.noise_generator = 1;
         return p;
       },
       {0.348451757747, 0.339298602446, 0.934085789957, 0.624347545137, 0.697817501298}},
      {"bozo noise_generator 3",
       [] {
         Pattern p = make(PatternKind::bozo);
         p.noise_generator = 3;
         return p;
       },
       {0.639419336941, 0.445168696205, 0.409811540864, 0.560968612817, 0.699238554062}},
      {"brick",
       [] {
         Pattern p = make(PatternKind::brick);
         return p;
       },
       {1, 1, 1, 0, 1}},
      {"cells",
       [] {
         Pattern p = make(PatternKind::cells);
         return p;
       },
       {0.824241705472, 0.912577491952, 0.642315457109, 0.491239255294, 0.539091458777}},
      {"checker",
       [] {
         Pattern p = make(PatternKind::checker);
         return p;
       },
       {1, 1, 0, 0, 1}},
      {"crackle",
       [] {
         Pattern p = make(PatternKind::crackle);
         return p;
       },
       {0.141697372802, 0.0226149672844, 0.368209699985, 0.290003463098, 0.171891444877}},
      {"crackle solid",
       [] {
         Pattern p = make(PatternKind::crackle);
         {
           CrackleParams c;
           c.solid = true;
           p.params = c;
         }
         return p;
       },
       {0.432821227159, 0.550679402563, 0.545212908195, 0.51385861775, 0.566580892324}},
      {"crackle form <1,0,0>",
       [] {
         Pattern p = make(PatternKind::crackle);
         {
           CrackleParams c;
           c.form = {1, 0, 0};
           p.params = c;
         }
         return p;
       },
       {0.580299851426, 0.669612898037, 0.495151031736, 0.291825608783, 0.42789093546}},
      {"crackle metric 1",
       [] {
         Pattern p = make(PatternKind::crackle);
         {
           CrackleParams c;
           c.metric = 1;
           p.params = c;
         }
         return p;
       },
       {0.0184761796147, 0.120792644564, 0.456400620379, 0.414549475303, 0.291301818844}},
      {"crackle metric 3 form <1,1,-1> offset 0.2",
       [] {
         Pattern p = make(PatternKind::crackle);
         {
           CrackleParams c;
           c.metric = 3;
           c.form = {1, 1, -1};
           c.offset = 0.2;
           p.params = c;
         }
         return p;
       },
       {0.453667117772, 0.618413592886, 0.339395643222, 0.224630184628, 0.321039051995}},
      {"cubic",
       [] {
         Pattern p = make(PatternKind::cubic);
         return p;
       },
       {1, 2, 1, 5, 2}},
      {"dents",
       [] {
         Pattern p = make(PatternKind::dents);
         return p;
       },
       {0.0859396801465, 0.0833466784617, 0.386104294581, 0.191547665528, 0.22971131162}},
      {"gradient <1,2,-0.5>",
       [] {
         Pattern p = make(PatternKind::gradient);
         p.params = GradientParams{{1, 2, -0.5}};
         return p;
       },
       {0.829227982897, 0.359583528144, 0.291287847478, 0.81881307913, 0.774197519593}},
      {"granite",
       [] {
         Pattern p = make(PatternKind::granite);
         return p;
       },
       {0.410771541468, 0.502898028001, 0.236015733138, 0.515153862035, 0.266942287905}},
      {"granite noise_generator 1",
       [] {
         Pattern p = make(PatternKind::granite);
         p.noise_generator = 1;
         return p;
       },
       {0.392521427734, 0.546303658945, 0.264533488848, 0.530776848213, 0.309286039472}},
      {"granite noise_generator 3",
       [] {
         Pattern p = make(PatternKind::granite);
         p.noise_generator = 3;
         return p;
       },
       {0.458449600336, 0.253859744082, 0.663843886297, 0.369773678861, 0.533041516957}},
      {"hexagon",
       [] {
         Pattern p = make(PatternKind::hexagon);
         return p;
       },
       {0, 1, 1, 2, 1}},
      {"leopard",
       [] {
         Pattern p = make(PatternKind::leopard);
         return p;
       },
       {0.0336501787625, 0.00173064830429, 0.004893274222, 0.34208706193, 0.0621356791431}},
      {"marble",
       [] {
         Pattern p = make(PatternKind::marble);
         return p;
       },
       {0.6, 0.49998, 0.19994, 0.9999, 0.8}},
      {"marble turbulence 0.7",
       [] {
         Pattern p = make(PatternKind::marble);
         classic(p).amount = Vec3(0.7, 0.7, 0.7);
         return p;
       },
       {0.0509731810832, 0.253755040071, 0.153121186355, 0.58564020733, 0.321766953211}},
      {"marble turbulence <0.7,0.2,0.1> octaves 3 omega 0.7 lambda 1.9 noise_generator 1",
       [] {
         Pattern p = make(PatternKind::marble);
         classic(p).amount = Vec3(0.7, 0.2, 0.1);
         classic(p).octaves = 3;
         classic(p).omega = static_cast<float>(0.7);
         classic(p).lambda = static_cast<float>(1.9);
         p.noise_generator = 1;
         return p;
       },
       {0.277263138253, 0.0517234404369, 0.182213978265, 0.618073998612, 0.571711218141}},
      {"onion",
       [] {
         Pattern p = make(PatternKind::onion);
         return p;
       },
       {0.860232526704, 0.699468055004, 0.457105459857, 0.142209798512, 0.844292530666}},
      {"onion sine_wave",
       [] {
         Pattern p = make(PatternKind::onion);
         p.wave = Wave::sine;
         return p;
       },
       {0.115209430513, 0.024990812097, 0.633131672252, 0.889644524782, 0.0852145271011}},
      {"onion triangle_wave frequency 3",
       [] {
         Pattern p = make(PatternKind::onion);
         p.wave = Wave::triangle;
         p.frequency = static_cast<float>(3);
         return p;
       },
       {0.838644839774, 0.196768330022, 0.742612759141, 0.853258791069, 0.934284816007}},
      {"onion scallop_wave",
       [] {
         Pattern p = make(PatternKind::onion);
         p.wave = Wave::scallop;
         return p;
       },
       {0.425118198069, 0.809998144189, 0.99093398426, 0.432050549734, 0.469892897113}},
      {"onion cubic_wave phase 0.3",
       [] {
         Pattern p = make(PatternKind::onion);
         p.wave = Wave::cubic;
         p.phase = static_cast<float>(0.3);
         return p;
       },
       {0.0687875561531, 0.999999151443, 0.851667206678, 0.413700720136, 0.0564451664487}},
      {"onion poly_wave 2.2",
       [] {
         Pattern p = make(PatternKind::onion);
         p.wave = Wave::poly;
         p.exponent = 2.2f;
         return p;
       },
       {0.718050334062, 0.455501004785, 0.17866360097, 0.0136913069141, 0.689103538866}},
      {"onion frequency -2.5 phase 0.1",
       [] {
         Pattern p = make(PatternKind::onion);
         p.frequency = static_cast<float>(-2.5);
         p.phase = static_cast<float>(0.1);
         return p;
       },
       {0.949438684729, 0.351339863981, 0.957246351848, 0.744475505211, 0.989288674826}},
      {"quilted",
       [] {
         Pattern p = make(PatternKind::quilted);
         return p;
       },
       {0.126439708911, 0.172482827417, 0.319715573109, 0.14213161757, 0.174332165292}},
      {"quilted control0 0.2 control1 1.7",
       [] {
         Pattern p = make(PatternKind::quilted);
         {
           QuiltedParams c;
           c.control0 = static_cast<float>(0.2);
           c.control1 = static_cast<float>(1.7);
           p.params = c;
         }
         return p;
       },
       {0.0840044661268, 0.132408703525, 0.33538627952, 0.107633583664, 0.135598388301}},
      {"radial",
       [] {
         Pattern p = make(PatternKind::radial);
         return p;
       },
       {0.14757361765, 0.803189270716, 0.544970017381, 0.147225357937, 0.707624670269}},
      {"radial frequency 6",
       [] {
         Pattern p = make(PatternKind::radial);
         p.frequency = static_cast<float>(6);
         return p;
       },
       {0.885441705903, 0.819095624299, 0.269790104284, 0.883352147622, 0.245708021616}},
      {"ripples",
       [] {
         Pattern p = make(PatternKind::ripples);
         return p;
       },
       {0.578892884649, 0.432296627277, 0.531926297383, 0.414945244533, 0.447631630942}},
      {"ripples frequency 2.5 phase 0.3",
       [] {
         Pattern p = make(PatternKind::ripples);
         p.frequency = static_cast<float>(2.5);
         p.phase = static_cast<float>(0.3);
         return p;
       },
       {0.333127075423, 0.519739703331, 0.455828316723, 0.657342248585, 0.805550470355}},
      {"spiral1 3",
       [] {
         Pattern p = make(PatternKind::spiral1);
         p.params = SpiralParams{3};
         return p;
       },
       {0.663508554055, 0.351197766862, 0.150704579902, 0.127419096675, 0.318569305006}},
      {"spiral1 3 turbulence 0.3",
       [] {
         Pattern p = make(PatternKind::spiral1);
         p.params = SpiralParams{3};
         classic(p).amount = Vec3(0.3, 0.3, 0.3);
         return p;
       },
       {0.237999182243, 0.092930931505, 0.943220639447, 0.536152286025, 0.107316669027}},
      {"spiral2 5",
       [] {
         Pattern p = make(PatternKind::spiral2);
         p.params = SpiralParams{5};
         return p;
       },
       {0.7961720994, 0.242002512199, 0.612700141431, 0.315718071096, 0.142203166957}},
      {"spotted noise_generator 3",
       [] {
         Pattern p = make(PatternKind::spotted);
         p.noise_generator = 3;
         return p;
       },
       {0.639419336941, 0.445168696205, 0.409811540864, 0.560968612817, 0.699238554062}},
      {"waves",
       [] {
         Pattern p = make(PatternKind::waves);
         return p;
       },
       {0.578831830472, 0.63139730319, 0.558300224356, 0.549975602067, 0.501789793746}},
      {"waves frequency 4 phase 0.1 sine_wave",
       [] {
         Pattern p = make(PatternKind::waves);
         p.frequency = static_cast<float>(4);
         p.phase = static_cast<float>(0.1);
         p.wave = Wave::sine;
         return p;
       },
       {0.854299360003, 0.808954137987, 0.000799160880324, 0.321588384426, 0.697862502875}},
      {"wood",
       [] {
         Pattern p = make(PatternKind::wood);
         return p;
       },
       {0.476845378827, 0.0414629867973, 0.764657312638, 0.992829675346, 0.394468724536}},
      {"wood turbulence <0.3,0.1,0.2> octaves 4",
       [] {
         Pattern p = make(PatternKind::wood);
         classic(p).amount = Vec3(0.3, 0.1, 0.2);
         classic(p).octaves = 4;
         return p;
       },
       {0.608930521794, 0.545864531757, 0.534717398102, 0.769889688438, 0.0834848865378}},
      {"wrinkles",
       [] {
         Pattern p = make(PatternKind::wrinkles);
         return p;
       },
       {0.524949764088, 0.453832773506, 0.739489337269, 0.574431795293, 0.549473081169}},
      {"wrinkles noise_generator 1",
       [] {
         Pattern p = make(PatternKind::wrinkles);
         p.noise_generator = 1;
         return p;
       },
       {0.493796017683, 0.421206300792, 0.712778383944, 0.544302747608, 0.518868889288}},
      {"wrinkles noise_generator 3",
       [] {
         Pattern p = make(PatternKind::wrinkles);
         p.noise_generator = 3;
         return p;
       },
       {0.640730471503, 0.546682669034, 0.574424574222, 0.65818152998, 0.754351488853}},
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

TEST(WrapPeriod, IsTheExactRemainder) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> exponent(-4, 30), sign(-1, 1);
  for (int i = 0; i < 200000; ++i) {
    const double v = std::copysign(std::exp2(exponent(random)), sign(random));
    ASSERT_EQ(wrap_period(v), std::fmod(v, 1.00001)) << v;
  }
  for (int n = -50000; n <= 50000; ++n)  // at and beside multiples of the period
    for (const double v : {n * 1.00001, std::nextafter(n * 1.00001, 1e9), std::nextafter(n * 1.00001, -1e9)})
      ASSERT_EQ(wrap_period(v), std::fmod(v, 1.00001)) << v;
}

TEST(PatternProbes, Fractals) {
  const Vec3 points[5] = {{0.3, 0.2, 0}, {-0.75, 0.1, 0}, {0.4, -0.6, 0}, {-1.3, 0.02, 0}, {0.1, 0.8, 0}};
  const Probe probes[] = {
      {"mandel 25",
       [] {
         Pattern p = make(PatternKind::mandel);
         {
           FractalParams f;
           f.iterations = 25;
           p.params = f;
         }
         return p;
       },
       {1, 1, 0.52, 1, 0.16}},
      {"mandel 25 interior 1,1",
       [] {
         Pattern p = make(PatternKind::mandel);
         {
           FractalParams f;
           f.iterations = 25;
           f.interior_type = 1, f.interior_factor = 1;
           p.params = f;
         }
         return p;
       },
       {0.338534677077, 0.203730827319, 0.52, 0.037570703233, 0.16}},
      {"mandel 25 exponent 5",
       [] {
         Pattern p = make(PatternKind::mandel);
         {
           FractalParams f;
           f.iterations = 25;
           f.exponent = 5;
           p.params = f;
         }
         return p;
       },
       {1, 0.08, 1, 0, 0.04}},
      {"julia <0.3,0.5>,30 exterior 6,0.1",
       [] {
         Pattern p = make(PatternKind::julia);
         {
           FractalParams f;
           f.julia = {0.3, 0.5};
           f.iterations = 30;
           f.exterior_type = 6, f.exterior_factor = 0.1;
           p.params = f;
         }
         return p;
       },
       {0.212313343366, 0.248494647177, 1, 0.203941466112, 1}},
      {"magnet 1 mandel 30",
       [] {
         Pattern p = make(PatternKind::magnet_mandel);
         {
           FractalParams f;
           f.magnet = 1;
           f.iterations = 30;
           p.params = f;
         }
         return p;
       },
       {1, 0.133333333333, 1, 0.1, 1}},
      {"magnet 2 julia <0.3,0.5>,30 interior 6,0.5",
       [] {
         Pattern p = make(PatternKind::magnet_julia);
         {
           FractalParams f;
           f.magnet = 2;
           f.julia = {0.3, 0.5};
           f.iterations = 30;
           f.interior_type = 6, f.interior_factor = 0.5;
           p.params = f;
         }
         return p;
       },
       {0.198432376537, 0.198432376569, 0.198432376575, 0.198432376575, 0.19843237655}},
  };
  check(probes, points, 2e-12);
}

// Orbits that go round for ever end where step by step iteration ends, with the same bits.
TEST(PatternProbes, LongOrbitsOfFractals) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> real(-1.4, 0.4), imaginary(-0.8, 0.8);
  int stay = 0;
  for (int n = 0; n < 300; ++n) {
    FractalParams f;
    f.iterations = 1500 + n % 7, f.interior_type = 1 + n % 6, f.interior_factor = 0.7;
    const Vec3 p(real(random), imaginary(random), 0);
    double a = p.x, b = p.y, size = a * a + b * b, smallest = size;
    for (int k = 0; k < f.iterations && size <= 4; ++k) {
      const double square = a * a - b * b + p.x;
      b = 2 * a * b + p.y, a = square;
      size = a * a + b * b;
      smallest = std::min(smallest, size);
    }
    if (size > 4) continue;
    ++stay;
    const double expected[] = {std::sqrt(smallest) * 0.7, a * 0.7, b * 0.7, a * a * 0.7, b * b * 0.7,
                               a * a + b * b * 0.7};
    EXPECT_EQ(fractal(f, PatternKind::mandel, p), expected[f.interior_type - 1]) << n;
  }
  EXPECT_GT(stay, 100);
}

// Eight orbits at once end as each does alone, with every instruction set.
TEST(PatternProbes, OrbitsSideBySide) {
  std::mt19937 random{12};
  std::uniform_real_distribution<double> real(-1.5, 0.5), imaginary(-1, 1);
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const OrbitKernels* kernels = orbit_kernels(set);
    if (!kernels) continue;
    for (int n = 0; n < 60; ++n) {
      FractalParams f;
      f.iterations = n % 9 == 0 ? 0 : 40 * n, f.exponent = 2 + n % 4, f.julia = {real(random), imaginary(random)};
      f.exterior_type = n % 9, f.exterior_factor = 3.5, f.interior_type = n % 7, f.interior_factor = 0.7;
      const PatternKind kind = n % 2 ? PatternKind::julia : PatternKind::mandel;
      double x[40], y[40], values[40];
      for (int i = 0; i < 40; ++i) x[i] = real(random), y[i] = imaginary(random);
      const int count = 33 + n % 8;
      fractal_batch(f, kind, count, x, y, values, *kernels);
      for (int i = 0; i < count; ++i)
        ASSERT_EQ(values[i], fractal(f, kind, {x[i], y[i], 0})) << "set " << set << " case " << n << " point " << i;
    }
  }
}

}  // namespace
}  // namespace verisim::textures
