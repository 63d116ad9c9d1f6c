#include "cli/settings/reading/ini.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/settings/reading/switches.h"
#include "cli/settings/text.h"
#include "tracer/base/whole_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

constexpr int kMaxNesting = 20;                  // INI files that name INI files
constexpr std::uintmax_t kMaxBytes = 16u << 20;  // of one INI file
thread_local int nesting = 0;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

// Takes words off the front of a line. Quotes of either kind keep spaces together and are removed.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  bool at_end() {
    skip_space();
    return text_.empty();
  }
  char peek() const { return text_.empty() ? '\0' : text_.front(); }
  std::string_view rest() const { return text_; }
  void skip_space() {
    while (!text_.empty() && is_space(text_.front())) text_.remove_prefix(1);
  }
  void skip(std::size_t count) { text_.remove_prefix(count); }

  // Up to a space outside quotes. With `commas` a comma ends the word, too.
  std::string word(bool commas = false) {
    std::string result;
    char quote = 0;
    while (!text_.empty()) {
      const char c = text_.front();
      if (quote) {
        if (c == quote)
          quote = 0;
        else
          result += c;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (is_space(c) || (commas && c == ',')) {
        break;
      } else {
        result += c;
      }
      text_.remove_prefix(1);
    }
    if (quote) throw OptionError(fmt::format("a quotation mark ({}) is not closed", quote));
    return result;
  }

  // The key of Key=Value at this place, or empty. Afterwards the value stands in front.
  std::string key() {
    std::size_t end = 0;
    while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_')) ++end;
    std::size_t equals = end;
    while (equals < text_.size() && (text_[equals] == ' ' || text_[equals] == '\t')) ++equals;
    if (end == 0 || equals == text_.size() || text_[equals] != '=') return "";
    std::string name(text_.substr(0, end));
    skip(equals + 1);
    while (!text_.empty() && (text_.front() == ' ' || text_.front() == '\t')) skip(1);
    return name;
  }

 private:
  std::string_view text_;
};

bool ends_with(std::string_view text, std::string_view ending) {
  return text.size() >= ending.size() && equal_ignoring_case(text.substr(text.size() - ending.size()), ending);
}

void set_or_include(Options& options, std::string_view key, std::string_view value) {
  if (equal_ignoring_case(key, "Include_Ini"))
    apply_ini_file(options, value);
  else
    set(options, key, value);
}

// A word that is neither switch nor Key=Value.
void apply_bare_word(Options& options, const std::string& word) {
  if (word.empty()) return;
  if (word.back() == '/')
    set(options, "Library_Path", word);
  else if (ends_with(word, ".pov"))
    set(options, "Input_File_Name", word);
  else
    apply_ini_file(options, word);
}

// The inside of Declare='NAME="text"' keeps its double quotes: only the outer pair goes.
std::string declare_value(Words& words) {
  const char quote = words.peek();
  if (quote != '"' && quote != '\'') {
    std::size_t end = 0;
    bool quoted = false;
    const std::string_view text = words.rest();
    while (end < text.size() && (quoted || !is_space(text[end]))) quoted ^= text[end++] == '"';
    std::string value(text.substr(0, end));
    words.skip(end);
    return value;
  }
  const std::size_t close = words.rest().find(quote, 1);
  if (close == std::string_view::npos) throw OptionError("Declare: a quotation mark is not closed");
  std::string value(words.rest().substr(1, close - 1));
  words.skip(close + 1);
  return value;
}

// One line of an INI file without its comment, or one argument. In an INI file everything after the first value is
// ignored.
void apply_words(Options& options, std::string_view line, bool from_file) {
  Words words(line);
  while (!words.at_end()) {
    if (words.peek() == '+' || words.peek() == '-') {
      const std::string word = words.word();
      if (word.size() < 2) throw OptionError(fmt::format("'{}' is no switch", word));
      apply_switch(options, word);
      continue;
    }
    const std::string key = words.key();
    if (key.empty()) {
      const std::string word = words.word();
      if (word.find('=') != std::string::npos) throw OptionError(fmt::format("'{}' is no Key=Value", word));
      if (from_file && !ends_with(word, ".pov") && !ends_with(word, ".ini") && word.find('[') == std::string::npos &&
          (word.empty() || word.back() != '/'))
        throw OptionError(fmt::format("'{}' is no setting", word));
      apply_bare_word(options, word);
      continue;
    }
    if (ends_with(key, "_Command")) {  // taken raw to the end of the line
      set(options, key, trim(words.rest()));
      return;
    }
    if (equal_ignoring_case(key, "Declare")) {
      set(options, key, declare_value(words));
    } else {
      const bool quoted = words.peek() == '"' || words.peek() == '\'';
      const std::string_view raw = words.rest();
      std::vector<std::string> values{words.word(true)};
      while (words.peek() == ',') {
        words.skip(1);
        words.skip_space();
        values.push_back(words.word(true));
      }
      if (from_file && !quoted && values.size() == 1 && !words.at_end()) {
        // Further words that are no setting belong to the value.
        Words ahead(words.rest());
        const std::string next = ahead.key();
        if (words.peek() != '+' && words.peek() != '-' && (next.empty() || !is_setting(next))) {
          values[0] = trim(raw);
          options.notes.push_back(
              fmt::format("{}={}: the value has spaces and should be in quotation marks", key, values[0]));
        }
      }
      for (const std::string& value : values) set_or_include(options, key, value);
    }
    if (from_file) return;
  }
}

