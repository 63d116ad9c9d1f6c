// Whether, and how, verisim and POV-Ray differ on a text.
#pragma once

#include <semaphore>

#include "compare/compare.h"

namespace verisim::compare {

// What is different, as far as two candidates must agree to show the same difference.
struct Difference {
  enum class Kind : std::uint8_t {
    none,
    undecided,  // a program came to no end
    picture,
    only_verisim,  // draws what POV-Ray refuses
    only_povray,   // draws what verisim refuses
    unsupported,   // by verisim
    verisim_crashes,
    povray_crashes,  // where verisim does not
    verisim_warns,   // of something that POV-Ray does not warn of; the pictures are the same, or do not matter
    povray_warns,    // and the reverse
    debug_text,      // of #debug is another
  };
  Kind kind = Kind::none;
  std::size_t pixels = 0;  // that differ by more than `limit` code values
  double limit = 1, largest = 0;
  std::string message;  // of who refuses or crashes; of none: POV-Ray's, where both refuse
  int x = 0, y = 0;     // the worst pixel where most of them are
};

// The same kind; of pictures, not a few pixels in the place of many, nor last bits in the place of surfaces; else the
// same message, whatever names and numbers are in it.
bool same_difference(const Difference& whole, const Difference& candidate);
// "12 pixels differ, by up to 31.5 code values", "only verisim draws it; POV-Ray: ..."
std::string in_words(const Difference& difference);
// Of two pictures of one size; beyond one code value or, if no pixel is, by the least that is no rounding.
Difference picture_difference(const Picture& reference, const Picture& test);

// How large the picture is, and which part of it is drawn.
struct Frame {
  int width = 160, height = 120;
  std::vector<std::string> switches;
};

struct Examination {
  Difference difference;
  double native_seconds = 0, oracle_seconds = 0;  // CPU time
  bool random = false;                            // the scene has random elements
};

class Examiner {
 public:
  Examiner(SceneRequest scene, NativeRenderer native, OracleOptions oracle, std::atomic<bool>* cancel);

  // A file of the scene's folder has the text meanwhile: a private copy of that folder. `wanted`: what the scene is
  // known to show; POV-Ray is asked only where that is still possible. Thread safe. Throws std::runtime_error when the
  // folder cannot be copied.
  Examination examine(const std::string& text, const Frame& frame, bool replay, double time_limit,
                      const Difference* wanted = nullptr);
  const OracleProgram& oracle() const { return oracle_program_; }

 private:
  NativeResult native(const std::string& text, const Frame& frame, bool replay, double time_limit, Picture& picture);
  NativeResult povray(const std::string& text, const Frame& frame, double time_limit, Picture& picture);
  Difference said(const std::string& text, const Frame& frame, double time_limit, const NativeResult& native,
                  NativeResult oracle, const Difference* wanted);

  SceneRequest scene_;
  NativeRenderer native_;
  OracleOptions oracle_;
  OracleProgram oracle_program_;
  std::atomic<bool>* cancel_;
  std::counting_semaphore<> cores_;  // POV-Ray sleeps, verisim computes
};

}  // namespace verisim::compare
