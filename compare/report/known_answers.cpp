#include "compare/report/known_answers.h"

#include <fmt/format.h>

#include <cmath>

namespace verisim::compare {
namespace {

// -1: the reference is nearer, 1: the judged one is. A step of 16 bits tells nothing.
int nearer(const SceneResult& s) {
  constexpr double kSame = 2e-5, kSamePart = 0.01;
  const double theirs = s.oracle_truth->max, ours = s.native_truth->max;
  if (std::fabs(theirs - ours) <= std::max(kSame, kSamePart * std::max(theirs, ours))) return 0;
  return ours < theirs ? 1 : -1;
}

}  // namespace

std::string known_answer(const SceneResult& s, const Run& run) {
  if (!s.oracle_truth || !s.native_truth) return "";
  const int who = nearer(s);
  return fmt::format("off the known answer by {:.5f} ({}) and {:.5f} ({}): {}", s.native_truth->max, run.test_name,
                     s.oracle_truth->max, run.reference_name,
                     who == 0 ? "both are as near" : (who > 0 ? run.test_name : run.reference_name) + " is nearer");
}

std::string known_answers(const Run& run) {
  int count[3] = {};
  for (const SceneResult& s : run.scenes)
    if (s.oracle_truth && s.native_truth) ++count[nearer(s) + 1];
  if (count[0] + count[1] + count[2] == 0) return "";
  return fmt::format("known answers: {} is nearer in {} {}, {} in {}, both are as near in {}", run.test_name, count[2],
                     count[2] == 1 ? "scene" : "scenes", run.reference_name, count[0], count[1]);
}

}  // namespace verisim::compare
