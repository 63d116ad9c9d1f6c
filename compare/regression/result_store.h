// The results of a run, kept beside its pictures, so that a run that was broken off goes on where it was.
#pragma once

#include "compare/regression/renders.h"

namespace verisim::compare {

MetricOptions metric_options(const SceneRequest& request);

class ResultStore {
 public:
  // Both outlive this.
  ResultStore(const RunOptions& options, const Renders& renders) : options_(options), renders_(renders) {}

  // Replaces `result` and returns true if the scene was judged before and nothing has changed since.
  bool resumed(const std::string& stem, SceneResult& result) const;
  void remember(const std::string& stem, const std::vector<std::filesystem::path>& files_read,
                const SceneResult& result) const;

 private:
  // A result is kept only while nothing has changed that decides it: the content of every file the scene reads, the
  // settings, and both programs.
  std::string resume_key(const SceneRequest& request, std::vector<std::filesystem::path> files_read) const;

  const RunOptions& options_;
  const Renders& renders_;
};

}  // namespace verisim::compare
