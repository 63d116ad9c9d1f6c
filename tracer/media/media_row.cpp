#include "tracer/media/media_row.h"

#include <algorithm>

#include "tracer/media/media_kernels.h"
#include "tracer/media/media_refinement.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/shading/direct/shadow_row.h"
#include "tracer/textures/point_row.h"

namespace verisim::global {
namespace {

using shading::ContainerStretch;
using shading::LightWay;

constexpr std::size_t kMost = MediaLanes::kMost;
static_assert(kMost <= textures::PointRow::kMost && kMost <= shading::ShadowRow::kMost);
constexpr std::size_t kMostPlaces = 128;  // of a ray, before its stretches are halved
constexpr float kDark = static_cast<float>(kEpsilon);

void clear(std::size_t count, textures::RgbRow& row) {
  for (float* channel : {row.r, row.g, row.b}) std::fill_n(channel, count, 0.0f);
}
void add(std::size_t count, const textures::RgbRow& density, const Rgb& color, textures::RgbRow& to) {
  for (std::size_t i = 0; i < count; ++i)
    to.r[i] += density.r[i] * color.r, to.g[i] += density.g[i] * color.g, to.b[i] += density.b[i] * color.b;
}
Rgb at(const textures::RgbRow& row, std::size_t i) { return {row.r[i], row.g[i], row.b[i]}; }

}  // namespace

// A place that is looked at.
struct MediaRow::Question {
  std::uint32_t interval;
  double at;  // 0 to 1 of it
};

// Of a thread: it would be much to make and to clear for every row.
struct MediaRow::Room {
  struct RayPart {
    std::uint32_t first, end;  // intervals
    bool lost;                 // numbers are drawn on the way to a light
  };
  struct Interval {
    MediaInterval span;
    std::uint32_t ray;
  };
  std::span<const ContainerStretch> stretches;
  std::vector<RayPart> rays;
  std::vector<Interval> intervals;
  std::vector<const shading::Light*> lights;
  std::vector<LitRange> lit;       // of each light, of each ray
  std::vector<MediaSample> first;  // of the grid and the middles of its stretches
  MediaRefinement tree;            // first those of the grids
  std::vector<Question> questions;
  MediaIntervals dividing;
  // What is asked.
  Vec3 points[kMost];
  double distances[kMost];
  textures::RgbRow extinction, emission, scattering, source;
  MediaLanes lanes;
  std::size_t question[kMost];  // of each lane

  const Ray& ray(std::uint32_t interval) const { return stretches[intervals[interval].ray].ray; }
};

MediaRow::MediaRow(shading::Tracer& tracer, const shading::RayState& common,
                   std::span<const CompiledMedia* const> media, MediaEnvironment& environment)
    : tracer_(tracer), common_(common), mixture_(media), environment_(environment), room_([]() -> Room& {
        thread_local Room room;
        return room;
      }()) {}

bool MediaRow::possible() const {
  return mixture_.control->method == 3 && mixture_.control->jitter == 0.0 && (mixture_.scatters || mixture_.varies) &&
         !environment_.replay();
}

void MediaRow::integrate(std::span<const ContainerStretch> rays, MediaResult* results, bool* done) {
  divide(rays);
  look_along();
  refine();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Room::RayPart& part = room_.rays[i];
    done[i] = part.first != part.end && !part.lost;
    if (done[i]) results[i] = result(static_cast<std::uint32_t>(i));
  }
}

