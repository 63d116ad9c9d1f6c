#include "tools/spectra/cornell_box.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace verisim::spectra {
namespace {

using nlohmann::json;

Spectrum spectrum(const json& samples) {
  Spectrum result;
  for (const json& sample : samples) result.emplace_back(sample.at(0).get<double>(), sample.at(1).get<double>());
  if (result.empty()) throw std::runtime_error("an empty spectrum");
  return result;
}

Triple triple(const json& values) {
  return {values.at(0).get<double>(), values.at(1).get<double>(), values.at(2).get<double>()};
}

double triangle_area(const Triple& a, const Triple& b, const Triple& c) {
  const Triple u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

double area(const json& quads) {
  double sum = 0;
  for (const json& quad : quads) {
    const Triple a = triple(quad.at(0)), b = triple(quad.at(1)), c = triple(quad.at(2)), d = triple(quad.at(3));
    sum += triangle_area(a, b, c) + triangle_area(a, c, d);
  }
  return sum;
}

}  // namespace

CornellBox read_cornell_box(const std::filesystem::path& path, Illuminant illuminant) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  try {
    const json data = json::parse(stream);
    CornellBox box;
    for (const auto& [material, samples] : data.at("reflectance_nm").items())
      box.reflectance[material] = reflectance_to_rgb(spectrum(samples), illuminant);
    box.light_color = emission_to_rgb(spectrum(data.at("emission_nm")));
    box.light_reflectance = data.at("light_reflectance").get<double>();
    const json& surfaces = data.at("surfaces");
    box.light_area = area(surfaces.at("light").at("quads"));
    for (const char* name : {"floor", "ceiling", "back_wall", "right_wall", "left_wall"}) {
      const double size = area(surfaces.at(name).at("quads"));
      const Triple& color = box.reflectance.at(surfaces.at(name).at("material").get<std::string>());
      box.room_area += size;
      for (std::size_t c = 0; c < 3; ++c) box.mean_reflectance[c] += size * color[c];
    }
    box.room_area += area(surfaces.at("back_wall").at("quads"));  // the open front, as large as the back
    for (double& value : box.mean_reflectance) value /= box.room_area;
    return box;
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

double band_mean(const Spectrum& spectrum, int band) {
  double sum = 0;
  for (int nm = 0; nm < kBandWidth; ++nm) sum += value_at(spectrum, kFirstBand + kBandWidth * band + nm + 0.5);
  return sum / kBandWidth;
}

std::array<BandMatrix, 4> band_matrices(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  try {
    const Spectrum emission = spectrum(json::parse(stream).at("emission_nm"));
    double mean = 0, luminance = 0;
    for (int band = 0; band < kBands; ++band) mean += band_mean(emission, band) / kBands;
    std::array<Triple, kBands> xyz{};
    for (int band = 0; band < kBands; ++band) {
      Triple& sum = xyz[static_cast<std::size_t>(band)];
      for (int nm = 0; nm < kBandWidth; ++nm) {
        const Triple weights = observer_at(kFirstBand + kBandWidth * band + nm + 0.5);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += weights[c];
      }
      luminance += sum[1] * band_mean(emission, band) / mean;
    }
    std::array<BandMatrix, 4> out{};
    for (std::size_t band = 0; band < kBands; ++band) {
      Triple value = xyz[band];
      for (double& v : value) v /= luminance;
      const Triple rgb = xyz_to_rgb(value);
      for (std::size_t row = 0; row < 3; ++row) out[band / 3][row][band % 3] = rgb[row];
    }
    return out;
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

std::string as_passes(const std::array<BandMatrix, 4>& matrices) {
  std::string text;
  char line[300];
  for (std::size_t pass = 0; pass < matrices.size(); ++pass) {
    const BandMatrix& m = matrices[pass];
    std::snprintf(line, sizeof line,
                  "  { switches = \"Declare=Bands=%d\", matrix = [[%.6f, %.6f, %.6f], [%.6f, %.6f, %.6f], [%.6f, %.6f, "
                  "%.6f]] },\n",
                  static_cast<int>(pass), m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1],
                  m[2][2]);
    text += line;
  }
  return text;
}

std::string as_sdl(const CornellBox& box) {
  std::string text;
  char line[200];
  const auto color = [&](const std::string& name, const Triple& v) {
    std::snprintf(line, sizeof line, "#declare %s = rgb <%.5f, %.5f, %.5f>;\n", name.c_str(), v[0], v[1], v[2]);
    text += line;
  };
  const auto number = [&](const char* name, double v) {
    std::snprintf(line, sizeof line, "#declare %s = %.6g;\n", name, v);
    text += line;
  };
  for (const auto& [material, value] : box.reflectance) {
    std::string name = material + "_Reflectance";
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    color(name, value);
  }
  color("Light_Color", box.light_color);
  color("Mean_Reflectance", box.mean_reflectance);
  number("Light_Reflectance", box.light_reflectance);
  number("Light_Area", box.light_area);
  number("Room_Area", box.room_area);
  return text;
}

}  // namespace verisim::spectra
