#include "compare/reduce/messages.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace verisim::compare {
namespace {

using Kind = Difference::Kind;

constexpr const char* kOwn[] = {"experimental feature", "#version", "assumed_gamma", "language version",
                                "default gamma"};

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// POV-Ray's parser says its part between a headline and the next rule; verisim has no headlines in its own style.
std::string of_parser(const std::string& console) {
  const std::size_t head = console.find("==== [Parsing...]");
  if (head == std::string::npos) return console;
  const std::size_t begin = std::min(console.find('\n', head), console.size());
  return console.substr(begin, std::min(console.find("\n----", begin), console.find("\n==== [", begin)) - begin);
}

// "16 by 12: parsed in 0.00 s, ..."
bool is_summary(const std::string& line) { return line.find(" by ") < 8 && line.find(": parsed in ") < 20; }

// Words in small letters; what is quoted and numbers are not among them.
std::vector<std::string> plain_words(const std::string& text) {
  std::vector<std::string> out;
  std::string word;
  bool quoted = false;
  for (const char c : text + " ") {
    if (c == '\'' || c == '"') quoted = !quoted;
    if (!quoted && std::isalpha(static_cast<unsigned char>(c)))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!word.empty())
      out.push_back(std::exchange(word, {}));
  }
  return out;
}

std::size_t common_words(const std::string& a, const std::string& b) {
  const std::vector<std::string> left = plain_words(a), right = plain_words(b);
  const std::set<std::string> known(left.begin(), left.end());
  return static_cast<std::size_t>(std::ranges::count_if(std::set<std::string>(right.begin(), right.end()),
                                                        [&](const std::string& word) { return known.contains(word); }));
}

// Each once.
std::vector<std::string> not_in(const std::vector<std::string>& those, const std::vector<std::string>& others) {
  std::vector<std::string> out;
  for (const std::string& warning : those) {
    const auto same = [&](const std::string& other) { return same_warning(warning, other); };
    if (std::ranges::none_of(others, same) && std::ranges::none_of(out, same)) out.push_back(warning);
  }
  return out;
}

// Those of the longer list to which nothing in the shorter one corresponds.
std::vector<std::string> unmatched(std::vector<std::string> more, const std::vector<std::string>& fewer) {
  for (const std::string& other : fewer)
    more.erase(
        std::ranges::max_element(more, {}, [&](const std::string& warning) { return common_words(warning, other); }));
  return more;
}

}  // namespace

bool same_warning(const std::string& a, const std::string& b) { return plain_words(a) == plain_words(b); }

bool is_of_messages(Kind kind) {
  return kind == Kind::verisim_warns || kind == Kind::povray_warns || kind == Kind::debug_text;
}

Messages messages_of(const std::string& console) {
  Messages out;
  enum class In { debug, warning, excerpt } in = In::debug;  // a warning of POV-Ray goes on in lines that are indented
  std::istringstream lines(of_parser(console));
  for (std::string line; std::getline(lines, line);) {
    if (const auto cr = line.find_last_of('\r'); cr != std::string::npos) line.erase(0, cr + 1);
    if (line.empty() || is_summary(line)) continue;
    std::size_t text = std::string::npos;
    for (const char* mark : {"Parse Warning: ", "Possible Parse Error: ", ": warning: ", ": possible error: "})
      if (const std::size_t at = line.find(mark); at != std::string::npos && text == std::string::npos)
        text = at + std::string_view(mark).size(), in = mark[0] == ':' ? In::excerpt : In::warning;
    if (text != std::string::npos) {
      const std::size_t code = in == In::excerpt ? line.rfind(" [") : std::string::npos;
      out.warnings.push_back(line.substr(text, code == std::string::npos ? code : code - text));
    } else if (line[0] == ' ' && in != In::debug) {
      if (in == In::warning) out.warnings.back() += line;
    } else {
      in = In::debug;
      std::ranges::copy_if(line, std::back_inserter(out.debug), [](char c) { return !is_blank(c); });
    }
  }
  std::erase_if(out.warnings, [](const std::string& warning) {
    return std::ranges::any_of(kOwn, [&](const char* own) { return warning.find(own) != std::string::npos; });
  });
  return out;
}

Difference message_difference(const Messages& ours, const Messages& theirs, const Difference* wanted) {
  Difference out;
  const std::vector<std::string> mine = not_in(ours.warnings, theirs.warnings),
                                 foreign = not_in(theirs.warnings, ours.warnings);
  if (mine.size() != foreign.size()) {
    const bool we = mine.size() > foreign.size();
    const std::vector<std::string> left = we ? unmatched(mine, foreign) : unmatched(foreign, mine);
    const auto known =
        std::ranges::find_if(left, [&](const std::string& w) { return wanted && same_warning(w, wanted->message); });
    out.kind = we ? Kind::verisim_warns : Kind::povray_warns;
    out.message = known == left.end() ? left.front() : *known;
    if (!wanted || wanted->kind == out.kind) return out;
  }
  if (!ours.debug.starts_with(theirs.debug)) {
    constexpr std::size_t kLong = 60;
    const auto at = static_cast<std::size_t>(std::ranges::mismatch(ours.debug, theirs.debug).in1 - ours.debug.begin());
    out.kind = Kind::debug_text;
    out.message = "'" + theirs.debug.substr(at, kLong) + "' in POV-Ray, '" + ours.debug.substr(at, kLong) + "' here";
  }
  return out;
}

}  // namespace verisim::compare
