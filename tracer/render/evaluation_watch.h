// What goes wrong while functions and textures are evaluated on a thread of a render: its limits, or a request to stop.
#pragma once

#include "tracer/functions/evaluation_budget.h"

namespace verisim::render {

// What a thread evaluates while it lives: functions and textures may be asked by native code, so they note what is
// wrong and throw nothing.
class EvaluationWatch {
 public:
  // `cancel` may be null; once it is set, functions come to an end soon.
  explicit EvaluationWatch(const std::atomic<bool>* cancel);
  // Throws what was noted since it was made or last asked.
  void check() const;

 private:
  const std::atomic<bool>* cancel_;
  functions::EvaluationBudget::EndsAt end_;
};

}  // namespace verisim::render
