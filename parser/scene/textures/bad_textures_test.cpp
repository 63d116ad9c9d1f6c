// What textures make of senseless input: an error with its place, or what POV-Ray does, but never a crash, a hang or
// unbounded memory (issue of textures).
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "parser/scene/test_support.h"

namespace verisim::parser {
namespace {

namespace fs = std::filesystem;
using testing::first_error;
using testing::parse;
using testing::pigment_of;
using testing::sphere_with;

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

class BadImages : public ::testing::Test {
 protected:
  void SetUp() override {
    before_ = fs::current_path();
    folder_ = fs::temp_directory_path() / ("verisim_bad_images_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }
  static void write(const std::string& name, const std::string& bytes) {
    std::ofstream(name, std::ios::binary) << bytes;
  }
  static std::string error_of(const std::string& type, const std::string& name) {
    return first_error("sphere { 0, 1 pigment { image_map { " + type + " \"" + name + "\" } } }");
  }

  fs::path before_, folder_;
};

struct Format {
  const char *type, *extension;
};
constexpr Format kFormats[] = {{"gif", "gif"},  {"tga", "tga"}, {"png", "png"}, {"jpeg", "jpg"},
                               {"tiff", "tif"}, {"bmp", "bmp"}, {"ppm", "ppm"}, {"pgm", "pgm"},
                               {"exr", "exr"},  {"hdr", "hdr"}, {"iff", "iff"}};

TEST_F(BadImages, MissingEmptyAndCorruptFilesOfEveryFormatAreErrors) {
  std::mt19937 random(11);
  for (const Format& f : kFormats) {
    EXPECT_EQ(error_of(f.type, std::string("missing.") + f.extension),
              std::string("Cannot find file 'missing.") + f.extension + "'.")
        << f.type;
    const std::string empty = std::string("empty.") + f.extension, corrupt = std::string("corrupt.") + f.extension;
    write(empty, "");
    EXPECT_NE(error_of(f.type, empty), "") << f.type;
    std::string bytes(600, ' ');
    for (char& c : bytes) c = static_cast<char>(random());
    write(corrupt, bytes);
    EXPECT_TRUE(error_of(f.type, corrupt).starts_with(corrupt)) << f.type << ": " << error_of(f.type, corrupt);
  }
}

TEST_F(BadImages, WithoutPixelsOrTooLargeAreErrors) {
  const auto tga = [](const char* size) {
    return std::string("\0\0\2\0\0\0\0\0\0\0\0\0", 12) + std::string(size, 4) + std::string("\x18\x20", 2);
  };
  const auto bmp = [](const char* size) {
    return "BM" + std::string("\x36\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0", 16) + std::string(size, 8) +
           std::string("\1\0\x18\0", 4) + std::string(24, '\0');
  };
  const struct {
    const char *type, *name;
    std::string bytes;
  } cases[] = {{"ppm", "a.ppm", "P6\n0 0\n255\n"},
               {"ppm", "b.ppm", "P3\n0 4\n255\n"},
               {"pgm", "c.pgm", "P5\n4 0\n255\n"},
               {"ppm", "d.ppm", "P6\n100000 100000\n255\n"},
               {"ppm", "e.ppm", "P6\n-4 4\n255\n"},
               {"tga", "f.tga", tga("\0\0\0\0")},
               {"tga", "g.tga", tga("\xff\xff\xff\xff")},
               {"bmp", "h.bmp", bmp("\0\0\0\0\0\0\0\0")},
               {"bmp", "i.bmp", bmp("\xfb\xff\xff\xff\0\0\0\x80")},
               {"hdr", "j.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 0\n"},
               {"hdr", "k.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n"},
               {"gif", "l.gif", std::string("GIF89a\0\0\0\0\x80\0\0\0\0\0\0\0\0;", 20)}};
  for (const auto& c : cases) {
    write(c.name, c.bytes);
    EXPECT_TRUE(error_of(c.type, c.name).starts_with(c.name)) << c.name << ": " << error_of(c.type, c.name);
  }
  EXPECT_NE(first_error("sphere { 0, 1 pigment { image_pattern { ppm \"a.ppm\" } } }"), "");
  EXPECT_NE(first_error("sphere { 0, 1 pigment { rgb 1 } normal { bump_map { ppm \"a.ppm\" } } }"), "");
  EXPECT_NE(first_error("sphere { 0, 1 texture { material_map { ppm \"a.ppm\" texture { pigment { rgb 1 } } } } }"),
            "");
  EXPECT_NE(first_error("sphere { 0, 1 pigment { image_map { function 0, 4 { x } } } }"), "");
  EXPECT_NE(first_error("sphere { 0, 1 pigment { image_map { function 100000, 100000 { x } } } }"), "");
}

TEST_F(BadImages, DensityFilesMustHoldWhatTheySay) {
  for (const std::string& bytes :
       {std::string("\0", 1), std::string(6, '\0'), std::string(6, '\xff'), std::string("\0\2\0\2\0\2abc", 9)}) {
    write("bad.df3", bytes);
    EXPECT_NE(first_error("sphere { 0, 1 pigment { density_file df3 \"bad.df3\" } }"), "") << bytes.size();
  }
}

TEST(BadMaps, PositionsMayBeUnsortedAndOutOfRange) {
  const auto pigment = pigment_of("gradient y color_map { [2 rgb x] [-1e30 rgb y] [0.5 rgb z] [1e300 rgb 1] }");
  ASSERT_TRUE(pigment->color_map);
  EXPECT_EQ(pigment->color_map->size(), 4u);
  EXPECT_EQ((*pigment->color_map)[1].position, -1e30f);  // as written, never sorted
}

TEST(BadMaps, MoreThan256EntriesAreAnErrorAsInPovRay) {
  const std::string most = "Too many entries in map. The maximum is 256 entries per map.";
  EXPECT_EQ(first_error("sphere { 0, 1 pigment { gradient y color_map {" + repeated("[0 rgb 1]", 10000) + "} } }"),
            most);
  EXPECT_EQ(first_error("sphere { 0, 1 pigment { average pigment_map {" + repeated("[1 bozo]", 10000) + "} } }"), most);
  EXPECT_EQ(first_error("sphere { 0, 1 texture { gradient y texture_map {" + repeated("[0 pigment { bozo }]", 10000) +
                        "} } }"),
            most);
  EXPECT_EQ(first_error("sphere { 0, 1 pigment { rgb 1 } normal { gradient y normal_map {" +
                        repeated("[0 bumps]", 10000) + "} } }"),
            most);
  EXPECT_EQ(first_error("sphere { 0, 1 pigment { rgb 1 } normal { gradient y slope_map {" +
                        repeated("[0 <0, 1>]", 10000) + "} } }"),
            most);
  EXPECT_EQ(first_error("sphere { 0, 1 pigment { gradient y color_map {" + repeated("[0 rgb 1]", 256) + "} } }"), "");
}

// 100,000, so that copying all earlier layers for each one would not end in time.
TEST(BadTextures, ManyLayersAreReadInLinearTime) {
  const auto object = sphere_with(repeated("texture { pigment { rgbt 0.9 } }", 100000));
  EXPECT_EQ(object->texture->layers.size(), 100000u);
}

TEST(BadTextures, AddingALayerLeavesTheIdentifierAlone) {
  const auto scene = testing::scene_of(
      "#declare T = texture { pigment { rgb 1 } }; sphere { 0, 1 texture { T } texture { pigment { rgbt 0.5 } } } "
      "sphere { 0, 1 texture { T } }");
  EXPECT_EQ(scene.objects[0]->texture->layers.size(), 2u);
  EXPECT_EQ(scene.objects[1]->texture->layers.size(), 1u);
}

TEST(BadTextures, NestingIsLimitedWhetherWrittenOrDeclared) {
  const std::string written = "Nested deeper than 500 levels.", declared = "nested deeper than 500 levels";
  EXPECT_EQ(first_error("sphere { 0, 1 pigment {" + repeated("gradient y pigment_map {[0 ", 3000) + "rgb 1" +
                        repeated("]}", 3000) + "} }"),
            written);
  EXPECT_EQ(first_error("sphere { 0, 1 texture {" + repeated("gradient y texture_map {[0 ", 3000) +
                        "pigment { rgb 1 }" + repeated("]}", 3000) + "} }"),
            written);
  const auto loop = [](const std::string& start, const std::string& step) {
    return first_error("#declare P = " + start + "; #declare I = 0; #while (I < 300000) #declare P = " + step +
                       " #declare I = I + 1; #end");
  };
  EXPECT_TRUE(loop("pigment { rgb 1 }", "pigment { gradient y pigment_map { [0 P] } }").find(declared) !=
              std::string::npos);
  EXPECT_TRUE(loop("pigment { rgb 1 }", "pigment { checker pigment { P } pigment { rgb 1 } }").find(declared) !=
              std::string::npos);
  EXPECT_TRUE(loop("pigment { rgb 1 }", "pigment { pigment_pattern { P } }").find(declared) != std::string::npos);
  EXPECT_TRUE(loop("pigment { rgb 1 }", "pigment { uv_mapping pigment_pattern { P } }").find(declared) !=
              std::string::npos);
  EXPECT_TRUE(loop("normal { bumps }", "normal { gradient y normal_map { [0 P] } }").find(declared) !=
              std::string::npos);
  EXPECT_TRUE(loop("density { bozo }", "density { gradient y density_map { [0 P] } }").find(declared) !=
              std::string::npos);
  EXPECT_TRUE(loop("texture { pigment { rgb 1 } }", "texture { gradient y texture_map { [0 P] } }").find(declared) !=
              std::string::npos);
}

TEST(BadTextures, DoublingWithEveryLevelIsLimited) {
  const auto loop = [](const std::string& start, const std::string& step) {
    return first_error("#declare P = " + start + "; #declare I = 0; #while (I < 60) #declare P = " + step +
                       " #declare I = I + 1; #end");
  };
  EXPECT_EQ(loop("texture { pigment { rgb 1 } }", "texture { average texture_map { [1 P] [1 P] } }"),
            "Maps within maps: one point would need more than 10000000 evaluations.");
  EXPECT_EQ(loop("pigment { rgb 1 }", "pigment { gradient y pigment_map { [0 P] [1 P] } }"),
            "Maps within maps: one point would need more than 10000000 evaluations.");
}

TEST(BadTextures, DeclaringAnIdentifierByItselfUsesTheOldOne) {
  const auto pigment = pigment_of(
      "P", "#declare P = pigment { rgb 1 }; #declare P = pigment { gradient y pigment_map { [0 P] [1 P] } }");
  ASSERT_TRUE(pigment->pigment_map);
  EXPECT_EQ((*pigment->pigment_map)[0].value->pattern.kind, scene::PatternKind::plain);
}

}  // namespace
}  // namespace verisim::parser
