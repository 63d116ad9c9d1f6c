#include "tools/spectra/spectrum.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tools/spectra/cornell_box.h"

namespace verisim::spectra {
namespace {

void expect_near(const Triple& got, const Triple& want, double tolerance) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], tolerance) << "channel " << c;
}

TEST(Observer, SumsAreThoseOfThePublishedTable) {
  // Totals of the 5 nm table in Wyszecki and Stiles: an error in one digit of one entry shows here.
  Triple sum{};
  for (const Triple& row : observer())
    for (std::size_t c = 0; c < 3; ++c) sum[c] += row[c];
  expect_near(sum, {21.3714, 21.3711, 21.3715}, 5e-5);
}

TEST(Observer, WhitesHaveTheirPublishedChromaticity) {
  const auto xy = [](const Triple& t) { return std::pair(t[0] / (t[0] + t[1] + t[2]), t[1] / (t[0] + t[1] + t[2])); };
  const auto [x, y] = xy(integrate(power(Illuminant::d65), {}));
  EXPECT_NEAR(x, 0.31272, 1e-4);
  EXPECT_NEAR(y, 0.32903, 1e-4);
  const auto [ex, ey] = xy(integrate(power(Illuminant::e), {}));
  EXPECT_NEAR(ex, 1 / 3.0, 1e-4);
  EXPECT_NEAR(ey, 1 / 3.0, 1e-4);
}

TEST(Spectrum, IsLinearBetweenSamplesAndConstantOutside) {
  const Spectrum s{{400, 1}, {500, 3}};
  EXPECT_EQ(value_at(s, 300), 1);
  EXPECT_EQ(value_at(s, 400), 1);
  EXPECT_EQ(value_at(s, 450), 2);
  EXPECT_EQ(value_at(s, 500), 3);
  EXPECT_EQ(value_at(s, 600), 3);
  EXPECT_EQ(value_at({}, 555), 1);
}

TEST(Reflectance, APerfectWhiteIsWhiteUnderEveryIlluminant) {
  for (const Illuminant illuminant : {Illuminant::d65, Illuminant::e}) {
    expect_near(reflectance_to_rgb({{380, 1}}, illuminant), {1, 1, 1}, 3e-4);
    expect_near(reflectance_to_rgb({{380, 0.25}}, illuminant), {0.25, 0.25, 0.25}, 1e-4);
  }
}

TEST(Reflectance, IsLinearInTheSpectrum) {
  const Spectrum a{{400, 0.2}, {700, 0.8}}, b{{400, 0.9}, {700, 0.1}}, both{{400, 0.55}, {700, 0.45}};
  const Triple ra = reflectance_to_rgb(a), rb = reflectance_to_rgb(b), rm = reflectance_to_rgb(both);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rm[c], (ra[c] + rb[c]) / 2, 1e-12);
}

TEST(Rgb, TheSrgbPrimariesComeBack) {
  // Columns of the inverse matrix: XYZ of the primaries (IEC 61966-2-1).
  expect_near(xyz_to_rgb({0.4124, 0.2126, 0.0193}), {1, 0, 0}, 2e-4);
  expect_near(xyz_to_rgb({0.3576, 0.7152, 0.1192}), {0, 1, 0}, 2e-4);
  expect_near(xyz_to_rgb({0.1805, 0.0722, 0.9505}), {0, 0, 1}, 2e-4);
}

