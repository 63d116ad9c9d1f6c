// What shading and shadows know of the surfaces of objects: their textures, and POV-Ray's flags of what is opaque (spec
// 06 9.3).
#include <algorithm>
#include <unordered_set>
#include <utility>

#include "tracer/textures/evaluation/pigment.h"
#include "tracer/world/world_impl.h"

namespace verisim::accel {
namespace {

// POV-Ray flags layers, and material maps of what is flagged, but no other maps of textures.
bool flagged_opaque(const textures::CompiledTexture& texture) {
  if (!texture.patterned()) return texture.opaque;
  return texture.material_map &&
         std::ranges::all_of(texture.map, [](const auto& entry) { return flagged_opaque(*entry.value); });
}
bool flagged_opaque(const scene::TexturePtr& texture, textures::Compiler& compiler) {
  return flagged_opaque(*compiler.texture(texture));
}
// The textures of the object itself, which its children may have replaced.
bool flagged_opaque(const scene::Object& object, textures::Compiler& compiler) {
  return object.texture && flagged_opaque(object.texture, compiler) &&
         (!object.interior_texture || flagged_opaque(object.interior_texture, compiler));
}
// What a blob's pigments were when its statement ended decides, whatever `pigment` made of them in a copy since.
bool was_flagged_opaque(const scene::Object& object, textures::Compiler& compiler) {
  const auto* blob = object.as<std::shared_ptr<const scene::Blob>>();
  return blob && (*blob)->first_texture && flagged_opaque((*blob)->first_texture, compiler) &&
         std::ranges::all_of((*blob)->components, [&](const scene::BlobComponent& component) {
           return !component.texture || flagged_opaque(component.texture, compiler);
         });
}

}  // namespace

void World::Impl::add_surfaces(Shape& shape, int frame_object, const Shape* cutaway, textures::Compiler& compiler) {
  const scene::Object& o = *shape.object;
  const bool container = o.as<scene::Csg>() || o.as<scene::LightSource>() || o.as<scene::LightGroup>();
  if (container) {
    const auto* csg = o.as<scene::Csg>();
    if (!cutaway && csg && (csg->kind != scene::CsgKind::union_ || !o.clipped_by.empty())) cutaway = &shape;
    const auto outer = handed_down;
    if (o.texture && compiler.texture(o.texture)->images_filter)
      handed_down = {o.texture.get(), reveals_images(o.texture, compiler)};
    for (const auto& child : shape.children()) add_surfaces(*child, frame_object, cutaway, compiler);
    handed_down = outer;
    return;
  }
  static const scene::Interior kNoInterior;
  any_isosurface = any_isosurface || o.as<std::shared_ptr<const scene::Isosurface>>();
  Surface& s = surfaces.add();
  s.object = &o;
  s.texture = o.texture ? compiler.texture(o.texture) : nullptr;
  s.interior_texture = o.interior_texture ? compiler.texture(o.interior_texture) : nullptr;
  s.interior = o.interior ? o.interior.get() : &kNoInterior;
  s.frame_object = frame_object;
  s.double_illuminate = o.double_illuminate;
  s.ignore_global_lights = o.ignore_global_lights;
  s.uv_mapping = o.uv_mapping;
  s.no_radiosity = o.no_radiosity;
  s.cutaway = cutaway;
  s.opaque = s.texture && s.texture->opaque && (!s.interior_texture || s.interior_texture->opaque);
  Surface::Rest rest;
  for (const scene::TexturePtr& texture : shape.extra_textures()) {
    rest.extra_textures.push_back(texture ? compiler.texture(texture) : s.texture);
    s.opaque = s.opaque && rest.extra_textures.back() && rest.extra_textures.back()->opaque;
  }
  const auto flag = [](const textures::CompiledTexture* texture) { return texture && flagged_opaque(*texture); };
  // A mesh or a blob is opaque if it is so from outside.
  const bool from_outside = !s.interior_texture || o.as<scene::Mesh>() || o.as<std::shared_ptr<const scene::Blob>>();
  const bool flagged =
      was_flagged_opaque(o, compiler) ||
      (flag(s.texture) && std::ranges::all_of(rest.extra_textures, flag) && (from_outside || flag(s.interior_texture)));
  const bool revealed =
      reveals_images(o, compiler) ||
      std::ranges::any_of(shape.extra_textures(), [&](const auto& one) { return reveals_images(one, compiler); });
  s.opaque = (s.opaque || flagged) && !revealed;
  ready_maps.add(o.texture, compiler), ready_maps.add(o.interior_texture, compiler);
  for (const scene::TexturePtr& texture : shape.extra_textures()) ready_maps.add(texture, compiler);
  // What casts no shadow by itself does so in a union that casts one, but is not remembered.
  const bool remembered = cutaway ? !cutaway->object->no_shadow && flagged_opaque(*cutaway->object, compiler) &&
                                        !reveals_images(*cutaway->object, compiler)
                                  : !o.no_shadow && flagged && !revealed;
  s.remembered = !remembered ? nullptr : cutaway ? cutaway : &shape;
  for (const auto& light : o.group_lights) rest.group_lights.push_back(light.get());
  if (!rest.group_lights.empty() || !rest.extra_textures.empty()) s.rest = &surface_rests.emplace_back(std::move(rest));
  shape.surface = &s;
}

bool World::Impl::reveals_images(const scene::Object& object, textures::Compiler& compiler) const {
  return reveals_images(object.texture, compiler) || reveals_images(object.interior_texture, compiler);
}

bool World::Impl::reveals_images(const scene::TexturePtr& texture, textures::Compiler& compiler) const {
  if (!texture) return false;
  return texture.get() == handed_down.first ? handed_down.second : ready_maps.reveal(texture, compiler);
}

void World::Impl::hand_down(const scene::Object* whole, textures::Compiler& compiler) {
  handed_down = {};
  if (!whole || !compiler.texture(whole->texture)->images_filter) return;
  const auto [known, fresh] = dissolved.try_emplace(whole, false);
  if (fresh) known->second = ready_maps.reveal(whole->texture, compiler);
  handed_down = {whole->texture.get(), known->second};
}

void World::Impl::find_twice_filtering(std::size_t first) {
  // Some of its points may block all light.
  const auto may_block = [](const Surface& surface) {
    if (surface.opaque || !surface.texture || surface.texture->patterned()) return true;
    return std::ranges::any_of(surface.texture->layers, [](const textures::CompiledLayer& layer) {
      return layer.pigment->source != textures::CompiledPigment::Source::plain;
    });
  };
  // Only CSG is remembered for what its parts block; a bounded union may hold very many other things.
  std::unordered_set<const Shape*> blockers;
  for (std::size_t i = first; i < surfaces.size(); ++i)
    if (const Surface& s = surfaces[i]; s.cutaway && s.remembered && may_block(s)) blockers.insert(s.remembered);
  for (std::size_t i = first; i < surfaces.size(); ++i) {
    Surface& s = surfaces[i];
    s.filters_twice = !s.opaque && !s.object->no_shadow && s.remembered && blockers.contains(s.remembered);
    filters_twice = filters_twice || s.filters_twice;
  }
}

}  // namespace verisim::accel
