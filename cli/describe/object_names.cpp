#include "cli/describe/object_names.h"

#include <fmt/format.h>

namespace verisim::cli {
namespace {

struct Keyword {
  const char* operator()(const scene::Sphere&) const { return "sphere"; }
  const char* operator()(const scene::Box&) const { return "box"; }
  const char* operator()(const scene::Plane&) const { return "plane"; }
  const char* operator()(const scene::Cone& cone) const {
    return cone.base_radius == cone.cap_radius ? "cylinder" : "cone";
  }
  const char* operator()(const scene::Torus&) const { return "torus"; }
  const char* operator()(const scene::Disc&) const { return "disc"; }
  const char* operator()(const scene::Triangle&) const { return "triangle"; }
  const char* operator()(const scene::Boxed<scene::SmoothTriangle>&) const { return "smooth_triangle"; }
  const char* operator()(const scene::Polygon&) const { return "polygon"; }
  const char* operator()(const scene::Poly&) const { return "poly"; }
  const char* operator()(const scene::Boxed<scene::Quadric>&) const { return "quadric"; }
  const char* operator()(const scene::Superellipsoid&) const { return "superellipsoid"; }
  const char* operator()(const scene::Ovus&) const { return "ovus"; }
  const char* operator()(const std::shared_ptr<const scene::Blob>&) const { return "blob"; }
  const char* operator()(const std::shared_ptr<const scene::Lathe>&) const { return "lathe"; }
  const char* operator()(const std::shared_ptr<const scene::Sor>&) const { return "sor"; }
  const char* operator()(const std::shared_ptr<const scene::Prism>&) const { return "prism"; }
  const char* operator()(const std::shared_ptr<const scene::SphereSweep>&) const { return "sphere_sweep"; }
  const char* operator()(const std::shared_ptr<const scene::BicubicPatch>&) const { return "bicubic_patch"; }
  const char* operator()(const std::shared_ptr<const scene::HeightField>&) const { return "height_field"; }
  const char* operator()(const std::shared_ptr<const scene::Isosurface>&) const { return "isosurface"; }
  const char* operator()(const std::shared_ptr<const scene::Parametric>&) const { return "parametric"; }
  const char* operator()(const std::shared_ptr<const scene::JuliaFractal>&) const { return "julia_fractal"; }
  const char* operator()(const std::shared_ptr<const scene::Text>&) const { return "text"; }
  const char* operator()(const scene::Mesh&) const { return "mesh"; }
  const char* operator()(const scene::Csg& csg) const {
    return csg.difference                       ? "difference"
           : csg.kind == scene::CsgKind::union_ ? "union"
           : csg.kind == scene::CsgKind::merge  ? "merge"
                                                : "intersection";
  }
  const char* operator()(const scene::LightGroup&) const { return "light_group"; }
  const char* operator()(const scene::Boxed<scene::LightSource>&) const { return "light_source"; }
};

}  // namespace

const char* object_keyword(const scene::Object& object) { return std::visit(Keyword(), object.shape); }

std::string object_name(const scene::Object& object) {
  const std::string keyword = object_keyword(object);
  if (!object.place.file || object.place.line <= 0) return keyword;
  return fmt::format("{} ({}:{})", keyword, *object.place.file, object.place.line);
}

}  // namespace verisim::cli
