#include "tracer/global/media.h"

#include <algorithm>
#include <array>

#include <boost/container/small_vector.hpp>

#include "tracer/math/chi_square.h"

namespace verisim::global {
namespace {

constexpr int kMaxIntervals = 256;  // POV-Ray stops the render beyond
constexpr int kMaxLights = 256;
constexpr int kMostSpans = kMaxIntervals + 2 * kMaxLights + 1;  // one more by rounding for every piece

struct Interval {
  double start, length;
  bool lit;  // lights are looked at only in lit pieces
};

// The result of one sample: source radiance and optical depth, both times the interval's length.
struct Sample {
  Rgb source, depth;
};
Sample operator+(const Sample& a, const Sample& b) { return {a.source + b.source, a.depth + b.depth}; }
Sample operator*(const Sample& a, float s) { return {a.source * s, a.depth * s}; }

Rgb exponential(const Rgb& optical_depth) {
  if (optical_depth == Rgb()) return Rgb(1.0f);
  return {std::exp(-optical_depth.r), std::exp(-optical_depth.g), std::exp(-optical_depth.b)};
}

float difference(const Rgb& a, const Rgb& b) { return std::fabs(a.r - b.r) + std::fabs(a.g - b.g) + std::fabs(a.b - b.b); }

class Integrator {
 public:
  Integrator(std::span<const CompiledMedia* const> media, const Ray& ray, double length, bool shadow, MediaEnvironment& environment)
      : media_(media), ray_(ray), length_(length), shadow_(shadow), environment_(environment) {
    control_ = media[0]->description;
    aa_threshold_ = control_->aa_threshold;
    for (const CompiledMedia* m : media) {
      if (m->description->intervals > control_->intervals) control_ = m->description;
      aa_threshold_ = std::min(aa_threshold_, m->description->aa_threshold);
      scatters_ |= m->scatters;
      isotropic_ &= !m->scatters || phase_is_constant(*m->description);
      has_density_ |= !m->densities.empty();
      varies_ |= m->varies;
      constant_shadow_ &= m->last_density_plain;
    }
    if (!shadow_) collect_lights();
  }

  int foreseen_places(int most, double* places) {
    if (control_->method != 3 || control_->jitter != 0.0 || !scatters_ || varies_) return 0;
    divide();
    const int q = stretches(), each = 2 * q + 1;
    if (intervals_ > most / each) return 0;
    const double step = 1.0 / (q + 1);
    for (int i = 0; i < intervals_; ++i) {
      const Interval& span = spans_[static_cast<std::size_t>(i)];
      const auto set = [&](int number, double at) { places[i * each + number] = span.lit ? span.start + at * span.length : -1; };
      set(0, 0.0);
      for (int k = 1; k <= q; ++k) set(2 * k - 1, middle((k - 1) * step, k * step)), set(2 * k, k * step);
    }
    return intervals_ * each;
  }

  MediaResult run() {
    divide();
    Rgb emission, depth;
    const auto combine = [&](const Sample& s) {
      emission += s.source * exponential(depth);
      depth += s.depth;
    };
    if (!shadow_ && control_->method != 3 && control_->samples_max > control_->samples_min) {
      // All intervals take their first samples before any takes extra ones.
      boost::container::small_vector<Samples, 16> taken(static_cast<std::size_t>(intervals_));
      for (std::size_t i = 0; i < taken.size(); ++i) take_first(spans_[i], taken[i]);
      for (std::size_t i = 0; i < taken.size(); ++i) take_extra(spans_[i], taken[i]);
      for (const Samples& s : taken) combine(s.mean());
    } else {
      for (int i = 0; i < intervals_; ++i) combine(interval(spans_[static_cast<std::size_t>(i)]));
    }
    return {emission, exponential(depth)};
  }

 private:
  struct LitLight {
    std::size_t index;
    double first, last;
  };

