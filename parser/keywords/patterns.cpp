// Patterns: what gives every point of space a value from 0 to 1.
#include "parser/keywords/keywords.h"
#include "tracer/scene/pattern_kinds.h"

namespace verisim::parser {
namespace {

constexpr Keyword kPatternWords[] = {
    {"pigment", "pigment", "checker pigment { ... }, pigment { ... }", "",
     "One of the pigments of a pattern that takes a list of them."},
    {"normal", "normal", "hexagon normal { ... }, normal { ... }", "",
     "One of the normals of a pattern that takes a list of them."},
    {"texture", "texture", "brick texture { ... }, texture { ... }", "",
     "One of the textures of a pattern that takes a list of them."},
    {"density", "density", "checker density { ... }, density { ... }", "",
     "One of the densities of a pattern that takes a list of them."},
    {"agate", "@pattern function_pattern", "agate [agate_turb A]", "", "Bands as in polished agate."},
    {"altitude", "+slope", "slope { V altitude AXIS ... }", "",
     "Mixes the height along an axis into the slope: snow on mountains."},
    {"aoi", "@pattern", "aoi", "", "The angle between the ray and the surface: 0 at the edge, 0.5 to 1 inside."},
    {"average", "@pattern", "average", "",
     "No pattern: the mean of all entries of the map, weighted by their numbers."},
    {"boxed", "@pattern function_pattern", "boxed", "",
     "1 at the origin, falling to 0 at the faces of the cube from -1 to 1."},
    {"bozo", "@pattern function_pattern", "bozo", "", "Soft spots of noise: clouds."},
    {"brick", "@pattern function_pattern", "brick [MORTAR, BRICK] [brick_size V] [mortar A]", "",
     "Bricks with joints; takes two colours or textures."},
    {"bumps", "@pattern function_pattern", "bumps [A]", "", "Noise; as a normal: a rolling surface."},
    {"cells", "@pattern function_pattern", "cells", "", "Unit cubes with a random value each."},
    {"checker", "@pattern function_pattern", "checker [A, B]", "",
     "Unit cubes of two colours in turn; takes two colours or textures."},
    {"crackle", "@pattern function_pattern", "crackle [form V] [metric A] [offset A] [solid]", "",
     "Cells around random points with cracks between them: stones, leather, scales."},
    {"cubic", "@pattern function_pattern", "cubic [A, B, C, D, E, F]", "",
     "Six colours, one a side of a cube around the origin."},
    {"cylindrical", "@pattern function_pattern", "cylindrical", "", "1 on the y axis, falling to 0 at the distance 1."},
    {"density_file", "@pattern function_pattern", "density_file df3 \"file.df3\" [interpolate N]", "",
     "Values from a file of voxels, in the unit cube."},
    {"dents", "@pattern function_pattern", "dents [A]", "", "Sharp noise; as a normal: dents."},
    {"df3", "+density_file", "density_file df3 \"file.df3\"", "",
     "The format of voxel files: three sizes of two bytes, then the values, high bytes first."},
    {"facets", "normal", "facets coords A | size A", "", "Flat pieces, as if the surface were cut with a chisel."},
    {"function", "@pattern function_pattern", "function { EXPRESSION }", "", "The value is a function of x, y and z."},
    {"gradient", "@pattern function_pattern", "gradient AXIS", "",
     "Rises from 0 to 1 along an axis, and again in each unit."},
    {"granite", "@pattern function_pattern", "granite", "", "Fine noise of many sizes."},
    {"hexagon", "@pattern function_pattern", "hexagon [A, B, C]", "", "Hexagonal tiles of three colours in x and z."},
    {"image_pattern", "@pattern function_pattern", "image_pattern { [TYPE] \"picture\" ... }", "",
     "The brightness or transparency of a picture as a pattern."},
    {"julia", "@pattern function_pattern +magnet", "julia <A, B>, N", "", "A Julia set in x and y with N iterations."},
    {"leopard", "@pattern function_pattern", "leopard", "", "Regular round spots."},
    {"magnet", "@pattern function_pattern", "magnet 1|2 mandel N | magnet 1|2 julia <A, B>, N", "",
     "Two fractals that come from the physics of magnets."},
    {"mandel", "@pattern function_pattern +magnet", "mandel N", "", "The Mandelbrot set in x and y with N iterations."},
    {"marble", "@pattern function_pattern", "marble", "", "Straight bands along x; turbulence makes marble of them."},
    {"object", "@pattern function_pattern", "object { OBJECT [OUTSIDE, INSIDE] }", "",
     "Two colours or textures: outside and inside an object."},
    {"onion", "@pattern function_pattern", "onion", "", "Shells around the origin, one a unit."},
    {"pavement", "@pattern", "pavement [number_of_sides N] [number_of_tiles N] [pattern N]", "",
     "Tiles made of triangles, squares or hexagons that fill the plane of x and z."},
    {"pigment_pattern", "@pattern function_pattern", "pigment_pattern { PIGMENT }", "",
     "The brightness of another pigment as a pattern."},
    {"planar", "@pattern function_pattern", "planar", "", "1 at the plane y = 0, falling to 0 at the distance 1."},
    {"quilted", "@pattern function_pattern", "quilted [control0 A] [control1 A]", "",
     "Unit cubes that swell like a quilt."},
    {"radial", "@pattern function_pattern", "radial", "", "Rises once around the y axis."},
    {"ripples", "@pattern function_pattern", "ripples [A]", "",
     "Rings of ripples from ten centres, as drops in water."},
    {"slope", "@pattern", "slope { V [, LOW, HIGH] [altitude AXIS [, LOW, HIGH]] [point_at] }", "",
     "How the surface lies to a direction: 0.5 is upright to it."},
    {"point_at", "+slope", "slope { point_at P ... }", "", "The direction is that to this place."},
    {"spherical", "@pattern function_pattern", "spherical", "", "1 at the origin, falling to 0 at the distance 1."},
    {"spiral1", "@pattern function_pattern", "spiral1 N", "", "A spiral of N arms around the z axis."},
    {"spiral2", "@pattern function_pattern", "spiral2 N", "", "A double spiral of N arms around the z axis."},
    {"spotted", "@pattern function_pattern", "spotted", "", "Spots of noise, as bozo."},
    {"square", "@pattern", "square [A, B, C, D]", "", "Square tiles of four colours in x and z."},
    {"tile2", "texture", "tiles { TEXTURE tile2 TEXTURE }", "", "Old: the second texture of tiles."},
    {"tiling", "@pattern", "tiling N", "",
     "One of 27 tilings of the plane of x and z; every kind of tile has a value of its own."},
    {"triangular", "@pattern", "triangular [A, B, C, D, E, F]", "", "Triangular tiles of six colours in x and z."},
    {"waves", "@pattern function_pattern", "waves [A]", "", "Waves from ten centres, longer ones than ripples."},
    {"wood", "@pattern function_pattern", "wood", "", "Rings around the z axis; turbulence makes wood of them."},
    {"wrinkles", "@pattern function_pattern", "wrinkles [A]", "",
     "Fine noise of several sizes; as a normal: crumpled foil."},
};

constexpr bool is_elsewhere(std::string_view word) {  // images.cpp, textures.cpp
  return word == "bump_map" || word == "image_map" || word == "uv_mapping";
}
#define VERISIM_PATTERN(name, params, list, traits) \
  static_assert(describes(kPatternWords, #name) || is_elsewhere(#name), "a pattern without description");
VERISIM_PATTERNS_WITH_KEYWORD(VERISIM_PATTERN)
#undef VERISIM_PATTERN

}  // namespace

const KeywordSection kPatterns{
    "Patterns", "patterns",
    "A pattern gives every point of space a value from 0 to 1. `pigment`, `normal`, `texture` and `density` turn it "
    "into colours, bumps, textures and densities by a map; `function { pattern { ... } }` reads it as a number.",
    kPatternWords};

}  // namespace verisim::parser
