// Densities of media, one by one and many together.
#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "tracer/global/media.h"

namespace verisim::global {
namespace {

Rgb density_at(const textures::CompiledPigment& density, const Vec3& p) {
  Color c;
  textures::evaluate(density, p, nullptr, c);
  return c.rgb();
}

}  // namespace

Rgb media_density(const CompiledMedia& m, const Vec3& p) {
  if (m.densities.empty()) return Rgb(1.0f);
  boost::container::small_vector<Rgb, 8> values(m.densities.size());
  for (const std::size_t i : m.by_cost) {
    values[i] = density_at(*m.densities[i], p);
    if (values[i] == Rgb()) return {};
  }
  Rgb product(1.0f);
  for (const Rgb& value : values) product *= value;
  return product;
}

namespace {

constexpr int kMost = textures::PointRow::kMost;

// Room of a thread: what is asked for are often few points, and clearing a row would cost more than they do.
struct DensityRoom {
  textures::PointRow left;
  int place[kMost];
  Color colors[kMost];
  bool colored[kMost];
  std::vector<std::array<Rgb, kMost>> values;  // of each density where none that was asked for is zero
};

}  // namespace

void media_densities(const CompiledMedia& m, int count, const textures::PointRow& points, Rgb* densities) {
  thread_local DensityRoom room;
  if (room.values.size() < m.densities.size()) room.values.resize(m.densities.size());
  const textures::PointRow* left = &points;  // the points that are not known to have none
  int n = count;
  std::iota(room.place, room.place + n, 0);
  for (std::size_t known = 0; n > 0 && known < m.by_cost.size(); ++known) {
    textures::evaluate(*m.densities[m.by_cost[known]], n, *left, nullptr, room.colors, room.colored);
    auto& values = room.values[m.by_cost[known]];
    int kept = 0;
    for (int i = 0; i < n; ++i) {
      const Rgb value = room.colors[i].rgb();
      if (value == Rgb()) continue;
      if (kept != i) {
        for (std::size_t k = 0; k < known; ++k) room.values[m.by_cost[k]][kept] = room.values[m.by_cost[k]][i];
        room.place[kept] = room.place[i];
      }
      values[kept++] = value;
    }
    if (kept == n || known + 1 == m.by_cost.size()) {
      n = kept;
      continue;
    }
    for (int i = 0; i < kept; ++i) room.left.set(i, points.at(room.place[i]));
    left = &room.left;
    room.left.fill_up(n = kept);
  }
  std::fill_n(densities, count, Rgb());
  for (int i = 0; i < n; ++i) {
    Rgb product(1.0f);
    for (std::size_t density = 0; density < m.densities.size(); ++density) product *= room.values[density][i];
    densities[room.place[i]] = product;
  }
}

namespace {

double bound_of(const scene::Density& density) {
  if (density.pattern.kind == scene::PatternKind::plain) return density.color.rgb().max_abs();
  double most = density.color_map || density.density_map ? 0.0 : 1.0;  // built-in maps stay within 0..1
  if (density.color_map) {
    for (const auto& entry : *density.color_map) most = std::max(most, static_cast<double>(entry.value.rgb().max_abs()));
  }
  if (density.density_map) {
    for (const auto& entry : *density.density_map) most = std::max(most, entry.value ? bound_of(*entry.value) : 1.0);
  }
  return most;
}

// What a pattern costs, very roughly: one for a formula or the noise of an octave.
int cost_of(scene::PatternKind kind) {
  using enum scene::PatternKind;
  switch (kind) {
    case plain: case none: return 0;
    case granite: return 6;
    case crackle: case facets: case function: case object: case pigment_pattern: return 8;
    case wrinkles: case julia: case magnet_julia: case magnet_mandel: case mandel: return 10;
    default: return 1;
  }
}

int cost_of(const scene::Density& density) {
  const scene::Pattern& pattern = density.pattern;
  int cost = cost_of(pattern.kind);
  if (cost == 0) return 0;
  if (pattern.turbulence) cost += pattern.turbulence->octaves;
  for (const scene::Warp& warp : pattern.warps) {
    if (const auto* turbulence = std::get_if<scene::TurbulenceWarp>(&warp)) cost += turbulence->octaves;
  }
  if (density.density_map) {
    for (const auto& entry : *density.density_map) cost += entry.value ? cost_of(*entry.value) : 0;
  }
  return cost;
}

}  // namespace

CompiledMedia compile_media(const scene::Media& description, textures::Compiler& compiler) {
  CompiledMedia m;
  m.description = &description;
  m.extinction = description.absorption + description.scattering * static_cast<float>(description.extinction);
  m.emits = description.emission.max_abs() > 0.0f;
  m.scatters = description.scattering.max_abs() > 0.0f;
  std::vector<int> costs;
  for (const scene::DensityPtr& density : description.densities) {
    m.by_cost.push_back(m.densities.size());
    costs.push_back(cost_of(*density));
    m.densities.push_back(compiler.density(density));
    const bool plain = density->pattern.kind == scene::PatternKind::plain;
    m.varies |= !plain;
    m.last_density_plain = plain;
    m.density_bound *= bound_of(*density);
  }
  std::stable_sort(m.by_cost.begin(), m.by_cost.end(), [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  return m;
}

}  // namespace verisim::global
