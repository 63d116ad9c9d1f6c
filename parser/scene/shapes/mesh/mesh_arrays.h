// A mesh2 from arrays in memory, without a text between.
#pragma once

#include <cstdint>
#include <span>

#include "tracer/scene/object.h"

namespace verisim::parser {

// Numbers tightly packed, as mesh2 has them: vertices and normals three a piece, uvs two; faces and their indices three
// a face. Normals and uvs may be empty. Where their indices are empty they belong to the vertices and are as many.
struct MeshArrays {
  std::span<const double> vertices;
  std::span<const std::uint32_t> faces;
  std::span<const double> normals = {}, uvs = {};
  std::span<const std::uint32_t> normal_indices = {}, uv_indices = {};
  const Vec3* inside_vector = nullptr;
};

// The object that `mesh2 { ... }` of these numbers would be, for DeclaredValue: `object { NAME texture { ... } }`.
// Throws std::invalid_argument when an array has a wrong size or an index is out of range.
scene::ObjectPtr object_of_mesh(const MeshArrays& arrays);

}  // namespace verisim::parser
