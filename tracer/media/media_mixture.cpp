#include "tracer/media/media_mixture.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace verisim::global {

MediaMixture::MediaMixture(std::span<const CompiledMedia* const> list)
    : media(list), control(list[0]->description), aa_threshold(control->aa_threshold) {
  for (const CompiledMedia* m : media) {
    if (m->description->intervals > control->intervals) control = m->description;
    aa_threshold = std::min(aa_threshold, m->description->aa_threshold);
    scatters |= m->scatters;
    isotropic &= !m->scatters || phase_is_constant(*m->description);
    has_density |= !m->densities.empty();
    varies |= m->varies;
    constant_shadow &= m->last_density_plain;
  }
}

double MediaMixture::mean_phase(double cosine) const {
  double sum = 0.0;
  for (const CompiledMedia* m : media) sum += m->scatters ? phase(*m->description, cosine) : 1.0;
  return sum / static_cast<double>(media.size());
}

void MediaMixture::scatter(int count, MediaPacket& packet) const {
  static const MediaKernels& kernels = media_kernels();
  static const scene::Media isotropic_media{};
  std::fill_n(packet.phase, count, 0.0);
  for (const CompiledMedia* m : media)
    kernels.add_phase(m->scatters ? *m->description : isotropic_media, count, packet);
  kernels.scatter(static_cast<int>(media.size()), count, packet);
}

namespace {

using FourFloats = float __attribute__((vector_size(16)));

// In three channels; in the fourth is the exponent.
FourFloats mantissas(const Photon& photon) {
#if defined(__SSE2__)
  const __m128i bytes = _mm_cvtsi32_si128(std::bit_cast<std::int32_t>(photon.energy)), zero = _mm_setzero_si128();
  return (FourFloats)_mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_unpacklo_epi8(bytes, zero), zero));
#else
  return FourFloats{static_cast<float>(photon.energy[0]), static_cast<float>(photon.energy[1]),
                    static_cast<float>(photon.energy[2])};
#endif
}

// Adds scattering * (colour * share) of each, three channels at a time; the fourth is of no use.
void add_colors(const SomePhotons& photons, float share, const Rgb& scattering, Rgb& sum) {
  const FourFloats factor{scattering.r, scattering.g, scattering.b};
  FourFloats total{sum.r, sum.g, sum.b};
  for (std::size_t i = 0; i < photons.size(); ++i) {
    const Photon& photon = photons[i];
    total += factor * (mantissas(photon) * photon.scale() * share);
  }
  sum = {total[0], total[1], total[2]};
}

}  // namespace

void NearbyPhotons::add_scattered(const MediaMixture& mixture, const Rgb& scattering, const Vec3& view,
                                  Rgb& sum) const {
  if (mixture.isotropic) {
    add_colors(photons, share, scattering, sum);
    return;
  }
  MediaPacket packet;
  for (std::size_t first = 0; first < photons.size(); first += MediaPacket::kMax) {
    const int count = static_cast<int>(std::min<std::size_t>(MediaPacket::kMax, photons.size() - first));
    for (int i = 0; i < count; ++i) {
      const Photon& photon = photons[first + static_cast<std::size_t>(i)];
      packet.to_light.direction.set(i, photon.direction()), packet.view.set(i, view);
      packet.scattering.set(i, scattering), packet.arriving.set(i, photon.color() * share);
    }
    mixture.scatter(count, packet);
    for (int i = 0; i < count; ++i) sum += packet.scattered.at(i);
  }
}

void MediaIntervals::look_for_lights(std::span<const scene::LightSource* const> lights, const Ray& ray, double length) {
  lit_count_ = 0;
  for (std::size_t i = 0; i < lights.size() && lit_count_ < kMaxLights; ++i) {
    double first, last;
    if (lit_range(*lights[i], ray, length, first, last))
      lit_[static_cast<std::size_t>(lit_count_++)] = {i, first, last};
  }
}

void MediaIntervals::push(double start, double end, bool lit, int count, bool last) {
  // Where the end of the ray's last interval is rounded to below the ray's, another one of hardly any length follows.
  // It draws numbers, in POV-Ray as well, but lights are not looked at in it.
  const double step = (end - start) / count;
  int n = 0;
  for (double s = start; s < end && n < count + last && count_ < kMax; s = start + ++n * step)
    intervals_[static_cast<std::size_t>(count_++)] = {s, n < count ? step : end - s, lit && n < count};
}

// Spec 07 4.5: the union of all lit ranges cuts the segment; the pieces share the intervals by `ratio`.
void MediaIntervals::divide(const MediaMixture& mixture, double length) {
  count_ = 0;
  struct Piece {
    double start, end;
    bool lit;
  };
  std::array<Piece, 2 * kMaxLights + 1> pieces;
  std::size_t count = 0;
  if (lit_count_ == 0) {
    pieces[count++] = {0.0, length, false};
  } else {
    const auto lights = static_cast<std::size_t>(lit_count_);
    std::array<std::pair<double, double>, kMaxLights> ranges;
    for (std::size_t i = 0; i < lights; ++i) ranges[i] = {lit_[i].first, lit_[i].last};
    std::sort(ranges.begin(), ranges.begin() + lit_count_);
    double position = 0.0;
    for (std::size_t i = 0; i < lights;) {
      const double start = ranges[i].first;
      double end = ranges[i].second;
      for (++i; i < lights && ranges[i].first <= end; ++i) end = std::max(end, ranges[i].second);
      if (start > position) pieces[count++] = {position, start, false};
      pieces[count++] = {start, end, true};
      position = end;
    }
    if (position < length) pieces[count++] = {position, length, false};
  }
  const int piece_count = static_cast<int>(count);
  const int wanted = std::min(std::max(mixture.control->intervals, piece_count), kMaxIntervals);
  if (count == 1) {
    push(0.0, length, pieces[0].lit, !pieces[0].lit && !mixture.has_density ? 1 : wanted, true);
    return;
  }
  double total = 0.0;
  const auto weight = [&](const Piece& p) { return p.lit ? mixture.control->ratio : 1.0 - mixture.control->ratio; };
  for (std::size_t i = 0; i < count; ++i) total += weight(pieces[i]);
  int remaining = wanted;
  for (int i = 0; i < piece_count; ++i) {
    const Piece& piece = pieces[static_cast<std::size_t>(i)];
    const int n =
        std::max(1, std::min(static_cast<int>(weight(piece) / total * wanted) + 1, remaining - piece_count + i + 1));
    push(piece.start, piece.end, piece.lit, n, i + 1 == piece_count);
    remaining -= n;
  }
}

}  // namespace verisim::global