  void collect_lights() {
    const auto lights = environment_.lights();
    for (std::size_t i = 0; i < lights.size() && lit_count_ < kMaxLights; ++i) {
      double first, last;
      if (lit_range(*lights[i], ray_, length_, first, last)) lit_[lit_count_++] = {i, first, last};
    }
  }

  void push(double start, double end, bool lit, int count) {
    // Where the end of the last interval is rounded to below the piece's, another one of hardly any length follows. It draws numbers, in POV-Ray as well, but
    // lights are not looked at in it.
    const double step = (end - start) / count;
    int n = 0;
    for (double s = start; s < end && n <= count && intervals_ < kMostSpans; s = start + ++n * step) spans_[intervals_++] = {s, n < count ? step : end - s, lit && n < count};
  }

  // Spec 07 4.5: the union of all lit ranges cuts the segment; the pieces share the intervals by `ratio`.
  void divide() {
    struct Piece {
      double start, end;
      bool lit;
    };
    std::array<Piece, 2 * kMaxLights + 1> pieces;
    int count = 0;
    if (lit_count_ == 0) {
      pieces[count++] = {0.0, length_, false};
    } else {
      std::array<std::pair<double, double>, kMaxLights> ranges;
      for (int i = 0; i < lit_count_; ++i) ranges[i] = {lit_[i].first, lit_[i].last};
      std::sort(ranges.begin(), ranges.begin() + lit_count_);
      double position = 0.0;
      for (int i = 0; i < lit_count_;) {
        const double start = ranges[i].first;
        double end = ranges[i].second;
        for (++i; i < lit_count_ && ranges[i].first <= end; ++i) end = std::max(end, ranges[i].second);
        if (start > position) pieces[count++] = {position, start, false};
        pieces[count++] = {start, end, true};
        position = end;
      }
      if (position < length_) pieces[count++] = {position, length_, false};
    }
    const int wanted = std::min(std::max(control_->intervals, count), kMaxIntervals);
    if (count == 1) {
      push(0.0, length_, pieces[0].lit, !pieces[0].lit && !has_density_ ? 1 : wanted);
      return;
    }
    double total = 0.0;
    const auto weight = [&](const Piece& p) { return p.lit ? control_->ratio : 1.0 - control_->ratio; };
    for (int i = 0; i < count; ++i) total += weight(pieces[i]);
    int remaining = wanted;
    for (int i = 0; i < count; ++i) {
      const int n = std::max(1, std::min(static_cast<int>(weight(pieces[i]) / total * wanted) + 1, remaining - count + i + 1));
      push(pieces[i].start, pieces[i].end, pieces[i].lit, n);
      remaining -= n;
    }
  }

  // Spec 07 4.6: one sample at fraction `at` of an interval; `inner_attenuation`: methods 1 and 2 attenuate inside the interval. `place`: if foreseen.
  Sample sample(const Interval& span, double at, bool inner_attenuation, int place = -1) {
    const double distance = span.start + at * span.length;
    const Vec3 p = ray_.at(distance);
    Rgb extinction, emission, scattering;
    for (const CompiledMedia* m : media_) {
      const Rgb d = media_density(*m, p);
      extinction += d * m->extinction;
      if (shadow_) continue;
      if (m->emits) emission += d * m->description->emission;
      if (m->scatters) scattering += d * m->description->scattering;
    }
    const float s = static_cast<float>(span.length);
    Sample result{Rgb(), extinction * s};
    if (shadow_) return result;
    result.source = (emission + scattered(p, distance, scattering, span.lit, place)) * s;
    if (inner_attenuation) result.source *= exponential(extinction * static_cast<float>(at * span.length));
    return result;
  }

  // Mean phase over all media of the segment, also those without scattering (isotropic).
  float mean_phase(const Vec3& to_light) const {
    const double cosine = dot(to_light, ray_.direction);
    double sum = 0.0;
    for (const CompiledMedia* m : media_) sum += m->scatters ? phase(*m->description, cosine) : 1.0;
    return static_cast<float>(sum / static_cast<double>(media_.size()));
  }

