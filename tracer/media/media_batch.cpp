#include "tracer/media/media_batch.h"

#include <algorithm>
#include <memory>

#include <boost/container/static_vector.hpp>

#include "tracer/media/media_kernels.h"
#include "tracer/math/scaled.h"
#include "tracer/media/media_refinement.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/shading/direct/shadow_batch.h"
#include "tracer/textures/point_batch.h"

namespace verisim::global {
namespace {

using shading::MediaSegment;

constexpr std::size_t kMax = MediaPacket::kMax;
static_assert(kMax <= textures::PointBatch::kMax && kMax <= shading::ShadowBatch::kMax);
constexpr std::size_t kMaxPlaces = 128;  // of a ray, before its intervals are halved
constexpr float kDark = static_cast<float>(kEpsilon);

void clear(std::size_t count, textures::RgbBatch& batch) {
  for (float* channel : {batch.r, batch.g, batch.b}) std::fill_n(channel, count, 0.0f);
}
void add(std::size_t count, const textures::RgbBatch& density, const Rgb& color, textures::RgbBatch& to) {
  for (std::size_t i = 0; i < count; ++i)
    to.r[i] += density.r[i] * color.r, to.g[i] += density.g[i] * color.g, to.b[i] += density.b[i] * color.b;
}
Rgb at(const textures::RgbBatch& batch, std::size_t i) { return {batch.r[i], batch.g[i], batch.b[i]}; }

}  // namespace

// A place that is looked at.
struct MediaBatch::Question {
  std::uint32_t interval;
  double at;  // 0 to 1 of it
};

// Of a thread: it would be much to make and to clear for every batch.
struct MediaBatch::Workspace {
  struct RayPart {
    std::uint32_t first, end;       // intervals
    bool lost = false;              // numbers are drawn on the way to a light
    std::uint64_t shadow_rays = 0;  // that were counted for it
  };
  struct Interval {
    MediaInterval span;
    std::uint32_t ray;
  };
  std::span<const MediaSegment> subintervals;
  std::vector<RayPart> rays;
  std::vector<Interval> intervals;
  std::vector<const shading::Light*> lights;
  std::vector<LitRange> lit;       // of each light, of each ray
  std::vector<bool> shines;        // each light, on any ray
  std::vector<MediaSample> first;  // of the grid and the middles of its intervals
  MediaRefinement tree;            // first those of the grids
  std::vector<Question> questions;
  MediaIntervals dividing;
  // What is asked.
  Vec3 points[kMax];
  double distances[kMax];
  textures::RgbBatch extinction, scattering, source;  // source: emission, then what lights add
  struct Scatterer {                                  // a question in a lit piece where something scatters
    std::uint32_t question, ray;
  };
  boost::container::static_vector<Scatterer, kMax> scatterers;
  MediaPacket packet;
  shading::ShadowBatch shadows;
  std::size_t question[kMax];  // of each lane

  const Ray& ray(std::uint32_t interval) const { return subintervals[intervals[interval].ray].ray; }
};

MediaBatch::MediaBatch(shading::Tracer& tracer, const shading::RayState& common,
                       std::span<const CompiledMedia* const> media, MediaEnvironment& environment)
    : tracer_(tracer), common_(common), mixture_(media), environment_(environment), workspace_([]() -> Workspace& {
        static thread_local const std::unique_ptr<Workspace> workspace = std::make_unique<Workspace>();
        return *workspace;
      }()) {}

bool MediaBatch::possible() const {
  return mixture_.control->method == 3 && mixture_.control->jitter == 0.0 && (mixture_.scatters || mixture_.varies) &&
         !environment_.replay();
}

void MediaBatch::integrate(std::span<const MediaSegment> rays, MediaResult* results, bool* done) {
  divide(rays);
  look_along();
  refine();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Workspace::RayPart& part = workspace_.rays[i];
    done[i] = part.first != part.end && !part.lost;
    if (done[i])
      results[i] = result(static_cast<std::uint32_t>(i));
    else
      tracer_.statistics().shadow_rays -= part.shadow_rays;  // they will be counted when it goes alone
  }
}

