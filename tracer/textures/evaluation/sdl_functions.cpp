// Patterns and pigments as functions of SDL (spec 05 section 2, 01 section 24): there is no surface, so slope and aoi
// are 0.
#include <algorithm>

#include "tracer/functions/evaluation_budget.h"
#include "tracer/functions/function.h"
#include "tracer/textures/evaluation/many_points.h"
#include "tracer/textures/point_batch.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {
namespace {

class PatternFunction final : public Function {
 public:
  PatternFunction(const scene::Pattern& description, const Settings& settings)
      : compiler_(settings), pattern_(compiler_.pattern(description)) {}
  int parameters() const override { return 3; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> p, double* result) const override {
    functions::EvaluationBudget budget;
    budget.spend(functions::kPassesOfACall);
    result[0] = textures::evaluate(*pattern_, Vec3(p[0], p[1], p[2]), nullptr);
  }
  void evaluate_batch(const double* points, std::size_t stride, std::size_t count, double* result) const override {
    textures::evaluate(*pattern_, points, stride, count, result);
  }

 private:
  Compiler compiler_;
  const CompiledPattern* pattern_;
};

class PigmentFunction final : public Function {
 public:
  PigmentFunction(const scene::PigmentPtr& description, const Settings& settings)
      : compiler_(settings), pigment_(compiler_.pigment(description)) {}
  int parameters() const override { return 3; }
  int components() const override { return 5; }
  void evaluate(std::span<const double> p, double* result) const override {
    Color c;
    textures::evaluate(*pigment_, Vec3(p[0], p[1], p[2]), nullptr, c);
    result[0] = c.r, result[1] = c.g, result[2] = c.b, result[3] = c.f, result[4] = c.t;
  }
  void evaluate_batch(const double* points, std::size_t stride, std::size_t count, double* result) const override {
    PointBatch batch;
    Color colors[PointBatch::kMax];
    bool colored[PointBatch::kMax];
    for (std::size_t begin = 0; begin < count; begin += PointBatch::kMax) {
      const auto n = static_cast<int>(std::min<std::size_t>(PointBatch::kMax, count - begin));
      const double* const p = points + begin;
      for (int k = 0; k < n; ++k) batch.set(k, Vec3(p[k], p[stride + k], p[2 * stride + k]));
      batch.fill_up(n);
      textures::evaluate(*pigment_, n, batch, nullptr, colors, colored);
      for (int k = 0; k < n; ++k) {
        const Color& c = colors[k];
        double* const value = result + begin + static_cast<std::size_t>(k);
        value[0] = c.r, value[stride] = c.g, value[2 * stride] = c.b, value[3 * stride] = c.f, value[4 * stride] = c.t;
      }
    }
  }

 private:
  Compiler compiler_;
  const CompiledPigment* pigment_;
};

}  // namespace

FunctionPtr pattern_function(const scene::Pattern& description, const scene::ColorMap*, const Settings& settings) {
  return std::make_shared<PatternFunction>(description, settings);
}

FunctionPtr pigment_function(const scene::PigmentPtr& description, const Settings& settings) {
  return std::make_shared<PigmentFunction>(description, settings);
}

}  // namespace verisim::textures
