#include <tbb/enumerable_thread_specific.h>

#include "tracer/effects/photon_media.h"
#include "tracer/photons/photon_shooting.h"
#include "tracer/base/parallel.h"
#include "tracer/render/evaluation_watch.h"
#include "tracer/render/prepasses.h"

namespace verisim::render {
namespace {

using shading::PhotonShot;
using shading::StoredPhoton;

constexpr std::size_t kSmallRing = 64;  // not worth handing to threads
// Photons of a ring that look for their first surface together; what a thread is handed.
constexpr std::size_t kTogether = 2 * RayPacket::kCount;

void collect_primitives(const scene::Object& object, std::unordered_set<const scene::Object*>& out) {
  out.insert(&object);
  if (object.as<scene::Csg>())
    for (const auto& child : scene::children_of(object)) collect_primitives(*child, out);
}

// What shoots in one thread.
struct Gun {
  shading::Tracer tracer;
  // The interiors around a place: most photons of a light start at the same one.
  std::optional<Vec3> place{};
  std::vector<const scene::Interior*> interiors{};

  std::span<const scene::Interior* const> around(const shading::SceneData& data, const Vec3& p,
                                                 std::span<const std::uint32_t> holders) {
    if (place != p) {
      data.world.interiors_of_photon(p, holders, interiors);
      place = p;
    }
    return interiors;
  }
};

class Shooter {
 public:
  Shooter(global::SceneEffects& effects, const shading::SceneData& data, const Options& options, int threads)
      : effects_(effects),
        data_(data),
        options_(options),
        media_(effects),
        use_media_(effects.media_in_interiors || effects.atmosphere),
        threads_(threads),
        guns_([this] {
          return Gun{shading::Tracer(data_, shading::RandomSource(options_.replay, options_.seed), options_.cancel)};
        }) {}

  // `first` and `share`: the part of the whole pass that this pair is.
  void shoot(const global::PhotonPair& pair, double spacing, global::RandomTable& random, double first, double share) {
    const scene::Photons& settings = effects_.scene().settings.photons;
    std::unordered_set<const scene::Object*> target;
    collect_primitives(*pair.target, target);
    const shading::Light& light = data_.light_of(pair.light);
    PhotonShot shot;
    shot.light = pair.light, shot.target = &target;
    shot.max_trace_level = settings.max_trace_level > 0 ? settings.max_trace_level : data_.max_trace_level;
    shot.adc_bailout = settings.adc_bailout >= 0 ? static_cast<float>(settings.adc_bailout) : data_.adc_bailout;
    global::shoot(pair, spacing, settings, random,
                  [&](std::span<const global::PhotonStart> ring, double sigma, double done) {
                    shot.sigma = sigma;
                    if (options_.pass_progress) options_.pass_progress("photons", first + done * share);
                    return trace_ring(ring, shot, light);
                  });
  }

 private:
  bool trace_ring(std::span<const global::PhotonStart> ring, const PhotonShot& shot, const shading::Light& light) {
    results_.resize(std::max(results_.size(), ring.size()));
    Box3 box;
    for (const global::PhotonStart& start : ring) box.extendBy(start.ray.origin);
    holders_ = data_.world.photon_holders(light.projector() ? shapes::everywhere() : box);
    std::atomic<bool> hit{false};
    const auto trace = [&](std::size_t part) {
      const EvaluationWatch watch(options_.cancel);
      const std::size_t first = part * kTogether;
      if (trace_together(guns_.local(), ring.subspan(first, std::min(kTogether, ring.size() - first)), first, shot,
                         light))
        hit.store(true, std::memory_order_relaxed);
      watch.check();
    };
    const std::size_t parts = (ring.size() + kTogether - 1) / kTogether;
    if (options_.replay || threads_ == 1 || ring.size() < kSmallRing) {
      for (std::size_t part = 0; part < parts; ++part) trace(part);
    } else {
      parallel_for(parts, 1, trace);
    }
    shot_count_ += ring.size();
    for (Gun& gun : guns_) count_rays(options_, std::exchange(gun.tracer.statistics(), {}));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (const StoredPhoton& s : results_[i]) store(s);
    }
    return hit.load();
  }