void MediaBatch::divide(std::span<const MediaSegment> rays) {
  const shading::SceneData& scene = tracer_.scene();
  workspace_.subintervals = rays;
  workspace_.rays.clear(), workspace_.intervals.clear(), workspace_.lights.clear();
  std::vector<const scene::LightSource*> sources;
  for (std::size_t i = 0; i < scene.global_lights(); ++i) {  // intervals hang on them even where nothing scatters
    const shading::Light& light = scene.lights()[i];
    if (shines_on_media(light.source())) workspace_.lights.push_back(&light), sources.push_back(&light.source());
  }
  workspace_.lit.assign(sources.size() * rays.size(), LitRange{0, 1.0, -1.0});
  workspace_.shines.assign(sources.size(), false);
  const std::size_t each = 2 * static_cast<std::size_t>(mixture_.subintervals()) + 1;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const MediaSegment& s = rays[i];
    const auto first = static_cast<std::uint32_t>(workspace_.intervals.size());
    const bool own_lights = s.end && (s.end->ignore_global_lights || !s.end->group_lights().empty());
    if (s.length > 0.0 && !own_lights) {
      workspace_.dividing.look_for_lights(sources, s.ray, s.length);
      workspace_.dividing.divide(mixture_, s.length);
      if (workspace_.dividing.all().size() * each <= kMaxPlaces) {
        for (const LitRange& range : workspace_.dividing.lit())
          workspace_.lit[range.light * rays.size() + i] = range, workspace_.shines[range.light] = true;
        for (const MediaInterval& span : workspace_.dividing.all())
          workspace_.intervals.push_back({span, static_cast<std::uint32_t>(i)});
      }
    }
    workspace_.rays.push_back({first, static_cast<std::uint32_t>(workspace_.intervals.size())});
  }
}

// The grids of all rays, place by place: shadow rays from the same place of neighbouring rays go side by side, those
// from one place of a ray to the next do not.
void MediaBatch::look_along() {
  const int q = mixture_.subintervals();
  const std::size_t each = 2 * static_cast<std::size_t>(q) + 1;
  const double step = 1.0 / (q + 1);
  workspace_.first.resize(workspace_.intervals.size() * each);
  std::array<Question, kMax> questions;
  std::array<std::size_t, kMax> sample;
  std::array<MediaSample, kMax> samples;
  std::size_t count = 0;
  const auto flush = [&] {
    ask(std::span(questions).first(count), samples.data());
    for (std::size_t k = 0; k < count; ++k) workspace_.first[sample[k]] = samples[k];
    count = 0;
  };
  for (std::size_t place = 0, any = 1; any != 0; ++place) {
    const std::size_t number = place % each;
    const double at =
        number % 2 == 0 ? static_cast<double>(number / 2) * step
                        : middle_of(static_cast<double>(number / 2) * step, static_cast<double>(number / 2 + 1) * step);
    any = 0;
    for (const Workspace::RayPart& ray : workspace_.rays) {
      const std::size_t interval = ray.first + place / each;
      if (interval >= ray.end || ray.lost) continue;
      ++any;
      questions[count] = {static_cast<std::uint32_t>(interval), at}, sample[count] = interval * each + number;
      if (++count == kMax) flush();
    }
  }
  if (count > 0) flush();
}

void MediaBatch::refine() {
  const int q = mixture_.subintervals(), level = mixture_.halvings();
  const double step = 1.0 / (q + 1);
  auto& all = workspace_.tree.subintervals;
  all.clear();
  const MediaSample* s = workspace_.first.data();
  for (std::uint32_t i = 0; i < workspace_.intervals.size(); ++i, ++s)
    for (int k = 0; k < q; ++k, s += 2)
      all.push_back(workspace_.rays[workspace_.intervals[i].ray].lost
                        ? MediaRefinement::Subinterval{}
                        : MediaRefinement::Subinterval{k * step, (k + 1) * step, s[0], s[1], s[2], i});
  std::array<Question, kMax> questions;
  std::array<MediaSample, kMax> samples;
  std::size_t begin = 0;
  for (int depth = 0; depth < std::min(level, MediaRefinement::kMaxLevels); ++depth) {
    begin = workspace_.tree.halve(begin, mixture_.aa_threshold);
    for (std::size_t i = begin; i < all.size(); i += kMax) {
      const std::size_t n = std::min(kMax, all.size() - i);
      for (std::size_t k = 0; k < n; ++k) questions[k] = {all[i + k].interval, all[i + k].middle()};
      ask(std::span(questions).first(n), samples.data());
      for (std::size_t k = 0; k < n; ++k) all[i + k].s2 = samples[k];
    }
  }
}

