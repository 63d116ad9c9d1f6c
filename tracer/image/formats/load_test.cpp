// Probe P14 of spec 02 section 6: how image files become working-space values. The files are made here.
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tracer/image/module/module.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

struct PngOptions {
  int type = PNG_COLOR_TYPE_RGB, bits = 8;
  double gamma = 0;  // of a gAMA chunk, 0: none
  bool srgb = false;
  std::vector<png_color> palette;
  Bytes palette_alpha;
};

class LoadImage : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("verisim_load_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path put(const std::string& name, const Bytes& bytes) {
    const fs::path path = folder_ / name;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
  }
  fs::path put(const std::string& name, const std::string& text) { return put(name, Bytes(text.begin(), text.end())); }

  // `rows`: bytes of each row as PNG stores them.
  fs::path put_png(const std::string& name, int width, const std::vector<Bytes>& rows, const PngOptions& o = {}) {
    const fs::path path = folder_ / name;
    std::FILE* file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(rows.size()), o.bits, o.type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!o.palette.empty()) png_set_PLTE(png, info, o.palette.data(), static_cast<int>(o.palette.size()));
    if (!o.palette_alpha.empty())
      png_set_tRNS(png, info, o.palette_alpha.data(), static_cast<int>(o.palette_alpha.size()), nullptr);
    if (o.gamma != 0) png_set_gAMA(png, info, o.gamma);
    if (o.srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (const Bytes& row : rows) png_write_row(png, row.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
    return path;
  }
  fs::path rgb_png(const std::string& name, const PngOptions& o = {}) {
    const Bytes row = {128, 64, 200, 128, 64, 200};
    return put_png(name, 2, {row, row}, o);
  }

  fs::path folder_;
};

Bytes indices_of(const Image& image) {
  const auto* indices = image.samples.as<std::uint8_t>();
  return {indices, indices + image.samples.size()};
}

Bytes bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

ImageDecoding version(int v, double working_gamma = 1) {
  ImageDecoding d;
  d.version = v;
  d.working_gamma = working_gamma;
  return d;
}

void expect_pixel(const fs::path& file, const ImageDecoding& d, float r, float g, float b, float tolerance = 3e-7f) {
  const auto image = load_image(file, ImageType::unknown, d);
  const Color c = image->at(0, 0);
  EXPECT_NEAR(c.r, r, tolerance) << file;
  EXPECT_NEAR(c.g, g, tolerance) << file;
  EXPECT_NEAR(c.b, b, tolerance) << file;
}

TEST_F(LoadImage, PngGammaOfVersion37) {
  PngOptions g45455, g1, srgb;
  g45455.gamma = 0.45455;
  g1.gamma = 1;
  srgb.srgb = true;
  expect_pixel(rgb_png("plain.png"), version(370), 0.215860531f, 0.051269468f, 0.577580512f);
  expect_pixel(rgb_png("g2.png", g45455), version(370), 0.219523057f, 0.047777206f, 0.585976124f);
  expect_pixel(rgb_png("g1.png", g1), version(370), 0.501960814f, 0.250980407f, 0.784313738f);
  expect_pixel(rgb_png("plain.png"), version(370, 2.2), 0.498140067f, 0.259162515f, 0.779187679f);
  expect_pixel(rgb_png("g2.png", g45455), version(370, 2.2), 0.501960814f, 0.250980407f, 0.784313738f, 1e-5f);
  ImageDecoding power = version(370);
  power.gamma = ImageGamma::power;
  power.gamma_value = 2.2;
  expect_pixel(rgb_png("plain.png"), power, 0.219519734f, 0.047775757f, 0.585973024f);
}

TEST_F(LoadImage, PngGammaBefore37) {
  PngOptions srgb;
  srgb.srgb = true;
  ImageDecoding none = version(360);
  none.working_none = true;
  expect_pixel(rgb_png("plain.png"), none, 0.501960814f, 0.250980407f, 0.784313738f);
  expect_pixel(rgb_png("srgb.png", srgb), none, 0.501960814f, 0.250980407f, 0.784313738f);
  expect_pixel(rgb_png("plain.png"), version(360), 0.501960814f, 0.250980407f, 0.784313738f);
  expect_pixel(rgb_png("srgb.png", srgb), version(360), 0.215860531f, 0.051269468f, 0.577580512f);
}

TEST_F(LoadImage, DataStayRawUnlessGammaIsGiven) {
  ImageDecoding data = version(370);
  data.data = true;
  EXPECT_NEAR(load_image(rgb_png("a.png"), ImageType::png, data)->at(0, 0).grey(), 0.386321574, 1e-6);
  data.gamma = ImageGamma::srgb;
  EXPECT_NEAR(load_image(rgb_png("a.png"), ImageType::png, data)->at(0, 0).grey(), 0.160152465, 1e-6);
}

