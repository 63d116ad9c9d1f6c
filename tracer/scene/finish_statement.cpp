// What POV-Ray does with an object when its top-level statement ends: textures, interiors and flags run down the tree
// of children, every object gets its own interior or shares its parent's, light groups hand their lights to their
// objects (spec 03 5.3 and 5.4; 06 6.1, 6.6 and 10.1).
#include "tracer/scene/finish_statement.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "tracer/scene/copy_on_write.h"
#include "tracer/scene/parts.h"

namespace verisim::scene {

namespace {

bool has_children(const Object& object) { return object.as<Csg>() || object.as<LightGroup>(); }
// Such that was never inverted is passed over where properties are handed down, interiors too (spec 03 5.4).
bool is_empty_csg(const Object& object) {
  return object.as<Csg>() && !object.was_inverted &&
         std::ranges::all_of(declared_children(object),
                             [](const ObjectPtr& part) { return part->as<LightSource>() != nullptr; });
}

// Children are built by the parser as ordinary objects; one that is shared with a declared identifier is copied before
// it is changed.
bool has_texture_anywhere(const Object& object, SharedLists& seen) {
  // POV-Ray forgets of CSG that is inverted, be it once or twice, that it holds textures, until it reads a part of one
  // (spec 03 5.3).
  if (object.texture_forgotten && (has_children(object) || object.as<std::shared_ptr<const Text>>())) return false;
  if (object.texture) return true;
  if (!seen.first(object)) return false;
  for (const ObjectPtr& child : declared_children(object)) {
    if (has_texture_anywhere(*child, seen)) return true;
  }
  return false;
}

bool has_texture_anywhere(const Object& object) {
  SharedLists seen;
  return has_texture_anywhere(object, seen);
}

bool is_light(const Object& object) { return object.as<LightSource>() != nullptr; }

// A union whose objects are all without shadow is, too.
class ShadowlessUnion {
 public:
  bool is(const Object& object) {
    const auto* csg = object.as<Csg>();
    if (!csg || csg->kind != CsgKind::union_) return false;
    const std::vector<ObjectPtr>& children = declared_children(object);
    const auto [place, fresh] = known_.try_emplace(&children, false);
    bool& known = place->second;
    if (!fresh) return known;
    bool any = false;
    for (const ObjectPtr& child : children) {
      if (is_light(*child)) continue;
      if (!child->no_shadow && !is(*child)) return false;
      any = true;
    }
    return known = any;
  }

 private:
  std::unordered_map<const void*, bool> known_;  // by the list that copies share
};

bool is_shadowless_union(const Object& object) { return ShadowlessUnion().is(object); }

// Legacy finish keywords of the top layer act on the interior; `refraction` always does, with 1 when it was not written
// (spec 06 6.6).
void apply_legacy_finish(Object& object) {
  if (!object.texture || object.texture->patterned() || !object.interior) return;
  const Finish& finish = object.texture->layers.back().finish;
  Interior& interior = *object.interior;
  if (finish.ior && *finish.ior >= 0) {
    interior.ior = *finish.ior;
    interior.dispersion = 1;
  }
  if (finish.caustics) interior.caustics = *finish.caustics;
  interior.refraction = finish.refraction.value_or(1.0f);
}

// Plain enough that nobody asks for the surface's uv. May be false for others of them.
bool looks_at_points_only(const Pattern& pattern) {
  if (pattern.kind == PatternKind::plain || pattern.kind == PatternKind::none) return true;
  return pattern.kind != PatternKind::function &&
         !info(pattern.kind).is(PatternInfo::kNotRemembered | PatternInfo::kNoValue);
}
bool looks_at_points_only(const TextureLayer& layer) {
  return looks_at_points_only(layer.pigment->pattern) && !layer.pigment->pigment_map &&
         (!layer.normal || (looks_at_points_only(layer.normal->pattern) && !layer.normal->normal_map));
}
bool looks_at_points_only(const Texture& texture) {
  return !texture.patterned() &&
         std::ranges::all_of(texture.layers, [](const TextureLayer& layer) { return looks_at_points_only(layer); });
}

// The transformation of a sphere's uv is as large as all else of it, and hardly ever wanted.
void forget_uv(Object& object) {
  if (object.uv_mapping || !object.texture || !looks_at_points_only(*object.texture)) return;
  if (object.interior_texture && !looks_at_points_only(*object.interior_texture)) return;
  object.uv_transform.reset();
}

class Walk {
 public:
  explicit Walk(const TexturePtr& texture) : default_texture(texture) {}

  void object(Object& o, bool keeps_untextured) {
    itself(o, keeps_untextured);
    if (has_children(o)) children(o);
  }

  void itself(Object& o, bool keeps_untextured) {
    auto* const light = o.as<LightSource>();
    if (light && light->looks_like) inherit(o, writable(light->looks_like));
    if (!o.texture && !keeps_untextured && (!has_children(o) || !has_texture_anywhere(o))) o.texture = default_texture;
    // Objects written apart have interiors of their own, even copies of one declared object (spec 06 6.1).
    if (o.interior) {
      if (!interior_is_inherited) o.interior = std::make_shared<Interior>(*o.interior);
    } else if (!is_empty_csg(o)) {  // which keeps no fog out, though everything is inside of such an intersection
      o.interior = std::make_shared<Interior>();
    }
    if (o.interior) {
      // Lights and CSG of nothing else leave it as their neighbours made it.
      if (!light && !is_empty_csg(o)) o.interior->hollow = o.is_hollow();
      if (!o.interior->ior_given) o.interior->dispersion = 1;
    }
    apply_legacy_finish(o);
    if (o.uv_transform) forget_uv(o);
    if (light) attached_objects(o, *light);
  }

