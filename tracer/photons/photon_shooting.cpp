#include "tracer/photons/photon_shooting.h"

#include <algorithm>
#include <cmath>

#include "tracer/functions/sine_kernels.h"
#include "tracer/math/constants.h"
#include "tracer/film/errors.h"
#include "tracer/shading/random.h"

namespace verisim::global {
namespace {

constexpr double kMaxPerRing = 1e9;
constexpr std::size_t kMaxBatch = std::size_t{1} << 16;  // starts in memory at a time

bool active(scene::Flag object, scene::Flag light) {
  const bool on = object == scene::Flag::on || light == scene::Flag::on;
  const bool off = object == scene::Flag::off || light == scene::Flag::off;
  return on && !off;
}

void collect_lights(const std::vector<scene::ObjectPtr>& objects, std::vector<const scene::LightSource*>& lights) {
  for (const scene::ObjectPtr& o : objects) {
    if (const auto* light = o->as<scene::LightSource>()) {
      if (light->kind != scene::LightKind::shadowless) lights.push_back(light);
    } else if (o->as<scene::Csg>()) {
      collect_lights(scene::children_of(*o), lights);
    }
  }
}

// Unions that are dissolved into frame-level objects are targets piece by piece.
void collect_targets(const scene::Object& object, std::vector<const scene::Object*>& targets) {
  if (object.photons->target) {
    if (!object.ignore_global_lights) targets.push_back(&object);
  } else if (object.as<scene::Csg>()) {
    for (const scene::ObjectPtr& child : scene::children_of(object)) collect_targets(*child, targets);
  }
}

// Of an angle.
struct Turn {
  double sine, cosine;
};

// v turned about a unit axis, rounded as POV-Ray does, measured by its photon files: where photons of a plane lie in
// its map hangs on the last bit.
Vec3 rotate(const Vec3& v, const Vec3& axis, const Turn& turn) {
  const double c = turn.cosine, s = turn.sine, x = axis.x, y = axis.y, z = axis.z;
  const Vec3 row[3] = {{x * x + c * (1 - x * x), x * y * (1 - c) + z * s, x * z * (1 - c) - y * s},
                       {x * y * (1 - c) - z * s, y * y + c * (1 - y * y), y * z * (1 - c) + x * s},
                       {x * z * (1 - c) + y * s, y * z * (1 - c) - x * s, z * z + c * (1 - z * z)}};
  return v.x * row[0] + v.y * row[1] + v.z * row[2];
}

// Angles of photons, whose sines and cosines are computed together.
class Turns {
 public:
  bool full() const { return count_ == kMax; }
  int count() const { return count_; }
  // Around the line to the target, and away from it.
  void add(double phi, double theta) { phi_[count_] = phi, theta_[count_++] = theta; }
  void clear() { count_ = 0; }
  void compute() {
    const auto& kernels = functions::sine_kernels();
    kernels.sines_and_cosines(phi_, count_, phi_sine_, phi_cosine_);
    kernels.sines_and_cosines(theta_, count_, theta_sine_, theta_cosine_);
  }
  double away(int k) const { return theta_[k]; }
  Turn turn(int k) const { return {phi_sine_[k], phi_cosine_[k]}; }
  Turn turn_away(int k) const { return {theta_sine_[k], theta_cosine_[k]}; }

