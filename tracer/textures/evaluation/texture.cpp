// Patterned textures: which children show at a point.
#include "tracer/textures/texture.h"

#include "tracer/textures/patterns/pattern.h"

namespace verisim::textures {
namespace {

std::size_t material_of(const CompiledTexture& texture, const Vec3& p) {
  const int count = static_cast<int>(texture.map.size());
  int number = material_number(texture.pattern->as<ImageLookup>(), p);
  if (number > count) number %= count;  // `>`, not `>=`: number == count shows the last one (spec 05 12.7)
  return static_cast<std::size_t>(std::min(number, count - 1));
}

}  // namespace

std::span<const WeightedTexture> select(const CompiledTexture& texture, const Vec3& p, const SurfacePoint* surface,
                                        std::span<WeightedTexture> storage, Vec3& warped_point) {
  const auto& map = texture.map;
  if (texture.uv_mapping) {
    warped_point = surface ? uv_point(*surface) : p;
    storage[0] = {map[0].value, 1};
    return storage.first(1);
  }
  if (!texture.average && !texture.material_map) {
    const PatternValue at = value_of(*texture.pattern, p, surface);
    warped_point = at.point;
    const MapPlace place = texture.positions.find(at.value);
    if (place.single()) {
      storage[0] = {map[place.upper].value, 1};
      return storage.first(1);
    }
    storage[0] = {map[place.upper].value, place.t};
    storage[1] = {map[place.lower].value, 1 - place.t};
    return storage.first(2);
  }
  warped_point = warped(*texture.pattern, p);
  if (texture.average) {
    float total = 0;
    for (const auto& entry : map) total += entry.position;
    for (std::size_t i = 0; i < map.size(); ++i) storage[i] = {map[i].value, map[i].position / total};
    return storage.first(map.size());
  }
  storage[0] = {map[material_of(texture, warped_point)].value, 1};
  return storage.first(1);
}

Vec3 enter_frame(const CompiledTexture& texture, const Vec3& normal) {
  return texture.pattern ? normal_into_frame(*texture.pattern, texture.no_bump_scale, normal) : normal;
}

Vec3 leave_frame(const CompiledTexture& texture, const Vec3& normal) {
  return texture.pattern ? normal_out_of_frame(*texture.pattern, texture.no_bump_scale, normal) : normal;
}

}  // namespace verisim::textures
