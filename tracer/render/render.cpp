// From scene to framebuffer: compile, cut into blocks, render them on all threads.
#include "tracer/render/render.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

#include "tracer/base/keep_until_exit.h"
#include "tracer/base/lent_arena.h"
#include "tracer/base/parallel.h"
#include "tracer/render/sampling/adaptive_sampling.h"
#include "tracer/render/sampling/antialias.h"
#include "tracer/render/blocks.h"
#include "tracer/render/evaluation_watch.h"
#include "tracer/render/layers.h"
#include "tracer/render/path_pixels.h"
#include "tracer/render/sampling/pixel_sampler.h"
#include "tracer/render/last_blockers.h"
#include "tracer/shapes/implicit/last_miss.h"
#include "tracer/textures/compile/shared_maps.h"
#include "tracer/render/prepared_scene.h"
#include "tracer/render/prepass_data.h"
#include "tracer/render/prepasses.h"
#include "tracer/render/requirements.h"

namespace verisim::render {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void add(Statistics& total, const Statistics& part) {
  total.samples += part.samples;
  total.camera_rays += part.camera_rays;
  total.reflected_rays += part.reflected_rays;
  total.refracted_rays += part.refracted_rays;
  total.shadow_rays += part.shadow_rays;
  total.transmitted_rays += part.transmitted_rays;
  total.wavefront_rays += part.wavefront_rays;
}

textures::Settings texture_settings(const scene::Scene& scene, int quality) {
  return {scene.settings.noise_generator, scene.settings.number_of_waves, scene.version, quality <= 5};
}

// Hands blocks to threads and keeps count of what is done.
class Queue {
 public:
  Queue(const Options& options, Framebuffer& frame, Statistics& statistics)
      : options_(options),
        frame_(frame),
        statistics_(statistics),
        blocks_(blocks_of(render_area(options), options.block_size)),
        wanted_(wanted(blocks_, options)),
        places_(blocks_) {
    std::vector<Block> own;
    for (const std::size_t i : wanted_) own.push_back(blocks_[i]);
    for (const Block& b : own) pixels_ += static_cast<std::uint64_t>(b.width) * b.height;
    if (options.prepasses_to) return;
    int width = options.width, height = options.height;
    if (options.parts > 1) {
      width = height = 0;
      const std::vector<Block> strip = strip_of(own);
      for (std::size_t k = 0; k < strip.size(); ++k) {
        places_[wanted_[k]] = strip[k];
        width = std::max(width, strip[k].width), height += strip[k].height;
      }
    }
    make_room(width, height);
  }

  // The numbers of the blocks that are to be rendered; numbers are those of the whole picture.
  static std::vector<std::size_t> wanted(std::span<const Block> blocks, const Options& options) {
    const std::vector<int> parts = parts_of(blocks, options.parts);
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (parts[i] == options.part) numbers.push_back(i);
    return numbers;
  }
  std::size_t size() const { return wanted_.size(); }
  bool cancelled() const { return options_.cancel && options_.cancel->load(std::memory_order_relaxed); }
  int index(const Block* block) const { return static_cast<int>(block - blocks_.data()); }
  BlockPixels pixels(const Block& block) {
    const Block& place = places_[static_cast<std::size_t>(index(&block))];
    return {frame_, block.x - place.x, block.y - place.y};
  }
  std::span<const Block> blocks() const { return blocks_; }
  // Null when there are no more.
  const Block* next() {
    while (!cancelled()) {
      const std::size_t i = next_.fetch_add(1);
      if (i >= wanted_.size()) return nullptr;
      const Block& b = blocks_[wanted_[i]];
      if (!options_.block_known || !options_.block_known(b.x, b.y, b.width, b.height)) {
        const std::lock_guard lock(mutex_);
        ++in_work_;
        return &b;
      }
      finished(b, false);
    }
    return nullptr;
  }
  // A block of next() is done, or given up.
  void leave_block() {
    const std::lock_guard lock(mutex_);
    if (--in_work_ == 0) none_in_work_.notify_all();
  }
  // For threads without a block. TBB would wait busily: for a picture in many small parts a third of the time.
  void wait_for_others() {
    std::unique_lock lock(mutex_);
    none_in_work_.wait(lock, [this] { return in_work_ == 0; });
  }
  void finished(const Block& b, bool rendered = true) {
    if (rendered) {
      const Block& place = places_[static_cast<std::size_t>(index(&b))];
      for (int y = place.y; y < place.y + place.height; ++y)
        std::fill_n(frame_.done.begin() + static_cast<std::ptrdiff_t>(y) * frame_.width + place.x, place.width,
                    std::uint8_t{1});
      if (options_.block_done) options_.block_done(b.x, b.y, b.width, b.height);
      frame_.pixels.done_with(static_cast<std::size_t>(b.width) * static_cast<std::size_t>(b.height));
    }
    const std::lock_guard lock(mutex_);
    done_ += static_cast<std::uint64_t>(b.width) * b.height;
    if (rendered) statistics_.pixels += static_cast<std::uint64_t>(b.width) * b.height;
    if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(pixels_));
  }
  void add_statistics(const Statistics& part) {
    count_rays(options_, part);
    const std::lock_guard lock(mutex_);
    add(statistics_, part);
  }

