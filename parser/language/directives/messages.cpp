// Errors, warnings and the text directives (spec 01 sections 3 and 19).
#include <fmt/format.h>

#include "parser/language/impl.h"
#include "parser/source/confinement.h"

namespace verisim::parser {
namespace {

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

Code code_of(LexError why) {
  switch (why) {
    case LexError::unterminated_string:
      return Code::unterminated_string;
    case LexError::newline_after_backslash:
      return Code::bad_escape;
    case LexError::unterminated_comment:
      return Code::unterminated_comment;
    case LexError::second_point:
      return Code::bad_number;
    case LexError::too_many_tokens:
      return Code::size_limit;
    case LexError::illegal_character:
      break;
  }
  return Code::illegal_character;
}

}  // namespace

const char* Parser::Impl::kind_of(const Value& value) {
  static constexpr const char* kKinds[] = {
      "empty",     "float",       "string",     "array",      "function",    "spline",      "pigment",
      "normal",    "finish",      "texture",    "density",    "interior",    "media",       "material",
      "color_map", "pigment_map", "normal_map", "slope_map",  "texture_map", "density_map", "transform",
      "camera",    "fog",         "rainbow",    "sky_sphere", "object",      "macro",       "file"};
  static_assert(std::size(kKinds) == std::variant_size_v<Value>);
  const auto* n = std::get_if<Numeric>(&value);
  return n && n->terms > 1 ? (n->terms == 5 ? "color" : "vector") : kKinds[value.index()];
}

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
      return fmt::format("{} identifier '{}'", kind_of(symbol->value()), name);
    }
  }
  return "something else";
}

Diagnostic Parser::Impl::diagnostic(Severity severity, Code code, const std::string& text, const std::string& advice,
                                    Spot at) const {
  Diagnostic d;
  d.severity = severity;
  d.code = code;
  d.message = text;
  d.advice = advice;
  if (!at.file) return d;
  static_cast<Excerpt&>(d) = excerpt(at);
  d.trail = trail();
  return d;
}

void Parser::Impl::message(Severity severity, Code code, const std::string& text, const std::string& advice) {
  message_at(place_of(code), severity, code, text, advice);
}

void Parser::Impl::message_at(Spot at, Severity severity, Code code, const std::string& text, const std::string& advice,
                              std::optional<Fix> fix) {
  // A message from inside a loop is given once for each place, the name of an experimental feature once a scene.
  const std::size_t what = std::hash<std::string>{}(text);
  const bool new_here = code == Code::experimental
                            ? messages_given.emplace(nullptr, 0, what).second
                            : messages_given.emplace(file, file ? index(position) : 0, what).second;
  if (!new_here) return;
  if (messages_given.size() > 10000) messages_given.clear();
  give(severity, code, text, advice, at, std::move(fix));
}

void Parser::Impl::give(Severity severity, Code code, const std::string& text, const std::string& advice, Spot at,
                        std::optional<Fix> fix) {
  ++report.warnings;
  Diagnostic said = diagnostic(severity, code, text, advice, at);
  said.fix = std::move(fix);
  if (confinement.output_limit != 0 && !confinement.may_write(format(said).size()))
    fatal(Code::size_limit, confinement.refusal());
  if (options.message) options.message(said);
}

void Parser::Impl::error(Code code, const std::string& text, const std::string& advice) {
  error_at(place_of(code), code, text, advice);
}

void Parser::Impl::error_at(Spot at, Code code, const std::string& text, const std::string& advice) {
  throw ParseError{diagnostic(Severity::error, code, text, advice, at)};
}

void Parser::Impl::fatal(Code code, const std::string& text, const std::string& advice) {
  throw ParseError{diagnostic(Severity::error, code, text, advice, place_of(code)), true};
}

void Parser::Impl::expected(std::string_view what) {
  const Token& token = position->kind == TokenKind::error ? *position : peek_blocked();
  if (token.kind == TokenKind::error) lex_error(token);
  ready = true;
  if (token.kind == TokenKind::identifier && !names[token.id()].symbol && what != "identifier") undeclared(token.id());
  const std::string wanted = what.size() == 1 ? punctuation_text(what[0]) : std::string(what);
  if (token.kind == TokenKind::end && wanted == "}") unclosed_block();
  const bool of_a_kind = token.kind == TokenKind::identifier || token.kind == TokenKind::string;
  Diagnostic d = diagnostic(Severity::error, of_a_kind ? Code::wrong_type : Code::unexpected_token,
                            fmt::format("Expected '{}', {} found instead.", wanted, describe(token)), {}, here());
  const bool closing = wanted == ")" || wanted == "]" || wanted == "}";
  if (closing || token.kind == TokenKind::end)
    if (const Token* open = open_bracket(here()))
      d.related.push_back({fmt::format("'{}' was opened here", written({file, open})), excerpt(opener(open))});
  throw ParseError{std::move(d)};
}

// A block should end at the next token, and does not: something that cannot stand in it, or the end of the file.
void Parser::Impl::unclosed_block() {
  const Token& token = position->kind == TokenKind::error ? *position : peek_blocked();
  if (token.kind == TokenKind::error) lex_error(token);
  ready = true;
  if (token.kind == TokenKind::identifier && !names[token.id()].symbol) undeclared(token.id());
  const Token* const open = open_bracket(here());
  const std::string block = open ? written({file, open}) : "{";
  Diagnostic d;
  if (token.kind == TokenKind::end && open) {
    d = diagnostic(Severity::error, Code::unclosed_block,
                   fmt::format("'{}' is never closed: the file ends first.", block), {}, opener(open));
  } else {
    d = diagnostic(Severity::error, Code::unexpected_token,
                   fmt::format("Expected '}}' to end '{}', {} found instead.", block, describe(token)), {}, here());
    if (open) d.related.push_back({fmt::format("'{}' was opened here", block), excerpt(opener(open))});
  }
  if (const Token* other = badly_indented(here()); other && other != open)
    d.related.push_back(
        {fmt::format("the indentation says that '{}' is not closed where it should be", written({file, other})),
         excerpt(opener(other))});
  throw ParseError{std::move(d)};
}

