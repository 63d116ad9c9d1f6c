// Objects as SDL describes them (specs 03, 04). A tree of plain values; tracer/shapes compiles it for rays.
#pragma once

#include <array>
#include <string>

#include "tracer/scene/children.h"
#include "tracer/scene/light.h"
#include "tracer/scene/texture.h"

namespace verisim {
class Spline;
}

namespace verisim::scene {

// Shapes. Where it takes no work, box() is the box in the shape's own space (before its matrix), as POV-Ray stores it;
// the others: scene::local_bounds.
inline Box3 symmetric_box(double x, double y, double z) { return {Vec3(-x, -y, -z), Vec3(x, y, z)}; }

struct Sphere {
  Vec3 center;
  double radius;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("center", center), visit("radius", radius);
  }
  Box3 box() const { return {center - Vec3(radius), center + Vec3(radius)}; }
};
struct Box {
  Vec3 low, high;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("corners", low, high);
  }
  Box3 box() const { return {low, high}; }
};
struct Plane {
  Vec3 normal;
  double distance;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("normal", normal), visit("distance", distance);
  }
};
struct Cone {
  Vec3 base, cap;
  double base_radius, cap_radius;
  bool open = false;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("base", base), visit("cap", cap), visit("radii", base_radius, cap_radius), visit("open", open);
  }
};  // cylinder: equal radii
struct Torus {
  double major, minor;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("radii", major, minor);
  }
  Box3 box() const { return symmetric_box(major + minor, minor, major + minor); }
};
struct Disc {
  Vec3 center, normal;
  double radius, hole = 0;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("center", center), visit("normal", normal), visit("radii", radius, hole);
  }
  Box3 box() const { return symmetric_box(radius, radius, 0.001); }  // before its frame
};
struct Triangle {
  std::array<Vec3, 3> p;
};
struct SmoothTriangle {
  std::array<Vec3, 3> p, n;
};
struct Polygon {
  std::vector<Vec3> points;
};
struct Poly {
  int order;
  std::vector<double> coefficients;
};  // cubic, quartic, poly, polynomial
struct Quadric {
  Vec3 square, mixed, linear;
  double constant;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("square", square), visit("mixed", mixed), visit("linear", linear), visit("constant", constant);
  }
};
struct Superellipsoid {
  double east, north;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("exponents", east, north);
  }
  Box3 box() const { return symmetric_box(1.0001, 1.0001, 1.0001); }
};
struct Ovus {
  double bottom, top;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("radii", bottom, top);
  }
};
struct BlobComponent {
  Vec3 a, b;  // centre, or the axis of a cylinder
  double radius, strength;
  bool cylinder = false;
  Rare<Transform> transform;
  TexturePtr texture;
};
struct Blob {
  double threshold = 1;
  std::vector<BlobComponent> components;
  // The whole blob's as its statement ended: if it was opaque, so are all copies (spec 06 9.3).
  TexturePtr first_texture = {};
  bool hierarchy = true;  // `hierarchy` of that statement; what copies say does not matter
};
enum class SplineKind : std::uint8_t { linear, quadratic, cubic, bezier, b_spline };
struct Lathe {
  SplineKind spline = SplineKind::linear;
  std::vector<Vec2> points;
};
struct Sor {
  std::vector<Vec2> points;
  bool open = false;
};
struct Prism {
  SplineKind spline = SplineKind::linear;
  bool conic = false, open = false;
  double low = 0, high = 0;
  std::vector<Vec2> points;
};
struct SphereSweep {
  SplineKind spline = SplineKind::linear;
  std::vector<Vec3> centers;
  std::vector<double> radii;
  double tolerance = 1e-6;
};
struct BicubicPatch {
  int type = 0, u_steps = 0, v_steps = 0;
  double flatness = 0;
  std::array<Vec3, 16> points;
  std::optional<std::array<Vec2, 4>> uv;
};
// Heights 0 .. 65535, row by row from the bottom of an image (tracer/shapes/heights/height_map.h).
struct HeightMap {
  int width = 0, depth = 0, lowest = 65535, highest = 0;
  std::vector<std::uint16_t> heights;
};
struct HeightField {
  std::shared_ptr<const HeightMap> map;
  double water_level = 0;
  bool smooth = false;
};
struct Contained {
  bool sphere = false;
  Vec3 low{-1, -1, -1}, high{1, 1, 1};
  Vec3 center{0, 0, 0};
  double radius = 1;
};
struct Isosurface {
  FunctionPtr function;
  Contained container;
  double threshold = 0, accuracy = 0.001, max_gradient = 1.1;
  std::optional<Vec3> evaluate;
  int max_trace = 1;  // 0: all_intersections
  bool open = false;
};
struct Parametric {
  std::array<FunctionPtr, 3> function;
  Vec2 low{0, 0}, high{1, 1};
  Contained container;
  double accuracy = 0.001, max_gradient = 1;
  int precompute_depth = 0;
  std::array<bool, 3> precompute{false, false, false};
};
enum class JuliaFunction : std::uint8_t {
  sqr,
  cube,
  exp,
  reciprocal,
  sin,
  asin,
  sinh,
  asinh,
  cos,
  acos,
  cosh,
  acosh,
  tan,
  atan,
  tanh,
  atanh,
  ln,
  pwr
};
struct JuliaFractal {
  std::array<double, 4> parameter{1, 0, 0, 0}, slice{0, 0, 0, 1};
  Vec2 exponent{0, 0};  // of pwr
  double slice_distance = 0;
  bool hypercomplex = false;
  JuliaFunction function = JuliaFunction::sqr;
  int max_iteration = 20;
  double precision = 20;
};
struct Text {
  std::string font;
  int builtin_font = 0;
  std::u16string text;
  double thickness = 1;
  Vec3 offset{0, 0, 0};
  bool unicode = false;  // charset utf8 or sys: decides which character table of the font is used (spec 04 section 9)
  std::optional<Vec2> place;  // of a letter that was taken out of a text: where its outline stands
};

