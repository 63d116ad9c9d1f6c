// Where messages point: the token that is meant, the line it stands in, and the brackets that are open before it. All
// of this is worked out when there is a message; while a scene is read without one it costs nothing.
#include <fmt/format.h>

#include <algorithm>

#include "parser/language/impl.h"
#include "parser/source/origins.h"

namespace verisim::parser {
namespace {

constexpr std::size_t kExcerpt = 160;  // characters of a source line that are shown
constexpr std::size_t kTrail = 8;      // steps at each end of a long trail

// What a message with this code calls wrong is a value that was just read.
bool is_about_value(Code code) {
  switch (code) {
    case Code::bad_value:
    case Code::adjusted_value:
    case Code::domain_error:
      return true;
    default:
      return false;
  }
}

bool opens(const Token& token) {
  return token.punctuation == '{' || token.punctuation == '(' || token.punctuation == '[';
}
bool closes(const Token& token) {
  return token.punctuation == '}' || token.punctuation == ')' || token.punctuation == ']';
}

// Blanks before the first character of the token's line, a tab as eight; nothing when the token is not the first there.
std::optional<std::size_t> indentation(const TokenFile& file, const Token& token, bool must_be_first) {
  const std::string_view text = file.source->text();
  std::size_t start = token.offset;
  while (start > 0 && text[start - 1] != '\n' && text[start - 1] != '\r') --start;
  std::size_t columns = 0, i = start;
  for (; i < token.offset && (text[i] == ' ' || text[i] == '\t'); ++i)
    columns = text[i] == '\t' ? (columns / 8 + 1) * 8 : columns + 1;
  if (must_be_first && i != token.offset) return std::nullopt;
  return columns;
}

}  // namespace

Spot Parser::Impl::here() const {
  if (!file) return {};
  const Token* at = position;
  if (!ready && at > file->tokens.data() && at->kind != TokenKind::error) --at;
  return {file, at};
}

Spot Parser::Impl::place_of(Code code) const {
  const bool about_path = code == Code::missing_file || code == Code::bad_file;
  const Spot& read = about_path ? path_read : value_read;
  return (about_path || is_about_value(code)) && read.file && read.file == file ? read : here();
}

Excerpt Parser::Impl::excerpt(Spot at) {
  Excerpt e;
  if (!at.file) return e;
  const Source& source = *at.file->source;
  const Position position = source.position(at.token->offset);
  e.file = source.name();
  e.line = position.line;
  e.column = position.column;
  e.length = static_cast<int>(std::min<std::size_t>(at.file->length(*at.token), 1u << 20));
  const std::string_view line = source.line(position.line);
  const auto column = static_cast<std::size_t>(position.column - 1);
  const std::size_t start = column > kExcerpt / 2 && line.size() > kExcerpt ? column - kExcerpt / 2 : 0;
  e.source_line = line.substr(std::min(start, line.size()), kExcerpt);
  e.caret = static_cast<int>(column - start) + 1;
  return e;
}

scene::SourceLocation Parser::Impl::with_calls(const scene::SourceLocation& place) const {
  Origins::Origin origin;
  for (std::size_t i = frames.size(); i-- > 0 && origin.calls.size() < kTrail;) {
    const Frame& frame = frames[i];
    if (!frame.macro) continue;
    const std::size_t call = std::min<std::size_t>(frame.call, frame.file->tokens.size() - 1);
    const Source& source = *frame.file->source;
    origin.calls.push_back(fmt::format("{}:{}", source.name(), source.position(frame.file->tokens[call].offset).line));
  }
  return origin.calls.empty() ? place : options.origins->with(place, std::move(origin));
}

void Parser::Impl::name_object(Spot name, const Value& value) const {
  const auto* object = std::get_if<scene::ObjectPtr>(&value);
  if (!object || !*object || object->use_count() > 1) return;                 // another name of what has one
  scene::SourceLocation& place = const_cast<scene::Object&>(**object).place;  // nobody else has it yet
  Origins::Origin origin = options.origins->of(place);
  origin.declared = names[name.token->id()].text;
  place = options.origins->with(place, std::move(origin));
}

std::vector<std::string> Parser::Impl::trail() const {
  std::vector<std::string> steps_back;
  for (std::size_t i = frames.size(); i-- > 0;) {
    if (frames.size() > 2 * kTrail && i + kTrail + 1 == frames.size()) {
      steps_back.push_back(fmt::format("... {} more ...", frames.size() - 2 * kTrail));
      i = kTrail;
      continue;
    }
    const Frame& frame = frames[i];
    const std::size_t call = std::min<std::size_t>(frame.call, frame.file->tokens.size() - 1);
    const Excerpt place = excerpt({frame.file, &frame.file->tokens[call]});
    steps_back.push_back(frame.macro ? fmt::format("in macro '{}' called at {}:{}", names[frame.macro->name].text,
                                                   place.file, place.line)
                                     : fmt::format("included from {}:{}", place.file, place.line));
  }
  return steps_back;
}

const Token* Parser::Impl::open_bracket(Spot before) {
  int closed = 0;
  for (const Token* at = before.token; at-- > before.file->tokens.data();) {
    if (closes(*at))
      ++closed;
    else if (opens(*at) && closed-- == 0)
      return at;
  }
  return nullptr;
}

const Token* Parser::Impl::badly_indented(Spot before) {
  std::vector<const Token*> open;
  for (const Token* at = before.file->tokens.data(); at != before.token; ++at) {
    if (at->punctuation == '{') open.push_back(at);
    if (at->punctuation != '}' || open.empty()) continue;
    const Token* const opener = open.back();
    open.pop_back();
    const auto closing = indentation(*before.file, *at, true);
    if (closing && *closing < *indentation(*before.file, *opener, false)) return opener;
  }
  return nullptr;
}

Spot Parser::Impl::opener(const Token* bracket) const {
  const Token* const word = bracket > file->tokens.data() ? bracket - 1 : bracket;
  return {file, word->kind == TokenKind::word || word->kind == TokenKind::identifier ? word : bracket};
}

std::string Parser::Impl::written(Spot at) const {
  const std::string_view text = at.file->source->text();
  const auto as_text = [&](const Token& token) {
    return std::string(text.substr(token.offset, at.file->length(token)));
  };
  std::string out = as_text(*at.token);
  if (!opens(*at.token) || at.token == at.file->tokens.data()) return out;
  const Token& word = at.token[-1];
  if (word.kind != TokenKind::word && word.kind != TokenKind::identifier) return out;
  return as_text(word) + (at.token->punctuation == '{' ? " {" : out);
}

}  // namespace verisim::parser
