// Diffuse interreflection by POV-Ray's irradiance cache (spec 07 section 2): query, gathering of new samples, sample
// directions.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tracer/radiosity/final_gather_lattice.h"
#include "tracer/radiosity/irradiance_cache.h"
#include "tracer/radiosity/irradiance_weights.h"
#include "tracer/radiosity/pretrace.h"
#include "tracer/scene/scene.h"
#include "tracer/shading/ray_state.h"

namespace verisim::global {

inline constexpr int kMaxRadiosityDepth = 21;

// Constants of one scene, shared by all tasks.
class RadiositySettings {
 public:
  RadiositySettings(const scene::Radiosity& description, const Vec3& camera_location);

  const scene::Radiosity& description() const { return *description_; }
  // A cache for samples of this scene.
  IrradianceCache empty_cache() const;
  Vec3 camera_location() const { return camera_location_; }
  int rays(int depth) const { return rays_[depth]; }
  const FinalGatherLattice::Plan& lattice_plan(int depth) const { return lattice_plans_[depth]; }
  double required_weight(int depth) const;  // K_d; a query is satisfied by an accumulated weight of K_d / 4
  // Trace level and weight a gather ray of this depth starts with (spec 07 2.6).
  static int start_level(int depth) { return static_cast<int>(1.5 * (depth + 1)); }
  float gather_weight(int depth) const;
  const Vec3& direction(std::size_t index) const { return pool_[index]; }
  std::size_t pool_size() const { return pool_.size(); }

 private:
  const scene::Radiosity* description_;
  Vec3 camera_location_;
  std::vector<Vec3> pool_;  // Halton (2,3), cosine-weighted about +y
  std::array<int, kMaxRadiosityDepth> rays_{};
  std::array<FinalGatherLattice::Plan, kMaxRadiosityDepth> lattice_plans_;
};

// A ray that gathers light for a sample; it is shaded only where what it hits has at least this importance.
struct FinalGatherRay {
  Vec3 direction;
  float threshold;
};

struct FinalGatherResult {
  double distance = std::numeric_limits<double>::infinity();
  bool shaded = false;   // false: culled by importance
  float importance = 1;  // of what was hit, or the default importance
  Rgb color;
  shading::FinalGatherNotes notes;
};

inline constexpr int kGatheredTogether = 160;  // rays at most

// Traces rays of a sample; implemented by the tracer.
class FinalGatherer {
 public:
  virtual ~FinalGatherer() = default;
  // `depth`: of the sample that gathers; there is a result for each ray, as it was made.
  virtual void gather(const Vec3& from, std::span<const FinalGatherRay> rays, int depth,
                      FinalGatherResult* results) = 0;
};

struct RadiosityQuery {
  Vec3 point, geometric_normal, layer_normal;  // both normals on the same side of the surface
  double contribution = 1;                     // w_c of spec 07 2.5
  int depth = 0;
};

// One task of rendering (a thread's phase in POV-Ray, a tile here): direction cursors and the samples it adds.
class RadiosityTask {
 public:
  // `base` is read only; new samples go to `own` (which may be the same cache when tasks run one after the other).
  RadiosityTask(const RadiositySettings& settings, const IrradianceCache* base, IrradianceCache* own, bool pretrace,
                int pass, int tile);

  // The default mode: where the direction cursors start (POV-Ray starts every phase at 0), and the number of the first
  // lattice of directions.
  void spread(std::size_t first) {
    cursor_.fill(first % settings_.pool_size());
    next_lattice_ = first;
  }
  // Irradiance at the point, and what the enclosing ray is to know of it. A sample taken for it may be of better
  // quality than 1, if it has hit more of what is of little importance than most do, and then counts for as much.
  Rgb irradiance(const RadiosityQuery& query, FinalGatherer& gatherer, shading::FinalGatherNotes& notes);
  // Those of depth 0 so far; the weights are 4 S before gathering.
  const PretraceQueries& primary_queries() const { return primary_queries_; }

 private:
  struct Estimate {
    Rgb sum;
    double weight = 0;
  };
  struct Contribution {
    IrradianceCache::Turn turn;
    double weight;
  };
  void accumulate(const IrradianceCache& cache, const RadiosityQuery& query, const Vec3& normal, double bound,
                  Estimate& estimate);
  Rgb take_sample(const RadiosityQuery& query, FinalGatherer& gatherer, shading::FinalGatherNotes& notes);

  const RadiositySettings& settings_;
  const IrradianceCache* base_;
  IrradianceCache* own_;
  bool pretrace_;
  int pass_, tile_;
  std::array<std::size_t, kMaxRadiosityDepth> cursor_{};
  std::optional<std::size_t> next_lattice_;
  PretraceQueries primary_queries_;
  // Of the samples that are being taken, one within another. What is drawn does not hang on what rays meet, so they are
  // drawn before they are traced.
  struct Gathering {
    FinalGatherRay rays[kGatheredTogether];
    FinalGatherResult results[kGatheredTogether];
  };
  std::array<std::unique_ptr<Gathering>, kMaxRadiosityDepth> gathering_;
  IrradianceBatch batch_;  // of accumulate
  std::vector<Contribution> contributions_;
};

}  // namespace verisim::global