void MediaRow::divide(std::span<const ContainerStretch> rays) {
  const shading::SceneData& scene = tracer_.scene();
  room_.stretches = rays;
  room_.rays.clear(), room_.intervals.clear(), room_.lights.clear();
  std::vector<const scene::LightSource*> sources;
  for (std::size_t i = 0; i < scene.global_lights(); ++i) {  // intervals hang on them even where nothing scatters
    const shading::Light& light = scene.lights()[i];
    if (light.source().media_interaction && light.source().kind != scene::LightKind::shadowless)
      room_.lights.push_back(&light), sources.push_back(&light.source());
  }
  room_.lit.assign(sources.size() * rays.size(), LitRange{0, 1.0, -1.0});
  const std::size_t each = 2 * static_cast<std::size_t>(mixture_.stretches()) + 1;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ContainerStretch& s = rays[i];
    const auto first = static_cast<std::uint32_t>(room_.intervals.size());
    const bool own_lights = s.end && (s.end->ignore_global_lights || !s.end->group_lights.empty());
    if (s.length > 0.0 && !own_lights) {
      room_.dividing.look_for_lights(sources, s.ray, s.length);
      room_.dividing.divide(mixture_, s.length);
      if (room_.dividing.all().size() * each <= kMostPlaces) {
        for (const LitRange& range : room_.dividing.lit()) room_.lit[range.light * rays.size() + i] = range;
        for (const MediaInterval& span : room_.dividing.all())
          room_.intervals.push_back({span, static_cast<std::uint32_t>(i)});
      }
    }
    room_.rays.push_back({first, static_cast<std::uint32_t>(room_.intervals.size()), false});
  }
}

// The grids of all rays, place by place: shadow rays from the same place of neighbouring rays go side by side, those
// from one place of a ray to the next do not.
void MediaRow::look_along() {
  const int q = mixture_.stretches();
  const std::size_t each = 2 * static_cast<std::size_t>(q) + 1;
  const double step = 1.0 / (q + 1);
  room_.first.resize(room_.intervals.size() * each);
  std::array<Question, kMost> questions;
  std::array<std::size_t, kMost> sample;
  std::array<MediaSample, kMost> samples;
  std::size_t count = 0;
  const auto flush = [&] {
    ask(std::span(questions).first(count), samples.data());
    for (std::size_t k = 0; k < count; ++k) room_.first[sample[k]] = samples[k];
    count = 0;
  };
  for (std::size_t place = 0, any = 1; any != 0; ++place) {
    const std::size_t number = place % each;
    const double at =
        number % 2 == 0 ? static_cast<double>(number / 2) * step
                        : middle_of(static_cast<double>(number / 2) * step, static_cast<double>(number / 2 + 1) * step);
    any = 0;
    for (const Room::RayPart& ray : room_.rays) {
      const std::size_t interval = ray.first + place / each;
      if (interval >= ray.end || ray.lost) continue;
      ++any;
      questions[count] = {static_cast<std::uint32_t>(interval), at}, sample[count] = interval * each + number;
      if (++count == kMost) flush();
    }
  }
  if (count > 0) flush();
}

void MediaRow::refine() {
  const int q = mixture_.stretches(), level = mixture_.control->aa_level - 1;
  const double step = 1.0 / (q + 1);
  auto& all = room_.tree.stretches;
  all.clear();
  const MediaSample* s = room_.first.data();
  for (std::uint32_t i = 0; i < room_.intervals.size(); ++i, ++s)
    for (int k = 0; k < q; ++k, s += 2)
      all.push_back(room_.rays[room_.intervals[i].ray].lost
                        ? MediaRefinement::Stretch{}
                        : MediaRefinement::Stretch{k * step, (k + 1) * step, s[0], s[1], s[2], i});
  std::array<Question, kMost> questions;
  std::array<MediaSample, kMost> samples;
  std::size_t begin = 0;
  for (int depth = 0; depth < std::min(level, MediaRefinement::kMostLevels); ++depth) {
    begin = room_.tree.halve(begin, mixture_.aa_threshold);
    for (std::size_t i = begin; i < all.size(); i += kMost) {
      const std::size_t n = std::min(kMost, all.size() - i);
      for (std::size_t k = 0; k < n; ++k) questions[k] = {all[i + k].interval, all[i + k].middle()};
      ask(std::span(questions).first(n), samples.data());
      for (std::size_t k = 0; k < n; ++k) all[i + k].s2 = samples[k];
    }
  }
}

