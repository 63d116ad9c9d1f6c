// Scenes from memory: files, values and meshes that a program gives.
#include "parser/source/memory_file.h"

#include <gmock/gmock.h>

#include <clocale>

#include "parser/language/test_support.h"
#include "parser/scene/shapes/mesh/mesh_arrays.h"

namespace verisim::parser {
namespace {

using testing::run;

TEST(MemoryFile, IncludesAndDataAreReadByName) {
  ParseOptions options;
  options.files["part.inc"] = std::make_shared<MemoryFile>("#declare A = 7;");
  options.files["data/numbers.txt"] = std::make_shared<MemoryFile>("1.5, 2");
  const auto out =
      run("#include \"part\" #fopen F \"./data/numbers.txt\" read #read(F, B) #debug str(A + B, 0, 1)", options);
  EXPECT_EQ(out.error, "");
  EXPECT_EQ(out.text, "8.5");
  EXPECT_TRUE(out.result.files_read.empty());
  EXPECT_NE(run("#fopen F \"part.inc\" write", options).error, "");
}

TEST(MemoryFile, AnErrorInsideNamesTheFile) {
  ParseOptions options;
  options.files["part.inc"] = std::make_shared<MemoryFile>("\n  sphre { 0, 1 }");
  const auto out = run("#include \"part.inc\"", options);
  ASSERT_EQ(out.result.errors.size(), 1u);
  EXPECT_EQ(out.result.errors[0].file, "part.inc");
  EXPECT_EQ(out.result.errors[0].line, 2);
  EXPECT_EQ(out.result.errors[0].column, 3);
  EXPECT_EQ(out.result.errors[0].length, 5);
}

TEST(MemoryFile, PixelsAreAnImage) {
  image::PixelArray pixels{2, 1, 3, image::Samples(image::SampleType::byte, 6)};
  const unsigned char values[] = {255, 0, 0, 0, 0, 255};
  std::copy(values, values + 6, pixels.samples.as<unsigned char>());
  ParseOptions options;
  options.files["two"] = std::make_shared<MemoryFile>(pixels);
  const auto out =
      run("#declare F = function { pigment { image_map { png \"two\" once } } } #debug str(F(0.25, 0.5, 0).red, 0, 0) "
          "#debug str(F(0.75, 0.5, 0).blue, 0, 0)",
          options);
  EXPECT_EQ(out.error, "");
  EXPECT_EQ(out.text, "11");
  EXPECT_NE(run("#include \"two\"", options).error, "");
}

TEST(DeclaredValue, EveryKind) {
  const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint32_t faces[] = {0, 1, 2};
  ParseOptions options;
  options.values = {{"N", {0.123456789}},
                    {"V", {std::vector<double>{1, 2, 3}}},
                    {"S", {std::string("text")}},
                    {"A", {DeclaredArray{{2, 2}, {{1.0}, {2.0}, {3.0}, {4.0}}}}},
                    {"M", {object_of_mesh({vertices, faces})}}};
  const auto out =
      run("#debug concat(str(N, 0, 9), \" \", str(V.z, 0, 0), S, str(A[1][0], 0, 0), \" \", "
          "str(max_extent(M).x, 0, 0)) object { M pigment { rgb 1 } }",
          options);
  EXPECT_EQ(out.error, "");
  EXPECT_EQ(out.text, "0.123456789 3text3 1");
  options.values = {{"sphere", {1.0}}};
  EXPECT_NE(run("", options).error.find("reserved"), std::string::npos);
  options.values = {{"a b", {1.0}}};
  EXPECT_NE(run("", options).error.find("identifier"), std::string::npos);
}

TEST(MeshArrays, WrongArraysAreRefused) {
  const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint32_t faces[] = {0, 1, 3}, right[] = {0, 1, 2};
  EXPECT_THROW(object_of_mesh({vertices, faces}), std::invalid_argument);
  EXPECT_THROW(object_of_mesh({std::span(vertices, 8), right}), std::invalid_argument);
  EXPECT_THROW(object_of_mesh({vertices, right, std::span(vertices, 3)}), std::invalid_argument);
}

TEST(Parse, NumbersHaveAPointInAnyLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  if (!std::setlocale(LC_NUMERIC, "de_DE.UTF-8")) GTEST_SKIP() << "no German locale here";
  EXPECT_EQ(run("#debug str(val(\"1.5\"), 0, 2)").text, "1.50");
  std::setlocale(LC_NUMERIC, before.c_str());
}

}  // namespace
}  // namespace verisim::parser