  // The blocks nearest to a pixel first: they do not depend on each other.
  void look_outwards(int column, int row) {
    const auto distance = [&](std::size_t i) {
      const Block& b = blocks_[i];
      return std::hypot(b.x + b.width / 2 - column, b.y + b.height / 2 - row);
    };
    std::stable_sort(wanted_.begin(), wanted_.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  }

 private:
  // A framebuffer of another size is made anew.
  void make_room(int width, int height) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (frame_.width != width || frame_.height != height || frame_.pixels.size() != pixels) {
      frame_.width = width, frame_.height = height;
      frame_.pixels.assign(pixels, {});
    }
    frame_.done.assign(pixels, 0);
  }

  const Options& options_;
  Framebuffer& frame_;
  Statistics& statistics_;
  const std::vector<Block> blocks_;
  std::vector<std::size_t> wanted_;  // numbers of blocks, in the order they are worked on
  std::vector<Block> places_;        // of all blocks in the framebuffer
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable none_in_work_;
  int in_work_ = 0;
  std::uint64_t pixels_ = 0, done_ = 0;
};

// A thread's hold on a block of the queue.
struct InWork {
  Queue& queue;
  ~InWork() { queue.leave_block(); }
};

// One thread's work: blocks until there are none left.
void work(Queue& queue, const shading::SceneData& scene, global::SceneEffects& effects, const CameraModel& camera,
          const Options& options, const path::PathScene* paths, std::span<const shading::LastBlockers> blockers) {
  shading::Tracer tracer(scene, shading::RandomSource(options.replay, options.seed), options.cancel);
  tracer.coherent().set_camera(camera.coherence);
  PixelSampler sampler(camera, tracer);
  const AntialiasSettings settings =
      antialias_settings(options, scene.scene.settings.gamma, scene.scene.settings.assumed_gamma);
  const bool adaptive = options.antialias && options.sampler == Sampler::adaptive;
  const int method = options.antialias && !adaptive ? settings.method : 0;
  std::optional<AdaptiveGrid<PixelSampler>> grid;
  std::optional<RecursiveQuads<PixelSampler>> quads;
  std::optional<AdaptiveSampling<PixelSampler>> sampling;
  if (adaptive)
    sampling.emplace(adaptive_settings(options, scene.scene.settings.gamma, scene.scene.settings.assumed_gamma),
                     options.width, options.height, sampler);
  if (method == 1) grid.emplace(settings, sampler);
  if (method == 2) quads.emplace(settings, sampler);
  const EvaluationWatch watch(options.cancel);
  try {
    while (const Block* block = queue.next()) {
      const InWork hold{queue};
      const int index = queue.index(block);
      begin_block(effects, tracer, options, index);
      if (!blockers.empty()) tracer.remember_blockers(blockers[static_cast<std::size_t>(index)]);
      const BlockPixels pixels = queue.pixels(*block);
      if (paths) {
        render_paths(*block, camera, *paths, tracer, options, pixels);
      } else if (sampling) {
        sampling->render(*block, pixels);
      } else if (grid) {
        grid->render(*block, pixels);
      } else if (quads) {
        quads->render(*block, pixels);
      } else {
        render_plain(*block, sampler, pixels);
      }
      end_block(effects, tracer, options, index);
      watch.check();
      queue.add_statistics(std::exchange(tracer.statistics(), {}));
      queue.finished(*block);
    }
  } catch (const shading::Cancelled&) {
  }
  shapes::last_miss() = {};  // which is of no use to what this thread does next
  queue.add_statistics(tracer.statistics());
  queue.wait_for_others();
}

const scene::Scene& supported(const scene::Scene& scene, const Options& options) {
  check_supported(scene, options);
  scene::complete(scene);
  if (options.path_samples > 0) path::check_supported(scene);
  return scene;
}

}  // namespace

void count_rays(const Options& options, const Statistics& traced) {
  if (options.rays)
    options.rays->fetch_add(traced.camera_rays + traced.reflected_rays + traced.refracted_rays + traced.shadow_rays +
                            traced.transmitted_rays);
}

