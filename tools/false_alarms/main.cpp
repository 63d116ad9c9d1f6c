// How often is the verdict on noisy scenes wrong? POV-Ray renders every scene several times with other numbers of
// threads; its pictures are compared with each other (false alarms), and with pictures brightened by a part of their
// mean (power), under the low-pass comparison, under Welch's test, and under the verdict, which either of them refuses.
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
  return compare::judge_stochastic(compare::measure(reference[0], test), false, compare::low_pass(reference[0], test),
                                   compare::low_pass(reference[0], reference[1]))
             .status == compare::Status::differ;
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
    Rate low_pass_alarms, low_pass_found, welch_alarms, welch_found, alarms, found, one_split;
    std::printf("%-60s %6s %12s %12s %12s %12s %12s %12s\n", "scene", "mean", "low pass: al.", "found", "Welch: al.",
                "found", "verdict: al.", "found");
    for (int i = 4; i < argc; ++i) {
      compare::SceneRequest scene;
      scene.scene = std::filesystem::absolute(argv[i]), scene.name = scene.scene.filename().string();
      scene.width = std::atoi(argv[1]), scene.height = std::atoi(argv[2]), scene.switches = {"-A"};
      std::vector<image::Picture> pictures;
      for (int run = 0; run < 2 * runs; ++run) {
        compare::OracleRender render = compare::run_oracle(povray, options, scene, run, {scene.scene});
        if (!render.ok) break;
        pictures.push_back(std::move(render.picture));
      }
      if (static_cast<int>(pictures.size()) < 2 * runs) {
        std::printf("%-60s POV-Ray failed\n", argv[i]);
        continue;
      }
      // Every way to divide the runs into two halves, each once. The first: even against odd variants of the oracle, as
      // `verisim compare --native povray` takes them.
      Rate scene_low_alarms, scene_low_found, scene_welch_alarms, scene_welch_found, scene_alarms, scene_found;
      std::vector<unsigned> splits;
      unsigned odd = 0;
      for (int run = 0; run < 2 * runs; run += 2) odd |= 1u << run;
      splits.push_back(odd);
      for (unsigned half = 0; half < 1u << (2 * runs); ++half)
        if (__builtin_popcount(half) == runs && (half & 1u) && half != odd) splits.push_back(half);
      for (unsigned half : splits) {
        std::vector<image::Picture> a, b, bright;
        for (int run = 0; run < 2 * runs; ++run)
          (half >> run & 1u ? a : b).push_back(pictures[static_cast<std::size_t>(run)]);
        for (const image::Picture& p : b) bright.push_back(brightened(p));
        const bool low = low_pass_refuses(a, b[0]), low_bright = low_pass_refuses(a, bright[0]);
        const bool rejected = compare::welch_test(a, b).rejected,
                   rejected_bright = compare::welch_test(a, bright).rejected;
        scene_low_alarms.count(low), scene_low_found.count(low_bright);
        scene_welch_alarms.count(rejected), scene_welch_found.count(rejected_bright);
        scene_alarms.count(low || rejected), scene_found.count(low_bright || rejected_bright);
        if (half == odd) one_split.count(low || rejected);
      }
      double mean = 0;
      for (float v : pictures[0].samples)
        mean += 255 * static_cast<double>(v) / static_cast<double>(pictures[0].samples.size());
      std::printf("%-60s %6.1f %10.1f %% %10.1f %% %10.1f %% %10.1f %% %10.1f %% %10.1f %%\n", scene.name.c_str(), mean,
                  scene_low_alarms.percent(), scene_low_found.percent(), scene_welch_alarms.percent(),
                  scene_welch_found.percent(), scene_alarms.percent(), scene_found.percent());
      std::fflush(stdout);
      for (auto [all, one] :
           {std::pair(&low_pass_alarms, &scene_low_alarms), std::pair(&low_pass_found, &scene_low_found),
            std::pair(&welch_alarms, &scene_welch_alarms), std::pair(&welch_found, &scene_welch_found),
            std::pair(&alarms, &scene_alarms), std::pair(&found, &scene_found)})
        all->tries += one->tries, all->hits += one->hits;
    }
    std::printf(
        "\n%d scenes, %d runs on each side. Low pass: %.2f %% false alarms, %.1f %% found. Welch: %.2f %%, %.1f %%. "
        "Verdict: %.2f %% (the first division, as the program takes it: %d of %d), %.1f %%.\n",
        one_split.tries, runs, low_pass_alarms.percent(), low_pass_found.percent(), welch_alarms.percent(),
        welch_found.percent(), alarms.percent(), one_split.hits, one_split.tries, found.percent());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "false_alarms: %s\n", error.what());
    return 1;
  }
}
