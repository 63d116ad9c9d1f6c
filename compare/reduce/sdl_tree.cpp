#include "compare/reduce/sdl_tree.h"

#include <algorithm>
#include <memory>

#include "parser/editing/place.h"
#include "parser/keywords/keywords.h"
#include "parser/lexer/directive_links.h"

namespace verisim::compare {
namespace {

using parser::Token;
using parser::TokenFile;
using parser::TokenKind;
using parser::Word;

// Words that stand in blocks by themselves, and not only in expressions.
std::vector<bool> item_words() {
  std::vector<bool> out;
  for (const parser::WordEntry& entry : parser::all_words()) {
    const auto index = static_cast<std::size_t>(entry.word);
    if (index >= out.size()) out.resize(index + 1);
    for (const parser::Keyword* use : parser::keyword_uses(entry.text))
      for (const std::string_view place : parser::places_of(*use))
        if (place != "expression" && place != "value" && place != "#" && !place.starts_with('+')) out[index] = true;
  }
  return out;
}

bool begins_item(const Token& token) {
  static const std::vector<bool> words = item_words();
  const auto index = static_cast<std::size_t>(token.word);
  return token.kind == TokenKind::word && index < words.size() && words[index];
}

bool is(const Token& token, char punctuation) {
  return token.kind == TokenKind::punctuation && token.punctuation == punctuation;
}

class TreeReader {
 public:
  // constructs: directives with an #end are one statement; else each directive is one, as if it had nothing to do with
  // the others, for texts in which branches open and close blocks.
  TreeReader(const TokenFile& file, bool constructs) : file_(file), tokens_(file.tokens), constructs_(constructs) {}

  std::optional<SdlBlock> whole() {
    SdlBlock out;
    if (!read(out) || token().kind != TokenKind::end) return std::nullopt;
    return out;
  }

 private:
  const Token& token() const { return tokens_[at_]; }
  const Token& previous() const { return tokens_[at_ - 1]; }
  std::size_t end_of(std::size_t at) const { return tokens_[at].offset + file_.length(tokens_[at]); }

  bool ends_branch() const {
    return constructs_ && token().kind == TokenKind::directive &&
           (token().word == Word::end || parser::is_alternative(token().word));
  }

  // Up to what closes the block, which stays.
  bool read(SdlBlock& block) {
    block.inside.begin = at_ > 0 ? end_of(at_ - 1) : 0;
    // Deeper than anybody writes, and no danger for the stack.
    constexpr int kDeepest = 200;
    if (++depth_ > kDeepest) return false;
    for (bool complete = true;;) {
      const Token& t = token();
      if (t.kind == TokenKind::end || t.kind == TokenKind::error || is(t, '}') || is(t, ')') || is(t, ']') ||
          ends_branch())
        break;
      const bool statement = complete || begins_statement(block);
      if (statement) block.statements.push_back({{t.offset, 0}, {}, t.word, t.kind == TokenKind::directive});
      SdlStatement& last = block.statements.back();
      if (statement || begins_part()) last.parts.push_back({{t.offset, 0}, {}});
      complete = false;
      if (!read_token(last.parts.back(), complete)) return false;
      last.range.end = last.parts.back().range.end = end_of(at_ - 1);
    }
    --depth_;
    block.inside.end = token().kind == TokenKind::end ? file_.source->text().size() : token().offset;
    return closes(block.bracket);
  }

  bool closes(char bracket) const {
    const Token& t = token();
    if (bracket == '#') return ends_branch();
    return bracket == 0 ? t.kind == TokenKind::end : is(t, bracket == '{' ? '}' : ']');
  }

  // Sets `complete` where no token can belong to the statement any more.
  bool read_token(SdlPart& part, bool& complete) {
    const Token& t = token();
    ++at_;
    if (t.kind == TokenKind::directive && constructs_ && parser::opens_construct(t.word)) {
      complete = true;
      return read_construct(part, t.word);
    }
    if (is(t, '(')) return pass_parentheses();
    if (is(t, ';')) complete = true;
    if (!is(t, '{') && !is(t, '[')) return true;
    part.blocks.push_back({t.punctuation, {}, {}});
    if (!read(part.blocks.back())) return false;
    ++at_;
    return true;
  }

  // What stands behind its directive has been read.
  bool read_construct(SdlPart& part, Word word) {
    if (word == Word::macro && token().kind != TokenKind::punctuation) ++at_;
    for (;;) {
      if (is(token(), '(') && word != Word::else_) {
        ++at_;
        if (!pass_parentheses()) return false;
      }
      part.blocks.push_back({'#', {}, {}});
      if (!read(part.blocks.back())) return false;
      word = token().word;
      ++at_;
      if (word == Word::end) return true;
    }
  }

