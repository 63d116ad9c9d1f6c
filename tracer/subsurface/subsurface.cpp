#include "tracer/subsurface/subsurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include <boost/container/small_vector.hpp>

#include "tracer/math/constants.h"

namespace verisim::global {
namespace {

using Channels = std::array<double, 3>;

Channels channels(const Rgb& c) { return {c.r, c.g, c.b}; }
Rgb rgb(const Channels& c) { return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])}; }
double grey(const Channels& c) { return 0.297 * c[0] + 0.589 * c[1] + 0.114 * c[2]; }

// Diffuse Fresnel reflectance as POV-Ray approximates it (not the polynomial of the paper).
double diffuse_fresnel(double eta) {
  if (eta >= 1.0) {
    const double x = 1.0 - 1.0 / eta;
    return (x + 3.0 * std::pow(x, 4.5)) / 4.0;
  }
  return eta * eta - std::pow(eta, 2.25);
}

double boundary_term(double ior) {
  const double f = diffuse_fresnel(ior);
  return (1.0 + f) / (1.0 - f);
}

double reflectance_of(double albedo, double a) {
  const double r = std::sqrt(3.0 * (1.0 - albedo));
  return albedo / 2.0 * (1.0 + std::exp(-4.0 / 3.0 * a * r)) * std::exp(-r);
}

using Table = std::array<float, 101>;

const Table& albedo_table(double ior) {
  // A surface asks three times at every point: remember the last answer without taking the lock.
  thread_local double last_ior = -1.0;
  thread_local const Table* last = nullptr;
  if (last && ior == last_ior) return *last;
  static std::mutex mutex;
  static std::map<double, Table> tables;
  const std::lock_guard lock(mutex);
  auto [it, fresh] = tables.try_emplace(ior);
  last_ior = ior, last = &it->second;
  if (!fresh) return it->second;
  const double a = boundary_term(ior);
  for (int i = 0; i <= 100; ++i) {
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (reflectance_of(middle, a) < i / 100.0 ? low : high) = middle;
    }
    it->second[static_cast<std::size_t>(i)] = static_cast<float>(0.5 * (low + high));
  }
  return it->second;
}

// Optical coefficients of one channel, per millimetre.
struct Medium {
  Channels albedo, scattering, extinction, absorption, transport;
};

Medium medium_of(const SubsurfacePoint& point) {
  Medium m;
  const Channels reflectance = channels(point.reflectance), translucency = channels(point.translucency);
  for (int c = 0; c < 3; ++c) {
    m.albedo[c] = reduced_albedo(reflectance[c], point.interior->ior);
    const bool lit = m.albedo[c] > 0.0 && translucency[c] > 0.0;
    m.scattering[c] = lit ? 1.0 / translucency[c] : 0.0;
    m.extinction[c] = lit ? m.scattering[c] / m.albedo[c] : 0.0;
    m.absorption[c] = std::max(0.0, m.extinction[c] - m.scattering[c]);
    m.transport[c] = std::sqrt(3.0 * m.absorption[c] * m.extinction[c]);
  }
  return m;
}

// R_d at squared distance d2 (mm^2) from the point of incidence.
double dipole(double d2, int c, const Medium& m, double a) {
  if (m.extinction[c] <= 0.0) return 0.0;
  const double zr = 1.0 / m.extinction[c], zv = zr * (1.0 + 4.0 * a / 3.0);
  const double dr = std::sqrt(zr * zr + d2), dv = std::sqrt(zv * zv + d2), s = m.transport[c];
  return m.albedo[c] / (4.0 * kPi) *
         (zr * (s + 1.0 / dr) * std::exp(-s * dr) / (dr * dr) + zv * (s + 1.0 / dv) * std::exp(-s * dv) / (dv * dv));
}

class Estimator {
 public:
  Estimator(const SubsurfacePoint& point, const SubsurfaceSettings& settings, SubsurfaceEnvironment& environment)
      : point_(point),
        settings_(settings),
        environment_(environment),
        medium_(medium_of(point)),
        a_(boundary_term(point.relative_ior)),
        eta_(point.relative_ior) {
    cos_out_ = std::fabs(dot(point.view, point.normal));
    out_transmittance_ = fresnel_transmittance(cos_out_, eta_);
  }

  Rgb run() {
    Channels sum = diffuse();
    const Vec3 refracted = refract();
    SubsurfaceEnvironment::SurfaceHit exit;
    if (dot(refracted, refracted) > 0.0) {
      // A ray that never leaves (a plane) scatters all the same.
      const bool leaves = environment_.nearest({point_.point, refracted}, exit);
      single_scattering(refracted, leaves ? exit.t * settings_.mm_per_unit : std::numeric_limits<double>::infinity(),
                        sum);
      if (leaves) unscattered(refracted, exit, sum);
    }
    return rgb(sum);
  }