 private:
  static constexpr int kMax = 64;
  int count_ = 0;
  double phi_[kMax], theta_[kMax], phi_sine_[kMax], phi_cosine_[kMax], theta_sine_[kMax], theta_cosine_[kMax];
};

// How photons leave one point of a light: unit vectors towards the target and to the left of it, and the axis that they
// are turned about, which is normalised once more, as POV-Ray does: its last bits show in photons that are reflected.
struct Aim {
  Vec3 origin, towards, left, axis;
};

Aim aim(const PhotonPair& pair, const Vec3& origin) {
  Aim f;
  f.origin = origin;
  f.towards = pair.light->parallel ? pair.light->direction : normalize(pair.center - origin);
  const Vec3 up = std::fabs(std::fabs(f.towards.z) - 1.0) < 0.1 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  f.left = normalize(cross(f.towards, up));
  f.axis = normalize(f.towards);
  return f;
}

// Of the k-th photon.
Ray start_of(const PhotonPair& pair, const Aim& aim, const Turns& turns, int k) {
  if (pair.light->parallel) {
    const double back = dot(pair.center - aim.origin, aim.towards);
    return {pair.center - back * aim.towards + rotate(aim.left * turns.away(k), aim.axis, turns.turn(k)), aim.towards};
  }
  const Turn away = turns.turn_away(k);
  return {aim.origin, rotate(aim.towards * away.cosine - aim.left * away.sine, aim.axis, turns.turn(k))};
}

}  // namespace

RandomTable::RandomTable() : numbers_(shading::mersenne_table()) {}

std::vector<PhotonPair> photon_pairs(const scene::Scene& scene, std::span<const scene::Object* const> objects) {
  std::vector<const scene::LightSource*> lights;
  std::vector<const scene::Object*> targets;
  collect_lights(scene.objects, lights);
  for (const scene::Object* object : objects) collect_targets(*object, targets);
  std::vector<PhotonPair> pairs;
  for (const scene::LightSource* light : lights) {
    for (const scene::Object* target : targets) {
      PhotonPair pair;
      pair.light = light, pair.target = target;
      pair.reflection = active(target->photons->reflection, light->photon_reflection);
      pair.refraction = active(target->photons->refraction, light->photon_refraction);
      if (!pair.reflection && !pair.refraction) continue;
      const auto& b = target->bounds;
      const Vec3 half(0.5 * b.size[0], 0.5 * b.size[1], 0.5 * b.size[2]);
      pair.center = Vec3(b.low[0], b.low[1], b.low[2]) + half;
      pair.radius = length(half);
      pair.density = target->photons->target_spacing;
      pairs.push_back(pair);
    }
  }
  return pairs;
}

double photon_spacing(const scene::Photons& settings, std::span<const PhotonPair> pairs) {
  if (settings.count <= 0) return settings.spacing > 0.0 ? settings.spacing : 1.0;
  double sum = 0.0;
  for (const PhotonPair& p : pairs) {
    const double r = p.radius / p.density;
    double x = kPi * r * r;
    if (p.reflection && p.refraction) x *= 1.5;
    if (p.target->photons->collect) {
      if (p.reflection && p.refraction) {
        x *= 3.0;
      } else if (p.refraction) {
        x *= 2.0;
      }
    }
    sum += 0.5 * x;
  }
  return std::sqrt(sum / settings.count);
}

void shoot(const PhotonPair& pair, double spacing, const scene::Photons& settings, RandomTable& random,
           const std::function<bool(std::span<const PhotonStart>, double, double)>& trace) {
  const scene::LightSource& light = *pair.light;
  const bool grid = light.area && light.photon_area;
  const int columns = grid ? light.size1 : 1, rows = grid ? light.size2 : 1;
  const double distance = length(pair.center - light.position);
  double limit = pair.radius;
  if (!light.parallel) limit = distance >= pair.radius ? std::asin(pair.radius / distance) : kPi;
  double sigma = pair.density * spacing / (light.parallel ? 1.0 : distance);
  if (grid) sigma *= std::sqrt(static_cast<double>(columns) * rows);
  const double step = light.parallel ? sigma : std::atan(sigma);
  if (!(step > 0.0) || !std::isfinite(limit)) return;

  std::vector<Aim> aims;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      Vec3 origin = light.position;
      if (grid) {
        if (columns > 1) origin += light.axis1 * (i / (columns - 1.0) - 0.5);
        if (rows > 1) origin += light.axis2 * (j / (rows - 1.0) - 0.5);
      }
      aims.push_back(aim(pair, origin));
    }
  }
  const float share = 1.0f / static_cast<float>(aims.size());

  // Finer rings would not end in anybody's lifetime, and finest ones not at all.
  if (limit / step > kMaxPerRing)
    throw render::LimitExceeded("photons { }: the spacing is too fine for this target: more than 1e9 rings of photons");
  std::vector<PhotonStart> batch;
  Turns turns;
  bool hit_before = false;
  for (double theta = 0.0; theta < limit; theta += step) {
    const double around = theta < kEpsilon ? 2.0 * kPi : step / (light.parallel ? theta : std::sin(theta));
    const double first = -kPi + around * random.next() * 0.5;
    if (2.0 * kPi / around > kMaxPerRing)
      throw render::LimitExceeded(
          "photons { }: the spacing is too fine for this target: more than 1e9 photons in a ring");
    const double done = theta / limit * (theta / limit);  // rings grow with their radius
    bool hit = false;
    const auto start_all = [&] {
      turns.compute();
      for (int k = 0; k < turns.count(); ++k) {
        for (const Aim& f : aims) batch.push_back({start_of(pair, f, turns, k), share});
        if (batch.size() >= kMaxBatch) hit |= trace(batch, sigma, done), batch.clear();
      }
      turns.clear();
    };
    batch.clear();
    for (double phi = first; phi < first + 2.0 * kPi - around / 2.0; phi += around) {
      const double phi2 = phi + around * (random.next() - 0.5) * settings.jitter;
      turns.add(phi2, theta + step * (random.next() - 0.5) * settings.jitter);
      if (turns.full()) start_all();
    }
    start_all();
    hit |= trace(batch, sigma, done);
    if (hit_before && !hit && theta > settings.autostop * limit) break;
    hit_before |= hit;
  }
}

}  // namespace verisim::global
