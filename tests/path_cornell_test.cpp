// The Cornell box (measured geometry and reflectances, scenes/cornell_box) as an independent radiosity solution:
// patches, form factors by stratified rays, Jacobi iteration, final gathering from the patches. The path integrator
// must agree with it on the averages of parts of the walls.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/support/probe.h"
#include "tracer/math/vec.h"

namespace verisim::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Quad {
  std::array<Vec3, 4> p;
  Rgb reflectance;
  int patches;  // a side
  bool light = false;
};

const Rgb kWhite(0.738f, 0.736f, 0.738f), kGreen(0.069f, 0.398f, 0.087f), kRed(0.494f, 0.049f, 0.051f),
    kCornellLight(50.4f, 26.3f, 6.71f);

const std::vector<Quad>& box() {
  static const std::vector<Quad> quads = {
      {{Vec3(552.8, 0, 0), {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}, kWhite, 20},
      {{Vec3(556, 548.8, 0), {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}}, kWhite, 20},
      {{Vec3(549.6, 0, 559.2), {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}}, kWhite, 20},
      {{Vec3(0, 0, 559.2), {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}}, kGreen, 20},
      {{Vec3(552.8, 0, 0), {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}}, kRed, 20},
      {{Vec3(343, 548.7, 227), {343, 548.7, 332}, {213, 548.7, 332}, {213, 548.7, 227}}, Rgb(0), 1, true},
      {{Vec3(130, 165, 65), {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}, kWhite, 6},
      {{Vec3(290, 0, 114), {290, 165, 114}, {240, 165, 272}, {240, 0, 272}}, kWhite, 6},
      {{Vec3(130, 0, 65), {130, 165, 65}, {290, 165, 114}, {290, 0, 114}}, kWhite, 6},
      {{Vec3(82, 0, 225), {82, 165, 225}, {130, 165, 65}, {130, 0, 65}}, kWhite, 6},
      {{Vec3(240, 0, 272), {240, 165, 272}, {82, 165, 225}, {82, 0, 225}}, kWhite, 6},
      {{Vec3(423, 330, 247), {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}, kWhite, 8},
      {{Vec3(423, 0, 247), {423, 330, 247}, {472, 330, 406}, {472, 0, 406}}, kWhite, 8},
      {{Vec3(472, 0, 406), {472, 330, 406}, {314, 330, 456}, {314, 0, 456}}, kWhite, 8},
      {{Vec3(314, 0, 456), {314, 330, 456}, {265, 330, 296}, {265, 0, 296}}, kWhite, 8},
      {{Vec3(265, 0, 296), {265, 330, 296}, {423, 330, 247}, {423, 0, 247}}, kWhite, 8},
  };
  return quads;
}

// A quadrilateral with its normal; the walls' slight twist is nothing beside the patches' size.
struct Face {
  Vec3 a, u, v, n;  // p = a + s u + t v
  double uu, uv, vv, determinant;
};

class Radiosity {
 public:
  Radiosity() {
    for (std::size_t q = 0; q < box().size(); ++q) {
      const Quad& quad = box()[q];
      Face f;
      f.a = quad.p[0], f.u = quad.p[1] - quad.p[0], f.v = quad.p[3] - quad.p[0];
      f.n = normalize(cross(f.u, f.v));
      f.uu = dot(f.u, f.u), f.uv = dot(f.u, f.v), f.vv = dot(f.v, f.v), f.determinant = f.uu * f.vv - f.uv * f.uv;
      faces_.push_back(f);
      first_.push_back(patches_);
      patches_ += static_cast<std::size_t>(quad.patches * quad.patches);
    }
    solve();
  }

  // Radiance that leaves p, a point of quad q seen along -n.
  Rgb radiance(std::size_t q, const Vec3& p, const Vec3& n, std::mt19937& random) const {
    return box()[q].reflectance * (direct(p, n, random) + gathered(p, n, 16, random));
  }

 private:
  // The nearest face hit; its number and surface coordinates.
  bool hit(const Vec3& o, const Vec3& d, double limit, std::size_t& face, double& s, double& t) const {
    bool found = false;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Face& f = faces_[i];
      const double slope = dot(d, f.n);
      if (slope == 0) continue;
      const double distance = dot(f.a - o, f.n) / slope;
      if (!(distance > 0.02 && distance < limit)) continue;
      const Vec3 local = o + d * distance - f.a;
      const double x = dot(local, f.u), y = dot(local, f.v);
      const double a = (x * f.vv - y * f.uv) / f.determinant, b = (y * f.uu - x * f.uv) / f.determinant;
      // Walls are wider where they meet: coordinates a little outside still count.
      const double slack = i < 5 ? 0.02 : 0;
      if (a < -slack || a > 1 + slack || b < -slack || b > 1 + slack) continue;
      limit = distance, face = i, s = a, t = b, found = true;
    }
    return found;
  }

  std::size_t patch(std::size_t face, double s, double t) const {
    const int n = box()[face].patches;
    const auto index = [n](double x) {
      return static_cast<std::size_t>(std::clamp(static_cast<int>(x * n), 0, n - 1));
    };
    return first_[face] + index(t) * static_cast<std::size_t>(n) + index(s);
  }

  // Light of the lamp: the sum over its surface, mean over the hemisphere's cosine (irradiance over pi). None leaves
  // the gap above it, a tenth of a unit, whose patches would be noise and reach out of it.
  Rgb direct(const Vec3& p, const Vec3& n, std::mt19937& random) const {
    constexpr int kSide = 4;
    std::uniform_real_distribution<double> uniform(0, 1);
    const Face& lamp = faces_[5];
    const double area = std::sqrt(lamp.determinant);
    double sum = 0;
    if (p.y > lamp.a.y) return {};
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const Vec3 target =
            lamp.a + lamp.u * ((i + uniform(random)) / kSide) + lamp.v * ((j + uniform(random)) / kSide);
        const Vec3 to = target - p;
        const double distance = length(to), cosine = dot(to, n) / distance,
                     lamp_cosine = std::fabs(dot(to, lamp.n)) / distance;
        if (cosine <= 0) continue;
        std::size_t face;
        double s, t;
        if (hit(p, to / distance, distance - 0.05, face, s, t)) continue;
        sum += cosine * lamp_cosine / (distance * distance);
      }
    }
    return kCornellLight * static_cast<float>(sum * area / (kSide * kSide) / kPi);
  }

  static Vec3 cosine_direction(const Vec3& n, double u, double v) {
    const Vec3 side = std::fabs(n.x) > 0.5 ? Vec3(0, 1, 0) : Vec3(1, 0, 0), x = normalize(cross(n, side)),
               y = cross(n, x);
    const double r = std::sqrt(u), phi = 2 * kPi * v;
    return x * (r * std::cos(phi)) + y * (r * std::sin(phi)) + n * std::sqrt(1 - u);
  }

  // Mean radiance of the patches over the cosine hemisphere, `side` squared stratified rays.
  Rgb gathered(const Vec3& p, const Vec3& n, int side, std::mt19937& random) const {
    std::uniform_real_distribution<double> uniform(0, 1);
    Rgb sum;
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        std::size_t face;
        double s, t;
        const Vec3 d = cosine_direction(n, (i + uniform(random)) / side, (j + uniform(random)) / side);
        if (hit(p, d, 1e9, face, s, t)) sum += radiances_[patch(face, s, t)];
      }
    }
    return sum * (1.0f / static_cast<float>(side * side));
  }

  void solve() {
    constexpr int kPoints = 4, kRays = 8;  // squared: points of a patch, rays of a point
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    struct Link {
      std::uint32_t patch;
      float factor;
    };
    std::vector<std::vector<Link>> links(patches_);
    std::vector<Rgb> emitted(patches_), reflectance(patches_);
    const Vec3 middle(278, 274, 280);
    for (std::size_t q = 0; q < faces_.size(); ++q) {
      const Quad& quad = box()[q];
      if (quad.light) continue;
      const Face& f = faces_[q];
      // Walls face the room, blocks face away from their own middle.
      Vec3 inside = middle;
      if (q > 5) inside = q < 11 ? Vec3(186, 80, 168) : Vec3(368, 165, 351);
      Vec3 n = dot(inside - f.a, f.n) > 0 ? f.n : -f.n;
      if (q > 5) n = -n;
      for (int pt = 0; pt < quad.patches; ++pt) {
        for (int ps = 0; ps < quad.patches; ++ps) {
          const std::size_t i = first_[q] + static_cast<std::size_t>(pt * quad.patches + ps);
          std::vector<float> counts(patches_, 0.0f);
          Rgb light;
          for (int k = 0; k < kPoints * kPoints; ++k) {
            const double s = (ps + (k % kPoints + uniform(random)) / kPoints) / quad.patches,
                         t = (pt + (k / kPoints + uniform(random)) / kPoints) / quad.patches;
            const Vec3 p = f.a + f.u * s + f.v * t + n * 0.01;
            light += direct(p, n, random);
            for (int r = 0; r < kRays * kRays; ++r) {
              std::size_t face;
              double hs, ht;
              const Vec3 d =
                  cosine_direction(n, (r % kRays + uniform(random)) / kRays, (r / kRays + uniform(random)) / kRays);
              if (hit(p, d, 1e9, face, hs, ht)) counts[patch(face, hs, ht)] += 1;
            }
          }
          reflectance[i] = quad.reflectance;
          emitted[i] = quad.reflectance * light * (1.0f / (kPoints * kPoints));
          for (std::size_t j = 0; j < patches_; ++j)
            if (counts[j] > 0)
              links[i].push_back(
                  {static_cast<std::uint32_t>(j), counts[j] / static_cast<float>(kPoints * kPoints * kRays * kRays)});
        }
      }
    }
    radiances_ = emitted;
    for (int iteration = 0; iteration < 30; ++iteration) {
      std::vector<Rgb> next = emitted;
      for (std::size_t i = 0; i < patches_; ++i) {
        Rgb sum;
        for (const Link& l : links[i]) sum += radiances_[l.patch] * l.factor;
        next[i] += reflectance[i] * sum;
      }
      radiances_ = std::move(next);
    }
  }

  std::vector<Face> faces_;
  std::vector<std::size_t> first_;
  std::size_t patches_ = 0;
  std::vector<Rgb> radiances_;  // reflected, without the lamp's own
};