MediaSample MediaBatch::refine_alone(std::uint32_t interval, const MediaSample& s1, double d1, const MediaSample& s3,
                                     double d3, int level) {
  const double d2 = middle_of(d1, d3);
  const Question question{interval, d2};
  MediaSample s2;
  ask({&question, 1}, &s2);
  return mean_of_interval(
      s1, s2, s3, level, mixture_.aa_threshold, [&] { return refine_alone(interval, s1, d1, s2, d2, level - 1); },
      [&] { return refine_alone(interval, s2, d2, s3, d3, level - 1); });
}

MediaResult MediaBatch::result(std::uint32_t ray) {
  const int q = mixture_.subintervals(), level = mixture_.halvings();
  const Workspace::RayPart part = workspace_.rays[ray];
  Rgb emission, depth;
  for (std::uint32_t i = part.first; i < part.end; ++i) {
    const MediaSample s = mean_of_interval(q, [&](int k) {
      return workspace_.tree.mean(
          i * static_cast<std::size_t>(q) + static_cast<std::size_t>(k), level, mixture_.aa_threshold,
          [&](const auto& subinterval, const MediaSample& s1, double d1, const MediaSample& s3, double d3, int left) {
            return refine_alone(subinterval.interval, s1, d1, s3, d3, left);
          });
    });
    emission += s.source * transmitted(depth);
    depth += s.depth;
  }
  return {emission, transmitted(depth)};
}

