// A picture that is the sum of several renders.
#pragma once

#include "compare/compare.h"

namespace verisim::compare {

// The scene as one of its passes: with the pass's switches, linear values without loss of range (OpenEXR), and no
// passes.
SceneRequest request_of_pass(const SceneRequest& scene, const Pass& pass);

// Sums passes: out of linear values comes a picture of 16 bits, clipped to 0..1 and sRGB encoded. Alpha is left out.
class PassSum {
 public:
  void add(const Picture& render, const Pass& pass);  // throws PictureMismatch when the renders differ in size
  Picture picture() const;

 private:
  int width_ = 0, height_ = 0;
  std::vector<double> sums_;
};

// OpenEXR (of half precision) for floats without alpha, PNG of 16 bits for what holds them, else of 8. Returns the path
// with its extension. Throws std::runtime_error.
std::filesystem::path keep_exactly(const Picture& picture, std::filesystem::path path_without_extension);

// As a PNG of 16 bits. Throws std::runtime_error.
void write_16_bits(const Picture& picture, const std::filesystem::path& path);

}  // namespace verisim::compare
