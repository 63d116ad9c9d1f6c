// The same promises (surface_test_support.h) of surfaces that are sampled, tessellated or without an inside, each to
// its own accuracy.
#include <filesystem>

#include "tracer/shapes/heights/height_map.h"
#include "tracer/shapes/surface_test_support.h"
#include "tracer/shapes/trace_test_support.h"

namespace verisim::shapes::testing {
namespace {

using test::xyz;

template <class S>
auto shared(S shape) {
  return [shape](const Steps& m) { return make_shared_shape(shape, m); };
}
template <class S>
auto plain(S shape) {
  return [shape](const Steps& m) { return make(shape, m); };
}

Solid plane_figure(const char* name, std::function<ObjectRef(const Steps&)> build) {
  return {name, std::move(build), [](const Vec3& p) { return 0.2 * p.x + p.y - 0.1 * p.z; }, 1e-6, false};
}
// In the plane of plane_figure.
Vec3 on_plane(double x, double z) { return {x, -0.2 * x + 0.1 * z, z}; }

std::vector<Solid> flat_figures() {
  scene::BicubicPatch patch;
  patch.u_steps = patch.v_steps = 3;
  for (std::size_t i = 0; i < 16; ++i)
    patch.points[i] = on_plane(static_cast<double>(i % 4) - 1.5, static_cast<double>(i / 4) - 1.5);
  return {
      plane_figure("plane", plain(scene::Plane{normalize(Vec3(0.2, 1, -0.1)), 0})),
      plane_figure("disc", plain(scene::Disc{{0, 0, 0}, normalize(Vec3(0.2, 1, -0.1)), 1.5, 0.1})),
      plane_figure("triangle", plain(scene::Triangle{{on_plane(-2, -2), on_plane(2, -1), on_plane(0, 2)}})),
      plane_figure("bicubic_patch", shared(patch)),
  };
}

TEST(RandomTransforms, FlatFiguresAreMetInTheirPlane) { check_all(flat_figures(), 2000); }

TEST(RandomTransforms, PolygonsAreMetInTheirPlane) {
  check_all({{"polygon", plain(scene::Polygon{{{-1, -1, 0}, {1, -1, 0}, {0.2, 0.1, 0}, {-1, 1.1, 0}, {-1, -1, 0}}}),
              [](const Vec3& p) { return p.z; }, 1e-6, false}},
            1500);
}

std::shared_ptr<const scene::MeshData> cube() {
  auto data = std::make_shared<scene::MeshData>();
  for (int i = 0; i < 8; ++i) data->vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    for (const auto& corners : {std::array{a, b, c}, std::array{b, c, d}}) {
      scene::MeshTriangle t;
      t.vertex = corners;
      data->triangles.push_back(t);
    }
  };
  face(0, 1, 2, 3), face(4, 5, 6, 7), face(0, 1, 4, 5), face(2, 3, 6, 7), face(0, 2, 4, 6), face(1, 3, 5, 7);
  data->inside_vector = Vec3(0.3, 0.8, 0.1);
  return data;
}

TEST(RandomTransforms, MeshesWithAnInsideVectorAreSolids) {
  const auto data = cube();
  check_all({{"mesh",
              [data](const Steps& m) {
                return make(scene::Mesh{data, {}}, m);
              },
              [](const Vec3& p) {
                return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) - 1;
              },
              1e-6, true}},
            5000);
}

// Hits lie up to one accuracy behind the surface, counted in the world.
TEST(RandomTransforms, IsosurfacesToTheirAccuracy) {
  scene::Isosurface wavy;
  const auto f = [](double x, double y, double z) {
    return std::sqrt(x * x + y * y + z * z) - 0.8 + 0.1 * std::sin(4 * x) * std::sin(4 * y);
  };
  wavy.function = xyz(f);
  wavy.max_gradient = 2, wavy.accuracy = 1e-4, wavy.max_trace = 0;
  check_all({{"isosurface", shared(wavy), [f](const Vec3& p) { return f(p.x, p.y, p.z); }, 1e-3, true}}, 5000);
}

TEST(RandomTransforms, HeightFieldsAreMetOnTheirTriangles) {
  constexpr int kSide = 9;
  const auto height = [](int i, int k) { return 20000 + (i * 7919 + k * 104729) % 20000; };
  auto image = std::make_shared<Image>();
  image->width = image->height = kSide;
  image->grey = image->sixteen_bit = true;
  image->channels = 1;
  std::vector<float> values;
  for (int k = kSide - 1; k >= 0; --k) {  // the first row of an image is the last of the field
    for (int i = 0; i < kSide; ++i) values.push_back(static_cast<float>(height(i, k)) / 65535);
  }
  image->samples = image::Samples(std::move(values));
  scene::HeightField field;
  field.map = height_map(*image);
  const auto value = [height](const Vec3& p) {
    const double x = p.x * (kSide - 1), z = p.z * (kSide - 1);
    const int i = std::clamp(static_cast<int>(x), 0, kSide - 2), k = std::clamp(static_cast<int>(z), 0, kSide - 2);
    const double a = x - i, b = z - k, h10 = height(i + 1, k), h01 = height(i, k + 1), h00 = height(i, k),
                 h11 = height(i + 1, k + 1);
    return p.y -
           (a + b < 1 ? h00 + a * (h10 - h00) + b * (h01 - h00) : h11 + (1 - a) * (h01 - h11) + (1 - b) * (h10 - h11)) /
               65536;
  };
  check_all({{"height_field", shared(field), value, 1e-4, false}}, 1500);
}

// Where the march finds a fractal depends on its steps; a parametric surface is met where the ray enters the last of
// the three intervals of a small cell, which may be far from it for a ray that hardly moves along z (spec 04 sections 7
// and 8). So both promise only where they are.
TEST(RandomTransforms, SampledSurfacesStayInTheirBounds) {
  scene::JuliaFractal fractal;
  fractal.parameter = {-0.083, 0.0, -0.83, -0.025};
  fractal.max_iteration = 8;
  scene::Parametric sphere;
  const auto uv = [](auto g) -> FunctionPtr {
    return std::make_shared<test::Callable<2>>([g](const double* a) { return g(a[0], a[1]); });
  };
  sphere.function = {uv([](double u, double v) { return 0.9 * std::sin(u) * std::cos(v); }),
                     uv([](double u, double v) { return 0.9 * std::sin(u) * std::sin(v); }),
                     uv([](double u, double) { return 0.9 * std::cos(u); })};
  sphere.high = {3.14159265358979, 6.28318530717959};
  check_all({{"julia_fractal", shared(fractal), {}, 0, false}, {"parametric", shared(sphere), {}, 0, false}}, 5000);
}

TEST(RandomTransforms, TextsAreSolids) {
  scene::Text text;
  text.font = "/usr/share/povray-3.7/include/timrom.ttf";
  if (!std::filesystem::exists(text.font)) GTEST_SKIP() << "no fonts";
  text.text = u"O&g8";
  text.thickness = 0.5;
  check_all({{"text",
              [text](const Steps& m) {
                return make_shared_shape(text, [&](Object& o) {
                  scene::transform(o, Transform::translation({-1.1, -0.2, -0.25}));
                  m(o);
                });
              },
              {},
              0,
              true,
              0.01}},  // scan lines are off where curves are nearly straight (text_test.cpp)
            5000);
}

}  // namespace
}  // namespace verisim::shapes::testing
