// Radiosity, photons, media and subsurface scattering in default mode: the same picture for any number of threads;
// extremes and damaged files end with a name, soon, and without unbounded memory.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

const std::string kRoom =
    "camera { location <0,2,-4> look_at <0,0.5,0> } light_source { <3,5,-2> rgb 1 photons { refraction on reflection "
    "on } } background { rgb <0.3,0.4,0.6> }"
    "plane { y,0 pigment { rgb 0.7 } finish { ambient 0 } } sphere { <0.8,0.6,0>,0.6 pigment { rgbt 1 } interior { ior "
    "1.5 } photons { target refraction on collect off } }"
    "box { <-1.5,0,-0.5>,<-0.5,1,0.5> pigment { rgb <0.9,0.6,0.4> } interior { ior 1.4 } finish { ambient 0 diffuse 1 "
    "subsurface { translucency 1 } } }";

std::string scene(const std::string& settings, const std::string& more = "") {
  return "#version 3.7; global_settings { assumed_gamma 1 " + settings + " }\n" + kRoom + more;
}

struct Feature {
  std::string name, text;
};
void PrintTo(const Feature& f, std::ostream* out) { *out << f.name; }
class AnyThreads : public testing::TestWithParam<Feature> {};

TEST_P(AnyThreads, GiveTheSamePicture) {
  render::Options options;
  options.block_size = 8;
  options.threads = 1;
  const auto one = render_text(GetParam().text, 48, 32, options);
  for (const int threads : {2, 5}) {
    options.threads = threads;
    const auto many = render_text(GetParam().text, 48, 32, options);
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
      ASSERT_EQ(one.pixels[i].r, many.pixels[i].r) << threads << " threads, pixel " << i;
      ASSERT_EQ(one.pixels[i].g, many.pixels[i].g) << threads << " threads, pixel " << i;
      ASSERT_EQ(one.pixels[i].b, many.pixels[i].b) << threads << " threads, pixel " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Global, AnyThreads,
    testing::Values(
        Feature{"radiosity", scene("radiosity { pretrace_end 0.02 count 20 }")},
        Feature{"radiosity_always_sample",
                scene("radiosity { always_sample on count 20 recursion_limit 3 error_bound 0.7 }")},
        Feature{"photons", scene("photons { spacing 0.03 }")},
        Feature{"photons_and_media",
                scene("photons { spacing 0.05 media 20 }", "media { scattering { 1,0.02 } method 1 samples 2,6 }")},
        Feature{"media_jitter", scene("", "media { scattering { 1,0.05 } jitter 0.5 intervals 3 }")},
        Feature{"subsurface", scene("subsurface { samples 10,10 }")},
        Feature{"all",
                scene("radiosity { count 20 } photons { spacing 0.05 } subsurface { samples 5,5 radiosity on }")}),
    [](const auto& p) { return p.param.name; });

// What a render says when it gives up; empty if it does not.
std::string failure(const std::string& text, render::Options options = {}) {
  try {
    render_text(text, 16, 12, options);
  } catch (const std::exception& e) {
    return e.what();
  }
  return {};
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(GlobalLimits, ExtremeSettingsEndWithTheirName) {
  EXPECT_TRUE(says(failure(scene("radiosity { count 1000000000 }")), "directions"));
  EXPECT_TRUE(says(failure(scene("radiosity { count 0 }")), "count"));
  EXPECT_TRUE(says(failure(scene("photons { spacing 1e-12 }")), "spacing is too fine"));
  EXPECT_TRUE(says(failure(scene("", "media { absorption 0.1 intervals 1000000 }")), "intervals"));
  // No spacing at all, and targets that no light reaches: nothing is shot, or nothing is stored.
  EXPECT_EQ(failure(scene("photons { spacing 0 }")), "");
  EXPECT_EQ(failure(scene("photons { spacing 0.1 }",
                          "sphere { <1e30,0,0>,1 pigment { rgbt 1 } photons { target refraction on } }")),
            "");
  EXPECT_EQ(failure(scene("photons { spacing 0.1 autostop 1 }",
                          "sphere { <0,-50,0>,1 pigment { rgbt 1 } photons { target refraction on reflection on } }")),
            "");
}

TEST(GlobalLimits, MemoryOfThePassesIsBounded) {
  render::Options options;
  options.pass_memory = 200000;
  EXPECT_TRUE(says(failure(scene("photons { spacing 0.005 }"), options), "photons"));
  options.pass_memory = 50000;  // samples take a few hundred bytes each
  EXPECT_TRUE(says(failure(scene("radiosity { error_bound 0.01 minimum_reuse 0.0001 maximum_reuse 0.001 pretrace_start "
                                 "1 pretrace_end 0.05 count 5 }"),
                           options),
                   "radiosity"));
}

TEST(GlobalLimits, EndlessWorkCanBeCancelled) {
  // Each value takes nearly as long as one may, and a ray asks for many.
  const std::string slow =
      "#declare F = function(n) { sum(i, 1, n, i) } isosurface { function { x*x + y*y + z*z - 1 + 1e-30*F(9e7 + 0*x) } "
      "max_gradient 4 translate <0,1,1> pigment { rgb 1 } photons { target reflection on } }";
  for (const std::string& text :
       {scene("", "media { scattering { 1,0.1 } samples 1000000 }"), scene("photons { spacing 0.00001 }"),
        scene("radiosity { count 16000000 recursion_limit 5 }"), scene("subsurface { samples 100000000,100000000 }"),
        scene("", slow), scene("photons { spacing 0.01 }", slow), scene("radiosity { count 20 }", slow)}) {
    std::atomic<bool> cancel{false};
    render::Options options;
    options.cancel = &cancel;
    options.threads = 2;
    std::atomic<bool> over{false};
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t begin = std::clock();
    // The progress of passes and the flag itself are looked at while rays are traced; a thread of our own sets it.
    std::thread stopper([&] {
      while (!over && std::chrono::steady_clock::now() - start < std::chrono::milliseconds(300))
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      cancel = true;
    });
    failure(text, options);
    over = true;
    stopper.join();
    // The processor's time, not the clock's: a busy machine is no failure.
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 20) << text;
  }
}

TEST(GlobalProgress, PassesTellHowFarTheyAre) {
  std::map<std::string, double> last;
  render::Options options;
  options.pass_progress = [&](const char* pass, double fraction) {
    EXPECT_GE(fraction, last[pass]);
    EXPECT_LE(fraction, 1.0);
    last[pass] = fraction;
  };
  render_text(scene("radiosity { pretrace_end 0.02 count 10 } photons { spacing 0.05 }"), 64, 48, options);
  EXPECT_EQ(last["photons"], 1.0);
  EXPECT_GT(last["radiosity pretrace"], 0.5);
}

class Files : public testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const {
    return std::filesystem::path(testing::TempDir()) / ("verisim_global_" + name);
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
};

TEST_F(Files, RadiositySamplesComeBack) {
  render::Options options;
  options.radiosity_to = path("samples.rca").string();
  const std::string text = scene("radiosity { pretrace_end 0.02 count 50 error_bound 0.5 }");
  const auto first = render_text(text, 40, 30, options);
  ASSERT_GT(std::filesystem::file_size(options.radiosity_to), 1000u);
  // From the file, with hardly a pretrace of its own, the picture is the same but for the rounding of what was written.
  render::Options again;
  again.radiosity_from = options.radiosity_to;
  const auto second =
      render_text(scene("radiosity { pretrace_start 1 pretrace_end 1 count 50 error_bound 0.5 }"), 40, 30, again);
  double sum = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) sum += std::fabs(first.pixels[i].g - second.pixels[i].g);
  EXPECT_LT(sum / static_cast<double>(first.pixels.size()), 0.002);
}

