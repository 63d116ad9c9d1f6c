// Into how many tasks a render is cut: what each of them repeats against what it gets done (docs/farm.md has the model
// and its figures).
#pragma once

#include "cli/frame/job.h"

namespace verisim::cli {

// Seconds by the clock, on a machine like this one.
struct Costs {
  double start = 1;    // of a task, until verisim runs, and after it
  double parse = 0;    // of a frame or part: reading the scene, and its box trees
  double picture = 0;  // of a frame: the pixels; 0: nobody knows
};

// Renders some blocks from all over the picture, for at most ten seconds. Throws what a render throws.
Costs measure_costs(const Job& job, const scene::Scene& scene, double seconds_parse);

// A task shall last a minute, and ten times as long as what it repeats; of `nodes` (0: nobody knows how many) each
// shall have four tasks, if they are not too small then.
int parts_for(const Costs& costs, int blocks, int nodes);
int frames_per_task_for(const Costs& costs, int frames, int nodes);

}  // namespace verisim::cli