std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == ';' || c == '#')
      return line.substr(0, i);
  }
  return line;
}

// An INI name is tried as it is only if it has an extension of one to three letters.
bool has_extension(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || name.find('/', dot) != std::string_view::npos) return false;
  const std::size_t letters = name.size() - dot - 1;
  return letters >= 1 && letters <= 3;
}

fs::path find_ini(const Options& options, const std::string& name) {
  std::vector<std::string> variants;
  if (has_extension(name)) variants.push_back(name);
  variants.push_back(name + ".ini");
  variants.push_back(name + ".INI");
  std::vector<fs::path> folders{fs::path()};
  if (fs::path(name).is_relative())
    for (const std::string& path : options.library_paths) folders.emplace_back(path);
  for (const fs::path& folder : folders)
    for (const std::string& variant : variants) {
      std::error_code ignored;
      if (fs::exists(folder / variant, ignored)) return folder / variant;
    }
  throw OptionError(fmt::format("cannot find the INI file '{}'", name));
}

}  // namespace

void apply_argument(Options& options, std::string_view argument) {
  // A name with spaces reaches us as one argument: an existing file is taken as it is.
  if (argument.find(' ') != std::string_view::npos && argument.find('=') == std::string_view::npos &&
      argument.front() != '+' && argument.front() != '-') {
    std::error_code ignored;
    if (fs::is_regular_file(fs::path(argument), ignored)) return apply_bare_word(options, std::string(argument));
  }
  apply_words(options, argument, false);
}

void apply_ini_file(Options& options, std::string_view name) {
  std::string file(name), section;
  if (!file.empty() && file.back() == ']')
    if (const std::size_t open = file.rfind('['); open != std::string::npos) {
      section = file.substr(open + 1, file.size() - open - 2);
      file.resize(open);
    }
  const fs::path path = find_ini(options, file);
  std::error_code error;
  if (fs::is_directory(path, error)) throw OptionError(fmt::format("'{}' is a folder, not an INI file", path.string()));
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) > kMaxBytes)
    throw OptionError(fmt::format("'{}' is too large for an INI file", path.string()));
  const std::optional<std::string> text = whole_file(path);
  if (!text) throw OptionError(fmt::format("cannot read the INI file '{}'", path.string()));
  if (nesting >= kMaxNesting)
    throw OptionError(
        fmt::format("INI files include each other more than {} deep at '{}'", kMaxNesting, path.string()));
  struct Nest {
    Nest() { ++nesting; }
    ~Nest() { --nesting; }
  } nest;
  apply_ini_text(options, *text, section, path.string());
}

void apply_ini_text(Options& options, std::string_view text, std::string_view section, std::string_view source) {
  bool active = true;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = trim(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (!line.empty() && line.front() == '[') {
      const std::size_t close = line.find(']');
      if (close == std::string_view::npos)
        throw OptionError(fmt::format("{}:{}: a section name without its ]", source, number));
      active = !section.empty() && equal_ignoring_case(trim(line.substr(1, close - 1)), section);
      continue;
    }
    if (!active) continue;
    try {
      // Commands keep what looks like a comment.
      Words words(line);
      const std::string key = words.key();
      line = ends_with(key, "_Command") ? line : trim(without_comment(line));
      if (!line.empty()) apply_words(options, line, true);
    } catch (const OptionError& error) {
      throw OptionError(fmt::format("{}:{}: {}", source, number, error.what()));
    }
  }
}

}  // namespace verisim::cli
