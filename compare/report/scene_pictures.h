// The pictures that a report shows of one scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/metrics/flip.h"
#include "compare/report/place.h"

namespace verisim::compare {

// Each has a key:
//   o n         the reference's picture and ours: 8 bits, without alpha
//   oa na       their alpha
//   to tn td    thumbnails of both and of their difference
//   of nf       16 bits a value, where 8 would not show the difference: above the high bytes, below them the low ones
//   flip ssim p maps: FLIP's error and 1 - SSIM as grey from 0 to 1; -log10 of p-values as grey from 0 to 10
class ScenePictures {
 public:
  // Reads the scene's files; one that went away is left out.
  explicit ScenePictures(const SceneResult& scene);

  const std::vector<std::string>& keys() const { return keys_; }
  bool same() const { return same_; }  // both look alike, and `n` stands for both
  const char* fine() const;            // what `of` and `nf` hold: "integer" (0..65535), "half" (floats); else null
  std::optional<Place> place() const { return place_; }
  std::optional<Exposures> exposures() const;  // of the map `flip`, when it is HDR-FLIP
  // A PNG file. Throws std::runtime_error for a key that there is not.
  std::string png(const std::string& key) const;

 private:
  void add(char side, const std::filesystem::path& path, Picture& exact, Picture& shown);
  void add_difference(const SceneResult& scene);
  Picture picture(const std::string& key) const;

  Picture reference_, test_;              // as they are; empty when they are shown reduced
  Picture shown_reference_, shown_test_;  // for people: 8 bits
  std::filesystem::path p_map_;
  std::vector<std::string> keys_;
  std::optional<Place> place_;
  bool same_ = false, fine_ = false;
  double pixels_per_degree_ = 0;
};

}  // namespace verisim::compare
