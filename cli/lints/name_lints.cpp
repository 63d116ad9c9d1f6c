// Names that nothing uses, that hide others, that a loop declares anew for nothing.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/describe/including_scene.h"
#include "cli/lints/lints.h"
#include "parser/editing/index.h"
#include "parser/editing/place.h"
#include "parser/source/suggest.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

using parser::NameDeclaration;
using parser::Token;
using parser::TokenKind;
using parser::Word;

struct File {
  fs::path path;
  bool own = false;
  std::unique_ptr<parser::NameIndex> index;
};

std::vector<File> read_all(const LintedScene& linted, const std::vector<fs::path>& standard) {
  constexpr std::uintmax_t kLargest = 16u << 20;
  std::vector<File> files;
  for (const fs::path& path : linted.files) {
    const std::string extension = parser::lowered(path.extension().string());
    const bool scene = files.empty() || extension == ".inc" || extension == ".pov" || extension == ".mcr";
    std::error_code failed;
    if (const std::uintmax_t size = fs::file_size(path, failed); !scene || (!failed && size > kLargest)) continue;
    std::optional<std::string> text = linted.text(path);
    if (!text) continue;
    const bool own = std::none_of(standard.begin(), standard.end(),
                                  [&](const fs::path& folder) { return path.string().starts_with(folder.string()); });
    files.push_back({path, own, std::make_unique<parser::NameIndex>(*text)});
  }
  return files;
}

LintFinding finding(const File& file, std::string_view lint, std::size_t offset, std::size_t length,
                    std::string message, std::string advice = {}) {
  const parser::Source& source = *file.index->tokens().source;
  const parser::Position at = source.position(offset);
  LintFinding f;
  f.lint = lint_named(lint);
  f.file = file.path.string();
  f.line = at.line;
  f.column = at.column;
  f.length = static_cast<int>(length);
  if (const std::string_view line = source.line(at.line); line.size() < 400) f.source_line = line;
  f.message = std::move(message);
  f.advice = std::move(advice);
  return f;
}

// Names that are used in any file, by identifiers other than those that declare, or within strings.
std::set<std::string, std::less<>> used_names(const std::vector<File>& files) {
  std::set<std::string, std::less<>> used;
  for (const File& file : files) {
    std::set<std::size_t> declaring;
    for (const NameDeclaration& d : file.index->declarations()) declaring.insert(d.offset);
    for (const parser::NameUse& use : file.index->uses())
      if (!declaring.count(use.offset)) used.emplace(use.name);
    const parser::TokenFile& tokens = file.index->tokens();
    for (const Token& token : tokens.tokens) {
      if (token.kind != TokenKind::string) continue;
      const std::string_view text = tokens.raw_string(token);
      for (std::size_t i = 0; i < text.size();) {
        const auto letter = [&](std::size_t at) {
          return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
        };
        std::size_t end = i;
        while (letter(end)) ++end;
        if (end > i) used.emplace(text.substr(i, end - i));
        i = std::max(end, i + 1);
      }
    }
  }
  return used;
}

bool is_for(const File& file, const NameDeclaration& d) {
  const std::string_view text = file.index->tokens().source->text();
  return text.substr(d.whole.begin, d.offset - d.whole.begin).find('(') != std::string_view::npos;
}

bool is_local(const File& file, const NameDeclaration& d) {
  const std::string_view text = file.index->tokens().source->text();
  return text.substr(d.whole.begin, d.offset - d.whole.begin).find("local") != std::string_view::npos;
}

// A #declare in a macro that has a parameter or #local of the name changes that one, as it does in an include file.
bool changes_local(const File& file, bool is_scene, const NameDeclaration& d) {
  const auto& all = file.index->declarations();
  return std::any_of(all.begin(), all.end(), [&](const NameDeclaration& other) {
    return other.name == d.name && (other.global ? !is_scene && is_local(file, other) : other.scope.contains(d.offset));
  });
}

