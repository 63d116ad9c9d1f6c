// A review of what changed against stored pictures: each scene is accepted or refused, with a note, and only what was
// accepted is stored. Decisions are kept in the run's folder (review.json), each with the picture it was made on.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/regression/run_folder.h"

namespace verisim::compare {

struct Decision {
  bool accepted = false, stored = false;
  std::string note, picture;  // picture: a hash of its content
};

class Review {
 public:
  // Reads the run in the folder and what was decided on it; a decision on another picture than there is now does not
  // count. `baseline`: stored pictures elsewhere than where the run found them; without it those, if they
  // are there (baseline.json). Throws std::runtime_error.
  explicit Review(const std::filesystem::path& folder, const std::filesystem::path& baseline = {});

  const Run& run() const { return kept_.run; }
  const std::filesystem::path& baseline() const { return kept_.baseline; }
  // {"baseline", "decisions": {scene: {"decision": "accepted" or "refused", "note", "stored"}}}
  nlohmann::json state() const;

  // "accepted", "refused", or "open" to take it back; written at once. Throws std::runtime_error for a scene that there
  // is not, that did not change or has no picture to accept.
  void decide(const std::string& scene, const std::string& decision, const std::string& note);
  // Stores the accepted pictures with their notes; returns one line for each. Throws std::runtime_error.
  std::vector<std::string> store();

  struct Left {
    int undecided = 0, refused = 0, not_stored = 0;  // not_stored: accepted, but not stored yet
    bool any() const { return undecided + refused + not_stored > 0; }
  };
  Left left() const;
  // For a pull request. Pictures of reference, change and difference side by side are written into the folder beside
  // `file`, which is named after it. Throws std::runtime_error.
  void write_markdown(const std::filesystem::path& file) const;

 private:
  const SceneResult& changed(const std::string& scene) const;
  void write() const;

  std::filesystem::path folder_;
  KeptRun kept_;
  std::map<std::string, Decision> decisions_;
};

}  // namespace verisim::compare