 private:
  Channels diffuse() {
    const double mm = settings_.mm_per_unit;
    const double mean = grey(medium_.absorption) + grey(medium_.scattering);
    if (!(mean > 0.0) || settings_.diffuse_samples <= 0) return {};
    const double free_path = 1.0 / (mean * mm);
    double depth = free_path;
    SubsurfaceEnvironment::SurfaceHit back;
    const bool ends = environment_.nearest({point_.point, -point_.normal}, back);
    if (ends && back.t < 2.0 * free_path) {
      depth = std::min(free_path, back.interior == point_.interior ? back.t / 2.0 : back.t - kEpsilon);
    }
    const Vec3 base = point_.point - point_.normal * depth;
    return environment_.replay() ? everywhere(base)
                                 : where_it_counts(base, ends ? back.t : std::numeric_limits<double>::infinity());
  }

  // A place where light enters that leaves at the point.
  struct Entrance {
    Vec3 point, normal;  // geometric
    double weight;
    Channels reflected;  // share that leaves
    double worth() const { return weight * std::max({reflected[0], reflected[1], reflected[2]}); }
  };
  Entrance entrance(const Vec3& direction, const SubsurfaceEnvironment::SurfaceHit& hit) const {
    const double mm = settings_.mm_per_unit, t = hit.t * mm;
    Entrance e{hit.point, hit.normal, 4.0 * kPi * t * t / std::max(0.01, std::fabs(dot(direction, hit.normal))), {}};
    const Vec3 offset = hit.point - point_.point;
    const double d2 = dot(offset, offset) * mm * mm;
    for (int c = 0; c < 3; ++c) e.reflected[c] = medium_.extinction[c] > 0.0 ? dipole(d2, c, medium_, a_) : 0.0;
    return e;
  }

  void add_entering(const Entrance& e, Channels& sum) {
    Channels arriving{};
    for (std::size_t l = 0; l < environment_.lights(); ++l) {
      Rgb color;
      Vec3 to_light;
      if (!environment_.illumination(l, e.point, color, to_light)) continue;
      // The normal is turned to the side of the light.
      const double cosine = std::fabs(dot(e.normal, to_light));
      const double share = e.weight * cosine * fresnel_transmittance(cosine, eta_) * out_transmittance_;
      const Channels light = channels(color);
      for (int c = 0; c < 3; ++c) arriving[c] += share * light[c];
    }
    if (Rgb light; environment_.irradiance(e.point, e.normal, light)) {
      const double share = e.weight * fresnel_transmittance(1.0, eta_) * out_transmittance_;
      const Channels indirect = channels(light);
      for (int c = 0; c < 3; ++c) arriving[c] += share * indirect[c];
    }
    for (int c = 0; c < 3; ++c) {
      if (arriving[c] != 0.0) sum[c] += arriving[c] * e.reflected[c];
    }
  }

  // As POV-Ray does it: directions uniform on the sphere.
  Channels everywhere(const Vec3& base) {
    Channels sum{};
    int counted = 0;
    for (int i = 0; i < settings_.diffuse_samples; ++i) {
      const Vec3 direction = environment_.sphere_direction();
      SubsurfaceEnvironment::SurfaceHit hit;
      if (!environment_.nearest({base, direction}, hit)) continue;
      ++counted;
      if (hit.interior == point_.interior) add_entering(entrance(direction, hit), sum);
    }
    if (counted > 0) {
      for (double& v : sum) v /= counted;
    }
    return sum;
  }

