#include "tracer/media/media.h"

#include <algorithm>
#include <array>

#include <boost/container/small_vector.hpp>

#include "tracer/media/media_mixture.h"
#include "tracer/media/media_refinement.h"
#include "tracer/math/chi_square.h"
#include "tracer/math/scaled.h"

namespace verisim::global {
namespace {

class Integrator {
 public:
  Integrator(std::span<const CompiledMedia* const> media, const Ray& ray, double length, bool shadow,
             MediaEnvironment& environment)
      : mixture_(media),
        control_(mixture_.control),
        ray_(ray),
        length_(length),
        shadow_(shadow),
        environment_(environment) {
    if (!shadow_) intervals_.look_for_lights(environment_.lights(), ray_, length_);
  }

  MediaResult run() {
    intervals_.divide(mixture_, length_);
    const std::span<const MediaInterval> spans = intervals_.all();
    Rgb emission, depth;
    const auto combine = [&](const MediaSample& s) {
      emission += s.source * transmitted(depth);
      depth += s.depth;
    };
    if (!shadow_ && control_->method != 3 && control_->samples_max > control_->samples_min) {
      // All intervals take their first samples before any takes extra ones.
      boost::container::small_vector<Samples, 16> taken(spans.size());
      for (std::size_t i = 0; i < taken.size(); ++i) take_first(spans[i], taken[i]);
      for (std::size_t i = 0; i < taken.size(); ++i) take_extra(spans[i], taken[i]);
      for (const Samples& s : taken) combine(s.mean());
    } else {
      for (const MediaInterval& span : spans) combine(interval(span));
    }
    return {emission, transmitted(depth)};
  }

 private:
  // Spec 07 4.6: one sample at fraction `at` of an interval; `inner_attenuation`: methods 1 and 2 attenuate inside the
  // interval.
  MediaSample sample(const MediaInterval& span, double at, bool inner_attenuation) {
    const double distance = span.start + at * span.length;
    const Vec3 p = ray_.at(distance);
    Rgb extinction, source, scattering;
    for (const CompiledMedia* m : mixture_.media) {
      const Rgb d = media_density(*m, p);
      extinction += d * m->extinction;
      if (shadow_) continue;
      if (m->emits) source += d * m->description->emission;
      if (m->scatters) scattering += d * m->description->scattering;
    }
    const Rgb depth = scaled(extinction, span.length);
    if (shadow_) return {Rgb(), depth};
    add_scattered(p, distance, scattering, span.lit, source);
    if (!inner_attenuation) return {scaled(source, span.length), depth};
    return {source * scaled(transmitted(scaled(extinction, at * span.length)), span.length), depth};
  }

  // Photons are found everywhere, lights only in lit pieces.
  void add_scattered(const Vec3& p, double distance, const Rgb& scattering, bool lit, Rgb& sum) {
    if (!mixture_.scatters || (scattering.max_abs() <= 0.0f && !environment_.replay())) return;
    for (const LitRange& light : intervals_.lit()) {
      if (!lit || distance < light.first || distance > light.last) continue;
      Vec3 to_light;
      const Rgb arriving = environment_.illumination(light.light, p, to_light);
      if (arriving.max_abs() > 0.0f)
        sum += scaled(scattering, mixture_.mean_phase(dot(to_light, ray_.direction))) * arriving;
    }
    environment_.photons(p).add_scattered(mixture_, scattering, ray_.direction, sum);
  }

  MediaSample interval(const MediaInterval& span) {
    if (shadow_ && mixture_.constant_shadow) return single(span);
    return control_->method == 3 ? adaptive(span) : uniform(span);
  }

  // Shadow rays take one sample of what POV-Ray believes to be constant.
  MediaSample single(const MediaInterval& span) {
    const bool middle = control_->method == 2;
    const double draw = environment_.random();  // drawn even where the place does not matter
    const double at = middle ? 0.5 / control_->samples_min + draw * control_->jitter / control_->samples_min : draw;
    return sample(span, at, false);
  }

  // Samples of one interval under methods 1 and 2.
  struct Samples {
    MediaSample sum;
    Rgb squares;
    int n = 0;
    MediaSample mean() const { return sum / static_cast<float>(n); }
  };
  void take(const MediaInterval& span, double at, Samples& to) {
    const MediaSample s = sample(span, at, true);
    to.sum = to.sum + s, to.squares += s.source * s.source, ++to.n;
  }
  void take_first(const MediaInterval& span, Samples& to) {
    const int minimum = control_->samples_min;
    for (int j = 0; j < minimum; ++j) {
      const double draw = environment_.random();
      take(span, control_->method == 1 ? draw : (j + 0.5) / minimum + draw * control_->jitter / minimum, to);
    }
  }
  void take_extra(const MediaInterval& span, Samples& to) {
    const int maximum = control_->samples_max;
    const double top = chi_square_quantile(maximum - 1, control_->confidence);
    while (to.n <= maximum) {
      const double threshold = control_->variance * chi_square_quantile(to.n, control_->confidence) / top;
      const auto n = static_cast<float>(to.n);
      const Rgb mean = to.sum.source / n;
      const Rgb variance = (to.squares / n - mean * mean) / n;
      if (variance.r < threshold && variance.g < threshold && variance.b < threshold) break;
      take(span, environment_.random(), to);
    }
  }
  MediaSample uniform(const MediaInterval& span) {
    Samples samples;
    take_first(span, samples);
    return samples.mean();
  }

  double jittered(double at, double step) {
    // POV-Ray draws a number even where the place does not hang on it.
    if (control_->jitter == 0.0 && !environment_.replay()) return at;
    return at + control_->jitter * step * (environment_.random() - 0.5);
  }

