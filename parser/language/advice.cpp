// What a misspelt name or file probably means: the sentence behind a message, and the correction where there is no
// doubt.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "parser/language/impl.h"
#include "parser/source/suggest.h"

namespace verisim::parser {
namespace {

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

constexpr std::string_view kDirectives[] = {"break",      "case",    "debug",  "declare", "default", "else",  "elseif",
                                            "end",        "error",   "fclose", "fopen",   "for",     "if",    "ifdef",
                                            "ifndef",     "include", "local",  "macro",   "range",   "read",  "render",
                                            "statistics", "switch",  "undef",  "version", "warning", "while", "write"};

// The '#' that stands before a token with nothing but blanks between; npos: none.
std::size_t hash_before(const TokenFile& file, const Token& token) {
  const std::string_view text = file.source->text();
  std::size_t i = token.offset;
  while (i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\t')) --i;
  return i > 0 && text[i - 1] == '#' ? i - 1 : std::string_view::npos;
}

Fix replacement(Spot at, std::string text) {
  return {fmt::format("write '{}'", text), at.file->source->name(), at.token->offset, at.file->length(*at.token),
          std::move(text)};
}

void advise_directive(Diagnostic& d, std::string_view text, Spot at) {
  d.code = Code::unknown_directive;
  d.message = fmt::format("Unknown directive '#{}'.", text);
  const std::string lower = lowered(text);
  for (const std::string_view directive : kDirectives)
    if (lower == directive) {
      d.advice = fmt::format("Directives are written in lower case: '#{}'.", directive);
      d.fix = replacement(at, lower);
      return;
    }
  for (const Foreign& foreign : kForeign)
    if (lower == foreign.word) {
      d.advice = fmt::format("SDL calls it '#{}'.", foreign.directive);
      if (foreign.same) d.fix = replacement(at, std::string(foreign.directive));
      return;
    }
  if (const std::string_view likely = nearest(lower, kDirectives); !likely.empty())
    d.advice = fmt::format("Did you mean '#{}'?", likely);
}

}  // namespace

void Parser::Impl::advise_name(Diagnostic& d, std::uint32_t name, Spot at) {
  const std::string_view text = names[name].text;
  if (hash_before(*at.file, *at.token) != std::string_view::npos) return advise_directive(d, text, at);

  const std::string lower = lowered(text);
  const bool opens_block = at.token[1].punctuation == '{';
  const std::uint32_t same = names.find(lower);
  const bool keyword = same && names[same].word != Word::none;
  std::vector<std::string> includes;
  if (search && !(keyword && opens_block)) includes = includes_that_declare(text, search->library_paths());
  if (!includes.empty()) {
    d.advice =
        fmt::format("It is declared in {}: is #include \"{}\" missing?", fmt::join(includes, ", "), includes.front());
  } else if (keyword) {
    d.advice = fmt::format("Keywords are written in lower case: '{}'.", lower);
    d.fix = replacement(at, lower);
  }
  if (!d.advice.empty()) return;
  // The scene's own names come first: among equally near ones they are meant more often.
  std::vector<std::string_view> candidates;
  for (const bool own : {true, false})
    for (std::uint32_t id = 1; id < names.size(); ++id) {
      const bool word = names[id].word != Word::none;
      if (own ? names[id].symbol && !opens_block : word) candidates.push_back(names[id].text);
    }
  if (const std::string_view likely = nearest(text, candidates); !likely.empty())
    d.advice = fmt::format("Did you mean '{}'?", likely);
}

void Parser::Impl::advise_file(Diagnostic& d, const std::string& name, Spot at, bool include) {
  if (name.find('\n') != std::string::npos) {
    d.advice =
        fmt::format("The string that begins in line {} runs over several lines: is its closing quote missing?", d.line);
    return;
  }
  if (const auto similar = search->find_similar(name, include)) {
    d.advice = similar->certain ? fmt::format("The file is called '{}'.", similar->name)
                                : fmt::format("Did you mean '{}'?", similar->name);
    // Only where the name stands in the text as it is.
    if (similar->certain && at.token->kind == TokenKind::string && at.file->raw_string(*at.token) == name)
      d.fix = Fix{fmt::format("write \"{}\"", similar->name), at.file->source->name(),
                  at.token->offset + std::size_t{1}, name.size(), similar->name};
    return;
  }
  if (include && is_standard_include(name)) {
    d.advice =
        "It is one of POV-Ray's standard include files: install the package povray-includes, or give its folder with "
        "+L.";
  } else if (!search->library_paths().empty()) {
    std::vector<std::string> folders;
    for (const std::filesystem::path& p : search->library_paths()) folders.push_back(p.string());
    d.advice = fmt::format("Searched in the current folder and in {}.", fmt::join(folders, ", "));
  }
}

}  // namespace verisim::parser