  // The same mean with fewer rays: directions of a shifted Fibonacci lattice about the normal.
  Channels where_it_counts(const Vec3& base, double thickness) {
    constexpr double kThick = 4.0, kGolden = 0.61803398874989485;
    constexpr int kFew = 16, kBatch = 32, kTogether = 32 * kBatch;
    // Where light of every colour dies out before it reaches the far side, what counts is near and varies little.
    const bool thick = slowest_decay() * thickness * settings_.mm_per_unit > kThick;
    const int n = part_of(settings_.diffuse_samples, thick ? 0.25 : 0.8);
    const double below = thick && n >= kFew ? 0.3 : 0.5;  // of the directions; weights make up for it
    const double shift = environment_.random(), turn = environment_.random();
    const Vec3& up = point_.normal;
    const Vec3 x = normalize(cross(up, std::fabs(up.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0))), y = cross(up, x);
    Vec3 directions[kBatch];
    double shares[kBatch];
    SubsurfaceEnvironment::SurfaceHit hits[kBatch];
    bool found[kBatch];
    boost::container::small_vector<Entrance, 128> entrances;
    double counted = 0.0;
    Channels sum{};
    for (int begin = 0; begin < n; begin += kBatch) {
      const int size = std::min(kBatch, n - begin);
      for (int i = 0; i < size; ++i) {
        const double u = (begin + i + shift) / n, angle = 2.0 * kPi * ((begin + i) * kGolden + turn);
        const double cosine = u < below ? u / below - 1.0 : (u - below) / (1.0 - below),
                     sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
        directions[i] = sine * std::cos(angle) * x + sine * std::sin(angle) * y + cosine * up;
        shares[i] = 0.5 / (u < below ? below : 1.0 - below);
      }
      environment_.nearest(base, {directions, static_cast<std::size_t>(size)}, hits, found);
      for (int i = 0; i < size; ++i) {
        if (!found[i]) continue;
        counted += shares[i];
        if (hits[i].interior != point_.interior) continue;
        entrances.push_back(entrance(directions[i], hits[i]));
        entrances.back().weight *= shares[i];
      }
      if (entrances.size() < kTogether && begin + size < n) continue;
      add_some_of({entrances.data(), entrances.size()}, sum);
      entrances.clear();
    }
    if (counted > 0.0) {
      for (double& v : sum) v /= counted;
    }
    return sum;
  }