  // Photons are found everywhere, lights only in lit pieces.
  Rgb scattered(const Vec3& p, double distance, const Rgb& scattering, bool lit, int place) {
    Rgb sum;
    if (!scatters_ || (scattering.max_abs() <= 0.0f && !environment_.replay())) return sum;
    for (int i = 0; lit && i < lit_count_; ++i) {
      const LitLight& light = lit_[i];
      if (distance < light.first || distance > light.last) continue;
      Vec3 to_light;
      const Rgb arriving = environment_.illumination(light.index, p, to_light, place);
      if (arriving.max_abs() > 0.0f) sum += scattering * arriving * mean_phase(to_light);
    }
    const MediaEnvironment::NearbyPhotons near = environment_.photons(p);
    if (isotropic_) {
      for (const Photon* photon : near.photons) sum += scattering * (photon->color() * near.share);
    } else {
      for (const Photon* photon : near.photons) sum += scattering * (photon->color() * near.share) * mean_phase(photon->direction());
    }
    return sum;
  }

  Sample interval(const Interval& span) {
    if (shadow_ && constant_shadow_) return single(span);
    return control_->method == 3 ? adaptive(span) : uniform(span);
  }

  // Shadow rays take one sample of what POV-Ray believes to be constant.
  Sample single(const Interval& span) {
    const bool middle = control_->method == 2;
    const double draw = environment_.random();  // drawn even where the place does not matter
    const double at = middle ? 0.5 / control_->samples_min + draw * control_->jitter / control_->samples_min : draw;
    return sample(span, at, false);
  }

  // Samples of one interval under methods 1 and 2.
  struct Samples {
    Sample sum;
    Rgb squares;
    int n = 0;
    Sample mean() const { return sum * (1.0f / static_cast<float>(n)); }
  };
  void take(const Interval& span, double at, Samples& to) {
    const Sample s = sample(span, at, true);
    to.sum = to.sum + s, to.squares += s.source * s.source, ++to.n;
  }
  void take_first(const Interval& span, Samples& to) {
    const int minimum = control_->samples_min;
    for (int j = 0; j < minimum; ++j) {
      const double draw = environment_.random();
      take(span, control_->method == 1 ? draw : (j + 0.5) / minimum + draw * control_->jitter / minimum, to);
    }
  }
  void take_extra(const Interval& span, Samples& to) {
    const int maximum = control_->samples_max;
    const double top = chi_square_quantile(maximum - 1, control_->confidence);
    while (to.n <= maximum) {
      const double threshold = control_->variance * chi_square_quantile(to.n, control_->confidence) / top;
      const float inverse = 1.0f / static_cast<float>(to.n);
      const Rgb mean = to.sum.source * inverse;
      const Rgb variance = (to.squares * inverse - mean * mean) * inverse;
      if (variance.r < threshold && variance.g < threshold && variance.b < threshold) break;
      take(span, environment_.random(), to);
    }
  }
  Sample uniform(const Interval& span) {
    Samples samples;
    take_first(span, samples);
    return samples.mean();
  }

  double jittered(double at, double step) { return control_->jitter != 0.0 ? at + control_->jitter * step * (environment_.random() - 0.5) : at; }

  // d1 .. d3: places on the grid; only where samples are taken is jittered.
  Sample refine(const Interval& span, const Sample& s1, double d1, const Sample& s3, double d3, int level, int place = -1) {
    const double d2 = middle(d1, d3);
    const Sample s2 = sample(span, jittered(d2, d3 - d1), false, place);
    return weighted(s1, s2, s3, level, [&] { return refine(span, s1, d1, s2, d2, level - 1); }, [&] { return refine(span, s2, d2, s3, d3, level - 1); });
  }
  // The mean over a stretch with a sample at either end and in the middle; left() and right(): those over its halves, where the brightness changes.
  template <class Left, class Right>
  Sample weighted(const Sample& s1, const Sample& s2, const Sample& s3, int level, Left&& left, Right&& right) const {
    if (level <= 0) return (s1 + s2 + s3) * (1.0f / 3.0f);
    const Sample before = difference(s1.source, s2.source) > aa_threshold_ ? left() * 0.5f : s1 * (1.0f / 3.0f) + s2 * (1.0f / 6.0f);
    const Sample behind = difference(s2.source, s3.source) > aa_threshold_ ? right() * 0.5f : s2 * (1.0f / 6.0f) + s3 * (1.0f / 3.0f);
    return before + behind;
  }

