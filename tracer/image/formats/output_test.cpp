#include "tracer/image/output.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "tracer/image/gamma.h"

namespace verisim::image {
namespace {

render::Framebuffer filled(int width, int height, const Color& color) {
  return {width, height, std::vector<Color>(static_cast<std::size_t>(width) * height, color), {}};
}

std::vector<int> codes(const Color& color, const OutputOptions& options) {
  const Quantised q = quantise(filled(1, 1, color), options);
  return {q.samples.begin(), q.samples.end()};
}

OutputOptions linear_file() {
  OutputOptions options;
  options.file_srgb = false;
  options.file_gamma = 1;
  return options;
}

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("verisim_output_test_" + std::to_string(::getpid()) + "_" + name);
}

using Codes = std::vector<int>;

// Spec 02 probe P7: background {rgb <.5,.25,.003>}.
struct GammaCase {
  const char* name;
  scene::Gamma working;
  double working_gamma;
  bool file_srgb;
  double file_gamma;
  Codes eight, sixteen;
};
class GammaProbe : public testing::TestWithParam<GammaCase> {};

TEST_P(GammaProbe, GivesPovRaysCodes) {
  const GammaCase& c = GetParam();
  OutputOptions options;
  options.working = c.working, options.working_gamma = c.working_gamma, options.file_srgb = c.file_srgb,
  options.file_gamma = c.file_gamma;
  EXPECT_EQ(codes({.5f, .25f, .003f}, options), c.eight);
  options.bits = 16;
  const Codes sixteen = codes({.5f, .25f, .003f}, options);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sixteen[i], c.sixteen[i], 1) << i;
}
INSTANTIATE_TEST_SUITE_P(
    Output, GammaProbe,
    testing::Values(GammaCase{"linear", scene::Gamma::power, 1, true, 1, {188, 137, 10}, {48192, 35199, 2540}},
                    GammaCase{"linear_file1", scene::Gamma::power, 1, false, 1, {128, 64, 1}, {32768, 16384, 197}},
                    GammaCase{
                        "linear_file22", scene::Gamma::power, 1, false, 2.2, {186, 136, 18}, {47824, 34899, 4674}},
                    GammaCase{"g22", scene::Gamma::power, 2.2, true, 1, {128, 61, 0}, {33021, 15797, 2}},
                    GammaCase{"g22_file1", scene::Gamma::power, 2.2, false, 1, {55, 12, 0}, {14263, 3104, 0}},
                    GammaCase{"srgb", scene::Gamma::srgb, 1, true, 1, {128, 64, 1}, {32768, 16384, 197}},
                    GammaCase{"none", scene::Gamma::none, 1, true, 1, {128, 64, 1}, {32768, 16384, 197}}),
    [](const auto& i) { return std::string(i.param.name); });

TEST(Quantise, ClampsAndTreatsNanAsZero) {
  EXPECT_EQ(codes({-1, 2, std::nanf("")}, linear_file()), (Codes{0, 255, 0}));
}

TEST(Quantise, TableAgreesWithFormulaOnARamp) {
  OutputOptions table, formula;
  formula.dither = Dither::bayer2;  // not the table; pixel (0,0) is shifted by rank 1: -0.25 codes
  for (int i = 0; i <= 4096; ++i) {
    const float x = static_cast<float>(i) / 4096;
    const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
    EXPECT_EQ(codes({x, x, x}, table)[0], static_cast<int>(std::floor(encoded * 255 + 0.5f))) << x;
    EXPECT_EQ(codes({x, x, x}, formula)[0], std::max(0, static_cast<int>(std::floor(encoded * 255 + 0.25f)))) << x;
  }
}

