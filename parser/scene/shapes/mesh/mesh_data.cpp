#include "parser/scene/shapes/mesh/mesh_data.h"

#include <algorithm>
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

std::optional<std::uint32_t> UvTable::find(Key key, const Vec2& uv) const {
  const auto [first, last] = known.equal_range(key);
  for (auto i = first; i != last; ++i) {
    const Vec2& other = uvs[i->second];
    if (std::fabs(other.x - uv.x) < kSame && std::fabs(other.y - uv.y) < kSame) return i->second;
  }
  return std::nullopt;
}

std::uint32_t UvTable::index(const Vec2& uv) {
  if (uvs.empty()) uvs.push_back({0, 0});
  if (uv == Vec2(0, 0)) return 0;
  const Key own = key(uv, uv.x, uv.y);
  if (const auto number = find(own, uv)) return *number;
  for (const double x : {uv.x - kSame, uv.x + kSame})
    for (const double y : {uv.y - kSame, uv.y + kSame})
      if (const Key beside = key(uv, x, y); beside != own)
        if (const auto number = find(beside, uv)) return *number;
  const auto number = static_cast<std::uint32_t>(uvs.size());
  uvs.push_back(uv);
  known.emplace(own, number);
  return number;
}

}  // namespace verisim::parser
