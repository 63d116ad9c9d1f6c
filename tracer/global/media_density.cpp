// Densities of media, one by one and many together.
#include <algorithm>
#include <array>
#include <vector>

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
  for (const std::size_t i : m.simple_densities) {
    if (density_at(*m.densities[i], p) == Rgb()) return {};
  }
  Rgb value(1.0f);
  for (const textures::CompiledPigment* d : m.densities) value *= density_at(*d, p);
  return value;
}

namespace {

constexpr int kMost = textures::PointRow::kMost;

// Room of a thread: what is asked for are often few points, and clearing a row would cost more than they do.
struct DensityRoom {
  textures::PointRow left;
  int place[kMost];
  Rgb found[kMost];
  Color colors[kMost];
  bool colored[kMost];
  std::vector<std::array<Rgb, kMost>> known;
};

}  // namespace

void media_densities(const CompiledMedia& m, int count, const textures::PointRow& points, Rgb* densities) {
  thread_local DensityRoom room;
  const textures::PointRow* left = &points;  // the points that are not known to have none
  int n = count;
  const auto evaluate = [&](std::size_t density, Rgb* values) {
    textures::evaluate(*m.densities[density], n, *left, nullptr, room.colors, room.colored);
    for (int i = 0; i < n; ++i) values[i] = room.colors[i].rgb();
  };
  // Points where a simple density is zero are left out.
  if (room.known.size() < m.simple_densities.size()) room.known.resize(m.simple_densities.size());
  std::size_t known = 0;
  for (const std::size_t density : m.simple_densities) {
    if (n == 0) break;
    Rgb* const values = room.known[known++].data();
    evaluate(density, values);
    int kept = 0;
    for (int i = 0; i < n; ++i) {
      if (values[i] == Rgb()) continue;
      if (kept != i || left == &points) {
        for (std::size_t k = 0; k < known; ++k) room.known[k][kept] = room.known[k][i];
        room.left.set(kept, left->at(i));
        room.place[kept] = left == &points ? i : room.place[i];
      }
      ++kept;
    }
    left = &room.left;
    room.left.fill_up(n = kept);
  }
  if (left == &points) {
    for (int i = 0; i < n; ++i) densities[i] = Rgb(1.0f), room.place[i] = i;
  } else {
    std::fill_n(densities, count, Rgb());
    for (int i = 0; i < n; ++i) densities[room.place[i]] = Rgb(1.0f);
  }
  for (std::size_t density = 0, simple = 0; n > 0 && density < m.densities.size(); ++density) {
    const bool is_known = simple < m.simple_densities.size() && m.simple_densities[simple] == density;
    if (!is_known) evaluate(density, room.found);
    const Rgb* const values = is_known ? room.known[simple++].data() : room.found;
    for (int i = 0; i < n; ++i) densities[room.place[i]] *= values[i];
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

bool is_simple(const scene::Density& density) {
  using enum scene::PatternKind;
  const scene::Pattern& pattern = density.pattern;
  const bool formula = pattern.kind == spherical || pattern.kind == cylindrical || pattern.kind == boxed || pattern.kind == planar;
  const bool moved = std::any_of(pattern.warps.begin(), pattern.warps.end(), [](const scene::Warp& w) { return !std::holds_alternative<Transform>(w); });
  return formula && !moved && !pattern.turbulence && !density.density_map;
}

}  // namespace

CompiledMedia compile_media(const scene::Media& description, textures::Compiler& compiler) {
  CompiledMedia m;
  m.description = &description;
  m.extinction = description.absorption + description.scattering * static_cast<float>(description.extinction);
  m.emits = description.emission.max_abs() > 0.0f;
  m.scatters = description.scattering.max_abs() > 0.0f;
  for (const scene::DensityPtr& density : description.densities) {
    if (description.densities.size() > 1 && is_simple(*density)) m.simple_densities.push_back(m.densities.size());
    m.densities.push_back(compiler.density(density));
    const bool plain = density->pattern.kind == scene::PatternKind::plain;
    m.varies |= !plain;
    m.last_density_plain = plain;
    m.density_bound *= bound_of(*density);
  }
  return m;
}

}  // namespace verisim::global
