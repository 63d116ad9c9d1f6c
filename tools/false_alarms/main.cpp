// How often is the verdict on noisy scenes wrong? POV-Ray renders every scene several times with other numbers of threads; its pictures are compared with each other (false alarms), and
// with pictures brightened by a part of their mean (power), under both rules: the low-pass comparison and Welch's test.
//
//   false_alarms WIDTH HEIGHT RUNS SCENE...        RUNS on each side
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "compare/compare.h"

namespace {

using namespace verisim;

constexpr double kBrighter = 0.02;

// Adds the part of the picture's mean to every value, as an 8-bit file would hold it.
image::Picture brightened(image::Picture picture) {
  double sum = 0;
  for (float v : picture.samples) sum += v;
  const double add = kBrighter * sum / static_cast<double>(picture.samples.size());
  for (float& v : picture.samples) v = static_cast<float>(std::round(255 * std::min(1.0, v + add)) / 255);
  return picture;
}

struct Rate {
  int tries = 0, hits = 0;
  void count(bool hit) { ++tries, hits += hit; }
  double percent() const { return tries ? 100.0 * hits / tries : 0; }
};

bool low_pass_refuses(const std::vector<image::Picture>& reference, const image::Picture& test) {
  return compare::judge_stochastic(compare::measure(reference[0], test), false, compare::low_pass(reference[0], test), compare::low_pass(reference[0], reference[1])).status ==
         compare::Status::differ;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "false_alarms WIDTH HEIGHT RUNS SCENE...\n");
    return 2;
  }
  const int runs = std::max(2, std::atoi(argv[3]));
  try {
    compare::OracleOptions options;
    const compare::OracleProgram povray = compare::find_oracle(options);
    Rate low_pass_alarms, low_pass_found, welch_alarms, welch_found, one_split;
    std::printf("%-60s %6s %12s %12s %12s %12s\n", "scene", "mean", "low pass: al.", "found", "Welch: al.", "found");
    for (int i = 4; i < argc; ++i) {
      compare::SceneRequest scene;
      scene.scene = std::filesystem::absolute(argv[i]), scene.name = scene.scene.filename().string();
      scene.width = std::atoi(argv[1]), scene.height = std::atoi(argv[2]), scene.switches = {"-A"};
      std::vector<image::Picture> pictures;
      for (int run = 0; run < 2 * runs; ++run) {
        compare::OracleRender render = compare::run_oracle(povray, options, scene, 1 + run, {scene.scene});
        if (!render.ok) break;
        pictures.push_back(std::move(render.picture));
      }
      if (static_cast<int>(pictures.size()) < 2 * runs) {
        std::printf("%-60s POV-Ray failed\n", argv[i]);
        continue;
      }
      // Every way to divide the runs into two halves, each once. The first: odd against even numbers of threads, as `verisim compare --runs` takes them.
      Rate scene_low_alarms, scene_low_found, scene_welch_alarms, scene_welch_found;
      std::vector<unsigned> splits;
      unsigned odd = 0;
      for (int run = 0; run < 2 * runs; run += 2) odd |= 1u << run;
      splits.push_back(odd);
      for (unsigned half = 0; half < 1u << (2 * runs); ++half)
        if (__builtin_popcount(half) == runs && (half & 1u) && half != odd) splits.push_back(half);
      for (unsigned half : splits) {
        std::vector<image::Picture> a, b, bright;
        for (int run = 0; run < 2 * runs; ++run) (half >> run & 1u ? a : b).push_back(pictures[static_cast<std::size_t>(run)]);
        for (const image::Picture& p : b) bright.push_back(brightened(p));
        scene_low_alarms.count(low_pass_refuses(a, b[0])), scene_low_found.count(low_pass_refuses(a, bright[0]));
        const bool rejected = compare::welch_test(a, b).rejected;
        scene_welch_alarms.count(rejected), scene_welch_found.count(compare::welch_test(a, bright).rejected);
        if (half == odd) one_split.count(rejected);
      }
      double mean = 0;
      for (float v : pictures[0].samples) mean += 255 * static_cast<double>(v) / static_cast<double>(pictures[0].samples.size());
      std::printf("%-60s %6.1f %10.1f %% %10.1f %% %10.1f %% %10.1f %%\n", scene.name.c_str(), mean, scene_low_alarms.percent(), scene_low_found.percent(), scene_welch_alarms.percent(),
                  scene_welch_found.percent());
      std::fflush(stdout);
      for (auto [all, one] : {std::pair(&low_pass_alarms, &scene_low_alarms), std::pair(&low_pass_found, &scene_low_found), std::pair(&welch_alarms, &scene_welch_alarms),
                              std::pair(&welch_found, &scene_welch_found)})
        all->tries += one->tries, all->hits += one->hits;
    }
    std::printf("\n%d scenes, %d runs on each side. Low pass: %.2f %% false alarms, %.1f %% found. Welch: %.2f %% false alarms (odd against even threads: %d of %d), %.1f %% found.\n", one_split.tries,
                runs, low_pass_alarms.percent(), low_pass_found.percent(), welch_alarms.percent(), one_split.hits, one_split.tries, welch_found.percent());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "false_alarms: %s\n", error.what());
    return 1;
  }
}
