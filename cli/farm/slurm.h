// Slurm as an engine, by its commands sbatch, squeue, sacct and scancel: no library, no root, no database.
//
// Jobs are known by their names: KEY-prepass, KEY-merge, and KEY-0, KEY-1000 ... for arrays of a thousand tasks
// (MaxArraySize is 1001 where nobody changed it), so nothing is lost when somebody dies between asking Slurm and
// writing down its answer.
#pragma once

#include "cli/farm/engine.h"

namespace verisim::cli {

std::unique_ptr<Engine> slurm_engine();

// A time limit in Slurm's spelling (minutes, m:s, h:m:s, d-h, d-h:m, d-h:m:s) in seconds; nothing for what is none.
std::optional<long> slurm_seconds(const std::string& text);
// Numbers as the option --array has them: 1-5,7. They ascend.
std::string slurm_ranges(const std::vector<int>& numbers);

}  // namespace verisim::cli