void unused(const std::vector<File>& files, std::vector<LintFinding>& found) {
  const File& scene = files.front();
  if (!scene_that_includes(scene.path).empty()) return;  // its names may be for that one
  const auto used = used_names(files);
  std::set<std::string> told;
  for (const NameDeclaration& d : scene.index->declarations()) {
    const bool counts = d.kind == NameDeclaration::Kind::macro || d.kind == NameDeclaration::Kind::variable;
    if (!counts || used.count(d.name) || is_for(scene, d) || !told.insert(d.name).second) continue;
    const bool parameter = std::any_of(scene.index->declarations().begin(), scene.index->declarations().end(),
                                       [&](const NameDeclaration& other) {
                                         return other.name == d.name && other.kind == NameDeclaration::Kind::parameter;
                                       });
    if (parameter) continue;
    found.push_back(finding(scene, "unused-name", d.offset, d.name.size(),
                            d.kind == NameDeclaration::Kind::macro
                                ? fmt::format("The macro '{}' is never called.", d.name)
                                : fmt::format("Nothing uses '{}'.", d.name)));
  }
}

void shadowed(const std::vector<File>& files, std::vector<LintFinding>& found) {
  struct Global {
    const File* file;
    const NameDeclaration* declaration;
  };
  std::multimap<std::string, Global> globals;
  for (const File& file : files)
    for (const NameDeclaration& d : file.index->declarations())
      if (file.own && d.global && d.kind == NameDeclaration::Kind::variable && !is_for(file, d) &&
          !changes_local(file, &file == &files.front(), d))
        globals.emplace(d.name, Global{&file, &d});
  for (const File& file : files) {
    if (!file.own) continue;
    std::set<std::pair<std::size_t, std::string>> told;
    for (const NameDeclaration& d : file.index->declarations()) {
      if (d.global) continue;
      const auto [first, last] = globals.equal_range(d.name);
      const auto hidden = std::find_if(first, last, [&](const auto& entry) {
        return entry.second.file != &file || !d.scope.contains(entry.second.declaration->offset);
      });
      if (hidden == last || !told.insert({d.scope.begin, d.name}).second) continue;
      const Global& g = hidden->second;
      found.push_back(finding(file, "shadowed-name", d.offset, d.name.size(),
                              fmt::format("'{}' hides the global name of {}:{} within this macro.", d.name,
                                          g.file->path.filename().string(),
                                          g.file->index->tokens().source->position(g.declaration->offset).line)));
    }
  }
}

// '#' and a word that is neither a directive nor a macro: passed over, or there would have been an error.
void skipped_directives(const std::vector<File>& files, std::vector<LintFinding>& found) {
  std::set<std::string, std::less<>> macros;
  for (const File& file : files)
    for (const NameDeclaration& d : file.index->declarations())
      if (d.kind == NameDeclaration::Kind::macro) macros.insert(d.name);
  for (const File& file : files) {
    if (!file.own) continue;
    const parser::TokenFile& tokens = file.index->tokens();
    for (const parser::NameUse& use : file.index->uses()) {
      const bool hash = tokens.hash_before(parser::token_at(tokens, use.offset)) != std::string_view::npos;
      if (!hash || macros.count(use.name)) continue;
      const parser::MeantDirective meant = parser::meant_directive(use.name);
      if (meant.directive.empty()) continue;
      found.push_back(finding(file, "skipped-directive", use.offset, use.name.size(),
                              fmt::format("'#{}' is no directive, and is passed over here.", use.name),
                              fmt::format("'#{}' was meant, probably.", meant.directive)));
    }
  }
}

// Loops of a file, as ranges of tokens.
struct Loop {
  std::size_t begin = 0, end = 0;
};