  // Far places hardly count: there light is looked for by chance, with what is found made up for (Russian roulette; the
  // chances are spread evenly).
  void add_some_of(std::span<Entrance> entrances, Channels& sum) {
    double worth = 0.0;
    for (const Entrance& e : entrances) worth += e.worth();
    if (!(worth > 0.0)) return;
    const double ordinary = 0.4 * worth / static_cast<double>(entrances.size());
    double chances = environment_.random();
    for (Entrance& e : entrances) {
      const double chance = std::clamp(e.worth() / ordinary, 0.05, 1.0), before = std::floor(chances);
      chances += chance;
      if (std::floor(chances) == before) continue;
      e.weight /= chance;
      add_entering(e, sum);
    }
  }
  // Samples that make less noise than `samples` of POV-Ray's: at least one.
  static int part_of(int samples, double part) { return std::max(1, static_cast<int>(samples * part + 0.5)); }
  double slowest_decay() const {
    double slowest = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c) {
      if (medium_.extinction[c] > 0.0) slowest = std::min(slowest, medium_.transport[c]);
    }
    return slowest;
  }

  Vec3 refract() const {
    const double r = 1.0 / eta_, q = 1.0 + r * r * (cos_out_ * cos_out_ - 1.0);
    if (q < 0.0) return {0, 0, 0};
    return normalize(r * point_.view + (r * cos_out_ - std::sqrt(q)) * point_.normal);
  }

  // Light of source `l` that is scattered once at p, `depth` millimetres along the refracted ray, except for what
  // depends on the channel.
  struct Scattered {
    Channels light;
    double cosine, inner, path;  // outside and inside of the surface; millimetres to p
  };
  bool scattered(std::size_t l, const Vec3& p, Scattered& s) {
    const Vec3 direction = environment_.direction_to(l, p);
    SubsurfaceEnvironment::SurfaceHit surface;
    if (!environment_.nearest({p, direction}, surface) || surface.interior != point_.interior) return false;
    Rgb color;
    Vec3 to_light;
    if (!environment_.illumination(l, surface.point, color, to_light)) return false;
    s.cosine = std::fabs(dot(surface.normal, to_light));
    s.inner = std::sqrt(std::max(0.0, 1.0 - (1.0 - s.cosine * s.cosine) / (eta_ * eta_)));
    if (!(s.inner > 0.0)) return false;
    s.light = channels(color);
    s.path = surface.t * settings_.mm_per_unit * s.cosine / s.inner;
    return true;
  }
  double once(const Scattered& s, int c, double depth, double cos_inner) const {
    const double extinction = medium_.extinction[c], g = std::fabs(cos_inner / s.inner);
    return s.light[c] * s.cosine * medium_.scattering[c] * fresnel_transmittance(s.cosine, eta_) * out_transmittance_ *
           0.25 / (extinction + g * extinction) * std::exp(-s.path * extinction) * std::exp(-depth * extinction);
  }

  void single_scattering(const Vec3& refracted, double exit_distance, Channels& sum) {
    const double cos_inner = std::fabs(dot(refracted, point_.normal));
    if (settings_.single_samples <= 0) return;
    const Channels mean = environment_.replay() ? separate_channels(refracted, exit_distance, cos_inner)
                                                : shared_depths(refracted, exit_distance, cos_inner);
    for (int c = 0; c < 3; ++c) sum[c] += mean[c];
  }

  // As POV-Ray does it: every channel draws its own depths.
  Channels separate_channels(const Vec3& refracted, double exit_distance, double cos_inner) {
    Channels total{};
    for (int i = 0; i < settings_.single_samples; ++i) {
      for (int c = 0; c < 3; ++c) {
        const double draw = environment_.random(), extinction = medium_.extinction[c];
        if (extinction <= 0.0) continue;
        const double depth = std::fabs(std::log(draw)) / extinction;
        if (!(depth < exit_distance)) continue;
        const Vec3 p = point_.point + refracted * (depth / settings_.mm_per_unit);
        Scattered s;
        for (std::size_t l = 0; l < environment_.lights(); ++l) {
          if (scattered(l, p, s)) total[c] += once(s, c, depth, cos_inner);
        }
      }
    }
    for (double& v : total) v /= settings_.single_samples;
    return total;
  }

  // The same integral: the channels take turns in choosing a depth, stratified, and all use it, weighted by the balance
  // heuristic (Veach and Guibas 1995). A sixth of the rays for the same noise.
  Channels shared_depths(const Vec3& refracted, double exit_distance, double cos_inner) {
    Channels total{};
    std::array<int, 3> order{}, share{};
    int used = 0;
    for (int c = 0; c < 3; ++c) {
      if (medium_.extinction[c] > 0.0) order[static_cast<std::size_t>(used++)] = c;
    }
    if (used == 0) return total;
    const int n = part_of(settings_.single_samples, 0.5);
    for (int i = 0; i < n; ++i) ++share[static_cast<std::size_t>(i % used)];
    for (int i = 0; i < n; ++i) {
      const auto turn = static_cast<std::size_t>(i % used);
      const double draw = (i / used + environment_.random()) / share[turn];
      const double depth = std::fabs(std::log(1.0 - draw)) / medium_.extinction[order[turn]];
      if (!(depth < exit_distance)) continue;
      double density = 0.0;  // how often such depths are chosen, all channels together
      for (int k = 0; k < used; ++k) {
        const double extinction = medium_.extinction[order[static_cast<std::size_t>(k)]];
        density += share[static_cast<std::size_t>(k)] * extinction * std::exp(-extinction * depth);
      }
      const Vec3 p = point_.point + refracted * (depth / settings_.mm_per_unit);
      Scattered s;
      for (std::size_t l = 0; l < environment_.lights(); ++l) {
        if (!scattered(l, p, s)) continue;
        for (int k = 0; k < used; ++k) {
          const int c = order[static_cast<std::size_t>(k)];
          const double wanted = n * medium_.extinction[c] * std::exp(-medium_.extinction[c] * depth);
          total[c] += once(s, c, depth, cos_inner) * wanted / density;
        }
      }
    }
    for (double& v : total) v /= n;
    return total;
  }

  void unscattered(const Vec3& refracted, const SubsurfaceEnvironment::SurfaceHit& exit, Channels& sum) {
    Channels share{};
    double most = 0.0;
    for (int c = 0; c < 3; ++c) {
      share[c] = medium_.extinction[c] > 0.0 ? std::exp(-medium_.extinction[c] * exit.t * settings_.mm_per_unit) : 0.0;
      most = std::max(most, share[c]);
    }
    if (!(most > settings_.adc_bailout) || exit.interior != point_.interior) return;
    const Channels seen = channels(environment_.transmitted({point_.point, refracted}, exit, most));
    for (int c = 0; c < 3; ++c) sum[c] += share[c] * seen[c];
  }

  const SubsurfacePoint& point_;
  const SubsurfaceSettings& settings_;
  SubsurfaceEnvironment& environment_;
  Medium medium_;
  double a_, eta_, cos_out_, out_transmittance_;
};

}  // namespace

double fresnel_transmittance(double cosine, double eta) {
  const double q = eta * eta + cosine * cosine - 1.0;
  if (q <= 0.0) return 1.0;  // (sic) where all light is reflected
  const double g = std::sqrt(q), a = (g - cosine) / (g + cosine),
               b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
  return 1.0 - std::clamp(0.5 * a * a * (1.0 + b * b), 0.0, 1.0);
}

double reduced_albedo(double reflectance, double ior) {
  const Table& table = albedo_table(ior);
  const double scaled = std::clamp(reflectance, 0.0, 1.0) * 100.0;
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(scaled), 99);
  const double t = scaled - static_cast<double>(i);
  return table[i] + t * (table[i + 1] - table[i]);
}

Rgb subsurface(const SubsurfacePoint& point, const SubsurfaceSettings& settings, SubsurfaceEnvironment& environment) {
  return Estimator(point, settings, environment).run();
}

}  // namespace verisim::global
