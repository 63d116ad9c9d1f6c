// Objects: what has a shape, and the words that only one of them knows.
#include "parser/keywords/keywords.h"
#include "parser/keywords/object_statements.h"

namespace verisim::parser {
namespace {

constexpr Keyword kTable[] = {
    // clang-format off
    {"accuracy", "isosurface parametric", "accuracy A", "0.001", "How exactly the surface is found: less is finer and slower."},
    {"accuracy", "bicubic_patch", "accuracy A", "", "An old name of flatness."},
    {"all_intersections", "isosurface", "all_intersections", "max_trace 1", "Finds every place where a ray crosses the surface; needed in CSG."},
    {"b_spline", "sphere_sweep", "b_spline N, CENTRE, RADIUS, ...", "", "A soft curve that is led by its points and goes through none of them."},
    {"bezier_spline", "lathe prism", "bezier_spline N, POINT, ...", "", "Bezier curves of four points each: start, two handles, end."},
    {"bicubic_patch", "@object", "bicubic_patch { type T flatness F u_steps U v_steps V P1, ... P16 }", "", "A curved piece of surface with 4 by 4 control points."},
    {"blob", "@object", "blob { threshold T sphere { CENTRE, RADIUS, STRENGTH } ... }", "", "Soft balls and cylinders that flow into one another where their fields add up to the threshold."},
    {"box", "@object", "box { CORNER, CORNER }", "", "A box between two opposite corners, its faces along the axes."},
    {"box", "contained_by", "contained_by { box { CORNER, CORNER } }", "box { -1, 1 }", "The box that a surface is looked for in."},
    {"component", "blob", "component STRENGTH, RADIUS, CENTRE", "", "An old way to write a ball of a blob; write sphere { CENTRE, RADIUS, STRENGTH }."},
    {"composite", "@object", "composite { OBJECT ... }", "", "An old name of union."},
    {"cone", "@object", "cone { BASE, RADIUS, CAP, RADIUS [open] }", "", "A cone, or a piece of one, between two points with a radius at each."},
    {"conic_sweep", "prism", "conic_sweep", "linear_sweep", "The prism narrows to a point at the height 0."},
    {"contained_by", "isosurface parametric", "contained_by { box { ... } | sphere { ... } }", "box { -1, 1 }", "Where the surface is looked for; what is outside is cut off."},
    {"cube", "julia_fractal", "cube", "sqr", "The function z*z*z."},
    {"cubic", "@object", "cubic { <A1, ... A20> }", "", "A surface of the third order, by its 20 coefficients."},
    {"cubic_spline", "lathe prism sphere_sweep", "cubic_spline N, POINT, ...", "", "A smooth curve through the points (Catmull-Rom); the first and the last give directions only."},
    {"cylinder", "@object", "cylinder { BASE, CAP, RADIUS [open] }", "", "A cylinder between two points."},
    {"cylinder", "blob", "cylinder { END, END, RADIUS, STRENGTH }", "", "A soft cylinder with round ends: a component of the blob."},
    {"difference", "@object", "difference { OBJECT OBJECT ... }", "", "The first object without the others. A cutter that reaches a little beyond the faces it cuts leaves no speckles."},
    {"disc", "@object", "disc { CENTRE, NORMAL, RADIUS [, HOLE] }", "no hole", "A flat disc, perhaps with a round hole."},
    {"evaluate", "isosurface", "evaluate P0, P1, P2", "", "Lets the search adapt max_gradient while it runs: start, factor and falloff of the estimate."},
    {"face_indices", "mesh2", "face_indices { N, <A, B, C> [, TEXTURES], ... }", "", "The triangles, by the numbers of their corners in vertex_vectors."},
    {"flatness", "bicubic_patch", "flatness F", "0", "Parts of the patch that are flatter than this are not divided further."},
    {"function", "isosurface", "function { EXPRESSION }", "", "The surface is where the function of x, y, z equals the threshold; inside it is below."},
    {"function", "parametric", "function { X } function { Y } function { Z }", "", "The three coordinates of the surface as functions of u and v."},
    {"function", "height_field", "function WIDTH, HEIGHT { EXPRESSION }", "", "Heights that a function, pigment or pattern gives, instead of a picture."},
    {"height_field", "@object", "height_field { [TYPE] \"picture\" [smooth] [water_level W] }", "", "A landscape over the unit square; the heights are the brightness of a picture, or a function."},
    {"hierarchy", "blob height_field mesh mesh2", "hierarchy BOOL", "on", "Whether the parts are kept in boxes that speed the search up."},
    {"hypercomplex", "julia_fractal", "hypercomplex", "quaternion", "The fractal is one of hypercomplex numbers."},
    {"inside_vector", "mesh mesh2", "inside_vector V", "none", "Gives a closed mesh an inside: what a ray in this direction leaves through an odd number of triangles."},
    {"internal", "text", "text { internal N \"text\" DEPTH, OFFSET }", "", "One of the built-in fonts, by its number from 0 to 3."},
    {"intersection", "@object", "intersection { OBJECT OBJECT ... }", "", "What all of the objects have in common."},
    {"isosurface", "@object", "isosurface { function { F } contained_by { ... } threshold T max_gradient G }", "", "The surface where a function of x, y and z has a given value."},
    {"julia_fractal", "@object", "julia_fractal { <A, B, C, D> [quaternion | hypercomplex] [FUNCTION] max_iteration N precision P slice NORMAL, DISTANCE }", "", "A slice in three dimensions through a Julia set in four."},
    {"lathe", "@object", "lathe { [KIND] N, POINT, ... }", "linear_spline", "A curve of x and y turned around the y axis."},
    {"light_group", "@object", "light_group { LIGHT ... OBJECT ... [global_lights BOOL] }", "", "Lights that shine on the objects of the group alone."},
    {"linear_spline", "lathe prism sphere_sweep", "linear_spline N, POINT, ...", "the kind without a word", "Straight lines between the points."},
    {"linear_sweep", "prism", "linear_sweep", "linear_sweep", "The prism has the same outline at every height."},
    {"max_gradient", "isosurface parametric", "max_gradient G", "1.1, in parametric 1", "The steepest slope of the function. Too small leaves holes, too large costs time."},
    {"max_iteration", "julia_fractal", "max_iteration N", "20", "How often the function is repeated: more shows finer detail."},
    {"max_trace", "isosurface", "max_trace N", "1", "How many crossings with a ray are looked for."},
    {"merge", "@object", "merge { OBJECT OBJECT ... }", "", "Like union, without the surfaces inside: for transparent things."},
    {"mesh", "@object", "mesh { triangle { ... } ... [inside_vector V] }", "", "Many triangles as one object."},
    {"mesh2", "@object", "mesh2 { vertex_vectors { ... } [normal_vectors { ... }] [uv_vectors { ... }] [texture_list { ... }] face_indices { ... } [normal_indices { ... }] [uv_indices { ... }] }", "", "Many triangles that share their corners: the form that programs write."},
    {"normal_indices", "mesh2", "normal_indices { N, <A, B, C>, ... }", "face_indices", "The normals at the corners of the triangles, by their numbers in normal_vectors."},
    {"normal_vectors", "mesh2", "normal_vectors { N, V, ... }", "", "Normals that make the triangles look round."},
    {"object", "@object", "object { NAME [MODIFIER ...] }", "", "An object that was declared, with further modifiers."},
    {"open", "cone cylinder prism", "open", "closed", "Without the flat ends."},
    {"open", "isosurface", "open", "closed", "What the container cuts open stays open."},
    {"ovus", "@object", "ovus { BOTTOM_RADIUS, TOP_RADIUS }", "", "An egg along the y axis."},
    {"parametric", "@object", "parametric { function { X } function { Y } function { Z } <U1, V1>, <U2, V2> contained_by { ... } }", "", "A surface whose points are functions of two parameters u and v."},
    {"plane", "@object", "plane { NORMAL, DISTANCE }", "", "An endless flat surface; its inside is the side away from the normal."},
    {"poly", "@object", "poly { ORDER, <A1, ... An> }", "", "A surface of the order 2 to 35, by its coefficients."},
    {"polygon", "@object", "polygon { N, POINT, ... }", "", "A flat area with any outline. Repeating the first point closes it; further outlines make holes."},
    {"polynomial", "@object", "polynomial { ORDER, xyz(X, Y, Z): A, ... }", "", "A polynomial surface by the coefficients that are not zero."},
    {"precision", "julia_fractal", "precision P", "20", "How exactly the surface is found: its reciprocal is the tolerance."},
    {"precompute", "parametric", "precompute DEPTH, x, y, z", "", "Computes bounds of the named functions beforehand: faster at the price of memory."},
    {"prism", "@object", "prism { [KIND] [SWEEP] BOTTOM, TOP, N, POINT, ... [open] }", "linear_spline linear_sweep", "An outline in x and z, drawn out along y."},
    {"pwr", "julia_fractal", "pwr(X, Y)", "sqr", "The function z to the power of a complex number."},
    {"quadratic_spline", "lathe prism", "quadratic_spline N, POINT, ...", "", "Parabolas through the points; the first gives a direction only."},
    {"quadric", "@object", "quadric { <A, B, C>, <D, E, F>, <G, H, I>, J }", "", "A surface of the second order: A x2 + B y2 + C z2 + D xy + E xz + F yz + G x + H y + I z + J = 0."},
    {"quartic", "@object", "quartic { <A1, ... A35> }", "", "A surface of the fourth order, by its 35 coefficients."},
    {"quaternion", "julia_fractal", "quaternion", "quaternion", "The fractal is one of quaternions; the functions are sqr and cube."},
    {"reciprocal", "julia_fractal", "reciprocal", "sqr", "The function 1/z, of hypercomplex numbers."},
    {"slice", "julia_fractal", "slice NORMAL, DISTANCE", "<0, 0, 0, 1>, 0", "The plane in four dimensions that the fractal is cut with."},
    {"smooth", "height_field", "smooth", "off", "Blurs the edges between the triangles of the landscape by computed normals."},
    {"smooth_triangle", "@object mesh", "smooth_triangle { P1, N1, P2, N2, P3, N3 }", "", "A triangle with a normal at each corner, so that it looks round."},
    {"sor", "@object", "sor { N, POINT, ... [open] }", "", "A surface of revolution around y, by points of radius and height; heights must rise."},
    {"open", "sor", "open", "closed", "Without the flat ends."},
    {"sphere", "@object", "sphere { CENTRE, RADIUS }", "", "A ball."},
    {"sphere", "blob", "sphere { CENTRE, RADIUS, STRENGTH }", "", "A soft ball: a component of the blob. Negative strengths repel."},
    {"sphere", "contained_by", "contained_by { sphere { CENTRE, RADIUS } }", "box { -1, 1 }", "The ball that a surface is looked for in."},
    {"sphere_sweep", "@object", "sphere_sweep { KIND N, CENTRE, RADIUS, ... [tolerance T] }", "", "The space that a ball sweeps through while it moves along a curve and changes its size."},
    {"sqr", "julia_fractal", "sqr", "sqr", "The function z*z."},
    {"sturm", "blob cubic lathe ovus poly polynomial prism quartic sor torus", "sturm [BOOL]", "off", "A slower, more exact way to find the roots: against holes and speckles."},
    {"superellipsoid", "@object", "superellipsoid { <E, N> }", "", "Between box, cylinder and ball: small exponents are boxy, 1 is round."},
    {"text", "@object", "text { ttf \"font.ttf\" \"text\" DEPTH, OFFSET }", "", "Letters of a TrueType font as solids, starting at the origin along x."},
    {"texture_list", "mesh2", "texture_list { N, texture { ... }, ... }", "", "Textures for the triangles, by numbers in face_indices."},
    {"threshold", "blob isosurface", "threshold T", "0 in isosurface, 1 in blob", "The value of the field or function at the surface."},
    {"tolerance", "sphere_sweep", "tolerance T", "0.000001", "How exactly the surface is found; larger helps against speckles."},
    {"torus", "@object", "torus { MAJOR, MINOR }", "", "A ring around the y axis: its radius, and the radius of the tube."},
    {"triangle", "@object mesh", "triangle { P1, P2, P3 }", "", "A triangle."},
    {"ttf", "text", "text { ttf \"font.ttf\" \"text\" DEPTH, OFFSET }", "", "Announces the file of a TrueType font."},
    {"type", "bicubic_patch", "type 0|1", "", "0 needs less memory, 1 is faster."},
    {"u_steps", "bicubic_patch", "u_steps N", "0", "How often the patch is divided in the first direction at most."},
    {"union", "@object", "union { OBJECT OBJECT ... }", "", "Several objects as one."},
    {"uv_indices", "mesh2", "uv_indices { N, <A, B, C>, ... }", "face_indices", "Texture coordinates of the triangles, by their numbers in uv_vectors."},
    {"uv_vectors", "mesh2", "uv_vectors { N, <U, V>, ... }", "", "Texture coordinates for uv_mapping."},
    {"uv_vectors", "bicubic_patch mesh_triangle", "uv_vectors <U, V> ...", "", "Texture coordinates of the corners, for uv_mapping."},
    {"v_steps", "bicubic_patch", "v_steps N", "0", "How often the patch is divided in the second direction at most."},
    {"vertex_vectors", "mesh2", "vertex_vectors { N, POINT, ... }", "", "The corners of all triangles."},
    {"water_level", "height_field", "water_level W", "0", "Cuts the landscape off below this height, from 0 to 1."},
    {"xyz", "polynomial", "xyz(X, Y, Z): A", "", "A term: the powers of x, y and z, and its coefficient."},
    // clang-format on
};

#define VERISIM_OBJECT(word, reader) \
  static_assert(describes(kTable, #word) || std::string_view(#word).starts_with("light_"), "without description");
VERISIM_OBJECT_STATEMENTS(VERISIM_OBJECT)
#undef VERISIM_OBJECT

}  // namespace

const KeywordSection kShapes{
    "Shapes", "shapes",
    "Solids, surfaces and what combines them. After its own numbers every object takes modifiers: a texture, "
    "transformations and the like.",
    kTable};

}  // namespace verisim::parser
