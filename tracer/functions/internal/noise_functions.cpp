// Internal functions made of noise: noise3d, noise_generator and the multifractals (spec 01 section 24: 29, 58, 59, 76,
// 78).
#include "tracer/functions/internal/noise_functions.h"

#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include "tracer/functions/internal/formula_table.h"
#include "tracer/functions/narrowing.h"
#include "tracer/functions/operations.h"
#include "tracer/noise/noise_kernels.h"

namespace verisim::functions {

namespace {

constexpr int kMaxOctaves = 4096;  // a limit against endless loops; the weights have long vanished

// The generator named by a parameter: 0 acts as 1.
int generator(double p) {
  const int g = static_cast<int>(to_int(p)) & 3;
  return g == 0 ? 1 : g;
}

// Calls use(i, noise) for octaves i < count of p, whose place is multiplied by the lacunarity from each to the next.
template <class Use>
void each_octave(Vec3 p, double lacunarity, int count, int generator, Use use) {
  for (int first = 0; first < count; first += 8) {
    textures::EightPoints points;
    const int n = std::min(count - first, 8);
    for (int k = 0; k < n; ++k, p *= lacunarity) points.x[k] = p.x, points.y[k] = p.y, points.z[k] = p.z;
    alignas(64) double noises[8];
    textures::noises(generator, points, textures::first_of_eight(n), noises);
    for (int k = 0; k < n; ++k) use(first + k, noises[k]);
  }
}

// s^t with t multiplications; t <= 0 gives 1.
double repeated_product(double s, double t) {
  double r = 1;
  const int n = static_cast<int>(std::min(to_int(t), 1024.0));
  for (int i = 0; i < n; ++i) r *= s;
  return r;
}

double hetero_mf(Vec3 p, const double* a) {
  const double H = a[0], lacunarity = a[1], octaves = a[2], offset = a[3];
  const int whole = octaves > 1 ? static_cast<int>(std::min(std::ceil(octaves), static_cast<double>(kMaxOctaves))) : 1;
  const double fraction = octaves - std::trunc(octaves);
  const double falloff = std::pow(lacunarity, -H);
  double s = 0, weight = 1;
  each_octave(p, lacunarity, whole + (fraction != 0 && whole < kMaxOctaves), generator(a[5]), [&](int i, double noise) {
    const double n = 2 * noise - 1 + offset;
    if (i == 0) {
      s = n;
      return;
    }
    weight *= falloff;
    s += i < whole ? n * weight * repeated_product(s, a[4]) : n * weight * fraction * s;
  });
  return s;
}

double ridge(Vec3 p, const double* a) {
  const double lambda = a[0], omega = a[2], offset = a[3], level = a[4];
  const double octaves = std::min(to_int(a[1]), static_cast<double>(kMaxOctaves));
  const int g = generator(a[5]);
  const double scale = 1 / std::max(level, 1 - level);
  const auto term = [&](double frequency) {
    return std::fabs(textures::noise(p * frequency, g) - level) * scale - offset;
  };
  double sum = term(1), weights = 1, weight = 1, frequency = 1;
  for (int i = 2; i <= octaves; ++i) {
    weight *= omega, frequency *= lambda;
    sum += weight * term(frequency), weights += weight;
  }
  const double fraction = a[1] - std::trunc(a[1]);
  if (fraction != 0) {
    weight *= omega, frequency *= lambda;
    sum += fraction * (weight * term(frequency)), weights += fraction * weight;
  }
  return sum * (1 / std::max(offset, 1 - offset)) / weights;
}

class Noise final : public Function {
 public:
  explicit Noise(int fixed_generator) : generator_(fixed_generator) {}
  int parameters() const override { return 3; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> a, double* result) const override {
    *result = textures::noise({a[0], a[1], a[2]}, generator_);
  }
  void evaluate_batch(const double* points, std::size_t stride, std::size_t count, double* result) const override {
    textures::noise(generator_, points, stride, count, result);
  }

 private:
  int generator_;
};

class NoiseOfGenerator final : public Function {
 public:
  int parameters() const override { return 4; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> a, double* result) const override {
    *result = textures::noise({a[0], a[1], a[2]}, generator(a[3]));
  }
};

template <double (*Formula)(Vec3, const double*)>
class Fractal final : public Function {
 public:
  int parameters() const override { return 9; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> a, double* result) const override {
    *result = Formula({a[0], a[1], a[2]}, a.data() + 3);
  }
};

// The weights of the octaves are those of the first call ever made; later calls with other parameters use them, too.
class RidgedMultifractal final : public Function, public OctaveSum {
 public:
  int parameters() const override { return 9; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> a, double* result) const override {
    const Ridges ridges = known_ridges(a);
    double last = 0, sum = 0;
    each_octave({a[0], a[1], a[2]}, a[4], ridges.count, generator(a[8]),
                [&](int i, double noise) { add(ridges, i, noise, last, sum); });
    *result = sum;
  }