  // Behind the opening one.
  bool pass_parentheses() {
    for (int depth = 1; depth > 0; ++at_) {
      if (token().kind == TokenKind::end || token().kind == TokenKind::error) return false;
      depth += is(token(), '(') - is(token(), ')');
    }
    return true;
  }

  // Whether something may begin behind the token before: no operator, and no word that waits for a value.
  bool follows_value() const {
    const Token& p = previous();
    switch (p.kind) {
      case TokenKind::punctuation:
        return p.punctuation == '}' || p.punctuation == ')' || p.punctuation == ']' || p.punctuation == '>' ||
               p.punctuation == ';';
      case TokenKind::directive:
        return p.word == Word::end;
      case TokenKind::word:
        return !begins_item(p);
      default:
        return true;
    }
  }

  bool begins_statement(const SdlBlock& block) const {
    const Token& t = token();
    if (t.kind == TokenKind::directive) return true;
    if (is(t, '[')) return block.bracket == '{' && is(previous(), ']') && is_entry(block);
    return (begins_item(t) || t.kind == TokenKind::identifier) && follows_value();
  }
  // Whether the last statement is an entry of a map.
  bool is_entry(const SdlBlock& block) const {
    return file_.source->text()[block.statements.back().range.begin] == '[';
  }

  bool begins_part() const {
    const Token& t = token();
    if (!begins_item(t) && t.kind != TokenKind::identifier) return false;
    return follows_value() || begins_item(previous());
  }

  const TokenFile& file_;
  const parser::Tokens& tokens_;
  bool constructs_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

// A line end before each statement of a block with more than one, and before what closes it.
void break_lines(const std::string& text, const SdlBlock& block, std::vector<TextEdit>& out) {
  const bool lines = block.bracket != '[' && (block.statements.size() > 1 || block.bracket == '#');
  const auto add = [&](std::size_t at) {
    std::size_t begin = at;
    while (begin > 0 && std::isspace(static_cast<unsigned char>(text[begin - 1]))) --begin;
    if (begin > 0) out.push_back({{begin, at}, "\n"});
  };
  if (!lines && block.bracket == '{' && !block.statements.empty()) {
    out.push_back({{block.inside.begin, block.statements.front().range.begin}, " "});
    out.push_back({{block.statements.back().range.end, block.inside.end}, " "});
  }
  for (const SdlStatement& statement : block.statements) {
    if (lines) add(statement.range.begin);
    for (const SdlPart& part : statement.parts)
      for (const SdlBlock& inner : part.blocks) break_lines(text, inner, out);
  }
  if (lines && block.bracket != 0) add(block.inside.end);
}

std::shared_ptr<const TokenFile> tokens_of(std::string_view text, parser::Names& names) {
  return parser::tokenise(std::make_shared<parser::Source>("", text), names, parser::kMaxTokens);
}

}  // namespace

std::optional<SdlBlock> sdl_tree(std::string_view text) {
  parser::Names names;
  const auto file = tokens_of(text, names);
  if (auto tree = TreeReader(*file, true).whole()) return tree;
  return TreeReader(*file, false).whole();
}

std::string stripped(std::string_view text) {
  parser::Names names;
  const auto file = tokens_of(text, names);
  std::string out;
  std::size_t end = 0;
  for (const Token& token : file->tokens) {
    if (token.kind == TokenKind::error) return std::string(text);
    const std::string_view gap = text.substr(end, token.offset - end);
    if (token.kind == TokenKind::end) break;
    if (!out.empty() && !gap.empty()) out += gap.find('\n') == std::string_view::npos ? ' ' : '\n';
    out += text.substr(token.offset, file->length(token));
    end = token.offset + file->length(token);
  }
  if (!out.empty() && out.back() != '\n') out += '\n';
  return out;
}

std::string laid_out(const std::string& text) {
  std::vector<TextEdit> breaks;
  if (const auto tree = sdl_tree(text)) break_lines(text, *tree, breaks);
  std::sort(breaks.begin(), breaks.end(),
            [](const TextEdit& a, const TextEdit& b) { return a.range.begin < b.range.begin; });
  const std::string lines = stripped(parser::applied(text, breaks));
  return parser::applied(lines, parser::format_edits(lines, {}));
}

}  // namespace verisim::compare
