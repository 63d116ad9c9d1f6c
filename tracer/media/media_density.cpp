// Densities of media, one by one and many together.
#include <algorithm>
#include <numeric>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "tracer/math/scaled.h"
#include "tracer/media/media.h"

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

constexpr int kMaxPoints = textures::PointBatch::kMax, kEight = 8;

// Workspace of a thread: what is asked for are often few points, and clearing a batch would cost more than they do.
struct DensityWorkspace {
  textures::PointBatch left;
  int place[kMaxPoints];
  std::int32_t alive[kMaxPoints];          // 1 where no density so far is zero, otherwise 0
  std::vector<textures::RgbBatch> values;  // of each density at the points that are left
};

int in_eights(int count) { return (count + kEight - 1) / kEight * kEight; }

void multiply(int count, const float* __restrict by, float* __restrict to) {
  for (int i = 0; i < count; ++i) to[i] *= by[i];
}
// Returns how many are left.
int mark_zeros(int count, const textures::RgbBatch& values, std::int32_t* __restrict alive) {
  int still = 0;
  for (int i = 0; i < count; ++i) {
    alive[i] &= static_cast<std::int32_t>(values.r[i] != 0) | static_cast<std::int32_t>(values.g[i] != 0) |
                static_cast<std::int32_t>(values.b[i] != 0);
    still += alive[i];
  }
  return still;
}
void clear_dead(int count, const std::int32_t* __restrict alive, float* __restrict values) {
  for (int i = 0; i < count; ++i) values[i] = alive[i] != 0 ? values[i] : 0.0f;
}
void keep(int count, const int* kept, float* values) {
  for (int k = 0; k < count; ++k) values[k] = values[kept[k]];
}

}  // namespace

void media_densities(const CompiledMedia& m, int count, const textures::PointBatch& points,
                     textures::RgbBatch& densities) {
  thread_local DensityWorkspace workspace;
  if (workspace.values.size() < m.densities.size()) workspace.values.resize(m.densities.size());
  const textures::PointBatch* left = &points;  // the points where a density may not be zero, and few others
  int n = count;
  bool all = true;
  std::fill_n(workspace.alive, in_eights(n), 1);
  for (std::size_t known = 0; n > 0 && known < m.by_cost.size(); ++known) {
    textures::RgbBatch& values = workspace.values[m.by_cost[known]];
    textures::evaluate(*m.densities[m.by_cost[known]], n, *left, values);
    const int still = mark_zeros(n, values, workspace.alive);
    if (known + 1 == m.by_cost.size() || in_eights(still) == in_eights(n)) continue;  // eights are asked together
    if (all) std::iota(workspace.place, workspace.place + n, 0);
    all = false;
    int kept[kMaxPoints], k = 0;
    for (int i = 0; i < n; ++i)
      if (workspace.alive[i] != 0) kept[k++] = i;
    for (std::size_t i = 0; i <= known; ++i) {
      textures::RgbBatch& batch = workspace.values[m.by_cost[i]];
      keep(k, kept, batch.r), keep(k, kept, batch.g), keep(k, kept, batch.b);
    }
    for (int i = 0; i < k; ++i) {
      workspace.left.set(i, points.at(workspace.place[kept[i]]));
      workspace.place[i] = workspace.place[kept[i]];
    }
    left = &workspace.left;
    n = k;
    if (n > 0) workspace.left.fill_up(n);
    std::fill_n(workspace.alive, in_eights(n), 1);
  }
  textures::RgbBatch products;
  textures::RgbBatch& product = all ? densities : products;
  for (float* channel : {product.r, product.g, product.b}) std::fill_n(channel, in_eights(n), 1.0f);
  for (std::size_t density = 0; density < m.densities.size(); ++density) {
    const textures::RgbBatch& values = workspace.values[density];
    multiply(in_eights(n), values.r, product.r), multiply(in_eights(n), values.g, product.g),
        multiply(in_eights(n), values.b, product.b);
  }
  // Whatever the other densities are there.
  for (float* channel : {product.r, product.g, product.b}) clear_dead(n, workspace.alive, channel);
  if (all) return;
  for (float* channel : {densities.r, densities.g, densities.b}) std::fill_n(channel, count, 0.0f);
  for (int i = 0; i < n; ++i)
    densities.r[workspace.place[i]] = products.r[i], densities.g[workspace.place[i]] = products.g[i],
    densities.b[workspace.place[i]] = products.b[i];
}

namespace {

double bound_of(const scene::Density& density) {
  if (density.pattern.kind == scene::PatternKind::plain) return density.color.rgb().max_abs();
  double most = density.color_map || density.density_map ? 0.0 : 1.0;  // built-in maps stay within 0..1
  if (density.color_map) {
    for (const auto& entry : *density.color_map)
      most = std::max(most, static_cast<double>(entry.value.rgb().max_abs()));
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
    case plain:
    case none:
      return 0;
    case granite:
      return 6;
    case crackle:
    case facets:
    case function:
    case object:
    case pigment_pattern:
      return 8;
    case wrinkles:
    case julia:
    case magnet_julia:
    case magnet_mandel:
    case mandel:
      return 10;
    default:
      return 1;
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
  m.extinction = description.absorption + scaled(description.scattering, description.extinction);
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
  std::stable_sort(m.by_cost.begin(), m.by_cost.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  return m;
}

}  // namespace verisim::global