std::vector<Loop> loops_of(const parser::TokenFile& file) {
  std::vector<Loop> loops;
  std::vector<std::pair<bool, std::size_t>> open;
  for (std::size_t i = 0; i < file.tokens.size(); ++i) {
    if (file.tokens[i].kind != TokenKind::directive) continue;
    switch (file.tokens[i].word) {
      case Word::while_:
      case Word::for_:
        open.emplace_back(true, i);
        break;
      case Word::if_:
      case Word::ifdef:
      case Word::ifndef:
      case Word::switch_:
      case Word::macro:
        open.emplace_back(false, i);
        break;
      case Word::end:
        if (open.empty()) break;
        if (open.back().first) loops.push_back({open.back().second, i});
        open.pop_back();
        break;
      default:
        break;
    }
  }
  return loops;
}

bool writes_arguments(const Token& called) {
  return called.kind == TokenKind::identifier || called.word == Word::trace || called.word == Word::read;
}

void constant_in_loop(const File& file, std::vector<LintFinding>& found) {
  const parser::TokenFile& tokens = file.index->tokens();
  const parser::Tokens& t = tokens.tokens;
  const auto name_at = [&](std::size_t i) { return tokens.source->text().substr(t[i].offset, tokens.length(t[i])); };
  std::set<std::size_t> told;
  for (const Loop& loop : loops_of(tokens)) {
    int inner = 0;  // conditions, loops and macros within it
    for (std::size_t i = loop.begin + 1; i < loop.end; ++i) {
      if (t[i].kind != TokenKind::directive) continue;
      const Word word = t[i].word;
      inner += word == Word::if_ || word == Word::ifdef || word == Word::ifndef || word == Word::switch_ ||
               word == Word::while_ || word == Word::for_ || word == Word::macro;
      inner -= word == Word::end;
      if (inner > 0 || (word != Word::declare && word != Word::local)) continue;
      if (t[i + 1].kind != TokenKind::identifier || t[i + 2].punctuation != '=') continue;
      std::size_t end = i + 3;
      bool constant = true;
      for (; end < loop.end && t[end].punctuation != ';'; ++end)
        constant &= t[end].kind == TokenKind::number || t[end].kind == TokenKind::vector ||
                    t[end].kind == TokenKind::string ||
                    (t[end].kind == TokenKind::word && parser::word_class(t[end].word) == parser::WordClass::color) ||
                    (t[end].kind == TokenKind::punctuation &&
                     std::string_view("+-*/()<>,").find(t[end].punctuation) != std::string_view::npos);
      if (!constant || end == loop.end || end == i + 3) continue;
      const std::string_view name = name_at(i + 1);
      int writes = 0;
      std::vector<bool> calls;  // of the brackets that are open, which are those of calls
      for (std::size_t j = loop.begin; j < loop.end; ++j) {
        const char c = t[j].kind == TokenKind::punctuation ? t[j].punctuation : char{0};
        if (c == '(' || c == '{' || c == '[') calls.push_back(c == '(' && j && writes_arguments(t[j - 1]));
        if ((c == ')' || c == '}' || c == ']') && !calls.empty()) calls.pop_back();
        const bool declares =
            t[j].kind == TokenKind::directive && (t[j].word == Word::declare || t[j].word == Word::local);
        writes += declares && t[j + 1].kind == TokenKind::identifier && name_at(j + 1) == name;
        // A macro may change what it is given, as `trace` and `#read` do.
        writes += t[j].kind == TokenKind::identifier && !calls.empty() && calls.back() && name_at(j) == name;
      }
      if (writes == 1 && told.insert(t[i].offset).second)
        found.push_back(finding(file, "constant-in-loop", t[i + 1].offset, name.size(),
                                fmt::format("'{}' is the same in every pass of the loop.", name)));
    }
  }
}

}  // namespace

std::vector<LintFinding> lint_names(const LintedScene& linted, const std::vector<fs::path>& standard) {
  std::vector<LintFinding> found;
  const std::vector<File> files = read_all(linted, standard);
  if (files.empty()) return found;
  unused(files, found);
  shadowed(files, found);
  skipped_directives(files, found);
  for (const File& file : files)
    if (file.own) constant_in_loop(file, found);
  return found;
}

}  // namespace verisim::cli