  void children(Object& parent) {
    // The flags of a cutaway intersection reach all descendants; only its direct children stay without a texture (spec
    // 03 5.3), and of these not texts, which are unions of letters, unless they are inverted, which are intersections.
    auto* csg = std::get_if<Csg>(&parent.shape);
    const bool intersects =
        csg ? csg->kind == CsgKind::intersection : parent.as<LightGroup>() != nullptr && parent.inverted;
    const bool keeps_untextured = parent.cutaway_textures && intersects;
    for (ObjectPtr& pointer : own_children(parent)) {
      Object& child = writable(pointer);
      inherit(parent, child);
      const bool saved = interior_is_inherited;
      interior_is_inherited = !child.interior;
      if (interior_is_inherited && !is_empty_csg(child)) child.interior = parent.interior;
      object(child, keeps_untextured && (child.inverted || !child.as<std::shared_ptr<const Text>>()));
      interior_is_inherited = saved;
    }
    parent.no_shadow = parent.no_shadow || is_shadowless_union(parent);
  }

 private:
  const TexturePtr& default_texture;
  bool interior_is_inherited = false;

  void attached_objects(const Object& around, LightSource& light) {
    for (ObjectPtr* attached : {&light.looks_like, &light.projected_through}) {
      if (!*attached) continue;
      // What a light looks like shares the interior of those around the light, as a part of CSG does.
      const bool shares = attached == &light.looks_like && !(*attached)->interior;
      if (shares) writable(*attached).interior = around.interior;
      const bool saved = std::exchange(interior_is_inherited, shares);
      object(writable(*attached), false);
      interior_is_inherited = saved;
    }
  }

  void inherit(const Object& parent, Object& child) {
    if (is_empty_csg(child)) return;
    if (!child.texture && parent.texture) {
      child.texture = parent.texture;
      child.uv_mapping = child.uv_mapping || parent.uv_mapping;
    }
    // A child without interior_texture takes the uv flag even with a texture of its own (spec 03 5.4).
    if (!child.interior_texture) {
      child.interior_texture = parent.interior_texture;
      child.uv_mapping = child.uv_mapping || parent.uv_mapping;
    }
    child.no_shadow = child.no_shadow || parent.no_shadow;
    child.no_image = child.no_image || parent.no_image;
    child.no_reflection = child.no_reflection || parent.no_reflection;
    child.no_radiosity = child.no_radiosity || parent.no_radiosity;
    child.cutaway_textures = child.cutaway_textures || parent.cutaway_textures;
    if (child.radiosity_importance < 0) child.radiosity_importance = parent.radiosity_importance;
    if (parent.photons->given) child.photons.edit().inherit(*parent.photons);
  }
};

using Lights = std::vector<std::shared_ptr<const LightSource>>;

void add_lights(Object& object, const Lights& lights) {
  std::vector<std::shared_ptr<const LightSource>>& all = object.group_lights.edit();
  all.insert(all.end(), lights.begin(), lights.end());
  for (const ObjectPtr& child : own_children(object)) {
    // A group written in place that has lights of its own keeps the outer lights away from its objects (spec 06 10.1).
    if (const auto* group = child->as<LightGroup>(); group && !group->from_identifier) {
      bool has_lights = false;
      for (const ObjectPtr& inner : declared_children(*child)) has_lights = has_lights || is_light(*inner);
      if (has_lights) continue;
    }
    if (!is_light(*child)) add_lights(const_cast<Object&>(*child), lights);
  }
}

void hide_global_lights(Object& object, bool hide) {
  object.ignore_global_lights = hide;
  for (const ObjectPtr& child : own_children(object)) hide_global_lights(const_cast<Object&>(*child), hide);
}

// What an inverted light_group is once its lights are known, which stand in what they light: an intersection of its
// other children, which are inverted themselves.
Csg inverted_union(const std::vector<ObjectPtr>& children) {
  Csg csg;
  csg.kind = CsgKind::intersection;
  for (const ObjectPtr& child : children) {
    const auto* light = child->as<LightSource>();
    if (!light)
      csg.children.push_back(child);
    else if (light->looks_like)
      csg.children.push_back(light->looks_like);
  }
  return csg;
}

void collect_light_groups(Object& object, bool inside_group) {
  if (const auto* csg = object.as<Csg>(); csg && csg->postponable) return;  // no group below
  const std::vector<ObjectPtr>& children = own_children(object);
  const auto* group = object.as<LightGroup>();
  if (group) {
    // The outermost group decides about the global lights.
    if (!inside_group) hide_global_lights(object, !group->global_lights);
    Lights lights;
    for (const ObjectPtr& child : children) {
      if (const auto* light = child->as<LightSource>()) lights.emplace_back(child, light);
    }
    if (!lights.empty()) add_lights(object, lights);
  }
  for (const ObjectPtr& child : children) collect_light_groups(const_cast<Object&>(*child), inside_group || group);
  if (group && object.inverted) object.shape = inverted_union(children);
}

}  // namespace

void finish_children(Object& parent, const TexturePtr& default_texture) { Walk(default_texture).children(parent); }

void finish_statement(Object& object, const TexturePtr& default_texture) {
  Walk walk(default_texture);
  // What is below a copy may wait only here: deeper in the tree later siblings may share its interior, and the last one
  // written wins.
  if (auto* csg = object.as<Csg>(); csg && csg->postponable && (csg->children.shared() || csg->children.postponed())) {
    walk.itself(object, false);
    object.no_shadow = object.no_shadow || is_shadowless_union(object);
    csg->children.postpone_end(default_texture);
    return;
  }
  walk.object(object, false);
  collect_light_groups(object, false);
}

}  // namespace verisim::scene