TEST_F(LoadImage, GreyPngOfEightBitsIsTruncated) {
  PngOptions grey;
  grey.type = PNG_COLOR_TYPE_GRAY;
  expect_pixel(put_png("grey.png", 1, {{128}}, grey), version(370), 0.215686277f, 0.215686277f, 0.215686277f);
  ImageDecoding data = version(370);
  data.data = true;
  // Levels 3, 5, 127, 254 come out one step low (04 section 5.1).
  const int in[8] = {0, 1, 2, 3, 5, 127, 254, 255}, out[8] = {0, 1, 2, 2, 4, 126, 253, 255};
  Bytes row(in, in + 8);
  const auto image = load_image(put_png("levels.png", 8, {row}, grey), ImageType::png, data);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(std::lround(image->at(i, 0).r * 255), out[i]) << in[i];
  grey.bits = 4;
  const auto four = load_image(put_png("four.png", 2, {{0x3f}}, grey), ImageType::png, version(370));
  EXPECT_NEAR(four->at(0, 0).r, 0.031373, 1e-6);
  grey.bits = 16;
  expect_pixel(put_png("grey16.png", 1, {{0x80, 0x00}}, grey), version(370), 0.214048237f, 0.214048237f, 0.214048237f);
}

TEST_F(LoadImage, AlphaIsTransmit) {
  PngOptions rgba;
  rgba.type = PNG_COLOR_TYPE_RGB_ALPHA;
  const auto image = load_image(put_png("rgba.png", 1, {{128, 64, 200, 100}}, rgba), ImageType::png, version(370));
  EXPECT_NEAR(image->at(0, 0).t, 0.607843, 1e-6);
  EXPECT_TRUE(image->has_alpha);
  PngOptions palette;
  palette.type = PNG_COLOR_TYPE_PALETTE;
  palette.bits = 2;
  palette.palette = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
  palette.palette_alpha = {255, 51};
  const auto indexed = load_image(put_png("palette.png", 4, {{0x18}}, palette), ImageType::png, version(370));
  ASSERT_TRUE(indexed->indexed());
  EXPECT_EQ(indices_of(*indexed), (Bytes{0, 1, 2, 0}));
  EXPECT_NEAR(indexed->at(1, 0).t, 0.8, 1e-6);
  EXPECT_EQ(indexed->at(1, 0).g, 1);
  EXPECT_EQ(indexed->at(2, 0).t, 0);
}

TEST_F(LoadImage, PortablePixmapsAreNotDecoded) {
  const auto ppm = put("a.ppm", std::string("P6 # comment\n1 1\n255\n\x80\x40\xc8"));
  expect_pixel(ppm, version(370), 0.501960814f, 0.250980407f, 0.784313738f);
  expect_pixel(ppm, version(370, 2.2), 0.501960814f, 0.250980407f, 0.784313738f);
  expect_pixel(put("b.ppm", std::string("P3\n1 1 200\n128 64 200\n")), version(370), 0.640000045f, 0.320000023f, 1);
}

TEST_F(LoadImage, TargaAndBitmap) {
  Bytes tga = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 24, 0, 200, 64, 128};
  expect_pixel(put("a.tga", tga), version(370), 0.215860531f, 0.051269468f, 0.577580512f);
  Bytes packed = {0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 0, 0x81, 200, 64, 128};
  expect_pixel(put("b.tga", packed), version(360), 0.501960814f, 0.250980407f, 0.784313738f);
  Bytes bmp = {'B', 'M', 58, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0,   1,  0,   24,
               0,   0,   0,  0, 0, 4, 0, 0, 0, 0, 0,  0, 0, 0, 0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 200, 64, 128, 0};
  expect_pixel(put("a.bmp", bmp), version(370), 0.215860531f, 0.051269468f, 0.577580512f);
}

TEST_F(LoadImage, GifKeepsItsPalette) {
  // 2 x 1, four colours, the second transparent; LZW: clear, 1, 3, end.
  const Bytes gif = {'G', 'I', 'F', '8', '9', 'a', 2,  0,  1,    0,    0x81, 0,    0,    0, 0,   0, 255,
                     128, 64,  9,   9,   9,   10,  20, 30, 0x21, 0xf9, 4,    1,    0,    0, 1,   0, 0x2c,
                     0,   0,   0,   0,   2,   0,   1,  0,  0,    2,    2,    0xcc, 0x0a, 0, 0x3b};
  const auto image = load_image(put("a.gif", gif), ImageType::gif, version(360));
  ASSERT_TRUE(image->indexed());
  EXPECT_EQ(indices_of(*image), (Bytes{1, 3}));
  EXPECT_EQ(image->at(0, 0).r, 1);
  EXPECT_EQ(image->at(0, 0).t, 1);
  EXPECT_NEAR(image->at(1, 0).b, 30 / 255.0, 1e-6);
}

