// The grammar of tokens in Boost.Spirit X3. Blanks, names, numbers and comments are scanned by parsers of our own: they
// are nearly all of a file's bytes, and comments nest without limit, which a recursive rule would turn into stack.
#include "parser/lexer/lexer.h"

#include <boost/spirit/home/x3.hpp>
#include <bit>

#include "parser/lexer/directive_links.h"
#include "parser/lexer/number.h"

namespace verisim::parser {
namespace {

namespace x3 = boost::spirit::x3;

// Writes tokens; shared by all parsers of the grammar.
struct Sink {
  Tokens& tokens;
  Numbers& numbers;
  Names& names;
  const char* begin;
  std::size_t max_tokens;
  bool hash = false;     // a '#' waits for its word
  bool comment = false;  // a comment stands before the next token
  std::uint32_t hash_offset = 0;
  bool failed = false;

  std::uint32_t offset(const char* at) const { return static_cast<std::uint32_t>(at - begin); }

  bool put(const Token& token) {
    // '#' before anything but a directive word is ignored (spec 01 section 4).
    hash = comment = false;
    if (tokens.size() >= max_tokens) return fail(LexError::too_many_tokens, begin + token.offset);
    tokens.push_back(token);
    if (token.punctuation == '>') pack_vector();
    return true;
  }
  // Large scenes are mostly literal vectors: one token for each saves memory and time. Not behind what may be an
  // operand, where '<' may be "less than".
  bool may_precede_vector(std::size_t at) const {
    const auto is_color_word = [](const Token& token) {
      return token.kind == TokenKind::word && word_class(token.word) == WordClass::color;
    };
    const Token& previous = tokens[at - 1];
    switch (previous.kind) {
      case TokenKind::punctuation:
        return previous.punctuation != ')' && previous.punctuation != ']' && previous.punctuation != '>';
      case TokenKind::word:
        return word_class(previous.word) == WordClass::keyword || is_color_word(previous);
      case TokenKind::vector:  // that of a color may be an operand
        return at < 2 || !is_color_word(tokens[at - 2]);
      default:
        return false;
    }
  }
  // One with comments inside: those without never were tokens apart (Vector).
  void pack_vector() {
    std::size_t at = tokens.size() - 1, terms = 0;
    double values[5];
    for (;;) {
      if (at < 2 || terms == 5 || tokens[at - 1].kind != TokenKind::number) return;
      double value = tokens[--at].number();
      if (tokens[at - 1].punctuation == '-') value = -value, --at;
      values[terms++] = value;
      if (at < 1) return;
      const char before = tokens[--at].punctuation;
      if (before == '<') break;
      if (before != ',') return;
    }
    if (terms < 2 || at < 1 || tokens[at].kind != TokenKind::punctuation || !may_precede_vector(at)) return;
    if (numbers.size() + terms > 0xffffffffu) return;
    tokens[at].kind = TokenKind::vector;
    tokens[at].payload = numbers.size() | (std::uint64_t{terms} << 32);
    while (terms) numbers.push_back(values[--terms]);
    tokens.resize(at + 1);
  }
  bool fail(LexError error, const char* at) {
    Token token;
    token.kind = TokenKind::error;
    token.offset = offset(at);
    token.payload = static_cast<std::uint64_t>(error);
    tokens.push_back(token);
    failed = true;
    return false;
  }
};

// Base of our own parsers: no attribute, the Sink is the result.
template <class Derived>
struct TokenScanner : x3::parser<Derived> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
  Sink* sink;
  explicit TokenScanner(Sink& s) : sink(&s) {}

  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RContext&, Attribute&) const {
    return first != last && !sink->failed && static_cast<const Derived*>(this)->scan(first, last);
  }
};

struct Blanks : TokenScanner<Blanks> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char* last) const {
    const char* p = first;
    while (p != last && class_of(*p) == blank_class) ++p;
    if (p == first) return false;
    first = p;
    return true;
  }
};

struct LineComment : TokenScanner<LineComment> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char* last) const {
    if (*first != '/' || last - first < 2 || first[1] != '/') return false;
    while (first != last && *first != '\n' && *first != '\r') ++first;
    sink->comment = true;
    return true;
  }
};

// Nests; strings and line comments inside mean nothing; the '*' of an opener cannot also start a closer.
struct BlockComment : TokenScanner<BlockComment> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char* last) const {
    if (*first != '/' || last - first < 2 || first[1] != '*') return false;
    const char* p = first + 2;
    for (std::size_t depth = 1; depth;) {
      if (last - p < 2) return sink->fail(LexError::unterminated_comment, first);
      if (p[0] == '*' && p[1] == '/')
        --depth, p += 2;
      else if (p[0] == '/' && p[1] == '*')
        ++depth, p += 2;
      else
        ++p;
    }
    first = p;
    sink->comment = true;
    return true;
  }
};

struct WordOrIdentifier : TokenScanner<WordOrIdentifier> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char*) const {
    if (class_of(*first) != letter_class) return false;
    const char* p = first + 1;
    while (class_of(*p) == letter_class || class_of(*p) == digit_class) ++p;  // stops at the NUL behind the text
    const std::uint32_t id = sink->names.intern({first, static_cast<std::size_t>(p - first)});
    Token token;
    token.offset = sink->offset(first);
    token.word = sink->names[id].word;
    if (token.word == Word::none) {
      token.kind = TokenKind::identifier;
      token.payload = id;
    } else if (sink->hash && is_directive(token.word)) {
      token.kind = TokenKind::directive;
      token.offset = sink->hash_offset;
    } else {
      token.kind = TokenKind::word;
      token.payload = id;
    }
    first = p;
    return sink->put(token);
  }
};

