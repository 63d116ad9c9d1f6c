#include "parser/scene/shapes/mesh/mesh_data.h"

#include <cmath>

namespace verisim::parser {

namespace {

bool is_zero(const Vec3& v) {
  return std::fabs(v.x) < kEpsilon && std::fabs(v.y) < kEpsilon && std::fabs(v.z) < kEpsilon;
}

}  // namespace

Vec3 unit_normal(const Vec3& normal) { return is_zero(normal) ? Vec3(1, 0, 0) : round_to_float(normalize(normal)); }

Vec3 NormalFixer::fix(const Vec3& normal) {
  if (!warned && is_zero(normal)) {
    parser.warning(Code::adjusted_value,
                   std::string("Normal vector in ") + name + " cannot be zero - changing it to <1,0,0>.");
    warned = true;
  }
  return unit_normal(normal);
}

std::optional<Vec3> inside_vector(const Vec3& v) {
  if (is_zero(v)) return std::nullopt;
  return normalize(v);
}

std::int32_t TextureTable::index(const scene::TexturePtr& texture) {
  const auto [entry, added] = known.try_emplace(texture.get(), static_cast<std::int32_t>(textures.size()));
  if (added) textures.push_back(texture);
  return entry->second;
}

// POV-Ray's cells are 1/326 of u and 1/694.7 of v. They are divided further, so that few are compared in a large mesh;
// (x, y): a place that may lie beyond the border of such a part.
UvTable::Key UvTable::key(const Vec2& uv, double x, double y) {
  const auto cell = [](double v) {
    return std::isnan(v) ? 0 : static_cast<Key>(static_cast<std::int64_t>(std::clamp(v, -9e18, 9e18)));
  };
  Key result = 0;
  for (const double v : {326.0 * uv.x, 694.7 * uv.y, std::floor(x * 1e6), std::floor(y * 1e6)})
    result = (result ^ cell(v)) * 0x9e3779b97f4a7c15u;
  return result;
}

std::uint32_t UvTable::index(const Vec2& uv) {
  constexpr double kSame = 1e-10;
  if (uvs.empty()) uvs.push_back({0, 0});
  if (uv == Vec2(0, 0)) return 0;
  std::array<Key, 4> keys;
  for (std::size_t n = 0; n < 4; ++n)
    keys[n] = key(uv, uv.x + (n & 1 ? kSame : -kSame), uv.y + (n & 2 ? kSame : -kSame));
  std::sort(keys.begin(), keys.end());
  for (auto k = keys.begin(), end = std::unique(keys.begin(), keys.end()); k != end; ++k) {
    const auto [first, last] = known.equal_range(*k);
    for (auto i = first; i != last; ++i) {
      const Vec2& other = uvs[i->second];
      if (std::fabs(other.x - uv.x) < kSame && std::fabs(other.y - uv.y) < kSame) return i->second;
    }
  }
  const auto number = static_cast<std::uint32_t>(uvs.size());
  uvs.push_back(uv);
  known.emplace(key(uv, uv.x, uv.y), number);
  return number;
}

}  // namespace verisim::parser
