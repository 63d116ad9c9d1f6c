// The stable codes of diagnostics: what a message is about, by a name that searches, switches and reports can rely on.
// `verisim check --explain CODE` prints the entry; a test runs the examples of each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace verisim::parser {

enum class Code : std::uint8_t {
  // clang-format off
  // the text of a file
  illegal_character, unterminated_string, unterminated_comment, bad_number, bad_escape, non_ascii,
  // structure
  unexpected_token, unclosed_block, unclosed_condition, stray_branch, unknown_directive, missing_semicolon,
  missing_hash, misplaced_directive, misplaced_keyword,
  // names
  undeclared_identifier, reserved_word, redeclared, no_value, deprecated, unknown_undef,
  // arrays, macros, functions
  not_an_array, array_size, subscript_range, array_type, macro_arguments, function_arguments, function_syntax,
  // types and numbers
  wrong_type, wrong_terms, divide_by_zero, domain_error,
  // values
  bad_value, adjusted_value, degenerate, too_few, too_many, not_closed,
  // blocks
  missing_item, incompatible, duplicate, no_effect, discontinued, experimental,
  // files
  missing_include, missing_file, file_access, file_failed, bad_file,
  // the scene
  missing_version, late_version, version_limits, missing_gamma, no_objects, no_camera, no_light, camera_inside,
  // what the scene itself says
  user_error, user_warning,
  // limits of verisim
  nesting_limit, size_limit, time_limit, unsupported, internal,
  // clang-format on
  count
};

struct CodeEntry {
  Code code;
  std::string_view name;   // kebab-case; never changes
  std::string_view title;  // one line
  std::string_view text;   // what it means and what to do
  std::string_view wrong;  // SDL that gives it; empty: it cannot be shown in a few lines
  std::string_view right;  // the same without the mistake
};

// Every entry, in the order of the enumeration.
std::span<const CodeEntry> all_codes();
const CodeEntry& entry(Code code);
std::string_view name(Code code);
std::optional<Code> code_named(std::string_view name);
// The entry as text for a terminal.
std::string explanation(const CodeEntry& entry);

}  // namespace verisim::parser
