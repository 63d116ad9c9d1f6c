#include "cli/farm/plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "cli/console/seconds.h"
#include "cli/settings/region.h"
#include "tracer/render/blocks.h"
#include "tracer/render/prepared_scene.h"

namespace verisim::cli {
namespace {

constexpr double kShortestTask = 60;       // seconds
constexpr double kTimesRepeated = 10;      // of what a task repeats
constexpr double kLeastTimesRepeated = 2;  // where there are nodes for it
constexpr int kTasksPerNode = 4, kMaxTasksOfAPart = 1000;
constexpr std::chrono::seconds kSampling(10);

// Sets a flag after some time, unless it ends before.
class Alarm {
 public:
  explicit Alarm(std::atomic<bool>& flag)
      : thread_([this, &flag] {
          std::unique_lock lock(mutex_);
          if (!over_.wait_for(lock, kSampling, [this] { return ended_; })) flag = true;
        }) {}
  ~Alarm() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    over_.notify_all();
    thread_.join();
  }

 private:
  std::mutex mutex_;
  std::condition_variable over_;
  bool ended_ = false;
  std::thread thread_;
};

double seconds_of_task(const Costs& costs) {
  return std::max(kShortestTask, kTimesRepeated * (costs.start + costs.parse));
}

}  // namespace

Costs measure_costs(const Job& job, const scene::Scene& scene, double seconds_parse) {
  constexpr int kBlocks = 16;
  render::Options options = render_options(job, region(job.options));
  const auto blocks = static_cast<int>(render::blocks_of(render::render_area(options), options.block_size).size());
  options.part = 0, options.parts = std::max(1, blocks / kBlocks);
  std::atomic<bool> cancel{false};
  options.cancel = &cancel;
  double fraction = 0, seconds = 0;
  const auto start = Clock::now();
  Clock::time_point begin = start;
  options.pass_progress = [&](const char*, double) { begin = Clock::now(); };
  options.progress = [&](double done) { fraction = done, seconds = seconds_since(begin); };
  render::Framebuffer frame;
  double seconds_compile = 0;
  {
    const Alarm alarm(cancel);
    render::PreparedScene prepared(scene, options);
    begin = Clock::now();
    seconds_compile = seconds_since(start);
    prepared.render(options, frame);
  }
  Costs costs;
  costs.parse = seconds_parse + seconds_compile;
  if (fraction > 0) costs.picture = seconds / fraction * options.parts;
  return costs;
}

int parts_for(const Costs& costs, int blocks, int nodes) {
  constexpr int kUnknown = 64;
  const int most = std::max(1, std::min(blocks, std::max(kMaxTasksOfAPart, kTasksPerNode * nodes)));
  if (costs.picture <= 0) return std::min(most, std::max(kUnknown, kTasksPerNode * nodes));
  const double wanted = costs.picture / seconds_of_task(costs);
  const double allowed = costs.picture / (kLeastTimesRepeated * (costs.start + costs.parse));
  return static_cast<int>(std::clamp(std::ceil(std::max(wanted, std::min<double>(allowed, kTasksPerNode * nodes))), 1.0,
                                     static_cast<double>(most)));
}

int frames_per_task_for(const Costs& costs, int frames, int nodes) {
  if (costs.picture <= 0) return 1;
  // Every frame is read by itself wherever it is rendered: only the start is repeated.
  const double frame = costs.parse + costs.picture;
  const double wanted = std::max(kShortestTask, kTimesRepeated * costs.start) / frame;
  const double shared_out = nodes > 0 ? static_cast<double>(frames) / (kTasksPerNode * nodes) : wanted;
  const double least = kLeastTimesRepeated * costs.start / frame;
  return std::clamp(static_cast<int>(std::ceil(std::max(std::min(wanted, shared_out), least))), 1, std::max(frames, 1));
}

}  // namespace verisim::cli