MediaSample MediaRow::refine_alone(std::uint32_t interval, const MediaSample& s1, double d1, const MediaSample& s3,
                                   double d3, int level) {
  const double d2 = middle_of(d1, d3);
  const Question question{interval, d2};
  MediaSample s2;
  ask({&question, 1}, &s2);
  return mean_of_stretch(
      s1, s2, s3, level, mixture_.aa_threshold, [&] { return refine_alone(interval, s1, d1, s2, d2, level - 1); },
      [&] { return refine_alone(interval, s2, d2, s3, d3, level - 1); });
}

MediaResult MediaRow::result(std::uint32_t ray) {
  const int q = mixture_.stretches(), level = mixture_.control->aa_level - 1;
  const Room::RayPart part = room_.rays[ray];
  Rgb emission, depth;
  for (std::uint32_t i = part.first; i < part.end; ++i) {
    const MediaSample s = mean_of_interval(q, [&](int k) {
      return room_.tree.mean(i * static_cast<std::size_t>(q) + static_cast<std::size_t>(k), level,
                             mixture_.aa_threshold,
                             [&](const auto& stretch, const MediaSample& s1, double d1, const MediaSample& s3,
                                 double d3, int left) { return refine_alone(stretch.interval, s1, d1, s3, d3, left); });
    });
    emission += s.source * transmitted(depth);
    depth += s.depth;
  }
  return {emission, transmitted(depth)};
}

