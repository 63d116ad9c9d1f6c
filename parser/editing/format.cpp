#include "parser/editing/format.h"

#include <algorithm>
#include <memory>

#include "parser/editing/place.h"
#include "parser/lexer/directive_links.h"

namespace verisim::parser {
namespace {

std::shared_ptr<const TokenFile> all_tokens(std::string_view text, Names& names) {
  return tokenise(std::make_shared<Source>("", text), names, kMaxTokens);
}

bool same_tokens(const TokenFile& a, const TokenFile& b) {
  if (a.tokens.size() != b.tokens.size()) return false;
  for (std::size_t i = 0; i < a.tokens.size(); ++i) {
    const Token &x = a.tokens[i], &y = b.tokens[i];
    if (x.kind != y.kind || x.punctuation != y.punctuation || x.word != y.word || x.payload != y.payload) return false;
    if (x.kind == TokenKind::string && a.raw_string(x) != b.raw_string(y)) return false;
  }
  return a.numbers == b.numbers;
}

struct Line {
  std::size_t begin = 0, end = 0;  // without the line end
  bool inside = false;             // begins within a comment or a token: its blanks are not ours
  bool ends_inside = false;
  int levels = 0;
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back({begin, end});
    if (end == text.size()) return lines;
    begin = end + 1;
    if (begin < text.size() && text[end] != text[begin] && (text[begin] == '\r' || text[begin] == '\n')) ++begin;
  }
}

// What spans lines: marks those that begin or end within it.
void mark_inside(std::vector<Line>& lines, std::size_t begin, std::size_t end) {
  auto line = std::upper_bound(lines.begin(), lines.end(), begin,
                               [](std::size_t offset, const Line& l) { return offset < l.begin; });
  if (line == lines.begin()) return;
  for (--line; line != lines.end() && line->begin < end; ++line) {
    if (line->begin > begin) line->inside = true;
    if (line->end < end) line->ends_inside = true;
  }
}

// Levels of indentation: a line that opens something puts what follows one level deeper, however much it opens.
class Levels {
 public:
  Levels(const TokenFile& file, std::vector<Line>& lines) : file_(file), lines_(lines) {}

  void find() {
    const Tokens& tokens = file_.tokens;
    std::size_t next = 0;
    for (std::size_t n = 0; n < lines_.size(); ++n) {
      const std::size_t first = next;
      while (next < tokens.size() && tokens[next].kind != TokenKind::end && tokens[next].offset < line_end(n)) ++next;
      lines_[n].levels = level_of(first, next);
      for (std::size_t i = first; i < next; ++i) pass(tokens[i], lines_[n].levels);
    }
  }

 private:
  struct Open {
    char kind;  // '{', '(', '[', or '#' of a construct
    int level;  // of its line
  };

  std::size_t line_end(std::size_t n) const {
    return n + 1 < lines_.size() ? lines_[n + 1].begin : file_.source->text().size() + 1;
  }

  static char closes(const Token& token) {
    if (token.kind == TokenKind::directive) return token.word == Word::end ? '#' : char{0};
    if (token.kind != TokenKind::punctuation) return 0;
    return token.punctuation == '}' ? '{' : token.punctuation == ')' ? '(' : token.punctuation == ']' ? '[' : char{0};
  }

  // The innermost open one of a kind; its end when there is none.
  static std::vector<Open>::iterator innermost(std::vector<Open>& open, char kind) {
    const auto found = std::find_if(open.rbegin(), open.rend(), [&](const Open& o) { return o.kind == kind; });
    return found == open.rend() ? open.end() : std::prev(found.base());
  }

  // Of the line of tokens [first, next).
  int level_of(std::size_t first, std::size_t next) const {
    const Tokens& tokens = file_.tokens;
    std::vector<Open> open = open_;
    int level = -1;
    for (std::size_t i = first; i < next && closes(tokens[i]); ++i) {
      const auto closed = innermost(open, closes(tokens[i]));
      if (closed == open.end()) continue;
      level = closed->level;
      open.erase(closed);
    }
    if (level >= 0) return level;
    if (first < next && tokens[first].kind == TokenKind::directive && is_alternative(tokens[first].word))
      if (const auto construct = innermost(open, '#'); construct != open.end()) return construct->level;
    const int base = open_.empty() ? 0 : open_.back().level + 1;
    // What an `=` waits for.
    return base + (first < next && first > 0 && tokens[first - 1].punctuation == '=');
  }