  int stretches() const { return std::max(2, control_->samples_min / 2 + 1); }
  static double middle(double d1, double d3) { return 0.5 * (d1 + d3); }

  // Method 3: q sub-intervals on a grid of step 1 / (q + 1), refined where the brightness changes; a left Riemann rule for attenuation.
  Sample adaptive(const Interval& span) {
    const int q = stretches();
    const double step = 1.0 / (q + 1);
    const float share = 1.0f / static_cast<float>(q);
    Sample result;
    Rgb before;
    const auto add = [&](const Sample& part) {
      result.source += part.source * exponential(before * share) * share;
      before += part.depth;
    };
    const int level = control_->aa_level - 1;
    if (foreseeable()) {
      for (int k = 0; k < q; k += kMostStretches) {
        const Stretches stretches = refine_together(span, k, std::min(q - k, kMostStretches), step, level);
        for (int i = 0; i < kMostStretches && k + i < q; ++i) add(mean(span, stretches, i, level));
      }
    } else {
      const int first = static_cast<int>(&span - spans_.data()) * (2 * q + 1);  // as foreseen_places() counts
      Sample s1 = sample(span, jittered(0.0, step), false, first);
      for (int k = 1; k <= q; ++k) {
        const Sample s3 = sample(span, jittered(k * step, step), false, first + 2 * k);
        add(refine(span, s1, (k - 1) * step, s3, k * step, level, first + 2 * k - 1));
        s1 = s3;
      }
    }
    result.depth = before * share;
    return result;
  }

  // Whether samples neither draw numbers nor look at lights, so that they may be taken in any order; and densities gain from being asked for together.
  bool foreseeable() const { return varies_ && control_->jitter == 0.0 && (shadow_ || !scatters_); }

  // What refine() does with one stretch, taken level by level; behind a few levels it goes on alone.
  struct Stretch {
    double d1, d3;
    Sample s1, s2, s3;
    int left = -1, right = -1;  // refined
    double middle() const { return Integrator::middle(d1, d3); }
  };
  using Stretches = boost::container::small_vector<Stretch, 64>;
  static constexpr int kMostStretches = (textures::PointRow::kMost - 1) / 2, kLevelsTogether = 5;

  // Stretches first + 1 .. first + count of the grid.
  Stretches refine_together(const Interval& span, int first, int count, double step, int level) const {
    std::array<double, textures::PointRow::kMost> at;
    std::array<Sample, textures::PointRow::kMost> samples;
    Stretches all;
    for (int i = 0; i < count; ++i) all.push_back({(first + i) * step, (first + i + 1) * step, {}, {}, {}});
    // Both ends and the middle are wanted anyway.
    for (int i = 0; i < count; ++i) at[2 * i] = all[i].d1, at[2 * i + 1] = all[i].middle();
    at[2 * count] = all[count - 1].d3;
    sample_row(span, 2 * count + 1, at.data(), samples.data());
    for (int i = 0; i < count; ++i) all[i].s1 = samples[2 * i], all[i].s2 = samples[2 * i + 1], all[i].s3 = samples[2 * i + 2];
    for (std::size_t begin = 0, depth = 0; level > 0 && depth < kLevelsTogether; --level, ++depth) {
      const std::size_t end = all.size();
      for (; begin < end; ++begin) {
        const Stretch s = all[begin];
        if (difference(s.s1.source, s.s2.source) > aa_threshold_) {
          all[begin].left = static_cast<int>(all.size());
          all.push_back({s.d1, s.middle(), s.s1, {}, s.s2});
        }
        if (difference(s.s2.source, s.s3.source) > aa_threshold_) {
          all[begin].right = static_cast<int>(all.size());
          all.push_back({s.middle(), s.d3, s.s2, {}, s.s3});
        }
      }
      for (std::size_t i = end; i < all.size(); i += at.size()) {
        const std::size_t n = std::min(at.size(), all.size() - i);
        for (std::size_t k = 0; k < n; ++k) at[k] = all[i + k].middle();
        sample_row(span, static_cast<int>(n), at.data(), samples.data());
        for (std::size_t k = 0; k < n; ++k) all[i + k].s2 = samples[k];
      }
    }
    return all;
  }
  Sample mean(const Interval& span, const Stretches& all, int number, int level) {
    const Stretch& s = all[static_cast<std::size_t>(number)];
    return weighted(s.s1, s.s2, s.s3, level,
                    [&] { return s.left >= 0 ? mean(span, all, s.left, level - 1) : refine(span, s.s1, s.d1, s.s2, s.middle(), level - 1); },
                    [&] { return s.right >= 0 ? mean(span, all, s.right, level - 1) : refine(span, s.s2, s.middle(), s.s3, s.d3, level - 1); });
  }