TEST_F(Files, DamagedRadiosityFilesAreErrors) {
  render::Options options;
  options.radiosity_from = path("damaged.rca").string();
  const std::string text = scene("radiosity { }");
  write("damaged.rca", "C1\t0\t0\n");
  EXPECT_TRUE(says(failure(text, options), "line 1: not a sample"));
  write("damaged.rca", "B\nC1\tnan\t0\t0\t7ffe7f\t0.1\t0.1\t0.1\t1\t1\t7f7f7f\n");
  EXPECT_TRUE(says(failure(text, options), "line 2: impossible values"));
  write("damaged.rca", "C77\t0\t0\t0\t7ffe7f\t0.1\t0.1\t0.1\t1\t1\t7f7f7f\n");
  EXPECT_TRUE(says(failure(text, options), "impossible values"));
  write("damaged.rca", std::string(100000, 'C'));
  EXPECT_TRUE(says(failure(text, options), "line 1"));
  write("damaged.rca", std::string(1000, '\0'));
  EXPECT_EQ(failure(text, options), "");  // no line is a sample
  options.radiosity_from = path("absent.rca").string();
  EXPECT_TRUE(says(failure(text, options), "cannot read"));
}

TEST_F(Files, DamagedPhotonFilesAreErrors) {
  const auto text = [&](const std::string& name) {
    return scene("photons { spacing 0.1 load_file \"" + path(name).string() + "\" }");
  };
  write("short.ph", std::string("\x10\0\0\0", 4));
  EXPECT_TRUE(says(failure(text("short.ph")), "photon file"));
  write("huge.ph", std::string("\xff\xff\xff\x7f", 4));
  EXPECT_TRUE(says(failure(text("huge.ph")), "photon file"));
  write("negative.ph", std::string("\xff\xff\xff\xff", 4));
  EXPECT_TRUE(says(failure(text("negative.ph")), "photon file"));
  write("nan.ph", std::string("\x01\0\0\0", 4) + std::string(20, '\xff'));
  EXPECT_TRUE(says(failure(text("nan.ph")), "photon file"));
  write("empty.ph", "");
  EXPECT_EQ(failure(text("empty.ph")), "");
  EXPECT_NE(failure(text("absent.ph")), "");
}

// Nobody can end a thread of the language server, of view or of Python by force.
TEST(GlobalLimits, AFunctionThatNobodyCanWaitForEndsTheRender) {
  const std::string doubled =
      "#declare F = function(x,y,z) { sqrt(x*x + y*y + z*z) - 1 } #for (I, 1, 40) #undef G "
      "#declare G = function(x,y,z) { F(x,y,z) + F(x*1.000001,y,z) } #undef F "
      "#declare F = function(x,y,z) { (G(x,y,z) + G(x*1.00001,y,z))/4 } #end ";
  const auto text = scene("", doubled + "isosurface { function { F(x,y,z) } }");
  EXPECT_THROW(render_text(text, 16, 12, {}), render::LimitExceeded);
}

}  // namespace
}  // namespace verisim::test