  // At most kTogether photons, the first of which is the number `first` of the ring. Most of them go the same way
  // until they meet something, and many meet nothing.
  bool trace_together(Gun& gun, std::span<const global::PhotonStart> starts, std::size_t first, const PhotonShot& shot,
                      const shading::Light& light) {
    gun.tracer.begin_block();
    RayBatch rays;
    Rgb colors[kTogether];
    std::size_t index[kTogether];
    int count = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      results_[first + i].clear();
      Ray ray = starts[i].ray;
      if (!leaves(starts[i], light, ray, colors[count])) continue;
      rays.origin.set(count, ray.origin), rays.direction.set(count, ray.direction);
      index[count++] = first + i;
    }
    shapes::Hit hits[kTogether];
    bool found[kTogether];
    const auto kind = shapes::RayKind::photon;
    const double nearest = shading::PhotonWalk::kNearestHit;
    // In POV-Ray's order a photon goes all its way before the next one is shot.
    if (!options_.replay) data_.world.intersect_batch(rays, 0, count, kind, nearest, nullptr, hits, found);
    bool hit_target = false;
    for (int k = 0; k < count; ++k) {
      if (!options_.replay) gun.tracer.random().begin_sample(static_cast<double>(shot_count_ + index[k]), 0.5, 0);
      const Ray ray = rays.at(k);
      if (options_.replay) found[k] = data_.world.intersect(ray, kind, nearest, accel::kFarthestHit, hits[k]);
      const auto around =
          found[k] ? gun.around(data_, ray.origin, holders_) : std::span<const scene::Interior* const>();
      hit_target |= shading::PhotonWalk(gun.tracer, shot, use_media_ ? &media_ : nullptr)
                        .run(ray, found[k] ? &hits[k] : nullptr, around, colors[k], results_[index[k]]);
    }
    return hit_target;
  }

  // The packet carries what the light sends this way; fading is part of what is stored. False: nothing.
  static bool leaves(const global::PhotonStart& start, const shading::Light& light, Ray& ray, Rgb& color) {
    const double attenuation = light.emission(ray.origin, ray.direction);
    if (attenuation < 1e-5) return false;  // whatever the light's colour is
    color = light.color() * start.energy * static_cast<float>(attenuation);
    if (const shapes::Shape* projector = light.projector()) {
      shapes::HitList hits;
      projector->intersect_all(ray, shapes::RayKind::photon, hits);
      double farthest = 0;
      for (const auto& h : hits) farthest = std::max(farthest, h.t);
      if (hits.empty()) return false;
      ray.origin = ray.at(farthest);
    }
    return true;
  }

  void store(const StoredPhoton& s) {
    global::PhotonMap& map = s.media ? effects_.media_photons() : effects_.surface_photons();
    const std::uint64_t most = options_.pass_memory / (sizeof(global::PhotonPosition) + sizeof(global::Photon));
    if (effects_.surface_photons().size() + effects_.media_photons().size() >= most)
      throw LimitExceeded("more than " + std::to_string(most) +
                          " photons: raise the spacing or lower the count in photons { }, or allow more memory");
    global::Photon photon;
    photon.energy = global::Photon::encode(s.energy);
    photon.set_direction(s.towards_light);
    map.add({static_cast<float>(s.point.x), static_cast<float>(s.point.y), static_cast<float>(s.point.z)}, photon);
  }

  global::SceneEffects& effects_;
  const shading::SceneData& data_;
  const Options& options_;
  global::ScenePhotonMedia media_;
  bool use_media_;
  int threads_;
  tbb::enumerable_thread_specific<Gun> guns_;
  std::vector<std::vector<StoredPhoton>>
      results_;  // per photon of a ring, so that the map's order does not depend on threads
  std::size_t shot_count_ = 0;
  std::vector<std::uint32_t> holders_;  // of a ring: what its photons may start in
};

}  // namespace

void photon_pass(global::SceneEffects& effects, const shading::SceneData& data, const Options& options, int threads) {
  const scene::Photons& settings = effects.scene().settings.photons;
  global::PhotonMap &surface = effects.surface_photons(), &media = effects.media_photons();
  if (options.prepasses_from) {
    // The maps are there.
  } else if (!settings.load_file.empty()) {
    global::load_photons(settings.load_file, surface, media);
  } else {
    const auto pairs = global::photon_pairs(effects.scene(), data.world.objects());
    const double spacing = global::photon_spacing(settings, pairs);
    Shooter shooter(effects, data, options, threads);
    global::RandomTable random;
    try {
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double share = 1.0 / static_cast<double>(pairs.size());
        shooter.shoot(pairs[i], spacing, random, static_cast<double>(i) * share, share);
      }
      if (options.pass_progress) options.pass_progress("photons", 1.0);
    } catch (const shading::Cancelled&) {
      return;
    }
    surface.build(), media.build();
    if (!settings.save_file.empty() && !surface.empty()) global::save_photons(settings.save_file, surface, media);
  }
  global::CLibraryRandom random;
  surface.set_gather_radius(settings.radius, settings.radius_gather_multiplier, settings.gather_max, false, random);
  media.set_gather_radius(settings.media_radius, settings.media_radius_gather_multiplier, settings.gather_max, true,
                          random);
}

}  // namespace verisim::render
