#include "tools/spectra/spectrum.h"

#include <algorithm>

namespace verisim::spectra {
namespace {

using Matrix = std::array<Triple, 3>;

Triple operator*(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

// IEC 61966-2-1, amendment 1.
constexpr Matrix kXyzToRgb{
    {{3.2406255, -1.5372080, -0.4986286}, {-0.9689307, 1.8757561, 0.0415175}, {0.0557101, -0.2040211, 1.0569959}}};
// Lam, "Metamerism and Colour Constancy", 1985.
constexpr Matrix kBradford{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
constexpr Matrix kBradfordInverse{
    {{0.9869929, -0.1470543, 0.1599627}, {0.4323053, 0.5183603, 0.0492912}, {-0.0085287, 0.0400428, 0.9684867}}};

constexpr double kFirst = 380, kLast = 780, kObserverStep = 5;

}  // namespace

Triple observer_at(double nanometres) {
  const double position = (nanometres - kFirst) / kObserverStep;
  const std::size_t i = std::min(static_cast<std::size_t>(position), observer().size() - 2);
  const double f = position - static_cast<double>(i);
  Triple result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = (1 - f) * observer()[i][c] + f * observer()[i + 1][c];
  return result;
}

double value_at(const Spectrum& spectrum, double nanometres) {
  if (spectrum.empty()) return 1;
  const auto above = std::lower_bound(spectrum.begin(), spectrum.end(), nanometres,
                                      [](const auto& sample, double x) { return sample.first < x; });
  if (above == spectrum.begin()) return spectrum.front().second;
  if (above == spectrum.end()) return spectrum.back().second;
  const auto below = above - 1;
  const double f = (nanometres - below->first) / (above->first - below->first);
  return (1 - f) * below->second + f * above->second;
}

Triple integrate(const Spectrum& emission, const Spectrum& reflectance) {
  Triple sum{};
  for (int nanometres = static_cast<int>(kFirst); nanometres <= static_cast<int>(kLast); ++nanometres) {
    const double light = value_at(emission, nanometres) * value_at(reflectance, nanometres);
    const Triple weights = observer_at(nanometres);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += light * weights[c];
  }
  return sum;
}

Triple xyz_to_rgb(const Triple& xyz) { return kXyzToRgb * xyz; }

Triple adapt(const Triple& xyz, const Triple& from_white, const Triple& to_white) {
  const Triple from = kBradford * from_white, to = kBradford * to_white;
  Triple cone = kBradford * xyz;
  for (std::size_t c = 0; c < 3; ++c) cone[c] *= to[c] / from[c];
  return kBradfordInverse * cone;
}

Triple reflectance_to_rgb(const Spectrum& reflectance, Illuminant illuminant) {
  const Spectrum& light = power(illuminant);
  const Triple white = integrate(light, {});
  Triple xyz = integrate(light, reflectance);
  for (double& value : xyz) value /= white[1];
  // The matrix of sRGB takes a white of this chromaticity to (1, 1, 1); the tables give it to four digits.
  constexpr Triple kSrgbWhite{0.95047, 1, 1.08883};
  return xyz_to_rgb(adapt(xyz, {white[0] / white[1], 1, white[2] / white[1]}, kSrgbWhite));
}

Triple emission_to_rgb(const Spectrum& emission) {
  Triple xyz = integrate(emission, {});
  const double y = xyz[1];
  for (double& value : xyz) value /= y;
  return xyz_to_rgb(xyz);
}

}  // namespace verisim::spectra