std::string vec(const Vec3& v) {
  return "<" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + ">";
}
std::string rgb(const Rgb& c) {
  return "rgb <" + std::to_string(c.r) + "," + std::to_string(c.g) + "," + std::to_string(c.b) + ">";
}

std::string scene() {
  std::string text = "#version 3.7; global_settings { assumed_gamma 1 }\n";
  for (const Quad& q : box()) {
    const std::string look = " pigment { " + (q.light ? "rgb 1" : rgb(q.reflectance)) + " } finish { ambient 0 " +
                             (q.light ? "diffuse 0 emission " + rgb(kCornellLight) : std::string("diffuse 1")) +
                             " } }\n";
    text += "triangle { " + vec(q.p[0]) + "," + vec(q.p[1]) + "," + vec(q.p[2]) + look;
    text += "triangle { " + vec(q.p[0]) + "," + vec(q.p[2]) + "," + vec(q.p[3]) + look;
  }
  return text;
}

// A rectangle of a wall, seen by an orthographic camera right in front of it.
struct Part {
  const char* name;
  std::size_t quad;
  Vec3 center, right, up, normal;
};

TEST(PathIntegratorInTheCornellBox, AgreesWithARadiositySolution) {
  const Radiosity radiosity;
  const std::vector<Part> parts = {
      {"floor in front", 0, {420, 0, 100}, {220, 0, 0}, {0, 0, 160}, {0, 1, 0}},
      {"floor at the back", 0, {140, 0, 480}, {200, 0, 0}, {0, 0, 120}, {0, 1, 0}},
      {"ceiling, red side", 1, {450, 548.8, 280}, {160, 0, 0}, {0, 0, 400}, {0, -1, 0}},
      {"ceiling, green side", 1, {110, 548.8, 280}, {160, 0, 0}, {0, 0, 400}, {0, -1, 0}},
      {"back, above", 2, {275, 440, 559.2}, {400, 0, 0}, {0, 150, 0}, {0, 0, -1}},
      {"back, below", 2, {120, 120, 559.2}, {200, 0, 0}, {0, 200, 0}, {0, 0, -1}},
      {"green, front", 3, {0, 275, 140}, {0, 0, 240}, {0, 450, 0}, {1, 0, 0}},
      {"green, back", 3, {0, 275, 420}, {0, 0, 240}, {0, 450, 0}, {1, 0, 0}},
      {"top of the short block", 6, {186, 165, 169}, {80, 0, 0}, {0, 0, 80}, {0, 1, 0}},
      {"top of the tall block", 11, {368, 330, 351}, {80, 0, 0}, {0, 0, 80}, {0, 1, 0}},
  };
  const std::string text = scene();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Part& part : parts) {
    const std::string camera = "camera { orthographic location " + vec(part.center + part.normal * 0.5) +
                               " direction " + vec(-part.normal) + " right " + vec(part.right) + " up " + vec(part.up) +
                               " }\n";
    render::Options options;
    options.path_samples = 12288;
    options.block_size = 4;
    options.threads = 0;
    const auto picture = render_text(text + camera, 8, 8, options);
    Rgb traced, solved;
    for (const render::PixelColor& c : picture.pixels) traced += c.rgb() * (1.0f / 64);
    constexpr int kGathers = 40;  // squared
    for (int i = 0; i < kGathers * kGathers; ++i) {
      const double x = (i % kGathers + uniform(random)) / kGathers - 0.5,
                   y = (i / kGathers + uniform(random)) / kGathers - 0.5;
      const Vec3 p = part.center + part.right * x + part.up * y + part.normal * 0.01;
      solved += radiosity.radiance(part.quad, p, part.normal, random) * (1.0f / (kGathers * kGathers));
    }
    RecordProperty(part.name, std::to_string(traced.r / solved.r) + " " + std::to_string(traced.g / solved.g) + " " +
                                  std::to_string(traced.b / solved.b));
    EXPECT_NEAR(traced.r, solved.r, 0.008 * solved.r) << part.name;
    EXPECT_NEAR(traced.g, solved.g, 0.008 * solved.g) << part.name;
    EXPECT_NEAR(traced.b, solved.b, 0.008 * solved.b) << part.name;
  }
}

}  // namespace
}  // namespace verisim::test
