// mesh2 { vertex_vectors ... face_indices ... } (spec 04 section 1.2). Lists can be long: one pass, no work per item
// but reading and storing.
#include <cmath>

#include "parser/scene/objects.h"
#include "parser/scene/shapes/mesh/mesh_data.h"
#include "parser/scene/textures/texture.h"

namespace verisim::parser {

using scene::MeshData;
using scene::MeshTriangle;

namespace {

class Mesh2Reader {
 public:
  explicit Mesh2Reader(Parser& p) : parser(p) {}

  std::shared_ptr<MeshData> read() {
    while (vectors()) {
    }
    if (!have_vertices) parser.error(Code::missing_item, "Vertex vectors not found in mesh2");
    if (parser.at(Word::texture_list)) texture_list();
    if (!parser.at(Word::face_indices)) parser.error_expected("face_indices");
    face_indices();
    bool uv_indices_given = false, normal_indices_given = false;
    for (;;) {
      if (!uv_indices_given && parser.at(Word::uv_indices)) {
        uv_indices();
        uv_indices_given = true;
      } else if (!normal_indices_given && parser.at(Word::normal_indices)) {
        normal_indices();
        normal_indices_given = true;
      } else {
        break;
      }
    }
    if (!uv_indices_given) default_uv_indices();
    if (!normal_indices_given) default_normal_indices();
    for (MeshTriangle& t : data->triangles) {
      if (t.smooth)
        t.smooth = is_smooth(data->normals[t.normal[0]], data->normals[t.normal[1]], data->normals[t.normal[2]]);
    }
    if (parser.accept(Word::inside_vector)) data->inside_vector = inside_vector(parser.parse_vec3());
    return data;
  }

 private:
  Parser& parser;
  std::shared_ptr<MeshData> data = std::make_shared<MeshData>();
  bool have_vertices = false, have_normals = false, have_uvs = false;

  // `KEYWORD { count,`
  double open_list() {
    parser.next();
    parser.expect('{');
    const double count = parser.parse_int();
    parser.optional_comma();
    return count;
  }

  void warn_duplicate(bool& have, const char* name) {
    if (have) parser.warning(Code::duplicate, std::string("Duplicate ") + name + " block; ignoring previous block.");
    have = true;
  }

  bool vectors() {
    switch (word_at(parser)) {
      case Word::vertex_vectors: {
        warn_duplicate(have_vertices, "vertex_vectors");
        const double count = open_list();
        if (count <= 0) parser.error(Code::degenerate, "No vertices in triangle mesh.");
        read_list(data->vertices, checked_count(parser, count, "vertices", sizeof(Vec3)),
                  [&] { return round_to_float(parser.parse_vec3()); });
        close_block(parser);
        return true;
      }
      case Word::normal_vectors: {
        warn_duplicate(have_normals, "normal_vectors");
        const double count = open_list();
        NormalFixer normals(parser, "mesh2");
        data->normals.clear();
        if (count > 0)
          read_list(data->normals, checked_count(parser, count, "normals", sizeof(Vec3)),
                    [&] { return normals.fix(parser.parse_vec3()); });
        close_block(parser);
        return true;
      }
      case Word::uv_vectors: {
        warn_duplicate(have_uvs, "uv_vectors");
        const double count = open_list();
        data->uvs.clear();
        if (count > 0)
          read_list(data->uvs, checked_count(parser, count, "uv vectors", sizeof(Vec2)),
                    [&] { return parser.parse_vec2(); });
        close_block(parser);
        return true;
      }
      default:
        return false;
    }
  }

  template <class T, class Read>
  void read_list(std::vector<T>& list, std::size_t count, const Read& read) {
    list.clear();
    list.reserve(std::min<std::size_t>(count, 1 << 20));  // the count may promise more than the file holds
    for (std::size_t i = 0; i < count; ++i) {
      list.push_back(read());
      parser.optional_comma();
    }
  }

