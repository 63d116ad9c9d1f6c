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

// A blob or mesh is only asked for those of its components, be there any or not.
bool has_parts_with_textures(const scene::Object& object) {
  return object.as<scene::Mesh>() || object.as<std::shared_ptr<const scene::Blob>>();
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

// A hit on an untextured primitive shows what the CSG object around it is made of at that point (spec 03 5.3): adds all
// textures that there are.
void World::Impl::add_cutaway(const Shape& shape, const Vec3& p, std::vector<textures::WeightedTexture>& out) const {
  const auto* csg = shape.object->as<scene::Csg>();
  if (!csg) {
    if (shape.surface && shape.surface->texture) out.push_back({shape.surface->texture, 1});
    return;
  }
  const auto children = shape.children();
  if (csg->difference) {
    if (children.empty()) return;
    // Nested CSG may hold its children the other way round (shapes/csg/csg.cpp).
    const scene::Object* const first = scene::children_of(*shape.object)[0].get();
    const Shape& body = children.front()->object == first ? *children.front() : *children.back();
    if (body.object == first && body.inside_unclipped(p)) add_cutaway(body, p, out);
    return;
  }
  for (const auto& child : children)
    if (child->inside_unclipped(p)) add_cutaway(*child, p, out);
}

void World::weighted_textures(const Hit& hit, bool inside_hit, std::vector<textures::WeightedTexture>& out) const {
  out.clear();
  const Surface& surface = *hit.shape->surface;
  if (!surface.texture && surface.cutaway && surface.extra_textures().empty()) {
    if (has_parts_with_textures(*surface.object)) return;  // black
    impl_->add_cutaway(*surface.cutaway, hit.point, out);
    for (textures::WeightedTexture& each : out) each.weight = 1 / static_cast<float>(out.size());
    return;
  }
  if (surface.extra_textures().empty()) return;
  thread_local std::vector<shapes::TextureShare> shares;
  shares.clear();
  hit.shape->texture_shares(hit, inside_hit, shares);
  for (const shapes::TextureShare& share : shares) {
    const auto* texture =
        share.texture < 0 ? surface.texture : surface.extra_textures()[static_cast<std::size_t>(share.texture)];
    if (texture) out.push_back({texture, share.weight});
  }
}

}  // namespace verisim::accel
