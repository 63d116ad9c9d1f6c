// The evaluation of patterns and pigments as the rest of the program sees it: calls into the kernels that fit this machine.
#include "tracer/textures/evaluation.h"

namespace verisim::textures {
namespace {

const EvaluationKernels& kernels = evaluation_kernels(best_instruction_set());

}  // namespace

Vec3 warped(const CompiledPattern& c, const Vec3& p) { return kernels.warped(c, p); }
double value_at(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) { return kernels.value_at(c, p, surface); }
PatternValue value_of(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) { return kernels.value_of(c, p, surface); }
bool evaluate(const CompiledPigment& c, const Vec3& p, const SurfacePoint* surface, Color& color) { return kernels.evaluate(c, p, surface, color); }
void evaluate(const CompiledPigment& c, int count, const PointRow& points, const SurfacePoint* const* surfaces, Color* colors, bool* colored) {
  kernels.evaluate_row(c, count, points, surfaces, colors, colored);
}
double evaluate(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) { return kernels.value_of(c, p, surface).value; }

}  // namespace verisim::textures