TEST(CornellBoxTest, TheSceneHasTheComputedNumbers) {
  const CornellBox box = read_cornell_box(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.json");
  std::ifstream stream(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.pov");
  std::stringstream text;
  text << stream.rdbuf();
  const std::string scene = text.str();
  std::istringstream lines(as_sdl(box));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_NE(scene.find(line + "\n"), std::string::npos) << "the scene lacks: " << line;
  EXPECT_EQ(count, 8);
}

TEST(CornellBoxTest, TheSceneHasTheMeasuredGeometry) {
  // Every corner of the data stands in the scene as <x, y, z>.
  std::ifstream data(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.json"),
      source(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.pov");
  std::stringstream json, scene;
  json << data.rdbuf();
  scene << source.rdbuf();
  const auto corners = [](const std::string& text, const std::regex& pattern) {
    std::set<Triple> found;
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i)
      found.insert({std::stod((*i)[1]), std::stod((*i)[2]), std::stod((*i)[3])});
    return found;
  };
  const std::string number = R"(\s*(-?[0-9.]+)\s*)";
  const std::string whole = json.str();
  const auto measured = corners(whole.substr(whole.find("\"surfaces\"")),
                                std::regex(R"(\[)" + number + "," + number + "," + number + R"(\])"));
  const auto modelled = corners(scene.str(), std::regex("<" + number + "," + number + "," + number + ">"));
  EXPECT_GE(measured.size(), 28u);
  for (const Triple& corner : measured)
    EXPECT_TRUE(modelled.contains(corner)) << corner[0] << ", " << corner[1] << ", " << corner[2];
}

TEST(CornellBoxTest, WallsAreRedAndGreen) {
  const CornellBox box = read_cornell_box(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.json");
  EXPECT_GT(box.reflectance.at("red")[0], 4 * box.reflectance.at("red")[1]);
  EXPECT_GT(box.reflectance.at("green")[1], 2 * box.reflectance.at("green")[0]);
  for (const double value : box.reflectance.at("white")) EXPECT_NEAR(value, 0.73, 0.03);
  EXPECT_DOUBLE_EQ(box.light_area, 130 * 105);
}

TEST(CornellBoxTest, WrongFilesAreNamed) {
  EXPECT_THROW(read_cornell_box("/nonexistent.json"), std::runtime_error);
  EXPECT_THROW(read_cornell_box(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.pov"), std::runtime_error);
}

// What the bands add up to is what the spectra give when they are integrated: the light, and the light on a white and a
// red wall, but for the ends of the spectrum.
TEST(CornellBox, BandsAddUpToTheColoursOfTheSpectra) {
  std::ifstream data(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.json");
  const auto json = nlohmann::json::parse(data);
  const auto matrices = band_matrices(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.json");
  const auto spectrum = [](const nlohmann::json& samples) {
    Spectrum out;
    for (const auto& s : samples) out.emplace_back(s[0], s[1]);
    return out;
  };
  const Spectrum light = spectrum(json["emission_nm"]);
  double mean = 0;
  for (int band = 0; band < kBands; ++band) mean += band_mean(light, band) / kBands;
  const auto composed = [&](const Spectrum& wall) {
    Triple out{};
    for (std::size_t band = 0; band < kBands; ++band) {
      const double value = band_mean(light, static_cast<int>(band)) / mean *
                           (wall.empty() ? 1 : band_mean(wall, static_cast<int>(band)));
      for (std::size_t row = 0; row < 3; ++row) out[row] += matrices[band / 3][row][band % 3] * value;
    }
    return out;
  };
  const double y = integrate(light, {})[1];
  for (const Spectrum& wall : {Spectrum{}, spectrum(json["reflectance_nm"]["white"]),
                               spectrum(json["reflectance_nm"]["red"]), spectrum(json["reflectance_nm"]["green"])}) {
    Triple xyz = integrate(light, wall);
    for (double& v : xyz) v /= y;
    expect_near(composed(wall), xyz_to_rgb(xyz), 0.02);
  }
}

TEST(CornellBox, TheManifestHasTheComputedPasses) {
  std::ifstream source(VERISIM_SOURCE_DIR "/scenes/cornell_box/verisim.toml");
  const std::string manifest{std::istreambuf_iterator<char>(source), {}};
  EXPECT_NE(manifest.find(as_passes(band_matrices(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.json"))),
            std::string::npos);
}

// bands.inc: means over 25 nm, the light relative to its mean over all twelve.
TEST(CornellBox, BandsAreTheMeansOfTheSpectra) {
  std::ifstream data(VERISIM_SOURCE_DIR "/scenes/cornell_box/cornell_box.json"),
      source(VERISIM_SOURCE_DIR "/scenes/cornell_box/bands.inc");
  const auto json = nlohmann::json::parse(data);
  std::string text{std::istreambuf_iterator<char>(source), {}};
  const auto means = [](const nlohmann::json& samples) {
    Spectrum spectrum;
    for (const auto& s : samples) spectrum.emplace_back(s[0], s[1]);
    std::array<double, 12> out{};
    for (int band = 0; band < 12; ++band)
      for (int nm = 0; nm < 25; ++nm)
        out[static_cast<std::size_t>(band)] += value_at(spectrum, 400 + 25 * band + nm + 0.5) / 25;
    return out;
  };
  const auto expect_line = [&](const std::string& name, const std::array<double, 12>& values, double scale) {
    std::size_t at = text.find("#declare Band_" + name + " = array[12] { ");
    ASSERT_NE(at, std::string::npos) << name;
    std::istringstream numbers(text.substr(text.find('{', at) + 1));
    for (double value : values) {
      double got = 0;
      char comma = 0;
      numbers >> got >> comma;
      EXPECT_NEAR(got, value * scale, 0.51e-5) << name;
    }
  };
  const auto light = means(json["emission_nm"]);
  double mean = 0;
  for (double v : light) mean += v / 12;
  expect_line("White", means(json["reflectance_nm"]["white"]), 1);
  expect_line("Green", means(json["reflectance_nm"]["green"]), 1);
  expect_line("Red", means(json["reflectance_nm"]["red"]), 1);
  expect_line("Light", light, 1 / mean);
}

}  // namespace
}  // namespace verisim::spectra