// Spec 07 4.6: samples at these places.
void MediaRow::ask(std::span<const Question> questions, MediaSample* samples) {
  const std::size_t count = questions.size();
  textures::PointRow points;
  for (std::size_t i = 0; i < count; ++i) {
    const MediaInterval& span = room_.intervals[questions[i].interval].span;
    room_.distances[i] = span.start + questions[i].at * span.length;
    room_.points[i] = room_.ray(questions[i].interval).at(room_.distances[i]);
    if (mixture_.varies) points.set(static_cast<int>(i), room_.points[i]);
  }
  if (mixture_.varies) points.fill_up(static_cast<int>(count));
  clear(count, room_.extinction), clear(count, room_.emission), clear(count, room_.scattering),
      clear(count, room_.source);
  for (const CompiledMedia* m : mixture_.media) {
    textures::RgbRow density;
    if (m->varies) {
      if (!m->emits && !m->scatters && m->extinction == Rgb()) continue;
      media_densities(*m, static_cast<int>(count), points, density);
    } else {
      const Rgb constant = media_density(*m, room_.points[0]);
      for (std::size_t i = 0; i < count; ++i)
        density.r[i] = constant.r, density.g[i] = constant.g, density.b[i] = constant.b;
    }
    add(count, density, m->extinction, room_.extinction);
    if (m->emits) add(count, density, m->description->emission, room_.emission);
    if (m->scatters) add(count, density, m->description->scattering, room_.scattering);
  }
  if (mixture_.scatters) {
    for (std::size_t light = 0; light < room_.lights.size(); ++light) add_light(light, questions);
    for (std::size_t i = 0; i < count; ++i) {
      const Rgb scattering = at(room_.scattering, i);
      const NearbyPhotons near = scattering.max_abs() > 0.0f ? environment_.photons(room_.points[i]) : NearbyPhotons();
      if (near.photons.empty()) continue;
      Rgb sum = at(room_.source, i);
      near.add_scattered(mixture_, scattering, room_.ray(questions[i].interval).direction, sum);
      room_.source.r[i] = sum.r, room_.source.g[i] = sum.g, room_.source.b[i] = sum.b;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto s = static_cast<float>(room_.intervals[questions[i].interval].span.length);
    samples[i] = {(at(room_.emission, i) + at(room_.source, i)) * s, at(room_.extinction, i) * s};
  }
}

void MediaRow::add_light(std::size_t number, std::span<const Question> questions) {
  const shading::Light& light = *room_.lights[number];
  MediaLanes& lanes = room_.lanes;
  // Where it shines.
  const LitRange* const lit = room_.lit.data() + number * room_.rays.size();
  int count = 0;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Room::Interval& interval = room_.intervals[questions[i].interval];
    const LitRange& range = lit[interval.ray];
    const Rgb scattering = at(room_.scattering, i);
    if (!interval.span.lit || room_.distances[i] < range.first || room_.distances[i] > range.last ||
        scattering.max_abs() <= 0.0f || room_.rays[interval.ray].lost)
      continue;
    lanes.to_light.origin.set(count, room_.points[i]);
    lanes.view.set(count, room_.ray(questions[i].interval).direction);
    lanes.scattering.set(count, scattering);
    room_.question[count++] = i;
  }
  if (count == 0) return;
  shading::aim_at(light, count, lanes.to_light, lanes.distance);
  // What arrives: nothing is asked where that is dark.
  float attenuation[MediaLanes::kSize];
  if (const auto falloff = light.attenuates() ? shading::LightFalloff::of(light) : std::nullopt) {
    falloff->attenuate(lanes.to_light.direction, lanes.distance, count, attenuation);
  } else {
    for (int k = 0; k < count; ++k)
      attenuation[k] = static_cast<float>(
          light.attenuation(lanes.to_light.origin.at(k), {lanes.to_light.direction.at(k), lanes.distance[k]}));
  }
  int bright = 0;
  for (int k = 0; k < count; ++k) {
    const Rgb color = light.color() * attenuation[k];
    if (color.max_abs() < kDark) continue;
    lanes.arriving.set(bright, color);
    if (bright != k) {
      lanes.to_light.origin.set(bright, lanes.to_light.origin.at(k)),
          lanes.to_light.direction.set(bright, lanes.to_light.direction.at(k));
      lanes.view.set(bright, lanes.view.at(k)), lanes.scattering.set(bright, lanes.scattering.at(k));
      lanes.distance[bright] = lanes.distance[k], room_.question[bright] = room_.question[k];
    }
    ++bright;
  }
  if (bright == 0) return;
  shading::LightWays ways;
  tracer_.look_for_light(light, common_, lanes.to_light, lanes.distance, bright, ways.data());
  for (int k = 0; k < bright; ++k) {
    if (ways[static_cast<std::size_t>(k)] == LightWay::blocked) lanes.arriving.set(k, Rgb());
    if (ways[static_cast<std::size_t>(k)] == LightWay::unknown)
      lanes.arriving.set(
          k, light_alone(light, k, room_.intervals[questions[room_.question[k]].interval].ray, lanes.arriving.at(k)));
  }
  mixture_.scatter(bright, lanes);
  for (int k = 0; k < bright; ++k) {
    if (!(lanes.arriving.at(k).max_abs() > 0.0f)) continue;
    const std::size_t i = room_.question[k];
    room_.source.r[i] += lanes.scattered.r[k], room_.source.g[i] += lanes.scattered.g[k],
        room_.source.b[i] += lanes.scattered.b[k];
  }
}

// Where surfaces or volumes may filter the light. If that draws numbers, their order matters, and the ray has to go
// alone from its start to its end.
Rgb MediaRow::light_alone(const shading::Light& light, int lane, std::uint32_t ray, const Rgb& color) {
  if (room_.rays[ray].lost) return {};
  tracer_.random().begin(room_.stretches[ray].key);
  shading::RayState state = common_;
  state.ray = room_.stretches[ray].ray;
  const Rgb arriving =
      tracer_.shadowed(light, room_.lanes.to_light.origin.at(lane),
                       {room_.lanes.to_light.direction.at(lane), room_.lanes.distance[lane]}, state, nullptr, color);
  room_.rays[ray].lost = tracer_.random().drawn();
  return arriving;
}

}  // namespace verisim::global
