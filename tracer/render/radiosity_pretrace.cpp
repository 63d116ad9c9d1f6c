#include <mutex>

#include <tbb/enumerable_thread_specific.h>

#include "tracer/effects/effects_state.h"
#include "tracer/radiosity/irradiance_file.h"
#include "tracer/radiosity/pretrace.h"
#include "tracer/base/parallel.h"
#include "tracer/render/blocks.h"
#include "tracer/render/evaluation_watch.h"
#include "tracer/render/prepasses.h"

namespace verisim::render {
namespace {

using global::EffectsStateOfScene;
using global::IrradianceCache;
using global::PretracePlan;
using global::PretraceTile;
using global::RadiosityTask;

// A pool of directions is walked through from a different place in every tile; any number coprime to the pool spreads
// the starts.
std::size_t first_direction(const Options& options, int pass, int tile, bool final_trace) {
  return options.seed % 1000003u * 379u + static_cast<std::size_t>(tile) * 613u +
         static_cast<std::size_t>(pass) * 101u + (final_trace ? 307u : 0u);
}

struct Worker {
  Worker(const shading::SceneData& data, const CameraModel& camera, const Options& options)
      : tracer(data, shading::RandomSource(options.replay, options.seed), options.cancel), sampler(camera, tracer) {
    tracer.set_pretrace(true);
  }
  shading::Tracer tracer;
  PixelSampler sampler;

  void trace_tile(const PretracePlan& plan, int pass, int adaptive, const RadiosityTask& task, PretraceTile& tile,
                  const std::atomic<bool>* cancel) {
    const EvaluationWatch watch(cancel);
    tile.run(
        plan, pass, adaptive, [this](double x, double y) { sampler(x, y); },
        [&task] { return task.primary_queries(); });
    watch.check();
  }
};

std::vector<PretraceTile> tiles_of(const Options& options) {
  std::vector<PretraceTile> tiles;
  for (const Block& b : blocks_of(render_area(options), options.block_size)) {
    const double x = b.x, y = b.y;
    tiles.push_back({static_cast<int>(tiles.size()), {x, y, x + b.width, y + b.height}});
  }
  return tiles;
}

// Tiles of a pass in groups that are worked on at the same time; a group sees the samples of all groups before it. What
// tiles of one group take twice is wasted, most of all while the cache is empty: the first pass begins with one tile.
// Neighbours are put in different groups. Depends on the picture's size alone, never on the number of threads.
std::vector<std::vector<std::size_t>> wavefronts_of(std::size_t tiles, int pass) {
  constexpr std::size_t kMin = 8, kMaxWavefronts = 16;
  const std::size_t full = std::max(kMin, (tiles + kMaxWavefronts - 1) / kMaxWavefronts);
  constexpr std::size_t kStride = 613;  // a prime, so that steps of it visit every tile
  std::vector<std::vector<std::size_t>> wavefronts;
  for (std::size_t i = 0, size = pass == 0 ? 1 : full; i < tiles; size = std::min(full, size * 2)) {
    auto& wavefront = wavefronts.emplace_back();
    for (; i < tiles && wavefront.size() < size; ++i)
      wavefront.push_back(tiles % kStride == 0 ? i : i * kStride % tiles);
  }
  return wavefronts;
}

// Tells how far the pretrace is; a pass counts by its number of positions.
class PretraceProgress {
 public:
  PretraceProgress(const PretracePlan& plan, std::size_t tiles, const Options& options)
      : plan_(plan), tiles_(static_cast<double>(tiles)), options_(options) {
    for (int pass = 0; pass < plan.passes; ++pass) total_ += positions(pass);
  }
  void tile_done(int pass) {
    if (!options_.pass_progress) return;
    const std::lock_guard lock(mutex_);
    done_ += positions(pass) / tiles_;
    double before = 0;  // tiles that were finished early count with their pass
    for (int p = 0; p < pass; ++p) before += positions(p);
    done_ = std::max(done_, before);
    options_.pass_progress("radiosity pretrace", std::min(1.0, done_ / total_));
  }

