#include "parser/editing/index.h"

#include <algorithm>

#include "parser/editing/place.h"
#include "parser/lexer/directive_links.h"

namespace verisim::parser {
namespace {

constexpr int kMaxRepairs = 100;

// A file that cannot be read to its end is read without what stopped the reading: the bytes up to the end of that line
// become blanks, so that all places stay.
std::shared_ptr<const TokenFile> tokens_of(std::string text, Names& names) {
  for (int i = 0;; ++i) {
    auto file = tokenise(std::make_shared<Source>("", text), names, kMaxTokens);
    const Token& last = file->tokens.back();
    if (last.kind != TokenKind::error || i == kMaxRepairs) return file;
    const std::size_t end = std::min(text.find_first_of("\r\n", last.offset), text.size());
    if (end <= last.offset) return file;
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(last.offset), text.begin() + static_cast<std::ptrdiff_t>(end),
              ' ');
  }
}

}  // namespace

NameIndex::NameIndex(std::string_view text) : file_(tokens_of(std::string(text), *names_)) { read(); }

std::size_t NameIndex::end_of(std::uint32_t token) const {
  const Token& t = file_->tokens[token];
  return t.offset + file_->length(t);
}

// Declares the identifier at a token; returns the token behind it.
std::uint32_t NameIndex::declare(std::uint32_t at, NameDeclaration::Kind kind, bool local) {
  const Token& token = file_->tokens[at];
  if (token.kind != TokenKind::identifier) return at;
  NameDeclaration d;
  d.name = (*names_)[token.id()].text;
  d.kind = kind;
  d.offset = token.offset;
  d.global = !local || macros_.empty();
  d.scope = d.global ? TextRange{0, file_->source->text().size()} : macros_.back();
  d.whole = {at > 0 ? file_->tokens[at - 1].offset : token.offset, end_of(at)};
  declarations_.push_back(std::move(d));
  return at + 1;
}

bool NameIndex::is(std::uint32_t token, char punctuation) const {
  return token < file_->tokens.size() && file_->tokens[token].punctuation == punctuation;
}

// Those from a token to a closing parenthesis.
void NameIndex::declare_parameters(std::uint32_t at, TextRange scope, std::vector<std::string>* list) {
  const Tokens& tokens = file_->tokens;
  for (; at < tokens.size() && (tokens[at].kind == TokenKind::identifier || is(at, ',')); ++at) {
    if (is(at, ',')) continue;
    NameDeclaration d;
    d.name = (*names_)[tokens[at].id()].text;
    d.kind = NameDeclaration::Kind::parameter;
    d.offset = tokens[at].offset;
    d.whole = {d.offset, end_of(at)};
    d.scope = scope;
    if (list) list->push_back(d.name);
    declarations_.push_back(std::move(d));
  }
}

// Where the braces behind the parameters of `function` close.
std::size_t NameIndex::end_of_function(std::uint32_t at) const {
  const Tokens& tokens = file_->tokens;
  for (int open = 0; at < tokens.size() && tokens[at].kind != TokenKind::end; ++at) {
    open += is(at, '{');
    if (is(at, '}') && --open <= 0) break;
  }
  return tokens[std::min<std::size_t>(at, tokens.size() - 1)].offset;
}

void NameIndex::read_macro(std::uint32_t at) {
  const Token& token = file_->tokens[at];
  const std::size_t end = token.link() ? end_of(token.link()) : file_->source->text().size();
  if (declare(at + 1, NameDeclaration::Kind::macro, false) == at + 1) return;
  const std::size_t here = declarations_.size() - 1;
  std::vector<std::string> list;
  const TextRange scope{end_of(at + 1), end};
  if (is(at + 2, '(')) declare_parameters(at + 3, scope, &list);
  declarations_[here].parameters = std::move(list);
  declarations_[here].whole = {token.offset, end};
  macros_.push_back(scope);
}

void NameIndex::read_directive(std::uint32_t at) {
  const Tokens& tokens = file_->tokens;
  using Kind = NameDeclaration::Kind;
  switch (const Word word = tokens[at++].word; word) {
    case Word::declare:
    case Word::local:
      if (tokens[at].word == Word::deprecated)
        while (at < tokens.size() && tokens[at].kind != TokenKind::identifier && tokens[at].kind != TokenKind::end)
          ++at;
      if (!is(at + 1, '[')) declare(at, Kind::variable, word == Word::local);
      break;
    case Word::fopen:
      declare(at, Kind::file, false);
      break;
    case Word::for_:
      if (is(at, '(')) declare(at + 1, Kind::variable, true);
      break;
    case Word::macro:
      read_macro(at - 1);
      break;
    case Word::include:
      if (tokens[at].kind == TokenKind::string) {
        const std::size_t begin = tokens[at].offset + std::size_t{1};
        includes_.push_back({begin, begin + tokens[at].id()});
      }
      break;
    default:
      break;
  }
}

void NameIndex::read() {
  const Tokens& tokens = file_->tokens;
  std::vector<std::size_t> constructs, blocks;  // where the open ones begin
  const auto close = [this](std::vector<std::size_t>& open, std::size_t end) {
    if (open.empty()) return;
    folds_.push_back({open.back(), end});
    open.pop_back();
  };
  for (std::uint32_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    while (!macros_.empty() && macros_.back().end <= token.offset) macros_.pop_back();
    if (token.kind == TokenKind::identifier) uses_.push_back({(*names_)[token.id()].text, token.offset});
    if (token.punctuation == '{')
      blocks.push_back(i && tokens[i - 1].kind == TokenKind::word ? tokens[i - 1].offset : token.offset);
    if (token.punctuation == '}') close(blocks, token.offset + std::size_t{1});
    if (token.kind == TokenKind::word && token.word == Word::function && is(i + 1, '('))
      declare_parameters(i + 2, {token.offset, end_of_function(i + 2)});
    if (token.kind != TokenKind::directive) continue;
    if (opens_construct(token.word)) constructs.push_back(token.offset);
    if (token.word == Word::end) close(constructs, end_of(i));
    read_directive(i);
  }
}

const NameUse* NameIndex::use_at(std::size_t offset) const {
  auto next = std::upper_bound(uses_.begin(), uses_.end(), offset,
                               [](std::size_t o, const NameUse& u) { return o < u.offset; });
  if (next == uses_.begin()) return nullptr;
  const NameUse& use = *std::prev(next);
  return offset <= use.offset + use.name.size() ? &use : nullptr;
}

const NameDeclaration* NameIndex::meaning(std::string_view name, std::size_t offset) const {
  const NameDeclaration* best = nullptr;
  for (const NameDeclaration& d : declarations_) {
    if (d.name != name || !d.scope.contains(offset)) continue;
    const auto size = [](const NameDeclaration& x) { return x.scope.end - x.scope.begin; };
    if (!best || size(d) < size(*best)) best = &d;
  }
  return best;
}

std::vector<NameUse> NameIndex::same_name(std::string_view name, std::size_t offset) const {
  const NameDeclaration* const wanted = meaning(name, offset);
  const TextRange everywhere{0, file_->source->text().size()};
  std::vector<NameUse> found;
  for (const NameUse& use : uses_) {
    if (use.name != name) continue;
    const NameDeclaration* d = meaning(name, use.offset);
    if ((d ? d->scope : everywhere) == (wanted ? wanted->scope : everywhere)) found.push_back(use);
  }
  return found;
}

}  // namespace verisim::parser
