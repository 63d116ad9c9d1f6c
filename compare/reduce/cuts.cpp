#include "compare/reduce/cuts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "parser/lexer/number.h"

namespace verisim::compare {
namespace {

using parser::NameDeclaration;
using parser::NameIndex;
using parser::Word;

Change replaced(TextRange range, std::string text) { return {{range, std::move(text)}}; }
std::string text_of(const std::string& text, TextRange range) {
  return text.substr(range.begin, range.end - range.begin);
}

void for_blocks(const SdlBlock& block, std::size_t depth, const std::function<void(const SdlBlock&)>& visit) {
  if (depth == 0) return visit(block);
  for (const SdlStatement& statement : block.statements)
    for (const SdlPart& part : statement.parts)
      for (const SdlBlock& inner : part.blocks) for_blocks(inner, depth - 1, visit);
}

void for_parts(const SdlBlock& tree, std::size_t depth,
               const std::function<void(const SdlStatement&, const SdlPart&)>& visit) {
  for_blocks(tree, depth, [&](const SdlBlock& block) {
    for (const SdlStatement& statement : block.statements)
      for (const SdlPart& part : statement.parts) visit(statement, part);
  });
}

// Where statements end, by where they begin.
void find_statements(const SdlBlock& block, std::map<std::size_t, std::size_t>& out) {
  for (const SdlStatement& statement : block.statements) {
    out[statement.range.begin] = statement.range.end;
    for (const SdlPart& part : statement.parts)
      for (const SdlBlock& inner : part.blocks) find_statements(inner, out);
  }
}

// Of `#declare NAME = VALUE`, which ends there, the value without a semicolon; nothing for what is no such thing.
std::optional<TextRange> value_of(const std::string& text, const NameDeclaration& declared, std::size_t end) {
  if (declared.kind != NameDeclaration::Kind::variable) return std::nullopt;
  std::size_t at = declared.offset + declared.name.size();
  const auto is_blank = [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(text[i])) != 0; };
  while (at < end && is_blank(at)) ++at;
  if (at >= end || text[at] != '=') return std::nullopt;
  while (++at < end && is_blank(at)) continue;
  while (end > at && (is_blank(end - 1) || text[end - 1] == ';')) --end;
  return at < end ? std::optional(TextRange{at, end}) : std::nullopt;
}

// `texture { BODY }`: BODY.
std::optional<std::string> content_of(const std::string& value) {
  const std::size_t open = value.find('{');
  if (open == std::string::npos || value.back() != '}') return std::nullopt;
  return value.substr(open + 1, value.size() - open - 2);
}

}  // namespace

std::size_t depth_of(const SdlBlock& tree) {
  std::size_t deepest = 0;
  for (const SdlStatement& statement : tree.statements)
    for (const SdlPart& part : statement.parts)
      for (const SdlBlock& block : part.blocks) deepest = std::max(deepest, depth_of(block));
  return deepest + 1;
}

std::vector<Change> statements_left_out(const SdlBlock& tree, std::size_t depth) {
  std::vector<Change> out;
  for_blocks(tree, depth, [&](const SdlBlock& block) {
    for (const SdlStatement& statement : block.statements) {
      const bool language =
          depth == 0 && &statement == block.statements.data() && statement.directive && statement.word == Word::version;
      if (!language) out.push_back(replaced(statement.range, " "));
    }
  });
  return out;
}

std::vector<Change> parts_left_out(const SdlBlock& tree, std::size_t depth) {
  std::vector<Change> out;
  for_parts(tree, depth, [&](const SdlStatement& statement, const SdlPart& part) {
    if (statement.parts.size() > 1) out.push_back(replaced(part.range, " "));
  });
  return out;
}

std::vector<Change> contents_of_blocks(const std::string& text, const SdlBlock& tree, std::size_t depth, bool last) {
  std::vector<Change> out;
  for_parts(tree, depth, [&](const SdlStatement&, const SdlPart& part) {
    if (part.blocks.empty() || (!last && part.blocks.size() < 2)) return;
    const SdlBlock& block = part.blocks[part.blocks.size() - (last ? 1 : 2)];
    if (block.bracket != '[') out.push_back(replaced(part.range, " " + text_of(text, block.inside) + " "));
  });
  return out;
}