PreparedScene::PreparedScene(const scene::Scene& scene, const Options& options)
    : compiler_(texture_settings(supported(scene, options), options.quality), textures::MapsWithoutBumpScale(scene)),
      world_(scene, compiler_, {options.split_unions, options.remove_bounds, options.bounding_threshold}),
      data_(scene, world_, compiler_, options.quality, options.output_alpha),
      effects_(scene, compiler_, options.quality) {
  if (options.path_samples > 0) {
    effects_.photons = effects_.radiosity = false;  // paths are their own interreflection and caustics
    paths_.emplace(data_, effects_, options.path_bounces);
  }
  if (effects_.any()) data_.effects = &effects_;
}

void PreparedScene::run_prepasses(const CameraModel& camera, const Options& options, int threads) {
  if (passes_ != Passes::none) return;
  passes_ = Passes::begun;
  if (effects_.photons) photon_pass(effects_, data_, options, threads);
  if (effects_.radiosity) radiosity_pretrace(effects_, data_, camera, options, threads);
  const bool whole = !(effects_.photons || effects_.radiosity) || !options.cancel || !options.cancel->load();
  if (whole) passes_ = Passes::done;
}

CameraModel PreparedScene::camera(const Options& options, const Window& window) {
  return {data_.scene.camera,
          window.width > 0 ? window.width : options.width,
          window.height > 0 ? window.height : options.height,
          compiler_,
          {window.left, window.top}};
}

Statistics PreparedScene::render(const Options& options, Framebuffer& frame, const Window& window) {
  Statistics statistics;
  const auto start = std::chrono::steady_clock::now();
  const CameraModel model = camera(options, window);
  Queue queue(options, frame, statistics);
  if (window.focus_column >= 0 && !options.replay) queue.look_outwards(window.focus_column, window.focus_row);
  const int cores = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
  const int useful = options.prepasses_to ? cores : static_cast<int>(queue.size());
  const int threads = options.replay ? 1 : std::max(1, std::min(cores, useful));
  std::vector<shading::LastBlockers> blockers;
  const auto before_the_picture = [&](int count) {
    if (options.prepasses_from && passes_ == Passes::none) read_prepasses(*options.prepasses_from, effects_, options);
    run_prepasses(model, options, count);
    if (options.prepasses_to)
      *options.prepasses_to = write_prepasses(effects_);
    else if (!effects_.radiosity && !paths_)
      blockers = blockers_at_blocks(data_, model, options, queue.blocks());
  };
  const auto work_on_blocks = [&] {
    work(queue, data_, effects_, model, options, paths_ ? &*paths_ : nullptr, blockers);
  };
  std::vector<Block> layer_blocks;  // of the whole picture, whatever region is rendered
  if (options.layers && !options.prepasses_to) {
    resize_layers(*options.layers, options.width, options.height);
    const std::vector<Block> all = blocks_of({0, 0, options.width, options.height}, options.block_size);
    for (const std::size_t i : Queue::wanted(all, options)) layer_blocks.push_back(all[i]);
  }
  const auto fill_layer_block = [&](std::size_t i) {
    if (!queue.cancelled())
      fill_layers(*options.layers, data_, model, options.width, layer_blocks[i], options.antialias);
  };
  if (threads == 1) {
    before_the_picture(1);
    if (!options.prepasses_to) work_on_blocks();
    for (std::size_t i = 0; i < layer_blocks.size(); ++i) fill_layer_block(i);
  } else {
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    const tbb::global_control stack(tbb::global_control::thread_stack_size, std::size_t{100} << 20);
    LentArena arena(threads);
    arena.execute([&] {
      before_the_picture(threads);
      if (options.prepasses_to) return;
      parallel_for(static_cast<std::size_t>(threads), 1, [&](std::size_t) { work_on_blocks(); });
      parallel_for(layer_blocks.size(), 1, fill_layer_block);
    });
  }
  statistics.cancelled = queue.cancelled();
  if (!statistics.cancelled && !paths_ && !options.prepasses_to) save_radiosity(effects_, options);
  statistics.seconds_render = seconds_since(start);
  statistics.findings = world_.findings();
  return statistics;
}

Statistics render(const scene::Scene& scene, const Options& options, Framebuffer& frame) {
  const auto start = std::chrono::steady_clock::now();
  auto prepared = std::make_unique<PreparedScene>(scene, options);
  const double seconds_compile = seconds_since(start);
  Statistics statistics = prepared->render(options, frame);
  statistics.seconds_compile = seconds_compile;
  if (options.last_of_process) keep_until_exit(std::move(prepared));
  return statistics;
}

}  // namespace verisim::render
