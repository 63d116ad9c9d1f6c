// The smallest scene that shows what a scene shows: where verisim and POV-Ray differ.
//
//   compare::ReduceOptions options;
//   options.native = compare::native_program("/usr/bin/verisim");
//   compare::Reduction small = compare::reduce_scene(compare::load_suite({"scene.pov"}).scenes[0], options);
#pragma once

#include "compare/compare.h"
#include "compare/reduce/examiner.h"

namespace verisim::compare {

struct ReduceProgress {
  std::size_t lines_before = 0, lines = 0;  // of the scene, and of the best so far
  std::size_t tried = 0;                    // candidates
  double seconds = 0;
};

struct ReduceOptions {
  NativeRenderer native;
  OracleOptions oracle;
  bool replay = false;
  double seconds = 60;  // for all; the best so far is the result
  std::function<void(const ReduceProgress&)> progress;
  std::atomic<bool>* cancel = nullptr;
};

struct Reduction {
  Difference difference;  // of the whole scene; none or undecided: nothing was reduced
  Difference left;        // of the reduced one
  std::string text;       // the reduced scene
  Frame frame;            // in which it shows the difference
  bool replay = false;    // it shows it only with the same random numbers on both sides
  bool random = false;    // and without those the scene differs from one run to the next
  bool complete = false;  // there was time for everything
  std::size_t lines_before = 0, lines = 0, tried = 0;
  double seconds = 0;
};

// Of the text laid out with a statement a line, without comments.
std::size_t lines_of_code(const std::string& text);

// Include files in the scene's folder become part of the text where that helps to make it smaller; those of libraries
// stay, as do images, fonts and other files. Throws OracleMissing, and std::runtime_error for a scene that cannot be
// read or whose folder cannot be copied.
Reduction reduce_scene(const SceneRequest& scene, const ReduceOptions& options);

}  // namespace verisim::compare