  // sample(), at many places of an interval, without lights.
  void sample_row(const Interval& span, int count, const double* at, Sample* samples) const {
    textures::PointRow points;
    for (int i = 0; i < count; ++i) points.set(i, ray_.at(span.start + at[i] * span.length));
    points.fill_up(count);
    textures::RgbRow density, source, depth;
    clear(count, source), clear(count, depth);
    for (const CompiledMedia* m : media_) {
      const bool shines = !shadow_ && m->emits, dims = m->extinction != Rgb();
      if (!shines && !dims) continue;
      media_densities(*m, count, points, density);
      if (dims) add(count, density, m->extinction, depth);
      if (shines) add(count, density, m->description->emission, source);
    }
    const float s = static_cast<float>(span.length);
    for (int i = 0; i < count; ++i) samples[i] = {Rgb(source.r[i], source.g[i], source.b[i]) * s, Rgb(depth.r[i], depth.g[i], depth.b[i]) * s};
  }
  static void clear(int count, textures::RgbRow& row) {
    for (float* channel : {row.r, row.g, row.b}) std::fill_n(channel, count, 0.0f);
  }
  static void add(int count, const textures::RgbRow& density, const Rgb& color, textures::RgbRow& to) {
    for (int i = 0; i < count; ++i) to.r[i] += density.r[i] * color.r, to.g[i] += density.g[i] * color.g, to.b[i] += density.b[i] * color.b;
  }

  std::span<const CompiledMedia* const> media_;
  Ray ray_;
  double length_;
  bool shadow_;
  MediaEnvironment& environment_;
  const scene::Media* control_;
  double aa_threshold_;
  bool scatters_ = false, isotropic_ = true, has_density_ = false, varies_ = false, constant_shadow_ = true;
  int lit_count_ = 0, intervals_ = 0;
  std::array<LitLight, kMaxLights> lit_;
  std::array<Interval, kMostSpans> spans_;
};

}  // namespace

MediaResult integrate(std::span<const CompiledMedia* const> media, const Ray& ray, double length, bool shadow, MediaEnvironment& environment) {
  if (media.empty() || !(length > 0.0)) return {};
  // Shadow rays pass what takes no light away without drawing a number.
  if (shadow && std::none_of(media.begin(), media.end(), [](const CompiledMedia* m) { return m->scatters || m->extinction != Rgb(); })) return {};
  return Integrator(media, ray, length, shadow, environment).run();
}

int foreseen_places(std::span<const CompiledMedia* const> media, const Ray& ray, double length, MediaEnvironment& environment, int most, double* places) {
  if (media.empty() || !(length > 0.0)) return 0;
  return Integrator(media, ray, length, false, environment).foreseen_places(most, places);
}

}  // namespace verisim::global
