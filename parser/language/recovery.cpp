// Going on after an error, so that one run names several mistakes: the failing statement or directive is skipped as
// text, and what it would have declared is remembered, so that its uses are not reported as further errors. The first
// error is the same as if parsing had stopped there.
#include "parser/language/impl.h"
#include "parser/lexer/directive_links.h"
#include "parser/source/suggest.h"

namespace verisim::parser {
namespace {

constexpr std::size_t kMaxErrors = 20;  // reported in one run
constexpr int kMaxFailures = 60;        // including those that are not reported: repeated in loops, or consequences
constexpr std::uint64_t kMaxStepsAfterError =
    20'000'000;  // executed tokens: the rest of the scene is only read for more errors

// Directives that declare nothing and have an end that can be found.
bool is_message(Word word) {
  return word == Word::debug || word == Word::warning || word == Word::render || word == Word::statistics ||
         word == Word::undef || word == Word::fclose || word == Word::write || word == Word::read;
}

bool is_last(const Token& token) { return token.kind == TokenKind::end || token.kind == TokenKind::error; }

// Behind the #end of the construct that a directive opens. Null, here and below: the end is not clear.
const Token* behind_construct(const TokenFile& file, const Token& opener) {
  std::uint32_t link = opener.link();
  while (link && file.tokens[link].word != Word::end) link = file.tokens[link].link();
  return link ? &file.tokens[link] + 1 : nullptr;
}

// Behind the parenthesis that closes the arguments of a name.
const Token* behind_call(const Token* name) {
  const Token* at = name;
  int open = 0;
  do {
    ++at;
    if (is_last(*at)) return nullptr;
    open += (at->punctuation == '(') - (at->punctuation == ')');
  } while (open);
  return at + 1;
}

// Behind a semicolon or the brace that closes the statement, or at the next directive.
const Token* behind_statement(const Token* first) {
  const bool directive = first->kind == TokenKind::directive;
  int braces = 0, parentheses = 0;
  bool block_in_parentheses = false;  // difference ( sphere { ... } )
  for (const Token* at = directive ? first + 1 : first;; ++at) {
    if (!braces) parentheses += (at->punctuation == '(') - (at->punctuation == ')');
    if (block_in_parentheses && !braces && !parentheses) return at + 1;
    if (is_last(*at)) return nullptr;
    if (at->kind == TokenKind::directive && !braces) return at;
    if (at->punctuation == ';' && !braces) return at + 1;
    if (at->punctuation == '{') ++braces;
    if (at->punctuation != '}') continue;
    if (braces > 0) --braces;
    block_in_parentheses |= !braces && parentheses > 0;
    if (braces || parentheses > 0) continue;
    if (!directive) return at + 1;
    // A layered texture goes on; a semicolon may end it.
    const Token* const next = at[1].punctuation == ';' ? at + 2 : at + 1;
    if (next->kind != TokenKind::word || next->word != Word::texture || first[3].word != Word::texture) return next;
    at = next - 1;
  }
}

}  // namespace

// Called where nothing is open but loops, branches, macros and include files: an error until the next call belongs to
// this token.
void Parser::Impl::mark_statement() {
  recovery.file = file;
  recovery.token = index(position);
  recovery.frames = frames.size();
  recovery.conditions = conditions.size();
}

// False: parsing ends here.
bool Parser::Impl::recover(ParseError& failure) {
  const bool consequence = touches_failed_name();
  if (!consequence && !failure.diagnostic.message.empty() &&
      recovery.reported.emplace(failure.diagnostic.file, failure.diagnostic.line, failure.diagnostic.message).second) {
    if (options.message) options.message(failure.diagnostic);
    report.errors.push_back(failure.diagnostic);
  }
  if (report.errors.size() == 1 && recovery.steps_left == 0) recovery.steps_left = steps + kMaxStepsAfterError;
  if (failure.last || report.errors.size() >= kMaxErrors || ++recovery.failures > kMaxFailures ||
      steps > recovery.steps_left)
    return false;
  if (!recovery.file || frames.size() < recovery.frames || conditions.size() < recovery.conditions) return false;

  while (frames.size() > recovery.frames) leave_frame();
  conditions.resize(recovery.conditions);
  if (file != recovery.file) return false;
  depth = depth_of_parentheses = 0;
  blocked = in_further_layer = false;
  arguments.clear();
  pending = {};
  go_to(recovery.file, recovery.token);
  return skip_statement();
}

// The statement names something whose declaration failed.
bool Parser::Impl::touches_failed_name() const {
  if (recovery.failed_names.empty() || !recovery.file || recovery.file != file) return false;
  const Tokens& tokens = recovery.file->tokens;
  const std::size_t last = std::min<std::size_t>(index(position) + 1, tokens.size());
  for (std::size_t i = recovery.token; i < last; ++i)
    if (tokens[i].kind == TokenKind::identifier && recovery.failed_names.contains(tokens[i].id())) return true;
  return false;
}

// What a call that failed would have declared.
void Parser::Impl::fail_names_of(const Macro& macro) {
  const Tokens& tokens = macro.file->tokens;
  for (std::uint32_t i = macro.body; i < macro.end; ++i)
    if (tokens[i].kind == TokenKind::directive && (tokens[i].word == Word::declare || tokens[i].word == Word::local) &&
        tokens[i + 1].kind == TokenKind::identifier)
      recovery.failed_names.insert(tokens[i + 1].id());
}

// A misspelt #if, #while, #for, #switch or #macro ends at its #end.
bool Parser::Impl::skip_block_of_directives() {
  int open = 1;
  for (const Token* at = position;; ++at) {
    if (is_last(*at)) return false;
    if (at->kind != TokenKind::directive) continue;
    open += opens_construct(at->word);
    if (at->word != Word::end || --open) continue;
    go_to(file, index(at) + 1);
    return true;
  }
}

// Moves the cursor behind the failing statement. False: its end is not clear.
bool Parser::Impl::skip_statement() {
  const Token* const first = position;
  const auto go_behind = [&](const Token* at) {
    if (at) go_to(file, index(at));
    return at != nullptr;
  };
  if (first->kind == TokenKind::directive) {
    const Word word = first->word;
    const bool declares = word == Word::declare || word == Word::local;
    if (declares || word == Word::macro) {
      if (first[1].kind != TokenKind::identifier) return false;
      recovery.failed_names.insert(first[1].id());
    }
    if (opens_construct(word)) return go_behind(behind_construct(*file, *first));
    return (declares || is_message(word) || word == Word::default_) && go_behind(behind_statement(first));
  }
  if (first->kind != TokenKind::end && file->hash_before(*first) != std::string_view::npos) {
    const MeantDirective meant = meant_directive(file->source->text().substr(first->offset, file->length(*first)));
    if (first[1].kind == TokenKind::identifier) recovery.failed_names.insert(first[1].id());  // #Declare NAME
    if (meant.opens) return skip_block_of_directives();
    if (meant.directive == "end" && !conditions.empty() && conditions.back().kind != Condition::Kind::macro) {
      conditions.pop_back();
      return go_behind(first + 1);
    }
  }
  if (first->kind == TokenKind::identifier) {
    const bool call = first[1].punctuation == '(';
    if (Symbol* symbol = names[first->id()].symbol; symbol && symbol->is_macro) {
      fail_names_of(*std::get<Shared<Macro>>(symbol->value()));
      if (!call) return go_behind(first + 1);
    }
    if (call) return go_behind(behind_call(first));
  }
  return go_behind(behind_statement(first));
}

}  // namespace verisim::parser