  void pass(const Token& token, int level) {
    if (const char kind = closes(token)) {
      if (const auto closed = innermost(open_, kind); closed != open_.end()) open_.erase(closed);
      if (kind == '#' && !before_.empty()) before_.pop_back();
    } else if (token.kind == TokenKind::directive) {
      if (opens_construct(token.word)) {
        before_.push_back(open_);
        open_.push_back({'#', level});
      } else if (is_alternative(token.word) && !before_.empty()) {
        // Each branch may close and open what it likes: the next begins as the first did.
        open_ = before_.back();
        open_.push_back({'#', level});
      }
    } else if (token.kind == TokenKind::punctuation &&
               (token.punctuation == '{' || token.punctuation == '(' || token.punctuation == '[')) {
      open_.push_back({token.punctuation, level});
    }
  }

  const TokenFile& file_;
  std::vector<Line>& lines_;
  std::vector<Open> open_;
  std::vector<std::vector<Open>> before_;  // what was open before each construct under way
};

std::string indentation(int levels, const Layout& layout) {
  const auto count = static_cast<std::size_t>(std::max(levels, 0));
  return layout.tabs ? std::string(count, '\t')
                     : std::string(count * static_cast<std::size_t>(std::clamp(layout.width, 0, 16)), ' ');
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::vector<TextEdit> format_edits(std::string_view text, const Layout& layout) {
  Names names;
  const auto file = all_tokens(text, names);
  if (file->tokens.back().kind == TokenKind::error) return {};
  std::vector<Line> lines = lines_of(text);
  for (const Comment& comment : comments_of(*file)) mark_inside(lines, comment.begin, comment.end);
  for (const Token& token : file->tokens)
    if (token.kind == TokenKind::string || token.kind == TokenKind::vector)
      mark_inside(lines, token.offset, token.offset + file->length(token));
  Levels(*file, lines).find();

  std::vector<TextEdit> edits;
  const auto replace = [&](std::size_t begin, std::size_t end, std::string with) {
    if (text.substr(begin, end - begin) != with) edits.push_back({{begin, end}, std::move(with)});
  };
  std::size_t token = 0;
  for (const Line& line : lines) {
    std::size_t first = line.begin, last = line.end;
    if (!line.ends_inside)
      while (last > first && is_blank(text[last - 1])) --last;
    if (!line.inside)
      while (first < last && is_blank(text[first])) ++first;
    if (!line.inside) replace(line.begin, first, first == last ? "" : indentation(line.levels, layout));
    for (; token < file->tokens.size() && file->tokens[token].offset < last; ++token) {
      const Token& t = file->tokens[token];
      if (t.punctuation != '{' || token == 0 || t.offset <= first) continue;
      const Token& before = file->tokens[token - 1];
      if ((before.kind == TokenKind::word || before.kind == TokenKind::directive) &&
          before.offset + file->length(before) == t.offset)
        edits.push_back({{t.offset, t.offset}, " "});
    }
    if (first < last || line.inside)
      replace(last, line.end, "");
    else if (first == last && !line.inside && first < line.end)
      replace(first, line.end, "");
  }
  const auto after = all_tokens(applied(text, edits), names);
  return same_tokens(*file, *after) ? edits : std::vector<TextEdit>{};
}

std::string applied(std::string_view text, const std::vector<TextEdit>& edits) {
  std::string out;
  std::size_t done = 0;
  for (const TextEdit& edit : edits) {
    out += text.substr(done, edit.range.begin - done);
    out += edit.text;
    done = edit.range.end;
  }
  out += text.substr(done);
  return out;
}

}  // namespace verisim::parser
