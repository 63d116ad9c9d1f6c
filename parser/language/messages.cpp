// Errors, warnings and the text directives (spec 01 sections 3 and 19).
#include <fmt/format.h>

#include <algorithm>

#include "parser/language/impl.h"
#include "parser/source/suggest.h"

namespace verisim::parser {
namespace {

constexpr std::size_t kExcerpt = 160;  // characters of a source line that are shown
constexpr std::size_t kTrail = 8;      // steps at each end of a long trail

std::string punctuation_text(char c) {
  switch (c) {
    case kLessEqual:
      return "<=";
    case kGreaterEqual:
      return ">=";
    case kNotEqual:
      return "!=";
    default:
      return std::string(1, c);
  }
}

}  // namespace

// "undeclared identifier 'foo'", "float function 'sin'", "pigment", "')'" ...
std::string Parser::Impl::describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::end:
      return "end of file";
    case TokenKind::error:
      return "an unreadable token";
    case TokenKind::number:
      return fmt::format("number {}", token.number());
    case TokenKind::string:
      return "string literal";
    case TokenKind::directive:
      return fmt::format("'#{}'", spelling(token.word));
    case TokenKind::vector:
    case TokenKind::punctuation:
      return fmt::format("'{}'", punctuation_text(token.punctuation));
    case TokenKind::word: {
      const char* kind = nullptr;  // keywords stand for themselves
      switch (word_class(token.word)) {
        case WordClass::float_function:
          kind = "float function";
          break;
        case WordClass::vector_function:
          kind = "vector function";
          break;
        case WordClass::string_function:
          kind = "string function";
          break;
        case WordClass::color:
          kind = "color keyword";
          break;
        case WordClass::keyword:
          break;
      }
      return kind ? fmt::format("{} '{}'", kind, spelling(token.word)) : std::string(spelling(token.word));
    }
    case TokenKind::identifier: {
      const std::string_view name = names[token.id()].text;
      Symbol* symbol = names[token.id()].symbol;
      if (!symbol) return fmt::format("undeclared identifier '{}'", name);
      static constexpr const char* kKinds[] = {
          "empty",     "float",       "string",     "array",      "function",    "spline",      "pigment",
          "normal",    "finish",      "texture",    "density",    "interior",    "media",       "material",
          "color_map", "pigment_map", "normal_map", "slope_map",  "texture_map", "density_map", "transform",
          "camera",    "fog",         "rainbow",    "sky_sphere", "object",      "macro",       "file"};
      static_assert(std::size(kKinds) == std::variant_size_v<Value>);
      const Value& value = symbol->value();
      const char* kind = kKinds[value.index()];
      if (const auto* n = std::get_if<Numeric>(&value); n && n->terms > 1) kind = n->terms == 5 ? "color" : "vector";
      return fmt::format("{} identifier '{}'", kind, name);
    }
  }
  return "something else";
}

void Parser::Impl::locate(Diagnostic& d, const TokenFile& in, std::uint32_t token) const {
  const Source& source = *in.source;
  const Position at = source.position(in.tokens[std::min<std::size_t>(token, in.tokens.size() - 1)].offset);
  d.file = source.name();
  d.line = at.line;
  d.column = at.column;
  const std::string_view line = source.line(at.line);
  const auto column = static_cast<std::size_t>(at.column - 1);
  const std::size_t start = column > kExcerpt / 2 && line.size() > kExcerpt ? column - kExcerpt / 2 : 0;
  d.source_line = line.substr(std::min(start, line.size()), kExcerpt);
  d.caret = static_cast<int>(column - start) + 1;
}

Diagnostic Parser::Impl::diagnostic(Severity severity, const std::string& text, const std::string& advice) {
  Diagnostic d;
  d.severity = severity;
  d.message = text;
  d.advice = advice;
  if (!file) return d;
  // The token that was looked at last: the one under the cursor, or the one just consumed.
  std::uint32_t at = index(position);
  if (!ready && at > 0 && position->kind != TokenKind::end && position->kind != TokenKind::error) --at;
  locate(d, *file, at);
  for (std::size_t i = frames.size(); i-- > 0;) {
    if (frames.size() > 2 * kTrail && i + kTrail + 1 == frames.size()) {
      d.trail.push_back(fmt::format("... {} more ...", frames.size() - 2 * kTrail));
      i = kTrail;
      continue;
    }
    const Frame& frame = frames[i];
    Diagnostic place;
    locate(place, *frame.file, frame.call);
    if (frame.macro)
      d.trail.push_back(
          fmt::format("in macro '{}' called at {}:{}", names[frame.macro->name].text, place.file, place.line));
    else
      d.trail.push_back(fmt::format("included from {}:{}", place.file, place.line));
  }
  return d;
}

