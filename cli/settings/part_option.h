// --part K/N and --part prepass: which part of a picture is rendered.
#pragma once

#include <string>

namespace verisim::cli {

struct PartChoice {
  bool any = false;        // something was chosen; else the whole picture is rendered
  bool prepasses = false;  // what comes before the picture, and no pixels
  int number = 1, of = 1;  // from 1

  std::string name() const;  // "part 3 of 12", "the prepasses"
};

// Throws OptionError.
PartChoice part_choice(const std::string& text);

}  // namespace verisim::cli