// A literal number (number.h).
struct Number : TokenScanner<Number> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char*) const {
    const char* p = first;
    if (!starts_number(p)) return false;
    Token token;
    double value;
    if (!read_number(p, value)) return sink->fail(LexError::second_point, first);
    token.kind = TokenKind::number;
    token.offset = sink->offset(first);
    token.payload = std::bit_cast<std::uint64_t>(value);
    first = p;
    return sink->put(token);
  }
};

// < > around 2 to 5 literal numbers with commas.
struct Vector : TokenScanner<Vector> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char* last) const {
    if (*first != '<' || sink->tokens.empty() || !sink->may_precede_vector(sink->tokens.size()) ||
        sink->numbers.size() + 5 > 0xffffffffu)
      return false;
    const char* p = first + 1;
    const auto skip_blanks = [&] {
      while (p != last && class_of(*p) == blank_class) ++p;
    };
    double values[5];
    std::size_t terms = 0;
    for (;;) {
      skip_blanks();
      const bool negative = *p == '-';
      if (negative) {
        ++p;
        skip_blanks();
      }
      if (terms == 5 || !starts_number(p) || !read_number(p, values[terms])) return false;
      if (negative) values[terms] = -values[terms];
      ++terms;
      skip_blanks();
      if (*p == '>') break;
      if (*p != ',') return false;
      ++p;
    }
    if (terms < 2 || p[1] == '=') return false;
    Token token;
    token.kind = TokenKind::vector;
    token.punctuation = '<';
    token.offset = sink->offset(first);
    token.payload = sink->numbers.size() | (std::uint64_t{terms} << 32);
    sink->numbers.insert(sink->numbers.end(), values, values + terms);
    first = p + 1;
    return sink->put(token);
  }
};

// "..." over any number of lines; \" does not end it, a backslash before a line end is an error.
struct String : TokenScanner<String> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char* last) const {
    if (*first != '"') return false;
    const char* p = first + 1;
    for (;; ++p) {
      if (p == last) return sink->fail(LexError::unterminated_string, first);
      if (*p == '"') break;
      if (*p != '\\') continue;
      if (++p == last) return sink->fail(LexError::unterminated_string, first);
      if (*p == '\n' || *p == '\r') return sink->fail(LexError::newline_after_backslash, p);
    }
    Token token;
    token.kind = TokenKind::string;
    token.offset = sink->offset(first);
    token.payload = static_cast<std::uint64_t>(p - first - 1);
    first = p + 1;
    return sink->put(token);
  }
};

struct Punctuation : TokenScanner<Punctuation> {
  using TokenScanner::TokenScanner;
  bool scan(const char*& first, const char*) const {
    if (class_of(*first) != punctuation_class) return false;
    const char c = *first;
    if (c == '#') {
      sink->hash = true;
      sink->hash_offset = sink->offset(first);
      ++first;
      return true;
    }
    Token token;
    token.kind = TokenKind::punctuation;
    token.offset = sink->offset(first);
    token.punctuation = c;
    token.payload = c == '[' && sink->comment;
    ++first;
    if (*first == '=' && (c == '<' || c == '>' || c == '!')) {
      token.punctuation = c == '<' ? kLessEqual : c == '>' ? kGreaterEqual : kNotEqual;
      ++first;
    }
    return sink->put(token);
  }
};
}  // namespace

const char* describe(LexError error) {
  switch (error) {
    case LexError::illegal_character:
      return "Illegal character in input file.";
    case LexError::unterminated_string:
      return "String has no closing quote: end of file reached.";
    case LexError::newline_after_backslash:
      return "Illegal escape sequence in string: a backslash at the end of a line.";
    case LexError::unterminated_comment:
      return "Comment has no closing '*/': end of file reached.";
    case LexError::second_point:
      return "Invalid number: a second decimal point.";
    case LexError::too_many_tokens:
      return "The scene has more tokens than --max-tokens allows.";
  }
  return "";
}
std::shared_ptr<const TokenFile> tokenise(std::shared_ptr<const Source> source, Names& names, std::size_t max_tokens,
                                          bool main_file) {
  auto file = std::make_shared<TokenFile>();
  const std::string_view text = source->text();
  const char* first = text.data();
  const char* const last = first + text.size();
  // Address space only: pages are touched as tokens arrive.
  file->tokens.reserve(std::min<std::size_t>(text.size() / 3 + 16, std::size_t{1} << 26));
  Sink sink{file->tokens, file->numbers, names, first, max_tokens};
  if (main_file)
    while (first != last && static_cast<unsigned char>(*first) >= 0x80) ++first, file->starts_with_high_bytes = true;

  const auto token = WordOrIdentifier(sink) | Number(sink) | Vector(sink) | Punctuation(sink) | String(sink);
  const auto tokens = *(Blanks(sink) | LineComment(sink) | BlockComment(sink) | token);
  x3::parse(first, last, tokens);

  if (!sink.failed && first != last) sink.fail(LexError::illegal_character, first);
  if (!sink.failed) {
    Token end;
    end.offset = static_cast<std::uint32_t>(text.size());
    file->tokens.push_back(end);
  }
  file->stray_branches = link_directives(file->tokens);
  file->source = std::move(source);
  return file;
}

}  // namespace verisim::parser