// As POV-Ray shows them: it does not put the rows of the four passes in order.
TEST_F(LoadImage, RowsOfInterlacedGifsStayInTheOrderOfTheFile) {
  const Bytes gif = {'G', 'I', 'F', '8', '9',  'a', 1, 0, 5, 0, 0x81, 0, 0, 0,    0, 0, 1,  1,  1,  2, 2,
                     2,   3,   3,   3,   0x2c, 0,   0, 0, 0, 1, 0,    5, 0, 0x40, 2, 3, 68, 52, 80, 0, 0x3b};
  EXPECT_EQ(indices_of(*load_image(put("i.gif", gif), ImageType::gif, version(360))), (Bytes{0, 1, 2, 3, 0}));
}

TEST_F(LoadImage, RadianceAddsHalfAStep) {
  Bytes hdr;
  for (const char c : std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n"))
    hdr.push_back(static_cast<std::uint8_t>(c));
  hdr.insert(hdr.end(), {128, 64, 32, 128});
  expect_pixel(put("a.hdr", hdr), version(370), 0.501953125f, 0.251953125f, 0.126953125f);
}

TEST_F(LoadImage, ModuleWritesAndReadsExr) {
  const float pixels[8] = {0.25f, 0.5f, 2, 0.5f, 1, 1, 1, 1};
  const VerisimImage picture{2, 1, 4, kVerisimFloat, const_cast<float*>(pixels), 1};
  const VerisimWriteOptions options{&picture, nullptr, 0, 0, 0, nullptr, nullptr, nullptr};
  char error[256] = "";
  const fs::path path = folder_ / "a.exr";
  ASSERT_EQ(image::image_module().write(path.c_str(), &options, error, sizeof error), 0) << error;
  const auto image = load_image(path, ImageType::exr, version(370));
  EXPECT_TRUE(image->premultiplied);
  EXPECT_NEAR(image->at(0, 0).b, 2, 1e-6);
  EXPECT_NEAR(image->at(0, 0).t, 0.5, 1e-6);
}

TEST_F(LoadImage, FilesAreReadOnceWhileTheyAreUsed) {
  const fs::path path = rgb_png("shared.png");
  const auto first = load_image(path, ImageType::png, version(370));
  EXPECT_EQ(load_image(path, ImageType::unknown, version(370)), first);
  EXPECT_EQ(load_image(path.parent_path() / "." / "shared.png", ImageType::png, version(370)), first);
  ImageDecoding raw = version(370);
  raw.data = true;
  EXPECT_NE(load_image(path, ImageType::png, raw), first);  // read in another way
  Bytes changed = bytes_of(path);
  changed.push_back(0);
  put("shared.png", changed);
  EXPECT_NE(load_image(path, ImageType::png, version(370)), first);  // another file now
}

TEST_F(LoadImage, DamagedFilesAreErrors) {
  const Bytes png = bytes_of(rgb_png("good.png"));
  const std::pair<const char*, Bytes> starts[] = {
      {"x.png", png},
      {"x.gif", {'G', 'I', 'F', '8', '9', 'a', 2, 0, 1, 0, 0x81, 0, 0}},
      {"x.tga", {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 24, 0, 1, 2, 3}},
      {"x.bmp", {'B', 'M', 58, 0,   0,   0,   0,   0,   0,   0,   54,  0, 0, 0,  40,
                 0,   0,   0,  255, 255, 255, 127, 255, 255, 255, 127, 1, 0, 24, 0}},
      {"x.ppm", {'P', '6', '\n', '9', '9', '9', '9', '9', ' ', '9', '9', '9', '9', '9', ' ', '2', '5', '5', '\n'}},
      {"x.hdr", {'#', '?', '\n', '\n', '-', 'Y', ' ', '9', '9', '9', ' ', '+', 'X', ' ', '9', '9', '9', '\n', 1}},
      {"x.jpg", {0xff, 0xd8, 0xff, 0xe0}},
  };
  for (const auto& [name, bytes] : starts)
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      const fs::path path = put(name, Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n)));
      if (std::string(name) == "x.jpg" && n > 0) continue;                   // one call of the module is enough
      if (std::string(name) == "x.png" && n + 12 >= bytes.size()) continue;  // only the end mark is missing
      EXPECT_THROW(load_image(path, ImageType::unknown, version(370)), std::runtime_error)
          << name << " cut to " << n << " bytes";
    }
  EXPECT_THROW(load_image(folder_ / "missing.png", ImageType::unknown, version(370)), std::runtime_error);
  EXPECT_THROW(load_image(folder_ / "missing.jpg", ImageType::unknown, version(370)), std::runtime_error);
  EXPECT_THROW(load_image(put("noext", Bytes{1}), ImageType::unknown, version(370)), std::runtime_error);
}

}  // namespace
}  // namespace verisim
