// Depth, normals, ids and colours beside the picture, in one part or several, each judged by what it is.
#include "compare/layers/layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compare/layers/test_exr.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace {

using testing::HasSubstr;

constexpr int kLayerWidth = 16, kLayerHeight = 8;
using Plane = std::vector<float>;

Plane plane(float a, float b) {
  Plane out;
  for (int i = 0; i < kLayerWidth * kLayerHeight; ++i) out.push_back(a + b * static_cast<float>(i % kLayerWidth));
  return out;
}
std::vector<ExrChannel> with(std::vector<ExrChannel> channels, const std::vector<ExrChannel>& more) {
  channels.insert(channels.end(), more.begin(), more.end());
  return channels;
}
std::vector<ExrChannel> colors(const std::string& prefix, float scale = 1) {
  return {floats(prefix + "R", plane(0.2f * scale, 0)), floats(prefix + "G", plane(0.3f * scale, 0.01f)),
          floats(prefix + "B", plane(0.4f * scale, 0))};
}
ExrChannel ids(std::uint32_t first) {
  ExrChannel out{"id", std::vector<std::uint32_t>(kLayerWidth * kLayerHeight, 4'000'000'000u), true};
  out.values[5] = first;
  return out;
}

class LayersTest : public testing::Test {
 protected:
  std::vector<LayerResult> compare(const std::vector<ExrChannel>& a, const std::vector<ExrChannel>& b,
                                   const std::vector<std::string>& rules = {}) {
    return compare_parts({{"", a}}, {{"", b}}, rules);
  }
  std::vector<LayerResult> compare_parts(const std::vector<ExrPart>& a, const std::vector<ExrPart>& b,
                                         const std::vector<std::string>& rules = {}) {
    std::vector<LayerRule> parsed;
    for (const std::string& rule : rules) parsed.push_back(layer_rule(rule));
    ExrWriter(kLayerWidth, kLayerHeight, a).write(folder_.path() / "a.exr");
    ExrWriter(kLayerWidth, kLayerHeight, b).write(folder_.path() / "b.exr");
    last_ = compare_layers(folder_.path() / "a.exr", folder_.path() / "b.exr", parsed, false);
    return last_.all;
  }
  TemporaryFolder folder_;
  Layers last_;
};

TEST_F(LayersTest, ThePictureAloneHasNone) { EXPECT_TRUE(compare(colors(""), colors("", 2)).empty()); }

TEST_F(LayersTest, EachIsKnownByItsKind) {
  const auto all = with(colors(""), with(colors("albedo."), {floats("Z", plane(5, 1)), floats("N.X", plane(0, 0)),
                                                             floats("N.Y", plane(0, 0)), floats("N.Z", plane(-1, 0)),
                                                             floats("uv.U", plane(0, 1)), ids(7)}));
  std::map<std::string, std::string> kinds;
  for (const LayerResult& layer : compare(all, all)) {
    kinds[layer.name] = layer.kind;
    EXPECT_EQ(layer.status, Status::exact) << layer.name << layer.reason;
  }
  EXPECT_EQ(kinds, (std::map<std::string, std::string>{
                       {"albedo", "color"}, {"Z", "depth"}, {"N", "normal"}, {"uv", "data"}, {"id", "id"}}));
}

TEST_F(LayersTest, WhatIsWrongInOneIsFoundThere) {
  Plane depth = plane(5, 1), infinite = depth;
  for (int i = 3; i < 9; ++i) depth[static_cast<std::size_t>(i)] *= 1.01f;
  infinite[3] = HUGE_VALF;
  const auto of = [&](const Plane& z) { return with(colors(""), {floats("Z", z)}); };
  const LayerResult wrong = compare(of(plane(5, 1)), of(depth)).at(0);
  EXPECT_EQ(wrong.status, Status::differ);
  EXPECT_EQ(wrong.wrong, 6u);
  EXPECT_EQ(wrong.worst_x, 8);
  EXPECT_THAT(wrong.reason, HasSubstr("6 pixels differ, 0 may"));
  EXPECT_EQ(compare(of(plane(5, 1)), of(infinite)).at(0).status, Status::differ);
  EXPECT_EQ(compare(of(infinite), of(plane(5, 1))).at(0).status, Status::differ);
  EXPECT_EQ(compare(of(infinite), of(infinite)).at(0).status, Status::exact);
  const Verdict verdict = with_layers({Status::exact, ""}, {true, {wrong}});
  EXPECT_EQ(verdict.status, Status::differ);
  EXPECT_THAT(verdict.reason, HasSubstr("layer Z: 6 pixels"));
}

TEST_F(LayersTest, LimitsOfTheirOwn) {
  Plane depth = plane(5, 1);
  for (int i = 3; i < 9; ++i) depth[static_cast<std::size_t>(i)] *= 1.01f;
  const auto a = with(colors(""), {floats("Z", plane(5, 1)), ids(7)}),
             b = with(colors(""), {floats("Z", depth), ids(8)});
  EXPECT_EQ(compare(a, b, {"Z:relative=0.02", "id:pixels=1"}).at(0).status, Status::match);
  EXPECT_EQ(compare(a, b, {"Z:relative=0.02", "id:pixels=1"}).at(1).status, Status::match);
  EXPECT_EQ(compare(a, b, {"Z:relative=0.001"}).at(0).status, Status::differ);
  EXPECT_EQ(compare(a, b, {"Z:relative=0.001, absolute=0.2"}).at(0).status, Status::match);
  EXPECT_EQ(compare(a, b, {"Z:relative=0.001,pixels=6"}).at(0).status, Status::match);
  EXPECT_TRUE(compare(a, b, {"[Zi]*:ignore"}).empty());
  EXPECT_EQ(compare(a, b, {"Z:max_rmse=1"}).at(0).reason, "max_rmse is a limit for colours");
  for (const char* bad : {"Z", "Z:", ":ignore", "Z:relative", "Z:relative=x", "Z:relative=-1", "Z:max_nonsense=1"})
    EXPECT_THROW(layer_rule(bad), std::invalid_argument) << bad;
}

TEST_F(LayersTest, LargeIdsAreToldApart) {
  const auto of = [&](std::uint32_t id) { return with(colors(""), {ids(id)}); };
  EXPECT_EQ(compare(of(4'000'000'001u), of(4'000'000'002u)).at(0).wrong, 1u);
}

TEST_F(LayersTest, ColorsAreJudgedAsPictures) {
  const auto of = [&](float scale) { return with(colors(""), colors("diffuse.", scale)); };
  const LayerResult wrong = compare(of(1), of(1.1f)).at(0);
  EXPECT_EQ(wrong.status, Status::differ);
  EXPECT_THAT(wrong.reason, HasSubstr("within_1_pct"));
  EXPECT_EQ(compare(of(1), of(1.1f), {"diffuse:max_rmse=20"}).at(0).status, Status::match);
  EXPECT_THAT(compare(of(1), of(1.1f), {"diffuse:max_rmse=1"}).at(0).reason, HasSubstr("rmse"));
}

TEST_F(LayersTest, WithoutColorsOnlyLayersCount) {
  const std::vector<ExrChannel> depth{floats("Z", plane(5, 1)), ids(7)};
  EXPECT_EQ(compare(depth, depth).size(), 2u);
  EXPECT_EQ(with_layers({Status::differ, "nonsense"}, last_).status, Status::exact);
  compare(colors("diffuse."), colors("diffuse."));
  EXPECT_TRUE(last_.picture) << "the first colours there are";
}

TEST_F(LayersTest, AddedAndLostOnesAreFailures) {
  const auto plain = colors(""), deep = with(colors(""), {floats("Z", plane(5, 1))});
  EXPECT_EQ(compare(deep, plain).at(0).status, Status::removed);
  EXPECT_EQ(compare(plain, deep).at(0).status, Status::added);
  EXPECT_EQ(with_layers({Status::exact, ""}, last_).status, Status::differ);
  const LayerResult other =
      compare(with(plain, {floats("N.X", plane(0, 0))}), with(plain, {floats("N.Y", plane(0, 0))})).at(0);
  EXPECT_EQ(other.reason, "its channels are X and Y");
}

TEST_F(LayersTest, PartsAreLayers) {
  const auto of = [&](float left, float depth) {
    return std::vector<ExrPart>{
        {"main", colors("")}, {"left", colors("", left)}, {"geometry", {floats("Z", plane(5, depth)), ids(7)}}};
  };
  const std::vector<LayerResult> same = compare_parts(of(1, 1), of(1, 1));
  ASSERT_EQ(same.size(), 3u);
  EXPECT_EQ(same[0].name, "left");
  EXPECT_EQ(same[1].name, "geometry/Z");
  EXPECT_EQ(same[2].name, "geometry/id");
  for (const LayerResult& layer : same) EXPECT_EQ(layer.status, Status::exact) << layer.name << layer.reason;
  const std::vector<LayerResult> wrong = compare_parts(of(1, 1), of(1.2f, 2));
  EXPECT_EQ(wrong[0].status, Status::differ);
  EXPECT_EQ(wrong[1].status, Status::differ);
  EXPECT_EQ(wrong[2].status, Status::exact);
}

TEST_F(LayersTest, DamagedFilesAreNamed) {
  ExrWriter(kLayerWidth, kLayerHeight, {{"", with(colors(""), {ids(1)})}}).write(folder_.path() / "a.exr");
  std::filesystem::copy_file(folder_.path() / "a.exr", folder_.path() / "b.exr");
  std::filesystem::resize_file(folder_.path() / "b.exr", std::filesystem::file_size(folder_.path() / "b.exr") / 2);
  try {
    compare_layers(folder_.path() / "a.exr", folder_.path() / "b.exr", {}, false);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("b.exr"));
  }
}

}  // namespace
}  // namespace verisim::compare
