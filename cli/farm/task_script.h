// task.sh: what the tasks of a job do on their nodes, as a script of plain sh that people can read, change and run.
#pragma once

#include <string>

#include "cli/farm/job.h"

namespace verisim::cli {

// One word for sh, whatever is in it.
std::string shell_word(const std::string& text);

std::string task_script(const FarmJob& job);

}  // namespace verisim::cli