TEST(Quantise, FineCodesAgreeWithTheFormula) {
  constexpr int kCount = 1 << 16;
  render::Framebuffer picture = filled(kCount, 1, {});
  std::mt19937 random{3};
  std::uniform_real_distribution<float> linear(-0.1f, 1.1f), exponent(-20, 0);
  for (int i = 0; i < kCount; ++i) {
    const float x = i % 2 ? linear(random) : std::exp2(exponent(random));
    picture.at(i, 0) =
        Color{x, i == 4 ? std::nanf("") : 1 - x, i == 4 ? 1 : 0.003f + 0.0003f * x};  // with the knee of sRGB's curve
  }
  for (const GammaCase& c : {GammaCase{"", scene::Gamma::power, 1, true, 1, {}, {}},
                             GammaCase{"", scene::Gamma::power, 1, false, 2.2, {}, {}},
                             GammaCase{"", scene::Gamma::power, 2.2, true, 1, {}, {}},
                             GammaCase{"", scene::Gamma::srgb, 1, false, 1.8, {}, {}},
                             GammaCase{"", scene::Gamma::none, 1, false, 5, {}, {}},
                             GammaCase{"", scene::Gamma::none, 1, true, 1, {}, {}}}) {
    OutputOptions options;
    options.working = c.working, options.working_gamma = c.working_gamma, options.file_srgb = c.file_srgb,
    options.file_gamma = c.file_gamma;
    const OutputCurve curve(c.working, c.working_gamma, c.file_srgb ? Curve::srgb() : Curve::power(c.file_gamma));
    for (const int bits : {5, 8, 9, 12, 16}) {
      options.bits = bits;
      const int max_value = (1 << bits) - 1;
      const Quantised q = quantise(picture, options);
      for (int i = 0; i < kCount; ++i) {
        const Color& color = picture.at(i, 0);
        const float values[3] = {color.r, color.g, color.b};
        for (int k = 0; k < 3; ++k) {
          const float encoded = curve.encode(values[k]), clipped = encoded > 0 ? std::min(encoded, 1.0f) : 0.0f;
          const int code = static_cast<int>(std::floor(clipped * static_cast<float>(max_value) + 0.5f));
          ASSERT_EQ(q.samples[static_cast<std::size_t>(3 * i + k)] >> ((bits <= 8 ? 8 : 16) - bits), code)
              << values[k] << " with " << bits << " bits";
        }
      }
    }
  }
}

// Spec 02 probe P10.
TEST(Quantise, GreyscaleAndBitDepths) {
  const Color c{.5f, .25f, .125f};
  OutputOptions grey;
  grey.greyscale = true;
  EXPECT_EQ(codes(c, grey), (Codes{38837}));
  OutputOptions grey_linear = linear_file();
  grey_linear.greyscale = true;
  EXPECT_EQ(codes(c, grey_linear), (Codes{20316}));
  OutputOptions five;
  five.bits = 5;
  EXPECT_EQ(codes(c, five), (Codes{189, 140, 99}));
  OutputOptions twelve;
  twelve.bits = 12;
  EXPECT_EQ(codes(c, twelve), (Codes{48187, 35192, 25462}));
  OutputOptions ppm;
  ppm.format = Format::ppm, ppm.greyscale = true;
  EXPECT_EQ(codes(c, ppm), (Codes{0x4F}));
}

// Spec 02 probe P8 and section 4.5.
TEST(Quantise, StraightAlphaKeepsHighlights) {
  OutputOptions options = linear_file();
  options.alpha = true;
  EXPECT_EQ(codes({1.14f, 0, 0, 0, .81f}, options), (Codes{255, 0, 0, 86}));
  EXPECT_EQ(codes({0, 0, 0, 0, 1}, options), (Codes{0, 0, 0, 0}));
  EXPECT_EQ(codes({.6f, .3f, .15f, 0, .25f}, options), (Codes{204, 102, 51, 191}));
  options.alpha = false;
  EXPECT_EQ(codes({.6f, .3f, .15f, 0, .25f}, options), (Codes{153, 77, 38}));
}

// Spec 02 probe P9: background {rgb .4981}, 6x6, File_Gamma 1: which pixels are 128 (127 elsewhere).
TEST(Quantise, Dithering) {
  const auto bright = [](Dither dither) {
    OutputOptions options = linear_file();
    options.dither = dither;
    const Quantised q = quantise(filled(6, 6, {.4981f, .4981f, .4981f}), options);
    std::vector<std::pair<int, int>> out;
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x)
        if (const int v = q.samples[3 * (6 * y + x)]; v != 127) {
          EXPECT_EQ(v, 128);
          out.emplace_back(x, y);
        }
    return out;
  };
  using Pixels = std::vector<std::pair<int, int>>;
  EXPECT_EQ(bright(Dither::none), Pixels{});
  EXPECT_EQ(bright(Dither::bayer2), (Pixels{{1, 0}, {3, 0}, {5, 0}, {1, 2}, {3, 2}, {5, 2}, {1, 4}, {3, 4}, {5, 4}}));
  EXPECT_EQ(bright(Dither::bayer3), (Pixels{{1, 2}, {4, 2}, {1, 5}, {4, 5}}));
  EXPECT_EQ(bright(Dither::bayer4), (Pixels{{3, 0}, {3, 4}}));
  EXPECT_EQ(bright(Dither::diffusion1d), (Pixels{{2, 5}}));
  EXPECT_EQ(bright(Dither::diffusion2d), Pixels{});
  EXPECT_EQ(bright(Dither::floyd_steinberg), Pixels{});
}

