// What mesh and mesh2 have in common (spec 04 section 1).
#pragma once

#include <optional>
#include <unordered_map>

#include "parser/language/blocks.h"

namespace verisim::parser {

// Coordinates are kept in single precision.
inline Vec3 round_to_float(const Vec3& v) {
  return {static_cast<double>(static_cast<float>(v.x)), static_cast<double>(static_cast<float>(v.y)),
          static_cast<double>(static_cast<float>(v.z))};
}

// Of length 1, in single precision; <1,0,0> when all components are (nearly) 0.
Vec3 unit_normal(const Vec3& normal);

// Unit normals; zero ones become <1,0,0>, with one warning.
class NormalFixer {
 public:
  NormalFixer(Parser& p, const char* block) : parser(p), name(block) {}
  Vec3 fix(const Vec3& normal);

 private:
  Parser& parser;
  const char* name;
  bool warned = false;
};

// A triangle with three equal normals is flat, whatever the normals are (spec 04 1.3).
inline bool is_smooth(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = a - b, ac = a - c;
  return dot(ab, ab) > kEpsilon || dot(ac, ac) > kEpsilon;
}

// Absent when all components are (nearly) 0.
std::optional<Vec3> inside_vector(const Vec3& v);

// Textures of triangles, each stored once.
class TextureTable {
 public:
  explicit TextureTable(std::vector<scene::TexturePtr>& list) : textures(list) {}
  std::int32_t index(const scene::TexturePtr& texture);

 private:
  std::vector<scene::TexturePtr>& textures;
  std::unordered_map<const scene::Texture*, std::int32_t> known;
};

// UV coordinates of triangles. Like POV-Ray it keeps one of those that are almost equal, the first, where both fall
// into the same of POV-Ray's cells (spec 04 1.1).
class UvTable {
 public:
  explicit UvTable(std::vector<Vec2>& list) : uvs(list) {}
  std::uint32_t index(const Vec2& uv);

 private:
  using Key = std::uint64_t;
  static constexpr double kSame = 1e-10;  // components nearer than this
  static Key key(const Vec2& uv, double x, double y);
  std::optional<std::uint32_t> find(Key key, const Vec2& uv) const;
  std::vector<Vec2>& uvs;
  std::unordered_multimap<Key, std::uint32_t> known;
};

}  // namespace verisim::parser