void Parser::Impl::message(Severity severity, const std::string& text, const std::string& advice) {
  // A message from inside a loop is given once for each place, the name of an experimental feature once a scene.
  const bool once = text.ends_with("an experimental feature of POV-Ray.");
  const std::size_t what = std::hash<std::string>{}(text);
  if (file &&
      !(once ? messages_given.emplace(nullptr, 0, what) : messages_given.emplace(file, index(position), what)).second)
    return;
  if (messages_given.size() > 10000) messages_given.clear();
  give(severity, text, advice);
}

void Parser::Impl::give(Severity severity, const std::string& text, const std::string& advice) {
  ++report.warnings;
  if (options.message) options.message(diagnostic(severity, text, advice));
}

void Parser::Impl::error(const std::string& text, const std::string& advice) {
  throw ParseError{diagnostic(Severity::error, text, advice)};
}

void Parser::Impl::fatal(const std::string& text, const std::string& advice) {
  throw ParseError{diagnostic(Severity::error, text, advice), true};
}

void Parser::Impl::expected(std::string_view what) {
  const Token& token = position->kind == TokenKind::error ? *position : peek_blocked();
  if (token.kind == TokenKind::error) lex_error(token);
  if (token.kind == TokenKind::identifier && !names[token.id()].symbol && what != "identifier") {
    ready = true;
    undeclared(token.id());
  }
  ready = true;
  const std::string found = describe(token);
  std::string advice;
  if (what.size() == 1) {
    const std::string code = punctuation_text(what[0]);
    error(fmt::format("Expected '{}', {} found instead.", code, found));
  }
  error(fmt::format("Expected '{}', {} found instead.", what, found));
}

void Parser::Impl::undeclared(std::uint32_t name) {
  const std::string_view text = names[name].text;
  const std::string message = fmt::format("Undeclared identifier '{}'.", text);
  // Looking for what was meant takes a while: not for errors that will not be shown, as those of later passes of a
  // loop.
  if (touches_failed_name()) error(message);
  const Diagnostic here = diagnostic(Severity::error, message, {});
  if (recovery.reported.contains({here.file, here.line, message})) throw ParseError{here};
  std::vector<std::string_view> candidates;
  for (std::uint32_t id = 1; id < names.size(); ++id)
    if (names[id].symbol || names[id].word != Word::none) candidates.push_back(names[id].text);
  std::string advice;
  const std::string_view likely = nearest(text, candidates);
  std::vector<std::string> includes;
  if (search) includes = includes_that_declare(text, search->library_paths());
  if (!includes.empty()) {
    advice =
        fmt::format("It is declared in {}: is #include \"{}\" missing?", fmt::join(includes, ", "), includes.front());
  } else if (!likely.empty()) {
    advice = fmt::format("Did you mean '{}'?", likely);
  }
  error(message, advice);
}

void Parser::Impl::lex_error(const Token& token) {
  ready = true;
  const auto why = static_cast<LexError>(token.id());
  std::string text = parser::describe(why);
  if (why == LexError::illegal_character) {
    const auto byte = static_cast<unsigned char>(file->source->text()[token.offset]);
    text = byte >= 0x21 && byte < 0x7f ? fmt::format("Illegal character '{}' in input file.", static_cast<char>(byte))
                                       : fmt::format("Illegal character in input file: value {:#04x}.", byte);
  }
  fatal(text);
}

void Parser::Impl::check_deprecated(Symbol& symbol) {
  Deprecation* deprecation = symbol.deprecation.get();
  if (!deprecation || (deprecation->once && deprecation->warned)) return;
  deprecation->warned = true;
  message(Severity::warning, deprecation->message);
}

void Parser::Impl::text_directive(Word word) {
  const std::string text = utf8(string(false));
  switch (word) {
    case Word::error:
      fatal("Parse halted by #error directive: " + text);
    case Word::warning:
      give(Severity::warning, text, {});
      return;
    case Word::render:
    case Word::statistics:
      message(Severity::warning, fmt::format("#{} writes to the debug stream.", spelling(word)));
      break;
    default:
      break;
  }
  if (options.debug) options.debug(text);
}

// ---- The public face ----

void Parser::error(const std::string& text, const std::string& advice) { impl_->error(text, advice); }
void Parser::fatal(const std::string& text, const std::string& advice) { impl_->fatal(text, advice); }
void Parser::error_expected(std::string_view what) { impl_->expected(what); }
void Parser::unsupported(const std::string& what) {
  throw ParseError{impl_->diagnostic(Severity::unsupported, what + " is not supported.", {}), true};
}
void Parser::warning(const std::string& text) { impl_->message(Severity::warning, text); }
void Parser::possible_error(const std::string& text) { impl_->message(Severity::possible_error, text); }

}  // namespace verisim::parser
