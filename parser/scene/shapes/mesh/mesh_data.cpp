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

}  // namespace verisim::parser