  Bounds begin(std::span<const double> a, Partial& p, Workspace& workspace) const override {
    constexpr double kFarthest = 1e9;
    if (!workspace.known) prepare(a, workspace);
    if (!workspace.gradual || !((std::fabs(a[0]) + std::fabs(a[1]) + std::fabs(a[2])) * workspace.growth < kFarthest)) {
      evaluate(a, &p.sum);
      p.done = workspace.count;
      return {p.sum, p.sum};
    }
    p = {0, Vec3(a[0], a[1], a[2]), 0, 0};
    return add_some(a, kFirst, p, workspace);
  }

  Bounds narrow(std::span<const double> a, Partial& p, Workspace& workspace) const override {
    return add_some(a, p.done == kFirst ? kNext : workspace.count, p, workspace);
  }

 private:
  static constexpr int kFirst = 3, kNext = 2;  // octaves
  static constexpr double kLargest = 1e50;
  struct Ridges {
    int count;
    double offset, gain;
  };
  Ridges known_ridges(std::span<const double> a) const {
    if (!known_.load(std::memory_order_acquire)) find_weights(a);
    return {a[5] > 1 ? static_cast<int>(std::min(std::ceil(a[5]), static_cast<double>(weights_.size()))) : 1, a[6],
            a[7]};
  }
  // `last`: what the octave before is.
  void add(const Ridges& ridges, int i, double noise, double& last, double& sum) const {
    const double ridge = sq(ridges.offset - std::fabs(2 * noise - 1));
    if (i == 0) {
      last = sum = ridge;
      return;
    }
    last = ridge * std::min(1.0, std::max(0.0, last * ridges.gain));
    sum += last * weights_[static_cast<std::size_t>(i)];
  }

  // Not less than what is computed with some other roundings.
  static double bound(double sum) { return sum * (1 + 1e-12) + 1e-300; }

  Bounds add_some(std::span<const double> a, int octaves, Partial& p, Workspace& workspace) const {
    const Ridges ridges{workspace.count, a[6], a[7]};
    const int first = p.done, done = std::min(first + octaves, workspace.count);
    Vec3 next = p.next;
    for (int i = first; i < done; ++i, next *= a[4])
      workspace.points.x[i] = next.x, workspace.points.y[i] = next.y, workspace.points.z[i] = next.z;
    alignas(64) double noises[8];
    textures::noises(workspace.generator, workspace.points,
                     textures::first_of_eight(done) & ~textures::first_of_eight(first), noises);
    double last = p.last, sum = p.sum;
    for (int i = first; i < done; ++i) add(ridges, i, noises[i], last, sum);
    p = {done, next, last, sum};
    return {sum, done == workspace.count ? sum : bound(sum + last * workspace.rest[static_cast<std::size_t>(done)])};
  }

  void prepare(std::span<const double> a, Workspace& workspace) const {
    const Ridges ridges = known_ridges(a);
    workspace.known = true;
    workspace.count = ridges.count, workspace.generator = generator(a[8]);
    workspace.gradual = workspace.count <= 8 && plain_ && std::fabs(ridges.offset) < kLargest && ridges.gain >= 0 &&
                        ridges.gain < kLargest;
    if (!workspace.gradual) return;
    workspace.growth = std::pow(std::max(1.0, std::fabs(a[4])), workspace.count);
    const double most = std::max(sq(ridges.offset), sq(ridges.offset - 1));  // of a ridge: noise is between 0 and 1
    double rest = 0;
    for (auto i = static_cast<std::size_t>(workspace.count); i-- > 1;)
      workspace.rest[i] = rest = most * ridges.gain * (weights_[i] + rest);
  }

  void find_weights(std::span<const double> a) const {
    const std::scoped_lock lock(mutex_);
    if (known_.load(std::memory_order_relaxed)) return;
    double frequency = 1;
    plain_ = true;
    for (double& w : weights_) w = std::pow(frequency, -a[3]), frequency *= a[4], plain_ &= w >= 0 && w < kLargest;
    known_.store(true, std::memory_order_release);
  }

  mutable std::mutex mutex_;
  mutable std::atomic<bool> known_ = false;
  mutable std::array<double, 64> weights_{};
  mutable bool plain_ = false;  // weights that let a sum only grow
};

}  // namespace

FunctionPtr noise_function(int n, int noise_generator) {
  switch (n) {
    case 29:
      return std::make_shared<Fractal<hetero_mf>>();
    case 58:
      return std::make_shared<Fractal<ridge>>();
    case 59:
      return std::make_shared<RidgedMultifractal>();
    case 76:
      return std::make_shared<Noise>(noise_generator);
    case 78:
      return std::make_shared<NoiseOfGenerator>();
    default:
      return nullptr;
  }
}

}  // namespace verisim::functions