TEST(Files, PngRoundTripKeepsEverySample) {
  render::Framebuffer frame = filled(5, 3, {});
  for (int i = 0; i < 15; ++i) frame.pixels[i] = Color{i / 15.0f, 1 - i / 15.0f, .3f, 0, i / 30.0f};
  for (int bits : {8, 16}) {
    for (bool alpha : {false, true}) {
      OutputOptions options;
      options.bits = bits, options.alpha = alpha;
      const auto path = scratch("round.png");
      write(frame, path, options);
      const Quantised expected = quantise(frame, options);
      const Picture got = read_picture(path);
      ASSERT_EQ(got.channels, alpha ? 4 : 3);
      ASSERT_EQ(got.bits, bits);
      ASSERT_EQ(got.samples.size(), expected.samples.size());
      for (std::size_t i = 0; i < got.samples.size(); ++i)
        EXPECT_EQ(std::lround(got.samples[i] * static_cast<float>((1 << bits) - 1)), expected.samples[i]) << i;
      std::filesystem::remove(path);
    }
  }
}

TEST(Files, PpmRoundTrip) {
  for (int bits : {8, 16}) {
    OutputOptions options;
    options.format = Format::ppm, options.bits = bits;
    options.metadata["Comment"] = "two\nlines";
    const auto path = scratch("round.ppm");
    write(filled(3, 2, {.5f, .25f, .125f}), path, options);
    const Picture got = read_picture(path);
    EXPECT_EQ(got.width, 3);
    EXPECT_EQ(got.bits, bits);
    EXPECT_NEAR(got.samples[0], 0.735f, 0.003f);
    std::filesystem::remove(path);
  }
}

// With File_Gamma linear, what comes back is what was quantised; EXR and HDR keep linear light.
TEST(Files, OtherFormatsRoundTrip) {
  const std::pair<Format, const char*> formats[] = {
      {Format::tga, "r.tga"}, {Format::tga_rle, "rle.tga"}, {Format::bmp, "r.bmp"}, {Format::jpeg, "r.jpg"},
      {Format::exr, "r.exr"}, {Format::hdr, "r.hdr"},       {Format::tiff, "r.tif"}};
  for (const auto& [format, name] : formats) {
    OutputOptions options = linear_file();
    options.format = format;
    const auto path = scratch(name);
    write(filled(8, 8, {.5f, .25f, .75f}), path, options);
    const Picture got = read_picture(path);
    EXPECT_EQ(got.width, 8) << name;
    EXPECT_EQ(got.channels, 3) << name;
    EXPECT_EQ(got.is_float, format == Format::exr || format == Format::hdr) << name;
    EXPECT_NEAR(got.samples[0], .5f, .01f) << name;
    EXPECT_NEAR(got.samples[1], .25f, .01f) << name;
    EXPECT_NEAR(got.samples[2], .75f, .01f) << name;
    std::filesystem::remove(path);
  }
}

TEST(Files, FailuresNameTheFileAndLeaveNothingBehind) {
  const auto path = scratch("no_such_folder") / "a.png";
  try {
    write(filled(1, 1, {}), path, {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("a.png"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Files, CorruptPicturesAreErrors) {
  const auto path = scratch("bad.png");
  for (const std::string& bytes :
       {std::string(), std::string("P6 1000000 1000000 255\n"), std::string("P5 3 3 0\n"), std::string("garbage"),
        std::string("P6\n99999999999 1 1"), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\xff\xff", 18),
        std::string("\x89PNG\r\n\x1a\n")}) {
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_THROW(read_picture(path), std::runtime_error);
  }
  std::filesystem::remove(path);
}

// Measured from POV-Ray 3.7.0.10 with constant backgrounds: mantissas are truncated, a Bayer offset counts in
// mantissas.
TEST(Hdr, MantissasAreTruncatedAndDithered) {
  const auto mantissas = [](float value, Dither dither) {
    render::Framebuffer frame;
    frame.width = 12, frame.height = 4;
    frame.pixels.assign(48, Color(value, value / 2, 0, 0, 0));
    OutputOptions options;
    options.format = Format::hdr;
    options.dither = dither;
    const std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) / ("dither_" + std::to_string(::getpid()) + ".hdr");
    write(frame, path, options);
    const Picture picture = read_picture(path);
    std::filesystem::remove(path);
    std::vector<int> red;
    for (int x = 0; x < 4; ++x) red.push_back(static_cast<int>(picture.samples[static_cast<std::size_t>(x) * 3] * 256));
    return red;
  };
  EXPECT_EQ(mantissas(153.95f / 256, Dither::none), (std::vector<int>{153, 153, 153, 153}));
  EXPECT_EQ(mantissas(153.05f / 256, Dither::bayer2), (std::vector<int>{152, 153, 152, 153}));
  EXPECT_EQ(mantissas(153.55f / 256, Dither::bayer2), (std::vector<int>{153, 154, 153, 154}));
  EXPECT_EQ(mantissas(153.05f / 256, Dither::bayer3), (std::vector<int>{152, 153, 152, 152}));
  EXPECT_EQ(mantissas(153.55f / 256, Dither::bayer4), (std::vector<int>{153, 153, 153, 154}));
}

}  // namespace
}  // namespace verisim::image
