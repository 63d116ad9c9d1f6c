// The verdict on one scene of a run: its two pictures by the rules of its class, and what speaks against it.
#pragma once

#include "compare/verdict/verdict.h"
#include "compare/regression/renders.h"

namespace verisim::compare {

class Judge {
 public:
  // Both outlive this.
  Judge(const RunOptions& options, const Renders& renders) : options_(options), renders_(renders) {}

  // Fills in status, reason, metrics and whatever else the rules ask for. `files_read`: for further references.
  void judge(const SceneRequest& request, const std::string& stem, const Picture& reference,
             const std::vector<std::filesystem::path>& files_read, SceneResult& result) const;
  // Against the mean and the deviation that were stored of several runs: one render is enough, unless it is refused;
  // then, and where none are stored yet, they are made anew, for an update. False when ours failed.
  bool stored_noise(const SceneRequest& request, const std::string& stem, const Picture& native, SceneResult& result,
                    Verdict& verdict) const;
  void keep_picture(const Picture& picture, const std::string& stem, const char* side,
                    std::filesystem::path& kept) const;

 private:
  void leave_out(const SceneRequest& request, Picture& oracle, Picture& native) const;
  // What passes is asked object by object: a small one shows in no figure of the whole picture.
  Verdict judge_leaning(const SceneRequest& request, const Picture& oracle, const Picture& native,
                        const Verdict& verdict, SceneResult& result) const;
  // Of a scene that differs from POV-Ray's picture: whether that is the same in another run. What another run passes is
  // a match.
  Verdict judge_again(const SceneRequest& request, const Picture& oracle, const Picture& native,
                      const std::vector<std::filesystem::path>& files_read, const Verdict& verdict,
                      SceneResult& result) const;
  // False when the oracle failed.
  bool judge_noise(const SceneRequest& request, const std::string& stem, const Picture& oracle, const Picture& native,
                   const std::vector<std::filesystem::path>& files_read, SceneResult& result, Verdict& verdict) const;
  void write_p_map(const std::vector<float>& p, const Picture& shape, const std::string& stem,
                   SceneResult& result) const;
  bool more_references(const SceneRequest& request, const std::vector<std::filesystem::path>& files_read, int runs,
                       std::vector<Picture>& references, SceneResult& result) const;
  bool more_tests(const SceneRequest& request, const std::string& stem, int runs, std::vector<Picture>& tests,
                  SceneResult& result, Verdict& verdict) const;
  // What the pixels of a scene show, by one of the two programs.
  std::optional<PixelTags> tags_by(const TagSource& source, const SceneRequest& request,
                                   const std::vector<std::pair<int, int>>& trees, SceneResult& result) const;
  void find_causes(const SceneRequest& request, const Picture& oracle, const Picture& native,
                   SceneResult& result) const;

  const RunOptions& options_;
  const Renders& renders_;
};

}  // namespace verisim::compare
