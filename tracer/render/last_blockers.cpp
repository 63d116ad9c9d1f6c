#include "tracer/render/last_blockers.h"

namespace verisim::render {

std::vector<shading::LastBlockers> blockers_at_blocks(const shading::SceneData& scene, const CameraModel& camera,
                                                      const Options& options, std::span<const Block> blocks) {
  constexpr int kStep = 4;
  shading::Tracer tracer(scene, shading::RandomSource(options.replay, options.seed), options.cancel);
  std::vector<shading::LastBlockers> result;
  if (!tracer.in_order() || options.replay) return result;
  PixelSampler sampler(camera, tracer);
  try {
    for (const Block& block : blocks) {
      result.push_back(tracer.remembered_blockers());
      const int last_row = block.y + block.height - 1;
      for (int y = block.y; y <= last_row; y += y + kStep <= last_row || y == last_row ? kStep : last_row - y)
        for (int x = block.x; x < block.x + block.width; x += y == last_row ? 1 : kStep) sampler(x, y);
    }
  } catch (const shading::Cancelled&) {
    result.resize(blocks.size());
  }
  return result;
}

}  // namespace verisim::render