  // d1 .. d3: places on the grid; only where samples are taken is jittered.
  MediaSample refine(const MediaInterval& span, const MediaSample& s1, double d1, const MediaSample& s3, double d3,
                     int level) {
    const double d2 = middle_of(d1, d3);
    const MediaSample s2 = sample(span, jittered(d2, d3 - d1), false);
    return mean_of_interval(
        s1, s2, s3, level, mixture_.aa_threshold, [&] { return refine(span, s1, d1, s2, d2, level - 1); },
        [&] { return refine(span, s2, d2, s3, d3, level - 1); });
  }

  MediaSample adaptive(const MediaInterval& span) {
    const int q = mixture_.subintervals(), level = mixture_.halvings();
    const double step = 1.0 / (q + 1);
    if (foreseeable()) {
      thread_local MediaRefinement batch;
      return mean_of_interval(q, [&](int k) {
        const int place = k % kMaxIntervals;
        if (place == 0) refine_together(span, k, std::min(q - k, kMaxIntervals), step, level, batch);
        return batch.mean(static_cast<std::size_t>(place), level, mixture_.aa_threshold,
                          [&](const auto&, const MediaSample& s1, double d1, const MediaSample& s3, double d3,
                              int left) { return refine(span, s1, d1, s3, d3, left); });
      });
    }
    MediaSample s1 = sample(span, jittered(0.0, step), false);
    return mean_of_interval(q, [&](int k) {
      const MediaSample s3 = sample(span, jittered((k + 1) * step, step), false);
      const MediaSample mean = refine(span, s1, k * step, s3, (k + 1) * step, level);
      s1 = s3;
      return mean;
    });
  }

  // Whether samples neither draw numbers nor look at lights, so that they may be taken in any order; and densities gain
  // from being asked for together.
  bool foreseeable() const {
    return mixture_.varies && control_->jitter == 0.0 && (shadow_ || !mixture_.scatters) && !environment_.replay();
  }

  static constexpr int kMaxIntervals = (textures::PointBatch::kMax - 1) / 2;

  // Intervals first + 1 .. first + count of the grid.
  void refine_together(const MediaInterval& span, int first, int count, double step, int level,
                       MediaRefinement& batch) const {
    std::array<double, textures::PointBatch::kMax> at;
    std::array<MediaSample, textures::PointBatch::kMax> samples;
    auto& all = batch.subintervals;
    all.clear();
    for (int i = 0; i < count; ++i) all.push_back({(first + i) * step, (first + i + 1) * step, {}, {}, {}, 0});
    // Both ends and the middle are wanted anyway.
    for (std::size_t i = 0; i < all.size(); ++i) at[2 * i] = all[i].d1, at[2 * i + 1] = all[i].middle();
    at[2 * all.size()] = all.back().d3;
    sample_batch(span, 2 * count + 1, at.data(), samples.data());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].s1 = samples[2 * i], all[i].s2 = samples[2 * i + 1], all[i].s3 = samples[2 * i + 2];
    std::size_t begin = 0;
    for (int depth = 0; depth < std::min(level, MediaRefinement::kMaxLevels); ++depth) {
      begin = batch.halve(begin, mixture_.aa_threshold);
      for (std::size_t i = begin; i < all.size(); i += at.size()) {
        const std::size_t n = std::min(at.size(), all.size() - i);
        for (std::size_t k = 0; k < n; ++k) at[k] = all[i + k].middle();
        sample_batch(span, static_cast<int>(n), at.data(), samples.data());
        for (std::size_t k = 0; k < n; ++k) all[i + k].s2 = samples[k];
      }
    }
  }

  // sample(), at many places of an interval, without lights.
  void sample_batch(const MediaInterval& span, int count, const double* at, MediaSample* samples) const {
    textures::PointBatch points;
    for (int i = 0; i < count; ++i) points.set(i, ray_.at(span.start + at[i] * span.length));
    points.fill_up(count);
    textures::RgbBatch density, source, depth;
    clear(count, source), clear(count, depth);
    for (const CompiledMedia* m : mixture_.media) {
      const bool shines = !shadow_ && m->emits, dims = m->extinction != Rgb();
      if (!shines && !dims) continue;
      media_densities(*m, count, points, density);
      if (dims) add(count, density, m->extinction, depth);
      if (shines) add(count, density, m->description->emission, source);
    }
    for (int i = 0; i < count; ++i)
      samples[i] = {scaled(Rgb(source.r[i], source.g[i], source.b[i]), span.length),
                    scaled(Rgb(depth.r[i], depth.g[i], depth.b[i]), span.length)};
  }
  static void clear(int count, textures::RgbBatch& batch) {
    for (float* channel : {batch.r, batch.g, batch.b}) std::fill_n(channel, count, 0.0f);
  }
  static void add(int count, const textures::RgbBatch& density, const Rgb& color, textures::RgbBatch& to) {
    for (int i = 0; i < count; ++i)
      to.r[i] += density.r[i] * color.r, to.g[i] += density.g[i] * color.g, to.b[i] += density.b[i] * color.b;
  }

  MediaMixture mixture_;
  const scene::Media* control_;
  Ray ray_;
  double length_;
  bool shadow_;
  MediaEnvironment& environment_;
  MediaIntervals intervals_;
};

}  // namespace

MediaResult integrate(std::span<const CompiledMedia* const> media, const Ray& ray, double length, bool shadow,
                      MediaEnvironment& environment) {
  if (media.empty() || !(length > 0.0)) return {};
  // Shadow rays pass what takes no light away without drawing a number.
  if (shadow && std::none_of(media.begin(), media.end(),
                             [](const CompiledMedia* m) { return m->scatters || m->extinction != Rgb(); }))
    return {};
  return Integrator(media, ray, length, shadow, environment).run();
}

}  // namespace verisim::global
