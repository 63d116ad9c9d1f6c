// Ripples and waves: circular waves around random centres.
#include "tracer/noise/noise.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {

std::shared_ptr<const std::vector<WaveSource>> wave_sources(int count) {
  auto sources = std::make_shared<std::vector<WaveSource>>();
  LinearCongruential generator(3734115329u);
  for (int i = 0; i < std::max(count, 1); ++i) {
    const double frequency = generator.draw() * 0.000030518509476 + 0.01;
    const Vec3 place = vector_noise(Vec3(i, 0, 0));
    sources->push_back({place / length(place), frequency});  // divided: not as other vectors are normalised
  }
  return sources;
}

double formulas::ripples(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const auto& sources = *c.as<WaveData>().sources;
  double sum = 0;
  for (const WaveSource& w : sources) sum += sine_cycle(wave_distance(w, p) * c.frequency + c.phase);
  return 0.5 * (1 + sum / static_cast<double>(sources.size()));
}

double formulas::waves(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const auto& sources = *c.as<WaveData>().sources;
  double sum = 0;
  for (const WaveSource& w : sources)
    sum += sine_cycle(wave_distance(w, p) * c.frequency * w.frequency + c.phase) / w.frequency;
  return 0.2 * (2.5 + sum / static_cast<double>(sources.size()));
}

Vec3 waves_bump(const CompiledPattern& c, double amount, const Vec3& p, Vec3 n) {
  for (const WaveSource& w : *c.as<WaveData>().sources) {
    const SourceWave wave(c, amount, w);
    const double d = wave_distance(w, p);
    n += wave.slope(sine_cycle(wave.cycles(d)), d) * (p - w.position);
  }
  return n;
}

}  // namespace verisim::textures
