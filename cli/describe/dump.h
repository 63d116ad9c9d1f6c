// `verisim check --dump`: the evaluated scene as JSON (docs/dump.md), for tests and other programs.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tracer/scene/scene.h"

namespace verisim::cli {

// Writes every description to one document. Textures and interiors are listed once and referred to by their index.
class SceneDump {
 public:
  using Json = nlohmann::ordered_json;
  static constexpr int kFormatVersion = 1;

  Json scene(const scene::Scene& scene);

  // dump_textures.cpp
  Json texture(const scene::TexturePtr& texture);  // an index; null: none
  Json pigment(const scene::Pigment& pigment);
  Json normal(const scene::Normal& normal);
  Json density(const scene::Density& density);
  Json media(const scene::Media& media);
  Json interior(const scene::InteriorPtr& interior);  // an index; null: none
  void pattern(Json& out, const scene::Pattern& pattern);

  // dump_objects.cpp
  Json object(const scene::Object& object);
  Json light(const scene::LightSource& light);

 private:
  std::vector<Json> textures_, interiors_;
  std::unordered_map<const void*, std::size_t> texture_index_, interior_index_;
  std::vector<scene::TexturePtr> keep_;
};

// Small values.
SceneDump::Json dump(const Vec2& v);
SceneDump::Json dump(const Vec3& v);
SceneDump::Json dump(const Rgb& c);
SceneDump::Json dump(const Color& c);
SceneDump::Json dump(const Transform& t);  // the 12 numbers of SDL's matrix
SceneDump::Json dump(const scene::SourceLocation& place);
SceneDump::Json dump(const scene::Turbulence& t);
SceneDump::Json dump(const FunctionPtr& function);
const char* dump_flag(scene::Flag flag);

}  // namespace verisim::cli
