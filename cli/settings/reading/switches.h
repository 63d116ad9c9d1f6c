// POV-Ray's settings as data: every INI keyword with its type and place in Options, every switch with the keywords it
// sets (spec 02 section 9.6).
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "cli/settings/options.h"

namespace verisim::cli {

// A keyword that POV-Ray accepts and that changes nothing in a picture; the reason is for the curious (and the manual).
struct NoEffect {
  std::string_view reason;
};
using Handler = void (*)(Options&, std::string_view value);
using Target = std::variant<bool Options::*, int Options::*, double Options::*, std::string Options::*,
                            std::optional<int> Options::*, std::optional<double> Options::*, Handler, NoEffect>;

// What settings are about: the sections of the help.
enum class Topic { scene, size, output, quality, speed, animation, messages, commands, ignored };

struct Setting {
  std::string_view key;  // the INI keyword
  Target target;
  Topic topic;
  std::string_view value;    // what stands for the value in the help; empty: on or off
  std::string_view meaning;  // with the default in parentheses; empty: the reason of NoEffect
};

struct Switch {
  std::string_view name;       // what stands after + or -
  std::string_view value_key;  // keyword that takes the rest of the word; empty: the rest must be empty
  std::string_view flag_key;   // keyword that takes on for + and off for -; may be empty
};

std::span<const Setting> settings();
std::span<const Switch> switches();  // in order of search

// One `Key=Value`. Throws OptionError: unknown key (with advice), value that is no number.
void set(Options& options, std::string_view key, std::string_view value);
// True if the keyword exists, in any case of letters.
bool is_setting(std::string_view key);
// True if a picture's file or pixels can hang on the keyword's value: not on messages, threads, or which frames of an
// animation are made by this call.
bool decides_picture(std::string_view key);
// One word that begins with + or -, quotes removed from its value (spec 02 section 9.3). Throws OptionError.
void apply_switch(Options& options, std::string_view word);
// What +F takes, as in +FN16 or +FPg: the letter, then g or the bits. Output_File_Type takes the letter alone.
void output_switch(Options& options, std::string_view value);

}  // namespace verisim::cli