struct MeshTriangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<std::uint32_t, 3> normal;  // into normals; only when smooth
  std::array<std::uint32_t, 3> uv;
  std::array<std::int32_t, 3> texture{-1, -1, -1};  // into textures; -1: the mesh's
  bool smooth = false, has_uv = false;
};
struct MeshData {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;  // of length 1
  std::vector<Vec2> uvs;
  std::vector<TexturePtr> textures;
  std::vector<MeshTriangle> triangles;
  std::optional<Vec3> inside_vector;
};
struct Mesh {
  std::shared_ptr<const MeshData> data;
  std::vector<TexturePtr> textures;  // data->textures moved along with this copy of the mesh; empty: as they are
};

enum class CsgKind : std::uint8_t {
  union_,
  merge,
  intersection
};  // a difference is an intersection whose later children are inverted
struct Csg {
  CsgKind kind = CsgKind::union_;
  bool difference = false;  // written as difference (cutaway_textures treats its first child apart)
  bool postponable =
      false;  // copies need not see what is below: no light_group, no bounds to warn of (set by compute_bounds)
  Children children;
};
struct LightGroup {
  Children children;
  bool global_lights = false;
  bool from_identifier =
      false;  // a copy of a declared group: lights of an outer group reach its objects (spec 06 10.1)
};

// X(what an object holds, name): the name of its factory in tracer/shapes and, mostly, its keyword
// (docs/add-a-primitive.md). Large ones are shared by copies.
#define VERISIM_SHAPES(X)                               \
  X(Sphere, sphere)                                     \
  X(Box, box)                                           \
  X(Plane, plane)                                       \
  X(Cone, cone)                                         \
  X(Torus, torus)                                       \
  X(Disc, disc)                                         \
  X(Triangle, triangle)                                 \
  X(Boxed<SmoothTriangle>, smooth_triangle)             \
  X(Polygon, polygon)                                   \
  X(Poly, poly)                                         \
  X(Boxed<Quadric>, quadric)                            \
  X(Superellipsoid, superellipsoid)                     \
  X(Ovus, ovus)                                         \
  X(std::shared_ptr<const Blob>, blob)                  \
  X(std::shared_ptr<const Lathe>, lathe)                \
  X(std::shared_ptr<const Sor>, sor)                    \
  X(std::shared_ptr<const Prism>, prism)                \
  X(std::shared_ptr<const SphereSweep>, sphere_sweep)   \
  X(std::shared_ptr<const BicubicPatch>, bicubic_patch) \
  X(std::shared_ptr<const HeightField>, height_field)   \
  X(std::shared_ptr<const Isosurface>, isosurface)      \
  X(std::shared_ptr<const Parametric>, parametric)      \
  X(std::shared_ptr<const JuliaFractal>, julia_fractal) \
  X(std::shared_ptr<const Text>, text)                  \
  X(Mesh, mesh)                                         \
  X(Csg, csg)                                           \
  X(LightGroup, light_group)                            \
  X(Boxed<LightSource>, light_source)

#define VERISIM_SHAPE(held, name) , held
using Shape = VariantOf<void VERISIM_SHAPES(VERISIM_SHAPE)>;
#undef VERISIM_SHAPE
#define VERISIM_SHAPE(held, name) || std::is_same_v<Boxed<T>, held>
template <class T>
inline constexpr bool kIsBoxed = false VERISIM_SHAPES(VERISIM_SHAPE);
#undef VERISIM_SHAPE

// Axis-aligned bounds as POV-Ray stores them: binary32 lower corner and edge lengths (spec 03 2.2).
struct Bounds {
  std::array<float, 3> low{-1e10f, -1e10f, -1e10f}, size{2e10f, 2e10f, 2e10f};
};

struct PhotonFlags {
  bool target = false;
  double target_spacing = 1;  // multiplier
  Flag reflection = Flag::unset, refraction = Flag::unset;
  bool pass_through = false, collect = true;
  bool given = false;

