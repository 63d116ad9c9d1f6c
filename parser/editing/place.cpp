#include "parser/editing/place.h"

#include <algorithm>
#include <cctype>

namespace verisim::parser {
namespace {

// An open bracket: which word opened it.
struct Open {
  char bracket = 0;
  Word word = Word::none;
  bool directive = false;
};

bool is_any(Word word, std::initializer_list<Word> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The block of entries of a map is the block that they are made of.
std::string entry_of(Word map) {
  switch (map) {
    case Word::pigment_map:
      return "pigment";
    case Word::normal_map:
      return "normal";
    case Word::texture_map:
      return "texture";
    case Word::density_map:
      return "density";
    default:
      return "expression";
  }
}

std::string place_of(const std::vector<Open>& open) {
  const Open& top = open.back();
  const Word parent = open.size() > 1 ? open[open.size() - 2].word : Word::none;
  if (top.bracket == '[') return entry_of(parent);
  if (top.bracket != '{') return "expression";
  switch (top.word) {
    case Word::sphere:
    case Word::cylinder:
      if (parent == Word::blob) return "component";
      [[fallthrough]];
    case Word::box:
      if (parent == Word::contained_by) return "expression";
      break;
    case Word::triangle:
    case Word::smooth_triangle:
      if (parent == Word::mesh) return "mesh_triangle";
      break;
    case Word::radiosity:
      return parent == Word::global_settings ? "global_radiosity" : "object_radiosity";
    case Word::photons:
      return parent == Word::global_settings                           ? "global_photons"
             : is_any(parent, {Word::light_source, Word::light_group}) ? "light_photons"
                                                                       : "object_photons";
    case Word::subsurface:
      return parent == Word::global_settings ? "global_subsurface" : "finish_subsurface";
    case Word::object:
      if (is_any(parent, {Word::pigment, Word::normal, Word::texture, Word::density, Word::interior_texture}))
        return "object_pattern";
      break;
    case Word::pattern:
      return "function_pattern";
    case Word::pigment_pattern:
      return "pigment";
    case Word::interior_texture:
      return "texture";
    case Word::slope:
      return "+slope";
    case Word::default_:
      if (top.directive) return "#default";
      break;
    case Word::none:
      return "";
    default:
      break;
  }
  return std::string(spelling(top.word));
}

// The word that opens the brace at a token: before it, or before the parameters of a function.
Open opener(const TokenFile& file, std::size_t at) {
  const Tokens& tokens = file.tokens;
  Open open{tokens[at].punctuation, Word::none, false};
  if (open.bracket != '{' || at == 0) return open;
  std::size_t i = at - 1;
  if (tokens[i].punctuation == ')') {
    int depth = 1;
    while (i > 0 && depth > 0) {
      --i;
      depth += (tokens[i].punctuation == ')') - (tokens[i].punctuation == '(');
    }
    if (i > 0) --i;
  } else {
    // height_field { function 4, 4 { ... } }
    for (std::size_t back = i; back > 0 && at - back < 5; --back)
      if (tokens[back].word == Word::function) i = back;
  }
  open.word = tokens[i].word;
  open.directive = tokens[i].kind == TokenKind::directive;
  return open;
}

bool is_name_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Whether an offset is in a comment; `from`: the end of the token before it.
bool in_comment(std::string_view text, std::size_t from, std::size_t offset) {
  for (std::size_t i = from; i < offset;) {
    if (text.compare(i, 2, "//") == 0) {
      const std::size_t end = std::min(text.find_first_of("\r\n", i), text.size());
      if (offset > i + 1 && offset <= end) return true;
      i = end;
    } else if (text.compare(i, 2, "/*") == 0) {
      int depth = 1;
      std::size_t j = i + 2;
      for (; j < text.size() && depth > 0; ++j) {
        if (text.compare(j, 2, "/*") == 0)
          ++depth, ++j;
        else if (text.compare(j, 2, "*/") == 0)
          --depth, ++j;
      }
      if (offset > i + 1 && offset < j) return true;
      i = j;
    } else {
      ++i;
    }
  }
  return false;
}

}  // namespace

EditPlace place_at(const TokenFile& file, std::string_view text, std::size_t offset) {
  const Tokens& tokens = file.tokens;
  EditPlace result;
  result.begin = offset;
  while (result.begin > 0 && is_name_character(text[result.begin - 1])) --result.begin;
  std::vector<Open> open;
  std::vector<bool> macros;  // of the constructs under way, which are macros
  std::size_t i = 0;         // the first token that begins at or behind the word under the cursor
  for (; i < tokens.size() && tokens[i].kind != TokenKind::end && tokens[i].offset < result.begin; ++i) {
    const Token& token = tokens[i];
    const char c = token.punctuation;
    if (token.kind == TokenKind::string || token.kind == TokenKind::vector) {
      const std::size_t end = token.offset + file.length(token);
      if (offset > token.offset && offset < end) {
        result.in = token.kind == TokenKind::string ? EditPlace::In::string : EditPlace::In::code;
        result.begin = token.kind == TokenKind::string ? token.offset + std::size_t{1} : result.begin;
        result.place = "expression";
        result.opener = i ? tokens[i - 1].word : Word::none;
        return result;
      }
    }
    if (token.kind == TokenKind::directive) {
      if (token.word == Word::end && !macros.empty()) macros.pop_back();
      if (is_any(token.word, {Word::if_, Word::ifdef, Word::ifndef, Word::while_, Word::for_, Word::switch_}))
        macros.push_back(false);
      if (token.word == Word::macro) macros.push_back(true), open.clear();
    }
    if (token.kind != TokenKind::punctuation) continue;
    if (c == '{' || c == '(' || c == '[') open.push_back(opener(file, i));
    if ((c == '}' || c == ')' || c == ']') && !open.empty()) open.pop_back();
  }
  const std::size_t behind = i ? tokens[i - 1].offset + file.length(tokens[i - 1]) : 0;
  if (in_comment(text, std::min(behind, offset), offset)) {
    result.in = EditPlace::In::comment;
    return result;
  }
  // A string that is not closed yet has no token.
  const std::size_t line = text.find_last_of("\r\n", offset ? offset - 1 : 0);
  const std::size_t line_start = line == std::string_view::npos || offset == 0 ? 0 : line + 1;
  const std::size_t from = std::max(line_start, std::min(behind, offset));
  if (const std::size_t quote = text.substr(0, offset).find('"', from); quote != std::string_view::npos) {
    result.in = EditPlace::In::string;
    result.begin = quote + 1;
    result.opener = i ? tokens[i - 1].word : Word::none;
    result.place = "expression";
    return result;
  }
  std::size_t before = result.begin;
  while (before > 0 && (text[before - 1] == ' ' || text[before - 1] == '\t')) --before;
  result.behind_hash = before > 0 && text[before - 1] == '#';
  result.behind_dot = result.begin > 0 && text[result.begin - 1] == '.';
  result.opener = i ? tokens[i - 1].word : Word::none;
  if (!open.empty())
    result.place = place_of(open);
  else if (i && tokens[i - 1].punctuation == '=')
    result.place = "value";
  else if (std::find(macros.begin(), macros.end(), true) == macros.end())
    result.place = "scene";
  return result;
}

std::vector<Comment> comments_of(const TokenFile& file) {
  const std::string_view text = file.source->text();
  std::vector<Comment> comments;
  std::size_t from = 0;
  for (const Token& token : file.tokens) {
    const std::size_t to = token.kind == TokenKind::end ? text.size() : token.offset;
    for (std::size_t i = from; i + 1 < to;) {
      if (text[i] == '/' && text[i + 1] == '/') {
        const std::size_t end = std::min({text.find_first_of("\r\n", i), text.size(), to});
        comments.push_back({i, end});
        i = end;
      } else if (text[i] == '/' && text[i + 1] == '*') {
        int depth = 1;
        std::size_t j = i + 2;
        for (; j < to && depth > 0; ++j) {
          if (text.compare(j, 2, "/*") == 0)
            ++depth, ++j;
          else if (text.compare(j, 2, "*/") == 0)
            --depth, ++j;
        }
        comments.push_back({i, std::min(j, to)});
        i = j;
      } else {
        ++i;
      }
    }
    if (token.kind == TokenKind::end || token.kind == TokenKind::error) break;
    from = token.offset + file.length(token);
  }
  return comments;
}

const Token& token_at(const TokenFile& file, std::size_t offset) {
  const Tokens& tokens = file.tokens;
  auto next = std::upper_bound(tokens.begin(), tokens.end(), offset,
                               [](std::size_t o, const Token& token) { return o < token.offset; });
  if (next == tokens.begin()) return tokens.back();
  const Token& token = *std::prev(next);
  const std::size_t end = token.offset + file.length(token);
  const auto is_name = [](const Token& t) {
    return t.kind == TokenKind::word || t.kind == TokenKind::identifier || t.kind == TokenKind::directive;
  };
  // The end of a name that something follows at once: "sphere{".
  if (token.offset == offset && !is_name(token) && std::prev(next) != tokens.begin()) {
    const Token& before = *std::prev(std::prev(next));
    if (is_name(before) && before.offset + file.length(before) == offset) return before;
  }
  return offset <= end && token.kind != TokenKind::end ? token : tokens.back();
}

}  // namespace verisim::parser
