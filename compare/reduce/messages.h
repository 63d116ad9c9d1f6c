// What programs say of a scene that they draw: warnings, and what #debug writes.
#pragma once

#include <string>
#include <vector>

#include "compare/reduce/examiner.h"

namespace verisim::compare {

struct Messages {
  std::vector<std::string> warnings;  // without their places; possible errors, too
  std::string debug;                  // without blanks and line ends: POV-Ray breaks long lines
};

// Of POV-Ray's console, or verisim's in either style. What each program has to say by intent (experimental features,
// the gamma of scenes that set none) is left out.
Messages messages_of(const std::string& console);

// What one says and the other does not. Each has words of its own: as long as both warn of equally many things that
// the other does not know, they warn of the same ones. `wanted`: what is looked for, if there are several. POV-Ray
// leaves out the end of a #debug text that no line end follows.
Difference message_difference(const Messages& ours, const Messages& theirs, const Difference* wanted = nullptr);

bool is_of_messages(Difference::Kind kind);
// Of the same thing, whatever names and numbers are in it.
bool same_warning(const std::string& a, const std::string& b);

}  // namespace verisim::compare