// The file ends inside a #if, #switch, loop or macro.
void Parser::Impl::unclosed_condition() {
  const Condition& last = conditions.back();
  const Spot opener{last.file, &last.file->tokens[last.opener]};
  const bool nested = conditions.size() > 1 && conditions[conditions.size() - 2].file == last.file;
  Diagnostic d = diagnostic(Severity::error, Code::unclosed_condition,
                            fmt::format("'{}' has no #end: the file ends first.", written(opener)), {}, opener);
  if (nested) d.advice = "If it has one, a construct inside it lacks its own.";
  throw ParseError{std::move(d), true};
}

void Parser::Impl::undeclared(std::uint32_t name) {
  Spot at = here();
  if (at.token->kind != TokenKind::identifier && position->kind == TokenKind::identifier) at = next();
  Diagnostic d = diagnostic(Severity::error, Code::undeclared_identifier,
                            fmt::format("Undeclared identifier '{}'.", names[name].text), {}, at);
  // Looking for what was meant takes a while: not for errors that will not be shown, as those of later passes of a
  // loop.
  if (!touches_failed_name() && !recovery.reported.contains({d.file, d.line, d.message})) advise_name(d, name, at);
  throw ParseError{std::move(d)};
}

namespace {

// What word processors and web pages make of the characters of SDL, and what was meant.
struct Lookalike {
  std::string_view utf8, meant;
};
constexpr Lookalike kLookalikes[] = {
    {"\xE2\x80\x9C", "\""}, {"\xE2\x80\x9D", "\""}, {"\xE2\x80\x9E", "\""},  // quotation marks
    {"\xE2\x88\x92", "-"},  {"\xE2\x80\x93", "-"},                           // minus, dash
    {"\xC2\xA0", " "},      {"\xE2\x80\xAF", " "},                           // blanks that do not break
};

}  // namespace

void Parser::Impl::lex_error(const Token& token) {
  ready = true;
  const auto why = static_cast<LexError>(token.id());
  std::string text = parser::describe(why);
  if (why == LexError::illegal_character)
    for (const Lookalike& l : kLookalikes) {
      if (!file->source->text().substr(token.offset).starts_with(l.utf8)) continue;
      Diagnostic d = diagnostic(
          Severity::error, code_of(why),
          fmt::format("Illegal character '{}': it only looks like '{}'.", l.utf8, l.meant),
          fmt::format("Write '{}' instead; programs for text and web pages put the other one in its place.", l.meant),
          {file, &token});
      d.fix = Fix{fmt::format("write '{}'", l.meant), file->source->name(), token.offset, l.utf8.size(),
                  std::string(l.meant)};
      throw ParseError{std::move(d), true};
    }
  if (why == LexError::illegal_character) {
    const auto byte = static_cast<unsigned char>(file->source->text()[token.offset]);
    text = byte >= 0x21 && byte < 0x7f ? fmt::format("Illegal character '{}' in input file.", static_cast<char>(byte))
                                       : fmt::format("Illegal character in input file: value {:#04x}.", byte);
  }
  throw ParseError{diagnostic(Severity::error, code_of(why), text, {}, {file, &token}), true};
}

void Parser::Impl::check_deprecated(Symbol& symbol) {
  Deprecation* deprecation = symbol.deprecation.get();
  if (!deprecation || (deprecation->once && deprecation->warned)) return;
  deprecation->warned = true;
  message(Severity::warning, Code::deprecated, deprecation->message);
}

void Parser::Impl::text_directive(Word word) {
  const std::string text = utf8(string(false));
  switch (word) {
    case Word::error:
      fatal(Code::user_error, "Parse halted by #error directive: " + text);
    case Word::warning:
      give(Severity::warning, Code::user_warning, text, {}, here());
      return;
    case Word::render:
    case Word::statistics:
      message(Severity::warning, Code::no_effect, fmt::format("#{} writes to the debug stream.", spelling(word)));
      break;
    default:
      break;
  }
  if (!confinement.may_write(text.size())) fatal(Code::size_limit, confinement.refusal());
  if (options.debug && report.errors.empty()) options.debug(text);  // POV-Ray ended before
}

// ---- The public face ----

void Parser::error(Code code, const std::string& text, const std::string& advice) { impl_->error(code, text, advice); }
void Parser::fatal(Code code, const std::string& text, const std::string& advice) { impl_->fatal(code, text, advice); }
void Parser::error_expected(std::string_view what) { impl_->expected(what); }
void Parser::error_unclosed() { impl_->unclosed_block(); }
void Parser::unsupported(const std::string& what) {
  throw ParseError{
      impl_->diagnostic(Severity::unsupported, Code::unsupported, what + " is not supported.", {}, impl_->here()),
      true};
}
void Parser::warning(Code code, const std::string& text) { impl_->message(Severity::warning, code, text); }
void Parser::possible_error(Code code, const std::string& text) {
  impl_->message(Severity::possible_error, code, text);
}

}  // namespace verisim::parser
