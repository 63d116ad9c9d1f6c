// The values of spec 05 section 15 (probes P3, P4 and the wave rows): patterns called as functions in POV-Ray.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tracer/textures/patterns/probe_test_support.h"

namespace verisim::textures {
namespace {

TEST(PatternProbes, PatternsAndWaves) {
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

}  // namespace
}  // namespace verisim::textures