  void texture_list() {
    const double count = open_list();
    const std::size_t size = checked_count(parser, count, "textures", sizeof(scene::TexturePtr));
    for (std::size_t i = 0; i < size; ++i) {
      if (!parser.at(Word::texture)) parser.error_expected("texture");
      data->textures.push_back(parse_texture(parser));
      parser.optional_comma();
    }
    close_block(parser);
  }

  // <a, b, c>, each below `size`.
  std::array<std::uint32_t, 3> indices(std::size_t size, const char* message) {
    const Vec3 v = parser.parse_vec3();
    std::array<std::uint32_t, 3> result;
    for (unsigned i = 0; i < 3; ++i) {
      if (!(v[i] > -1 && v[i] < static_cast<double>(size))) parser.error(Code::bad_value, message);
      result[i] = static_cast<std::uint32_t>(v[i]);
    }
    return result;
  }

  bool at_index() { return !parser.at('<') && !parser.at('}') && parser.at_number_start(); }

  std::int32_t texture_index() {
    const int index = parser.parse_int();
    if (index < 0 || static_cast<std::size_t>(index) >= data->textures.size())
      parser.error(Code::bad_value, "Texture index out of range in mesh2.");
    parser.optional_comma();
    return index;
  }

  void face_textures(MeshTriangle& t) {
    if (data->textures.empty() || !at_index()) return;
    t.texture[0] = texture_index();
    if (!at_index()) return;
    t.texture[1] = texture_index();
    if (!at_index()) parser.error(Code::bad_value, "A face of a mesh2 has one or three texture indices, not two.");
    t.texture[2] = texture_index();
  }

  void face_indices() {
    const double count = open_list();
    if (count == 0) parser.error(Code::degenerate, "No triangles in triangle mesh.");
    const std::size_t size = checked_count(parser, count, "faces", sizeof(MeshTriangle));
    data->triangles.reserve(std::min<std::size_t>(size, 1 << 22));  // pages that stay empty cost nothing
    const std::size_t vertices = data->vertices.size();
    for (std::size_t i = 0; i < size; ++i) {
      MeshTriangle t;
      t.vertex = indices(vertices, "Mesh face index out of range.");
      t.normal = {0, 0, 0};
      t.uv = {0, 0, 0};
      t.has_uv = true;
      parser.optional_comma();
      face_textures(t);
      data->triangles.push_back(t);
    }
    close_block(parser);
  }

  void uv_indices() {
    const double count = open_list();
    if (count != static_cast<double>(data->triangles.size()))
      parser.error(Code::incompatible, "Number of uv indices must equal number of faces.");
    if (data->uvs.empty()) data->uvs.push_back({0, 0});
    for (MeshTriangle& t : data->triangles) {
      t.uv = indices(data->uvs.size(), "Mesh UV index out of range.");
      parser.optional_comma();
    }
    close_block(parser);
  }

  void normal_indices() {
    const double count = open_list();
    if (count > static_cast<double>(data->triangles.size()))
      parser.error(Code::incompatible, "Number of normal indices cannot be more than the number of faces.");
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(0.0, count)); ++i) {
      MeshTriangle& t = data->triangles[i];
      t.normal = indices(data->normals.size(), "Mesh normal index out of range.");
      t.smooth = true;
      parser.optional_comma();
    }
    close_block(parser);
  }

  void default_uv_indices() {
    if (data->uvs.empty()) data->uvs.push_back({0, 0});
    if (data->uvs.size() == data->vertices.size()) {
      for (MeshTriangle& t : data->triangles) t.uv = t.vertex;
    } else if (data->uvs.size() != 1) {
      parser.error(Code::missing_item, "Missing uv_indicies section in mesh2.");
    }
  }

  void default_normal_indices() {
    if (data->normals.empty()) return;
    if (data->normals.size() != data->vertices.size())
      parser.error(Code::missing_item, "Missing normal_indicies section in mesh2.");
    for (MeshTriangle& t : data->triangles) {
      t.normal = t.vertex;
      t.smooth = true;
    }
  }
};

}  // namespace

ObjectRef parse_mesh2(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    object.shape = scene::Mesh{Mesh2Reader(parser).read(), {}};
  });
}

}  // namespace verisim::parser
