#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "tracer/global/effects_state.h"
#include "tracer/render/blocks.h"
#include "tracer/render/prepasses.h"

namespace verisim::render {
namespace {

using global::EffectsStateOfScene;
using global::IrradianceCache;
using global::PretracePlan;
using global::RadiosityTask;

// A pool of directions is walked through from a different place in every tile; any number coprime to the pool spreads the starts.
std::size_t first_direction(int pass, int tile, bool final_trace) {
  return static_cast<std::size_t>(tile) * 613u + static_cast<std::size_t>(pass) * 101u + (final_trace ? 307u : 0u);
}

struct Worker {
  Worker(const shading::SceneData& data, const CameraModel& camera, const Options& options)
      : tracer(data, shading::RandomSource(options.replay, options.seed), options.cancel), sampler(camera, tracer) {
    tracer.set_pretrace(true);
  }
  shading::Tracer tracer;
  PixelSampler sampler;
  std::vector<Vec2> positions;

  void trace_tile(const PretracePlan& plan, int pass, int tile, const Block& b) {
    global::pretrace_positions(plan, pass, tile, b.x, b.x + b.width - 1, b.y, b.y + b.height - 1, positions);
    for (const Vec2& p : positions) sampler(p.x, p.y);
  }
};

// Tiles that need no more passes (spec 07 2.9): whole tiles without any query, or with enough weight everywhere when nearest_count asks for that.
// With the adaptive value POV-Ray splits tiles into blocks; here the tile is the block, which only costs samples.
bool tile_finished(const RadiosityTask& task, std::size_t positions, int queries_before, double weight_before, int adaptive) {
  if (positions < 9) return false;
  const int queries = task.depth0_queries() - queries_before;
  if (queries == 0) return true;
  return adaptive > 0 && (task.depth0_weight() - weight_before) / queries >= adaptive;
}

}  // namespace

void radiosity_pretrace(global::SceneEffects& effects, const shading::SceneData& data, const CameraModel& camera, const Options& options, int threads) {
  const scene::Radiosity& settings = effects.scene().settings.radiosity;
  const PretracePlan plan = global::pretrace_plan(settings, options.width, options.height);
  const std::vector<Block> tiles = blocks_of(render_area(options), options.block_size);
  std::vector<std::uint8_t> finished(tiles.size(), 0);
  IrradianceCache& cache = effects.irradiance();
  try {
    if (options.replay) {
      Worker worker(data, camera, options);
      auto& task = EffectsStateOfScene::of(worker.tracer).radiosity;
      task.emplace(*effects.radiosity_settings(), &cache, &cache, true, 0, 0);
      for (int pass = 0; pass < plan.passes; ++pass) {
        for (std::size_t i = 0; i < tiles.size(); ++i) {
          if (finished[i]) continue;
          const int queries = task->depth0_queries();
          const double weight = task->depth0_weight();
          worker.trace_tile(plan, pass, static_cast<int>(i), tiles[i]);
          finished[i] = tile_finished(*task, worker.positions.size(), queries, weight, settings.adaptive_nearest_count);
        }
      }
      return;
    }
    tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(data, camera, options); });
    for (int pass = 0; pass < plan.passes; ++pass) {
      std::vector<IrradianceCache> found(tiles.size(), IrradianceCache(settings.error_bound));
      const auto work = [&](std::size_t i) {
        if (finished[i] || (options.cancel && options.cancel->load(std::memory_order_relaxed))) return;
        Worker& worker = workers.local();
        auto& task = EffectsStateOfScene::of(worker.tracer).radiosity;
        task.emplace(*effects.radiosity_settings(), &cache, &found[i], true, pass, static_cast<int>(i));
        task->seek(first_direction(pass, static_cast<int>(i), false));
        try {
          worker.trace_tile(plan, pass, static_cast<int>(i), tiles[i]);
        } catch (const shading::Cancelled&) {
          return;
        }
        finished[i] = tile_finished(*task, worker.positions.size(), 0, 0.0, settings.adaptive_nearest_count);
        task.reset();
      };
      if (threads == 1) {
        for (std::size_t i = 0; i < tiles.size(); ++i) work(i);
      } else {
        tbb::parallel_for(std::size_t{0}, tiles.size(), work, tbb::simple_partitioner());
      }
      for (const IrradianceCache& tile : found) {
        for (const global::IrradianceSample& sample : tile.samples()) cache.add(sample);
      }
    }
  } catch (const shading::Cancelled&) {
  }
}

void begin_block(global::SceneEffects& effects, shading::Tracer& tracer, const Options& options, int block) {
  if (!effects.radiosity) return;
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  if (options.replay) {
    if (!state.radiosity) state.radiosity.emplace(*effects.radiosity_settings(), &effects.irradiance(), &effects.irradiance(), false, -2, 0);
    return;
  }
  state.own_samples.emplace(effects.scene().settings.radiosity.error_bound);
  state.radiosity.emplace(*effects.radiosity_settings(), &effects.irradiance(), &*state.own_samples, false, -2, block);
  state.radiosity->seek(first_direction(0, block, true));
}

}  // namespace verisim::render
