// What POV-Ray's switches of a scene say that the comparison has to know (spec 02 section 9.6). The last one wins.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace verisim::compare {

// The value of a switch or INI key that is a boolean: "+A0.3", "-A", "Antialias=on".
bool switch_on(const std::vector<std::string>& switches, char letter, const std::string& ini_key);
bool alpha_on(const std::vector<std::string>& switches);  // +UA, Output_Alpha

// The letter of +F, 'N' for PNG; empty when nothing is said.
std::optional<char> output_type(const std::vector<std::string>& switches);
std::string output_extension(const std::vector<std::string>& switches);  // ".png" by default

// One line of switches as a shell would split it: blanks outside of quotes divide. Throws std::invalid_argument for an
// open quote.
std::vector<std::string> split_switches(const std::string& line);

// The picture type of a scene that names none: PNG of 16 bits, in which a difference below one code value of 8 bits can
// be told from rounding.
inline constexpr const char* kFinePicture = "+FN16";

}  // namespace verisim::compare
