// What a misspelt name or file probably means: the sentence behind a message, and the correction where there is no
// doubt.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "parser/language/impl.h"
#include "parser/source/suggest.h"

namespace verisim::parser {
namespace {

Fix replacement(Spot at, std::string text) {
  return {fmt::format("write '{}'", text), at.file->source->name(), at.token->offset, at.file->length(*at.token),
          std::move(text)};
}

void advise_directive(Diagnostic& d, std::string_view text, Spot at) {
  d.code = Code::unknown_directive;
  d.message = fmt::format("Unknown directive '#{}'.", text);
  const MeantDirective meant = meant_directive(text);
  if (meant.directive.empty()) return;
  switch (meant.why) {
    case MeantDirective::Why::case_:
      d.advice = fmt::format("Directives are written in lower case: '#{}'.", meant.directive);
      break;
    case MeantDirective::Why::foreign:
      d.advice = fmt::format("SDL calls it '#{}'.", meant.directive);
      break;
    case MeantDirective::Why::near:
      d.advice = fmt::format("Did you mean '#{}'?", meant.directive);
  }
  if (meant.certain) d.fix = replacement(at, std::string(meant.directive));
}

}  // namespace

void Parser::Impl::advise_name(Diagnostic& d, std::uint32_t name, Spot at) {
  const std::string_view text = names[name].text;
  if (at.file->hash_before(*at.token) != std::string_view::npos) return advise_directive(d, text, at);

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