  // What is a target, bends photons and lets them pass cannot be: what was said last wins (spec 07 3.2). Each says
  // which of the others it has turned off.
  enum class TurnedOff { nothing, refraction, pass_through };
  TurnedOff set_target(double density);  // <= 0: none
  TurnedOff set_refraction(bool on);
  TurnedOff set_pass_through(bool on);
  // What a compound object hands down to its parts; `turned_off` gets what that turns off in them.
  void inherit(const PhotonFlags& parent, std::vector<TurnedOff>* turned_off = nullptr);
};

struct Object {
  Shape shape;
  SourceLocation place;
  Rare<Transform> transform;     // of shapes that carry a matrix (spec 03 section 1)
  Rare<Transform> uv_transform;  // accumulated for the uv mapping of spheres
  Bounds bounds;
  List<ObjectPtr> bounded_by, clipped_by;
  std::uint32_t clips_in_bounds = 0;  // how many of the clips the automatic box of a quadric already knows
  bool automatic_box = true;          // false: of a quadric without one, whose bounds are kept (spec 03 4.11)
  bool clip_is_bound = false;         // clipped_by{bounded_by} or bounded_by{clipped_by}: transform once
  bool clip_from_bound = false;       // the former: no clip to the automatic box of a quadric
  TexturePtr texture, interior_texture;
  // What moved the top layer since it is of a solid colour: a pattern that takes its place while the object is read has
  // gone that way, too (spec 08 E).
  Rare<Transform> solid_steps;
  InteriorPtr interior;
  bool inverted = false, was_inverted = false;  // now; ever
  bool texture_forgotten = false;               // inverted, and nothing said of its texture since
  bool copied = false;                          // made from another object, not written in place
  Flag hollow = Flag::unset;                    // as written for this object
  bool hollow_inherited = false;                // as written for a CSG object around it
  bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false, double_illuminate = false;
  bool uv_mapping = false, sturm = false, hierarchy = true, split_union = true, cutaway_textures = false;
  bool ignore_global_lights = false;  // of objects below a light_group, see group_lights
  float radiosity_importance = -1;    // < 0: the scene's default
  Rare<PhotonFlags> photons;
  // Filled in by finish_statement for objects below a light_group: their own lights.
  List<std::shared_ptr<const LightSource>> group_lights;

  // The shape if it is a T; null: another one.
  template <class T>
  const T* as() const {
    if constexpr (kIsBoxed<T>) {
      const auto* box = std::get_if<Boxed<T>>(&shape);
      return box ? &**box : nullptr;
    } else {
      return std::get_if<T>(&shape);
    }
  }
  template <class T>
  T* as() {
    return const_cast<T*>(std::as_const(*this).as<T>());
  }
  bool is_hollow() const { return hollow == Flag::unset ? hollow_inherited : hollow == Flag::on; }
};

// ---- Operations the parser performs while it reads an object (object.cpp, spec 03) ----

// Computes `bounds` from the shape's own numbers; call once the parameters (or all CSG children) are read.
void compute_bounds(Object& object);
// One elementary transformation, applied as POV-Ray does: absorbed into the numbers where the shape can, else into the
// matrix; also moves clips, bounds, textures (unless uv-mapped), the interior's media and CSG children.
void translate(Object& object, const Vec3& v);
void scale(Object& object, const Vec3& s);
void rotate(Object& object, const Vec3& degrees);
void transform(Object& object, const Transform& t);
// Toggles inversion (spec 03 5.1: unions become intersections of inverted children and so on). Patches are unchanged:
// see is_patch.
void invert(Object& object);
// At the end of an object's modifier list: bounds from bounded_by and clipped_by, automatic quadric boxes (spec
// 03 2.2, 4.11).
void finish_modifiers(Object& object);
// True for shapes without an inside (triangle, mesh without inside_vector, bicubic_patch, parametric ...).
bool is_patch(const Object& object);
bool is_infinite(const Object& object);  // box volume > 2e10
// The objects below a CSG object or light_group; other shapes have none. The children of a copy are made by the first
// call.
const std::vector<ObjectPtr>& children_of(const Object& object);
// For writing.
std::vector<ObjectPtr>& own_children(Object& object);
// Of a copy, those of the original: enough where neither place nor inherited properties count.
const std::vector<ObjectPtr>& declared_children(const Object& object);
// Makes all children of copies below, so that threads may look at the tree.
void complete(const Object& object);
// A copy of the tree; heavy payloads (mesh, blob, lathe ...) and textures stay shared, children until one of the two is
// written. Interiors are shared until finish_statement.
std::shared_ptr<Object> copy(const Object& object);
// At the end of a top-level statement: pushes textures, interiors and flags to the children, gives every object its own
// interior and the default texture where it has none, collects light groups (spec 03 5.3, 5.4; 06 6.1, 10.1).
void finish_statement(Object& object, const TexturePtr& default_texture);

}  // namespace verisim::scene
