// Formats whose libraries we call: what their readers make of every depth, and that memory holds no more than the
// file's samples. The files are made here.
#include <gtest/gtest.h>
#include <half.h>
#include <cstdio>
// jpeglib.h needs the header above.
#include <jpeglib.h>
#include <png.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>

#include "tracer/base/sanitizers.h"
#include "tracer/image/gamma.h"
#include "tracer/image/image.h"
#include "tracer/image/module/module.h"

namespace verisim::image {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

ImageDecoding data() {
  ImageDecoding d;
  d.data = true;
  return d;
}

Bytes random_bytes(std::size_t count) {
  std::mt19937 random(7);
  Bytes bytes(count);
  for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random());
  return bytes;
}

class ImageFormats : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("verisim_formats_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // 9 x 7 pixels of noise.
  fs::path put_jpeg(int components, J_COLOR_SPACE space, bool progressive = false) {
    const fs::path path = folder_ / "a.jpg";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), std::fclose);
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    jpeg_stdio_dest(&jpeg, file.get());
    jpeg.image_width = 9, jpeg.image_height = 7;
    jpeg.input_components = components;
    jpeg.in_color_space = components == 1 ? JCS_GRAYSCALE : components == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_colorspace(&jpeg, space);
    if (progressive) jpeg_simple_progression(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    Bytes pixels = random_bytes(9 * 7 * 4);
    while (jpeg.next_scanline < 7) {
      JSAMPROW row = &pixels[jpeg.next_scanline * 9 * static_cast<unsigned>(components)];
      jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    return path;
  }
  // What libjpeg itself makes of it.
  static Bytes decoded_jpeg(const fs::path& path, J_COLOR_SPACE space, std::size_t components) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_decompress(&jpeg);
    jpeg_stdio_src(&jpeg, file.get());
    jpeg_read_header(&jpeg, TRUE);
    jpeg.out_color_space = space;
    jpeg_start_decompress(&jpeg);
    Bytes pixels(9 * 7 * components);
    while (jpeg.output_scanline < 7) {
      JSAMPROW row = &pixels[jpeg.output_scanline * 9 * components];
      jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_destroy_decompress(&jpeg);
    return pixels;
  }

  // Through OpenImageIO, in the format of the name's extension.
  fs::path put(const std::string& name, int channels, VerisimSample sample, void* pixels, bool premultiplied = false) {
    const fs::path path = folder_ / name;
    const VerisimImage picture{9, 7, channels, sample, pixels, premultiplied};
    const VerisimWriteOptions options{&picture, nullptr, 0, 0, 0, nullptr, nullptr, nullptr};
    char error[256] = "";
    if (image_module().write(path.c_str(), &options, error, sizeof error) != 0) throw std::runtime_error(error);
    return path;
  }
  fs::path put(const std::string& name, const Bytes& bytes) {
    const fs::path path = folder_ / name;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
  }
  fs::path put_png(int size, int type, int bits, const std::function<std::uint8_t(std::size_t)>& byte) {
    const fs::path path = folder_ / "a.png";
    std::FILE* file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    const auto side = static_cast<png_uint_32>(size);
    png_set_IHDR(png, info, side, side, bits, type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 1);
    png_write_info(png, info);
    Bytes row(png_get_rowbytes(png, info));
    for (int y = 0; y < size; ++y) {
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = byte(static_cast<std::size_t>(y) * row.size() + i);
      png_write_row(png, row.data());
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
    return path;
  }

  fs::path folder_;
};

TEST_F(ImageFormats, JpegsAreTheBytesOfTheLibrary) {
  for (const bool progressive : {false, true})
    for (const int channels : {1, 3}) {
      const fs::path path = put_jpeg(channels, channels == 1 ? JCS_GRAYSCALE : JCS_YCbCr, progressive);
      const Bytes expected =
          decoded_jpeg(path, channels == 1 ? JCS_GRAYSCALE : JCS_RGB, static_cast<std::size_t>(channels));
      const auto raw = load_image(path, ImageType::jpeg, data()), seen = load_image(path, ImageType::jpeg, {});
      ASSERT_EQ(raw->samples.type(), SampleType::byte);
      ASSERT_EQ(raw->samples.memory(), expected.size());
      EXPECT_EQ(raw->grey, channels == 1);
      for (std::size_t i = 0; i < 63; ++i) {
        const int x = static_cast<int>(i % 9), y = static_cast<int>(i / 9);
        const float blue = static_cast<float>(expected[(i + 1) * static_cast<std::size_t>(channels) - 1]) / 255.0f;
        EXPECT_EQ(raw->at(x, y).b, blue);
        EXPECT_EQ(seen->at(x, y).b, srgb_decode(blue));
      }
    }
}

TEST_F(ImageFormats, InksOfJpegsAreMultiplied) {
  for (const J_COLOR_SPACE space : {JCS_CMYK, JCS_YCCK}) {
    const fs::path path = put_jpeg(4, space);
    const Bytes inks = decoded_jpeg(path, JCS_CMYK, 4);
    const auto image = load_image(path, ImageType::jpeg, data());
    EXPECT_EQ(image->samples.memory(), 3u * 63u);
    for (std::size_t i = 0; i < 63; ++i) {
      const Color c = image->at(static_cast<int>(i % 9), static_cast<int>(i / 9));
      EXPECT_EQ(std::lround(c.g * 255), std::lround(inks[4 * i + 1] * inks[4 * i + 3] / 255.0));
    }
  }
}

// POV-Ray refuses them, too: even one without its last byte.
TEST_F(ImageFormats, JpegsThatEndTooSoonAreErrors) {
  const fs::path path = put_jpeg(3, JCS_YCbCr);
  std::ifstream file(path, std::ios::binary);
  const Bytes whole{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THROW(load_image(put("cut.jpg", Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(n))),
                            ImageType::jpeg, {}),
                 std::runtime_error)
        << n;
}

// Their own plug-ins and OpenImageIO's must agree.
TEST_F(ImageFormats, PlugInsReadTheSameSamples) {
  const Bytes noise = random_bytes(9 * 7 * 4 * 4);
  std::vector<float> reals;
  for (std::size_t i = 0; i < 9 * 7 * 4; ++i) reals.push_back(static_cast<float>(noise[i]) / 100);
  for (const char* extension : {".tif", ".exr"})
    for (const int channels : {1, 2, 3, 4})
      for (const VerisimSample sample : {kVerisimUint8, kVerisimUint16, kVerisimHalf, kVerisimFloat}) {
        const bool exr = std::string(extension) == ".exr", real = sample == kVerisimHalf || sample == kVerisimFloat;
        if (exr != real && !(sample == kVerisimFloat)) continue;
        SCOPED_TRACE(std::string(extension) + " " + std::to_string(channels) + " " + std::to_string(sample));
        void* pixels = real ? static_cast<void*>(reals.data()) : const_cast<std::uint8_t*>(noise.data());
        const fs::path path = put(std::string("b") + extension, channels, sample, pixels, exr);
        VerisimImage own{}, general{};
        char error[256] = "";
        const Module &special = image_module(exr ? ModuleKind::exr : ModuleKind::tiff), &all = image_module();
        const int status = special.read(path.c_str(), 1000, &own, error, sizeof error);
        if (status == kVerisimLeft) {
          EXPECT_TRUE(exr && channels <= 2);  // OpenImageIO names such channels as it likes
          continue;
        }
        ASSERT_EQ(status, kVerisimDone) << error;
        ASSERT_EQ(all.read(path.c_str(), 1000, &general, error, sizeof error), kVerisimDone) << error;
        EXPECT_EQ(own.channels, general.channels);
        EXPECT_EQ(own.premultiplied, general.premultiplied);
        EXPECT_EQ(own.sample, sample);
        for (std::size_t i = 0; i < 63 * static_cast<std::size_t>(channels); ++i) {
          const auto value = [&](const VerisimImage& image) -> double {
            switch (image.sample) {
              case kVerisimUint8:
                return static_cast<const std::uint8_t*>(image.pixels)[i];
              case kVerisimUint16:
                return static_cast<const std::uint16_t*>(image.pixels)[i];
              case kVerisimHalf:
                return imath_half_to_float(static_cast<const std::uint16_t*>(image.pixels)[i]);
              default:
                return static_cast<const float*>(image.pixels)[i];
            }
          };
          ASSERT_EQ(value(own), value(general)) << i;
        }
        special.free(&own);
        all.free(&general);
      }
}

TEST_F(ImageFormats, StraightAlphaOfTiffsIsMultiplied) {
  Bytes pixels = random_bytes(9 * 7 * 4);
  const auto image = load_image(put("c.tif", 4, kVerisimUint8, pixels.data()), ImageType::tiff, {});
  EXPECT_TRUE(image->premultiplied);
  EXPECT_EQ(image->samples.memory(), pixels.size());
  const float red = static_cast<float>(pixels[0]) / 255.0f, alpha = static_cast<float>(pixels[3]) / 255.0f;
  EXPECT_EQ(image->at(0, 0).r, std::floor(red * alpha * 255.0f + 0.5f) / 255.0f);
  EXPECT_EQ(image->at(0, 0).t, 1 - alpha);
}

TEST_F(ImageFormats, HalvesStayHalves) {
  std::vector<float> pixels;
  for (int i = 0; i < 9 * 7 * 4; ++i) pixels.push_back(static_cast<float>(i) / 64);
  ImageDecoding gamma;
  gamma.working_gamma = 2.2;
  const fs::path path = put("d.exr", 4, kVerisimHalf, pixels.data(), true);
  const auto image = load_image(path, ImageType::exr, gamma);
  EXPECT_EQ(image->samples.type(), SampleType::half);
  EXPECT_EQ(image->samples.memory(), 2 * pixels.size());
  EXPECT_EQ(image->at(2, 0).g, Curve::power(1 / static_cast<double>(2.2f)).decode(pixels[9]));
  EXPECT_EQ(image->at(2, 0).t, 1 - pixels[11]);
}

// 1 x 1, one bit: a layout that only OpenImageIO reads.
TEST_F(ImageFormats, OtherTiffsAreLeftToOpenImageIo) {
  const Bytes tiff = {'I', 'I', 42, 0, 8, 0, 0, 0, 8,   0,                    // eight tags at 8
                      0,   1,   3,  0, 1, 0, 0, 0, 1,   0, 0, 0,              // width
                      1,   1,   3,  0, 1, 0, 0, 0, 1,   0, 0, 0,              // height
                      2,   1,   3,  0, 1, 0, 0, 0, 1,   0, 0, 0,              // bits
                      3,   1,   3,  0, 1, 0, 0, 0, 1,   0, 0, 0,              // not compressed
                      6,   1,   3,  0, 1, 0, 0, 0, 1,   0, 0, 0,              // 0 is black
                      17,  1,   4,  0, 1, 0, 0, 0, 110, 0, 0, 0,              // where its strip is
                      22,  1,   3,  0, 1, 0, 0, 0, 1,   0, 0, 0,              // rows of a strip
                      23,  1,   4,  0, 1, 0, 0, 0, 1,   0, 0, 0, 0, 0, 0, 0,  // bytes of it; the end
                      128};
  const fs::path path = put("e.tif", tiff);
  VerisimImage image{};
  char error[256];
  EXPECT_EQ(image_module(ModuleKind::tiff).read(path.c_str(), 1000, &image, error, sizeof error), kVerisimLeft);
  EXPECT_EQ(load_image(path, ImageType::tiff, data())->at(0, 0).r, 1);
}

TEST_F(ImageFormats, PngsOfSixteenBits) {
  const auto byte = [](std::size_t i) { return static_cast<std::uint8_t>(i * 37); };
  const fs::path path = put_png(5, PNG_COLOR_TYPE_RGB_ALPHA, 16, byte);
  const auto raw = load_image(path, ImageType::png, data()), seen = load_image(path, ImageType::png, {});
  EXPECT_EQ(raw->samples.memory(), 25u * 8u);
  const auto code = [&](std::size_t k) { return static_cast<float>(byte(2 * k) << 8 | byte(2 * k + 1)) / 65535.0f; };
  EXPECT_EQ(raw->at(1, 1).g, code(25));
  EXPECT_EQ(seen->at(1, 1).g, srgb_decode(code(25)));
  EXPECT_EQ(raw->at(1, 1).t, 1 - code(27));
}

TEST_F(ImageFormats, SamplesOutOfRangeOfPixmaps) {
  const std::string text = "P3\n2 1 100\n250 100 50  70000 0 1\n";
  const auto image = load_image(put("f.ppm", Bytes(text.begin(), text.end())), ImageType::ppm, data());
  EXPECT_EQ(image->at(0, 0).r, 2.5f);
  EXPECT_EQ(image->at(1, 0).r, 700.0f);
  const std::string binary = std::string("P5\n1 1 100\n") + static_cast<char>(200);
  EXPECT_EQ(load_image(put("g.pgm", Bytes(binary.begin(), binary.end())), ImageType::pgm, data())->at(0, 0).r, 2.0f);
}

// Peak memory that loading takes in a process of its own, in bytes a pixel.
double bytes_a_pixel(const fs::path& path, double pixels) {
  const auto peak = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
  };
  int channel[2];
  if (::pipe(channel) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    const double before = peak();
    const auto image = load_image(path, ImageType::unknown, {});
    const double taken = peak() - before;
    const bool sent = ::write(channel[1], &taken, sizeof taken) == sizeof taken;
    ::_exit(sent && image ? 0 : 1);
  }
  double taken = -1;
  const bool got = ::read(channel[0], &taken, sizeof taken) == sizeof taken;
  ::close(channel[0]), ::close(channel[1]);
  ::waitpid(child, nullptr, 0);
  return got ? taken / pixels : -1;
}

TEST_F(ImageFormats, EightBitsTakeThreeBytesAPixel) {
#ifdef VERISIM_SANITIZED
  GTEST_SKIP() << "sanitizers keep memory of their own";
#endif
  constexpr int kSide = 4096;
  const fs::path path =
      put_png(kSide, PNG_COLOR_TYPE_RGB, 8, [](std::size_t i) { return static_cast<std::uint8_t>(i); });
  const double taken = bytes_a_pixel(path, double{kSide} * kSide);
  EXPECT_GE(taken, 2.5);  // or nothing was measured: what the process had free may be used again
  EXPECT_LE(taken, 3.5);  // the decoder's own memory and the ends of large pages are part of it
}

}  // namespace
}  // namespace verisim::image
