#include "parser/source/suggest.h"

#include <algorithm>
#include <cctype>

#include "parser/source/source.h"

namespace verisim::parser {
namespace fs = std::filesystem;
namespace {

bool is_name_char(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

void skip_blanks(std::string_view text, std::size_t& i) {
  while (i < text.size() && std::isspace(static_cast<unsigned char>(text[i]))) ++i;
}

std::string_view read_name(std::string_view text, std::size_t& i) {
  const std::size_t start = i;
  while (i < text.size() && is_name_char(text[i])) ++i;
  return text.substr(start, i - start);
}

bool declares(std::string_view text, std::string_view name) {
  for (std::size_t i = text.find('#'); i != std::string_view::npos; i = text.find('#', i)) {
    skip_blanks(text, ++i);
    const std::string_view directive = read_name(text, i);
    if (directive != "declare" && directive != "macro") continue;
    skip_blanks(text, i);
    if (read_name(text, i) == name) return true;
  }
  return false;
}

// Directives of other languages, and what SDL calls them; `same`: they mean exactly that.
struct Foreign {
  std::string_view word, directive;
  bool same;
};
constexpr Foreign kForeign[] = {
    {"elif", "elseif", true},     {"elsif", "elseif", true},   {"elseif", "elseif", true}, {"endif", "end", true},
    {"endmacro", "end", true},    {"endwhile", "end", true},   {"endfor", "end", true},    {"fi", "end", true},
    {"define", "declare", false}, {"set", "declare", false},   {"let", "declare", false},  {"var", "declare", false},
    {"import", "include", true},  {"print", "debug", false},   {"echo", "debug", false},   {"printf", "debug", false},
    {"warn", "warning", true},    {"fail", "error", true},     {"foreach", "for", false},  {"function", "macro", false},
    {"def", "macro", false},      {"undefine", "undef", true}, {"global", "declare", true}};

constexpr std::string_view kDirectiveNames[] = {
    "break",  "case",       "debug",  "declare", "default", "else",    "elseif", "end",   "error", "fclose",
    "fopen",  "for",        "if",     "ifdef",   "ifndef",  "include", "local",  "macro", "range", "read",
    "render", "statistics", "switch", "undef",   "version", "warning", "while",  "write"};

}  // namespace

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

int edit_distance(std::string_view a, std::string_view b, int limit) {
  const auto gap = static_cast<int>(a.size()) - static_cast<int>(b.size());
  if (gap > limit || -gap > limit || a.size() > 255 || b.size() > 255) return limit + 1;
  // In half units, so that a letter of the other case costs half an edit.
  std::vector<int> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(2 * j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = static_cast<int>(2 * i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const char p = a[i - 1], q = b[j - 1];
      const int change = p == q ? 0
                         : std::tolower(static_cast<unsigned char>(p)) == std::tolower(static_cast<unsigned char>(q))
                             ? 1
                             : 2;
      next[j] = std::min({row[j] + 2, next[j - 1] + 2, row[j - 1] + change});
      if (i > 1 && j > 1 && p == b[j - 2] && a[i - 2] == q) next[j] = std::min(next[j], before[j - 2] + 2);
    }
    std::swap(before, row);
    std::swap(row, next);
  }
  return std::min((row[b.size()] + 1) / 2, limit + 1);
}

std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates) {
  int limit = name.size() <= 3 ? 1 : name.size() <= 7 ? 2 : 3;
  std::string_view best;
  for (const std::string_view candidate : candidates) {
    if (candidate == name || candidate.size() < 2) continue;
    const int distance = edit_distance(name, candidate, limit);
    if (distance > limit) continue;
    best = candidate;
    limit = distance - 1;
    if (limit < 0) break;
  }
  return best;
}

MeantDirective meant_directive(std::string_view word) {
  const std::string lower = lowered(word);
  MeantDirective meant;
  for (const std::string_view directive : kDirectiveNames)
    if (lower == directive) meant = {directive, MeantDirective::Why::case_, true};
  for (const Foreign& foreign : kForeign)
    if (lower == foreign.word) meant = {foreign.directive, MeantDirective::Why::foreign, foreign.same};
  if (meant.directive.empty()) meant.directive = nearest(lower, kDirectiveNames);
  constexpr std::string_view kOpeners[] = {"for", "if", "ifdef", "ifndef", "macro", "switch", "while"};
  meant.opens = std::find(std::begin(kOpeners), std::end(kOpeners), meant.directive) != std::end(kOpeners);
  return meant;
}

std::vector<std::string> includes_that_declare(std::string_view name, std::span<const fs::path> folders) {
  constexpr std::size_t kMaxFile = 4u << 20, kMaxTotal = 64u << 20;
  std::size_t total = 0;
  std::vector<std::string> found;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() != ".inc" || total > kMaxTotal) continue;
      try {
        const auto source = Source::read(entry.path(), entry.path().filename(), kMaxFile);
        total += source->text().size();
        if (declares(source->text(), name)) found.push_back(entry.path().filename());
      } catch (const std::exception&) {
        continue;  // unreadable files give no advice
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool is_standard_include(std::string_view name) {
  static constexpr std::string_view kNames[] = {
      "arrays",    "chars",  "colors",   "consts",     "crystal",   "debug",   "finish",     "functions", "glass",
      "glass_old", "golds",  "ior",      "logo",       "makegrass", "math",    "meshmaker",  "metals",    "povlogo",
      "rad_def",   "rand",   "screen",   "shapes",     "shapes2",   "shapesq", "shapes_old", "skies",     "skysphere",
      "spectral",  "stage1", "stars",    "stdcam",     "stdinc",    "stones",  "stones1",    "stones2",   "stoneold",
      "strings",   "sunpos", "textures", "transforms", "woodmaps",  "woods",   "mrp"};
  if (name.ends_with(".inc")) name.remove_suffix(4);
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

}  // namespace verisim::parser