// Spec 07 4.6: samples at these places.
void MediaBatch::ask(std::span<const Question> questions, MediaSample* samples) {
  const std::size_t count = questions.size();
  textures::PointBatch points;
  for (std::size_t i = 0; i < count; ++i) {
    const MediaInterval& span = workspace_.intervals[questions[i].interval].span;
    workspace_.distances[i] = span.start + questions[i].at * span.length;
    workspace_.points[i] = workspace_.ray(questions[i].interval).at(workspace_.distances[i]);
    if (mixture_.varies) points.set(static_cast<int>(i), workspace_.points[i]);
  }
  if (mixture_.varies) points.fill_up(static_cast<int>(count));
  clear(count, workspace_.extinction), clear(count, workspace_.scattering), clear(count, workspace_.source);
  for (const CompiledMedia* m : mixture_.media) {
    textures::RgbBatch density;
    if (m->varies) {
      if (!m->emits && !m->scatters && m->extinction == Rgb()) continue;
      media_densities(*m, static_cast<int>(count), points, density);
    } else {
      const Rgb constant = media_density(*m, workspace_.points[0]);
      for (std::size_t i = 0; i < count; ++i)
        density.r[i] = constant.r, density.g[i] = constant.g, density.b[i] = constant.b;
    }
    add(count, density, m->extinction, workspace_.extinction);
    if (m->emits) add(count, density, m->description->emission, workspace_.source);
    if (m->scatters) add(count, density, m->description->scattering, workspace_.scattering);
  }
  if (mixture_.scatters) {
    find_scatterers(questions);
    for (std::size_t light = 0; light < workspace_.lights.size(); ++light)
      if (workspace_.shines[light]) add_light(light, questions);
    for (std::size_t i = 0; i < count; ++i) {
      const Rgb scattering = at(workspace_.scattering, i);
      const NearbyPhotons near =
          scattering.max_abs() > 0.0f ? environment_.photons(workspace_.points[i]) : NearbyPhotons();
      if (near.photons.empty()) continue;
      Rgb sum = at(workspace_.source, i);
      near.add_scattered(mixture_, scattering, workspace_.ray(questions[i].interval).direction, sum);
      workspace_.source.r[i] = sum.r, workspace_.source.g[i] = sum.g, workspace_.source.b[i] = sum.b;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double length = workspace_.intervals[questions[i].interval].span.length;
    samples[i] = {scaled(at(workspace_.source, i), length), scaled(at(workspace_.extinction, i), length)};
  }
}

void MediaBatch::find_scatterers(std::span<const Question> questions) {
  workspace_.scatterers.clear();
  for (std::uint32_t i = 0; i < questions.size(); ++i) {
    const Workspace::Interval& interval = workspace_.intervals[questions[i].interval];
    if (interval.span.lit && !(at(workspace_.scattering, i).max_abs() <= 0.0f))
      workspace_.scatterers.push_back({i, interval.ray});
  }
}

void MediaBatch::add_light(std::size_t number, std::span<const Question> questions) {
  const shading::Light& light = *workspace_.lights[number];
  MediaPacket& packet = workspace_.packet;
  // Where it shines.
  const LitRange* const lit = workspace_.lit.data() + number * workspace_.rays.size();
  int count = 0;
  for (const auto& [i, ray] : workspace_.scatterers) {
    const LitRange& range = lit[ray];
    if (workspace_.distances[i] < range.first || workspace_.distances[i] > range.last || workspace_.rays[ray].lost)
      continue;
    packet.to_light.origin.set(count, workspace_.points[i]);
    packet.view.set(count, workspace_.subintervals[ray].ray.direction);
    packet.scattering.set(count, at(workspace_.scattering, i));
    workspace_.question[count++] = i;
  }
  if (count == 0) return;
  shading::aim_at(light, count, packet.to_light, packet.distance);
  // What arrives: nothing is asked where that is dark.
  double attenuation[MediaPacket::kSize];
  if (!light.attenuates_air()) {
    std::fill_n(attenuation, count, 1.0);
  } else if (const auto falloff = shading::LightFalloff::of(light)) {
    falloff->attenuate(packet.to_light.direction, packet.distance, count, attenuation);
  } else {
    for (int k = 0; k < count; ++k)
      attenuation[k] =
          light.attenuation(packet.to_light.origin.at(k), {packet.to_light.direction.at(k), packet.distance[k]});
  }
  int bright = 0;
  for (int k = 0; k < count; ++k) {
    const Rgb color = scaled(light.color(), attenuation[k]);
    if (color.max_abs() < kDark) continue;
    packet.arriving.set(bright, color);
    if (bright != k) {
      packet.to_light.origin.set(bright, packet.to_light.origin.at(k)),
          packet.to_light.direction.set(bright, packet.to_light.direction.at(k));
      packet.view.set(bright, packet.view.at(k)), packet.scattering.set(bright, packet.scattering.at(k));
      packet.distance[bright] = packet.distance[k], workspace_.question[bright] = workspace_.question[k];
    }
    ++bright;
  }
  if (bright == 0) return;
  shading::ShadowBatch& batch = workspace_.shadows;
  batch.count = 0;
  const auto ray_of = [&](int k) {
    return workspace_.intervals[questions[workspace_.question[static_cast<std::size_t>(k)]].interval].ray;
  };
  for (int k = 0; k < bright; ++k)
    batch.add(packet.to_light.at(k), packet.distance[k], packet.arriving.at(k), nullptr,
              workspace_.subintervals[ray_of(k)].key);
  bool known[shading::ShadowBatch::kMax];
  tracer_.look_for_light(light, common_, batch, known);
  for (int k = 0; k < bright; ++k) {
    const std::uint32_t ray = ray_of(k);
    const std::uint64_t counted = tracer_.statistics().shadow_rays - (known[k] ? 1 : 0);
    packet.arriving.set(k, known[k] ? batch.light[k] : light_alone(light, k, ray, packet.arriving.at(k)));
    workspace_.rays[ray].shadow_rays += tracer_.statistics().shadow_rays - counted;
  }
  mixture_.scatter(bright, packet);
  for (int k = 0; k < bright; ++k) {
    if (!(packet.arriving.at(k).max_abs() > 0.0f)) continue;
    const std::size_t i = workspace_.question[k];
    workspace_.source.r[i] += packet.scattered.r[k], workspace_.source.g[i] += packet.scattered.g[k],
        workspace_.source.b[i] += packet.scattered.b[k];
  }
}

// Where surfaces or volumes may filter the light. If that draws numbers, their order matters, and the ray has to go
// alone from its start to its end.
Rgb MediaBatch::light_alone(const shading::Light& light, int lane, std::uint32_t ray, const Rgb& color) {
  if (workspace_.rays[ray].lost) return {};
  tracer_.random().begin(workspace_.subintervals[ray].key);
  shading::RayState state = common_;
  state.ray = workspace_.subintervals[ray].ray;
  const Rgb arriving = tracer_.shadowed(
      light, workspace_.packet.to_light.origin.at(lane),
      {workspace_.packet.to_light.direction.at(lane), workspace_.packet.distance[lane]}, state, nullptr, color);
  const shading::Effects* const effects = tracer_.scene().effects;
  const bool draws_count = !effects || effects->interior_draws_count || effects->air_draws_count;
  workspace_.rays[ray].lost = draws_count ? tracer_.random().drawn() : tracer_.random().drawn_outside_media();
  return arriving;
}

}  // namespace verisim::global
