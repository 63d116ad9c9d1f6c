// mesh { triangles ... } (spec 04 section 1.1).
#include <cmath>

#include "parser/scene/objects.h"
#include "parser/scene/shapes/mesh/mesh_data.h"

namespace verisim::parser {

using scene::MeshData;
using scene::MeshTriangle;

namespace {

class MeshReader {
 public:
  explicit MeshReader(Parser& p) : parser(p) {}

  std::shared_ptr<MeshData> read() {
    for (;;) {
      const Word word = word_at(parser);
      if (word == Word::triangle || word == Word::smooth_triangle) {
        triangle(word == Word::smooth_triangle);
      } else if (word == Word::inside_vector) {
        parser.next();
        data->inside_vector = inside_vector(parser.parse_vec3());
      } else {
        break;
      }
    }
    if (data->triangles.empty()) parser.error(Code::degenerate, "No triangles in triangle mesh.");
    // The lists grew by doubling; a mesh stays until the picture is done.
    data->triangles.shrink_to_fit(), data->vertices.shrink_to_fit();
    data->normals.shrink_to_fit(), data->uvs.shrink_to_fit();
    return data;
  }

 private:
  Parser& parser;
  std::shared_ptr<MeshData> data = std::make_shared<MeshData>();
  NormalFixer normals{parser, "mesh"};
  TextureTable textures{data->textures};
  UvTable uvs{data->uvs};

  void triangle(bool smooth) {
    parser.next();
    parser.expect('{');
    std::array<Vec3, 3> p, n;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = parser.parse_vec3();
      parser.optional_comma();
      if (!smooth) continue;
      n[i] = normals.fix(parser.parse_vec3());
      parser.optional_comma();
    }
    MeshTriangle t;
    t.has_uv = true;
    t.uv = {0, 0, 0};
    std::array<Vec2, 3> uv{Vec2(0), Vec2(0), Vec2(0)};
    if (parser.accept(Word::uv_vectors)) {
      for (Vec2& value : uv) {
        value = parser.parse_vec2();
        parser.optional_comma();
      }
    }
    parse_textures(t);
    close_block(parser);
    const bool degenerate = length(cross(p[1] - p[0], p[2] - p[0])) == 0;
    if (degenerate) return;  // dropped silently
    const auto first = static_cast<std::uint32_t>(data->vertices.size());
    for (std::size_t i = 0; i < 3; ++i) {
      t.vertex[i] = first + static_cast<std::uint32_t>(i);
      t.uv[i] = uvs.index(uv[i]);
    }
    data->vertices.insert(data->vertices.end(), p.begin(), p.end());
    t.normal = {0, 0, 0};
    t.smooth = smooth && is_smooth(n[0], n[1], n[2]);
    if (t.smooth) {
      const auto normal = static_cast<std::uint32_t>(data->normals.size());
      t.normal = {normal, normal + 1, normal + 2};
      data->normals.insert(data->normals.end(), n.begin(), n.end());
    }
    data->triangles.push_back(t);
  }

  scene::TexturePtr identifier() {
    const auto* value = parser.accept_value<scene::TexturePtr>();
    if (!value) parser.error_expected("texture identifier");
    return *value;
  }

  void parse_textures(MeshTriangle& t) {
    if (parser.accept(Word::texture)) {
      parser.expect('{');
      t.texture[0] = textures.index(identifier());
      close_block(parser);
    } else if (parser.accept(Word::texture_list)) {
      parser.expect('{');
      for (std::int32_t& index : t.texture) {
        index = textures.index(identifier());
        parser.optional_comma();
      }
      close_block(parser);
    }
  }
};

}  // namespace

ObjectRef parse_mesh(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) { object.shape = scene::Mesh{MeshReader(parser).read(), {}}; });
}

}  // namespace verisim::parser
