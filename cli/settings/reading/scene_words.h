// The words of `render`, `check`, `explain`: one scene, and switches, settings and INI files in POV-Ray's style.
#pragma once

#include <string>
#include <vector>

#include "cli/settings/options.h"

namespace verisim::cli {

// True for a word that is a setting rather than a file to work on: +W320, Width=320, quick.ini[small], lib/.
bool is_setting_word(const std::string& word);

// For commands that take folders of scenes: `scenes/` names one there, not a place to look for include files as in
// POV-Ray's style. Returns the words with such names as `scenes`.
std::vector<std::string> with_folders(std::vector<std::string> words);

// Applies the configuration and then the words left to right; returns the words that name files.
std::vector<std::string> apply_words(Options& options, const std::vector<std::string>& words);

// The picture's type follows its name's extension unless a switch chose one. Throws OptionError for an extension that
// is no picture type.
void choose_format(Options& options);
// +F or Output_File_Type was given.
bool format_chosen(const Options& options);

}  // namespace verisim::cli
