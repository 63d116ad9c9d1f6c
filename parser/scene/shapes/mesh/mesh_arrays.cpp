#include "parser/scene/shapes/mesh/mesh_arrays.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "parser/scene/shapes/mesh/mesh_data.h"
#include "tracer/base/parallel.h"

namespace verisim::parser {
namespace {

constexpr std::size_t kGrain = 1 << 14;  // elements a task

std::size_t count_of(std::size_t numbers, std::size_t each, const char* what) {
  if (numbers % each != 0)
    throw std::invalid_argument(std::string("mesh2: ") + what + " are not " + std::to_string(each) + " numbers each");
  return numbers / each;
}

Vec3 vector_at(std::span<const double> numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

void require_below(std::span<const std::uint32_t> indices, std::size_t size, const char* what) {
  const auto wrong = std::find_if(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= size; });
  if (wrong != indices.end())
    throw std::invalid_argument("mesh2: face " + std::to_string((wrong - indices.begin()) / 3) + " uses " + what + " " +
                                std::to_string(*wrong) + ", there are " + std::to_string(size));
}

// What the indices of normals or uvs are: their own, or the vertices'.
std::span<const std::uint32_t> indices_of(const MeshArrays& arrays, std::span<const std::uint32_t> own,
                                          std::size_t size, const char* what) {
  if (own.empty()) {
    if (size != arrays.vertices.size() / 3)
      throw std::invalid_argument(std::string("mesh2: without indices there must be as many ") + what +
                                  "s as vertices");
    return arrays.faces;
  }
  if (own.size() != arrays.faces.size())
    throw std::invalid_argument(std::string("mesh2: there must be three ") + what + " indices a face");
  require_below(own, size, what);
  return own;
}

std::array<std::uint32_t, 3> triple(std::span<const std::uint32_t> indices, std::size_t i) {
  return {indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]};
}

}  // namespace

scene::ObjectPtr object_of_mesh(const MeshArrays& arrays) {
  auto data = std::make_shared<scene::MeshData>();
  data->vertices.resize(count_of(arrays.vertices.size(), 3, "vertices"));
  data->triangles.resize(count_of(arrays.faces.size(), 3, "faces"));
  data->normals.resize(count_of(arrays.normals.size(), 3, "normals"));
  data->uvs.resize(count_of(arrays.uvs.size(), 2, "uvs"));
  if (data->vertices.empty() || data->triangles.empty())
    throw std::invalid_argument("mesh2: there must be vertices and faces");
  require_below(arrays.faces, data->vertices.size(), "vertex");
  const bool smooth = !data->normals.empty(), mapped = !data->uvs.empty();
  const auto normal_indices =
      smooth ? indices_of(arrays, arrays.normal_indices, data->normals.size(), "normal") : arrays.normal_indices;
  const auto uv_indices = mapped ? indices_of(arrays, arrays.uv_indices, data->uvs.size(), "uv") : arrays.uv_indices;
  if (!mapped) data->uvs.push_back({0, 0});

  parallel_for(data->vertices.size(), kGrain,
               [&](std::size_t i) { data->vertices[i] = round_to_float(vector_at(arrays.vertices, i)); });
  parallel_for(data->normals.size(), kGrain,
               [&](std::size_t i) { data->normals[i] = unit_normal(vector_at(arrays.normals, i)); });
  for (std::size_t i = 0; i < arrays.uvs.size() / 2; ++i) data->uvs[i] = {arrays.uvs[2 * i], arrays.uvs[2 * i + 1]};
  parallel_for(data->triangles.size(), kGrain, [&](std::size_t i) {
    scene::MeshTriangle& t = data->triangles[i];
    t.vertex = triple(arrays.faces, i);
    t.normal = {0, 0, 0};
    t.uv = {0, 0, 0};
    t.has_uv = true;
    if (mapped) t.uv = triple(uv_indices, i);
    if (!smooth) return;
    t.normal = triple(normal_indices, i);
    t.smooth = is_smooth(data->normals[t.normal[0]], data->normals[t.normal[1]], data->normals[t.normal[2]]);
  });
  if (arrays.inside_vector) data->inside_vector = inside_vector(*arrays.inside_vector);

  auto object = std::make_shared<scene::Object>();
  object->shape = scene::Mesh{std::move(data), {}};
  scene::compute_bounds(*object);
  scene::finish_modifiers(*object);
  return object;
}

}  // namespace verisim::parser
