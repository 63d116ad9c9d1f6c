// The cursor: from the token arrays of files to the one stream that blocks and expressions see. Directives and macro
// calls that stand in the way are executed when the next token is about to be read (spec 01 section 4).
#include <fmt/format.h>

#include "parser/language/impl.h"
#include "parser/language/blocks.h"
#include "parser/source/origins.h"
#include "tracer/base/resident_memory.h"

namespace verisim::parser {

const Token& Parser::Impl::fetch() {
  for (;;) {
    const Token& token = *position;
    switch (token.kind) {
      case TokenKind::identifier: {
        Symbol* symbol = names[token.id()].symbol;
        if (symbol && symbol->is_macro) {
          call_macro(*symbol);
          continue;
        }
        break;
      }
      case TokenKind::directive:
        directive();
        continue;
      case TokenKind::end:
        if (end_of_file()) continue;
        return token;  // of the main file: not `ready`, so that every look is at the end
      case TokenKind::error:
        lex_error(token);
      default:
        break;
    }
    ready = true;
    return *position;
  }
}

const Token& Parser::Impl::fetch_blocked() {
  for (;;) {
    const Token& token = *position;
    if (token.kind == TokenKind::error) lex_error(token);
    if (token.kind == TokenKind::end && end_of_file()) continue;
    // The end of a macro is always honoured.
    if (token.kind == TokenKind::directive && token.word == Word::end && !conditions.empty() &&
        conditions.back().kind == Condition::Kind::macro) {
      directive();
      continue;
    }
    return token;
  }
}

bool Parser::Impl::stopped() {
  if (!in_further_layer) return false;
  const Token& token = peek_blocked();
  if (token.kind != TokenKind::identifier) return token.kind == TokenKind::directive;
  const Symbol* symbol = names[token.id()].symbol;
  return symbol && symbol->is_macro;
}

Token Parser::Impl::take_raw() {
  const Token token = peek_blocked();
  if (token.kind != TokenKind::end) skip_token();
  return token;
}

void Parser::Impl::expect_operator(char punctuation) {
  if (!accept_operator(punctuation)) expected(std::string_view(&punctuation, 1));
}

void Parser::Impl::go_to(const TokenFile* target, std::uint32_t token) {
  file = target;
  position = target->tokens.data() + token;
  ready = false;
  pending.at = not_fast = nullptr;
}

bool Parser::Impl::end_of_file() {
  if (frames.empty()) return false;
  if (frames.back().macro)
    error(Code::unclosed_condition,
          fmt::format("The file ends inside macro '{}'.", names[frames.back().macro->name].text));
  leave_frame();
  return true;
}

void Parser::Impl::enter_file(std::shared_ptr<const TokenFile> entered, std::uint32_t call) {
  if (static_cast<int>(frames.size()) >= options.limits.max_depth)
    fatal(Code::nesting_limit, "Too many nested include files and macro calls.", "--max-depth raises this limit.");
  Frame frame;
  frame.file = file;
  frame.position = index(position);
  frame.call = call;
  frame.including = std::move(entered);
  frames.push_back(std::move(frame));
  symbols.push();
  go_to(frames.back().including.get(), 0);
  count_steps(file->tokens.size());
}

void Parser::Impl::leave_frame() {
  const Frame& frame = frames.back();
  go_to(frame.file, frame.position);
  symbols.pop();
  frames.pop_back();
}

// Now and then: is anything beyond its limit?
void Parser::Impl::check_limits() {
  next_check = steps + (1 << 16);
  next_look = coarse_milliseconds() + 100;
  const Limits& limits = options.limits;
  if (limits.max_steps && steps > limits.max_steps)
    fatal(Code::size_limit, "The scene executes more steps than --max-steps allows: an endless loop?");
  if (options.cancelled && options.cancelled())
    fatal(Code::time_limit, "Interrupted, or longer than --max-seconds allows.");
  if (resident_memory() > limits.max_memory_bytes)
    fatal(Code::size_limit, "The scene needs more memory than --max-memory allows.");
}

void Parser::Impl::too_many_passes(std::string_view what) {
  error(Code::size_limit,
        fmt::format("{} needs more than {} passes of sum and prod and calls of functions for one value.", what,
                    functions::kMaxPasses));
}

void Parser::Impl::nested_too_deeply() {
  --depth;
  fatal(Code::nesting_limit, fmt::format("Nested deeper than {} levels.", options.limits.max_depth),
        "--max-depth raises this limit.");
}

void Parser::Impl::missing_surface(std::string_view what) {
  error(Code::incompatible, fmt::format("{} asks for uv_mapping, but there is no surface.", what));
}

// ---- The public face ----

const Token& Parser::peek() { return impl_->peek_item(); }

Token Parser::next() {
  const Token token = impl_->peek_item();
  if (token.kind != TokenKind::end) impl_->skip_token();
  return token;
}

bool Parser::at(Word word) {
  const Token& token = impl_->peek_item();
  return token.word == word && token.kind == TokenKind::word;
}

bool Parser::at(char punctuation) { return impl_->peek_item().punctuation == punctuation; }

bool Parser::accept(Word word) {
  if (!at(word)) return false;
  impl_->skip_token();
  return true;
}

bool Parser::accept(char punctuation) {
  if (!at(punctuation)) return false;
  impl_->skip_token();
  return true;
}

void Parser::expect(Word word) {
  if (!accept(word)) error_expected(spelling(word));
}

void Parser::expect(char punctuation) {
  if (!accept(punctuation)) error_expected(std::string_view(&punctuation, 1));
}

bool Parser::at_number_start() { return impl_->starts_numeric(impl_->peek_item()); }

scene::SourceLocation Parser::place() {
  const Token& token = impl_->peek_item();
  const Source& source = *impl_->file->source;
  const Position at = source.position(token.offset);
  const scene::SourceLocation place{source.shared_name(), at.line, at.column};
  return impl_->options.origins ? impl_->with_calls(place) : place;
}

scene::SourceLocation Parser::copied_to(const scene::SourceLocation& declared,
                                        const scene::SourceLocation& copy) const {
  if (!impl_->options.origins || !copy.file) return declared;
  Origins::Origin origin = impl_->options.origins->of(declared);
  origin.calls = impl_->options.origins->of(copy).calls;
  origin.calls.insert(origin.calls.begin(), fmt::format("{}:{}", *copy.file, copy.line));
  return impl_->options.origins->with(declared, std::move(origin));
}

}  // namespace verisim::parser