std::vector<Change> loops_once(const std::string& text, const SdlBlock& tree, std::size_t depth) {
  std::vector<Change> out;
  for_parts(tree, depth, [&](const SdlStatement& statement, const SdlPart& part) {
    if (!statement.directive || part.blocks.size() != 1) return;
    const std::size_t begin = part.range.begin, body = part.blocks[0].inside.begin;
    if (statement.word == Word::while_) {
      const std::size_t word = text.find("while", begin);
      if (word < body) out.push_back(replaced({word, word + 5}, "if"));
    } else if (statement.word == Word::for_) {  // #for (NAME, FROM, TO): up to FROM
      const std::string head = text.substr(begin, body - begin);
      const std::size_t name = head.find(','), from = head.find(',', name + 1), end = head.rfind(')');
      if (name == std::string::npos || from == std::string::npos || end == std::string::npos) return;
      out.push_back(replaced({begin + from + 1, begin + end}, head.substr(name + 1, from - name - 1)));
    }
  });
  return out;
}

std::vector<Change> names_replaced(const std::string& text, Meaning meaning) {
  constexpr std::size_t kShort = 60;  // what is used more than once is repeated only when it is short
  const NameIndex index(text);
  const auto tree = sdl_tree(text);
  std::map<std::size_t, std::size_t> ends;
  if (tree) find_statements(*tree, ends);
  std::vector<Change> out;
  for (const NameDeclaration& declared : index.declarations()) {
    const auto statement = ends.find(declared.whole.begin);
    if (statement == ends.end()) continue;
    const TextRange whole{statement->first, statement->second};
    const auto range = value_of(text, declared, whole.end);
    if (!range) continue;
    std::string value = text_of(text, *range);
    if (meaning == Meaning::content) {
      const auto content = content_of(value);
      if (!content) continue;
      value = *content;
    } else if (meaning == Meaning::in_parentheses) {
      value = "(" + value + ")";
    }
    Change change;
    bool again = false;  // declared more than once: what it means is not to be told here
    for (const parser::NameUse& use : index.same_name(declared.name, declared.offset)) {
      again |= use.offset >= whole.begin && use.offset < whole.end && use.offset != declared.offset;
      for (const NameDeclaration& other : index.declarations())
        again |= &other != &declared && other.offset == use.offset;
      if (use.offset != declared.offset)
        change.push_back({{use.offset, use.offset + use.name.size()}, " " + value + " "});
    }
    if (again || change.empty() || (change.size() > 1 && value.size() > kShort)) continue;
    change.push_back({whole, " "});
    std::sort(change.begin(), change.end(),
              [](const TextEdit& a, const TextEdit& b) { return a.range.begin < b.range.begin; });
    out.push_back(std::move(change));
  }
  return out;
}

std::vector<Change> numbers_replaced(const std::string& text, char digit) {
  const NameIndex index(text);
  std::vector<Change> out;
  const auto replace = [&](std::size_t begin, std::size_t end) {
    const std::string number = text.substr(begin, end - begin),
                      rounder = digit ? std::string(1, digit) : fmt::format("{:.1g}", std::strtod(number.c_str(), {}));
    if (rounder.size() < number.size()) out.push_back(replaced({begin, end}, rounder));
  };
  const parser::Token* before = nullptr;
  for (const parser::Token& token : index.tokens().tokens) {
    const std::size_t end = token.offset + index.tokens().length(token);
    const bool version = before && before->word == Word::version;
    before = &token;
    if (token.kind == parser::TokenKind::number && !version) replace(token.offset, end);
    if (token.kind != parser::TokenKind::vector) continue;
    for (const char* p = text.c_str() + token.offset; p < text.c_str() + end;) {
      const char* const begin = p;
      double value = 0;
      if (!parser::starts_number(p) || !parser::read_number(p, value))
        ++p;
      else
        replace(static_cast<std::size_t>(begin - text.c_str()), static_cast<std::size_t>(p - text.c_str()));
    }
  }
  return out;
}

std::vector<Change> includes_replaced(const std::string& text,
                                      const std::function<std::optional<std::string>(const std::string&)>& file) {
  const NameIndex index(text);
  std::vector<Change> out;
  for (const TextRange& name : index.includes()) {
    const std::size_t directive = text.rfind('#', name.begin);
    if (directive == std::string::npos) continue;
    if (const auto content = file(text_of(text, name)))
      out.push_back(replaced({directive, name.end + 1}, "\n" + *content + "\n"));
  }
  return out;
}

std::vector<Change> lines_left_out(const std::string& text) {
  std::vector<Change> out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    out.push_back(replaced({begin, end}, ""));
    begin = end;
  }
  return out;
}

}  // namespace verisim::compare
