// What may follow the numbers of any object: textures, transformations, flags, bounds.
#include "parser/keywords/keywords.h"

namespace verisim::parser {
namespace {

constexpr Keyword kModifierWords[] = {
    {"bounded_by", "@modifier clipped_by", "bounded_by { OBJECT ... }", "an automatic box",
     "Bounds the object by hand: rays that miss these objects skip it. bounded_by { clipped_by } takes the clips."},
    {"clipped_by", "@modifier bounded_by", "clipped_by { OBJECT ... }", "",
     "Cuts away what lies outside these objects without closing the cut: the object becomes hollow to look into."},
    {"collect", "object_photons", "photons { collect BOOL }", "on", "Whether photons are stored on the object."},
    {"cutaway_textures", "difference intersection", "cutaway_textures", "off",
     "Cut faces take the texture of what was cut, not of the cutter, where the cutter has none."},
    {"double_illuminate", "@modifier", "double_illuminate [BOOL]", "off",
     "Light from behind lights the surface, too: for thin sheets."},
    {"dtag", "@modifier", "dtag [N]", "", "A number for debugging in some versions of POV-Ray; read and ignored."},
    {"finish", "@modifier component texture value #default", "finish { ITEM ... }", "",
     "How the surface reflects light: ambient, diffuse, highlights, mirrors."},
    {"hollow", "@modifier", "hollow [BOOL]", "off",
     "Lets fog and media fill the inside of the object; without it they are kept out."},
    {"importance", "object_radiosity", "radiosity { importance A }", "1",
     "The share of radiosity samples, from 0 to 1, that the object is worth."},
    {"interior", "@modifier material value", "interior { ITEM ... }", "",
     "What is inside: refraction, absorption, media."},
    {"interior_texture", "@modifier material", "interior_texture { ITEM ... }", "the texture",
     "The texture of the surface seen from inside."},
    {"inverse", "@modifier", "inverse [BOOL]", "off", "Swaps inside and outside for CSG."},
    {"inverse", "transform", "transform { ITEM ... inverse }", "",
     "Turns the transformation so far into the one that undoes it."},
    {"material", "@modifier value", "material { texture { ... } interior { ... } }", "",
     "Texture and interior together, under one name."},
    {"matrix", "@transform", "matrix <M00, M01, M02, M10, M11, M12, M20, M21, M22, M30, M31, M32>", "",
     "Any linear transformation, and a move in the last three numbers."},
    {"no_image", "@modifier", "no_image [BOOL]", "off", "The camera does not see the object; mirrors and shadows do."},
    {"no_radiosity", "@modifier", "no_radiosity [BOOL]", "off", "Rays that gather radiosity do not see the object."},
    {"no_reflection", "@modifier", "no_reflection [BOOL]", "off", "Mirrors do not see the object."},
    {"no_shadow", "@modifier", "no_shadow [BOOL]", "off", "The object throws no shadow."},
    {"normal", "@modifier component texture camera global_radiosity value #default",
     "normal { PATTERN [SIZE] ITEM ... }", "",
     "Bumps that are not there: bends the surface's normal by a pattern. In camera: bends the rays. In radiosity (on "
     "or off): bumps count for gathering light."},
    {"pass_through", "object_photons", "photons { pass_through [BOOL] }", "off",
     "Photons go through the object as if it were not there."},
    {"photons", "@modifier", "photons { target [A] reflection BOOL refraction BOOL collect BOOL pass_through BOOL }",
     "", "How the object takes part in photon mapping: as a target, what it sends on, whether it shows caustics."},
    {"pigment", "@modifier component texture sky_sphere value #default", "pigment { COLOR | PATTERN ITEM ... }", "",
     "The colour of a surface: one, or a pattern of many, with its transparency."},
    {"radiosity", "@modifier #default", "radiosity { importance A }", "",
     "How many radiosity samples the object is worth."},
    {"reflection", "object_photons light_photons", "photons { reflection BOOL }", "off",
     "Whether photons are followed that the object reflects; in a light: which this light sends there."},
    {"refraction", "object_photons light_photons", "photons { refraction BOOL }", "off",
     "Whether photons are followed that the object refracts; in a light: which this light sends there."},
    {"rotate", "@transform", "rotate <X, Y, Z>", "",
     "Turns around the x axis, then y, then z, by degrees, around the origin. Seen along the axis towards the origin "
     "it turns clockwise (left-handed)."},
    {"scale", "@transform", "scale <X, Y, Z>", "", "Stretches along the axes, from the origin."},
    {"split_union", "@modifier", "split_union BOOL", "on",
     "Whether a union is taken apart into its parts for the search."},
    {"target", "object_photons", "photons { target [A] }", "1",
     "Photons are shot at this object; larger numbers mean fewer of them."},
    {"texture", "@modifier component material mesh_triangle material_map texture_list value #default",
     "texture { pigment { ... } normal { ... } finish { ... } }", "#default",
     "The look of a surface. Several textures are layers: all but the lowest should be transparent in places."},
    {"texture_list", "mesh_triangle", "texture_list { TEXTURE TEXTURE TEXTURE }", "",
     "A texture for each corner of the triangle, blended between them."},
    {"transform", "@transform value", "transform { ITEM ... } | transform NAME", "",
     "Several transformations as one, or one that was declared."},
    {"translate", "@transform", "translate <X, Y, Z>", "", "Moves along the axes."},
    {"uv_mapping", "@modifier", "uv_mapping", "off",
     "The texture follows the coordinates of the surface instead of space."},
};

}  // namespace

const KeywordSection kModifiers{
    "Modifiers of objects", "modifiers",
    "They follow the numbers of an object, in any order; transformations act one after the other, on all that stands "
    "before them.",
    kModifierWords};

}  // namespace verisim::parser