 private:
  double positions(int pass) const { return 1.0 / (plan_.spacing(pass) * plan_.spacing(pass)); }
  const PretracePlan& plan_;
  double tiles_, total_ = 0, done_ = 0;
  const Options& options_;
  std::mutex mutex_;
};

}  // namespace

void radiosity_pretrace(global::SceneEffects& effects, const shading::SceneData& data, const CameraModel& camera,
                        const Options& options, int threads) {
  const scene::Radiosity& settings = effects.scene().settings.radiosity;
  const PretracePlan plan = global::pretrace_plan(settings, options.width, options.height);
  const int adaptive = settings.adaptive_nearest_count;
  std::vector<PretraceTile> tiles = tiles_of(options);
  IrradianceCache& cache = effects.irradiance();
  cache.set_memory_limit(options.pass_memory);
  if (!options.radiosity_from.empty()) {
    constexpr std::uint64_t kSampleBytes = 512;  // with its share of the lookup
    for (const global::IrradianceSample& s :
         global::load_samples(options.radiosity_from, options.pass_memory / kSampleBytes))
      cache.add(s);
  }
  if (!options.radiosity_to.empty() && !options.replay) effects.block_samples().resize(tiles.size());
  if (options.prepasses_from) return;  // the samples are there
  PretraceProgress progress(plan, tiles.size(), options);
  try {
    if (options.replay) {
      Worker worker(data, camera, options);
      auto& task = EffectsStateOfScene::of(worker.tracer).radiosity;
      task.emplace(*effects.radiosity_settings(), &cache, &cache, true, 0, 0);
      for (int pass = 0; pass < plan.passes; ++pass) {
        for (PretraceTile& tile : tiles) {
          if (tile.finished()) continue;
          worker.tracer.begin_block();
          worker.trace_tile(plan, pass, adaptive, *task, tile, options.cancel);
          count_rays(options, std::exchange(worker.tracer.statistics(), {}));
          progress.tile_done(pass);
        }
      }
      return;
    }
    tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(data, camera, options); });
    for (int pass = 0; pass < plan.passes; ++pass) {
      for (const std::vector<std::size_t>& wavefront : wavefronts_of(tiles.size(), pass)) {
        std::vector<IrradianceCache> found(wavefront.size(), effects.radiosity_settings()->empty_cache());
        const auto work = [&](std::size_t i) {
          const std::size_t tile = wavefront[i];
          if (tiles[tile].finished() || (options.cancel && options.cancel->load(std::memory_order_relaxed))) return;
          Worker& worker = workers.local();
          worker.tracer.begin_block();
          auto& task = EffectsStateOfScene::of(worker.tracer).radiosity;
          task.emplace(*effects.radiosity_settings(), &cache, &found[i], true, pass, static_cast<int>(tile));
          task->spread(first_direction(options, pass, static_cast<int>(tile), false));
          try {
            worker.trace_tile(plan, pass, adaptive, *task, tiles[tile], options.cancel);
          } catch (const shading::Cancelled&) {
            return;
          }
          task.reset();
          count_rays(options, std::exchange(worker.tracer.statistics(), {}));
          progress.tile_done(pass);
        };
        if (threads == 1) {
          for (std::size_t i = 0; i < wavefront.size(); ++i) work(i);
        } else {
          parallel_for(wavefront.size(), 1, work);
        }
        for (const IrradianceCache& tile : found) {
          for (const global::IrradianceSample& sample : tile.samples()) cache.add(sample);
        }
      }
    }
  } catch (const shading::Cancelled&) {
  }
}

void begin_block(global::SceneEffects& effects, shading::Tracer& tracer, const Options& options, int block) {
  tracer.begin_block();
  if (!effects.radiosity) return;
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  if (options.replay) {
    if (!state.radiosity)
      state.radiosity.emplace(*effects.radiosity_settings(), &effects.irradiance(), &effects.irradiance(), false, -2,
                              0);
    return;
  }
  state.own_samples.emplace(effects.radiosity_settings()->empty_cache());
  state.radiosity.emplace(*effects.radiosity_settings(), &effects.irradiance(), &*state.own_samples, false, -2, block);
  state.radiosity->spread(first_direction(options, 0, block, true));
}

void end_block(global::SceneEffects& effects, shading::Tracer& tracer, const Options& options, int block) {
  if (!effects.radiosity || options.replay || options.radiosity_to.empty()) return;
  effects.block_samples()[static_cast<std::size_t>(block)] = EffectsStateOfScene::of(tracer).own_samples->samples();
}

void save_radiosity(global::SceneEffects& effects, const Options& options) {
  if (!effects.radiosity || options.radiosity_to.empty()) return;
  std::vector<global::IrradianceSample> samples;
  const bool append = options.radiosity_from == options.radiosity_to;
  for (const global::IrradianceSample& s : effects.irradiance().samples()) {
    if (s.pass != -1 || !append) samples.push_back(s);  // those of the file are in it
  }
  for (const auto& block : effects.block_samples()) samples.insert(samples.end(), block.begin(), block.end());
  global::save_samples(options.radiosity_to, samples, append);
}

}  // namespace verisim::render
