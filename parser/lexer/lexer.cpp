// The grammar of tokens in Boost.Spirit X3. Blanks, names, numbers and comments are scanned by parsers of our own: they
// are nearly all of a file's bytes, and comments nest without limit, which a recursive rule would turn into stack.
#include "parser/lexer/lexer.h"

#include <sys/mman.h>

#include <array>
#include <boost/spirit/home/x3.hpp>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

namespace verisim::parser {
namespace {

namespace x3 = boost::spirit::x3;

enum CharClass : std::uint8_t { other_class, blank_class, letter_class, digit_class, punctuation_class };

constexpr auto kClass = [] {
  std::array<CharClass, 256> table{};
  for (const char c : {' ', '\t', '\v', '\f', '\r', '\n', '\0', '\x1a'})
    table[static_cast<unsigned char>(c)] = blank_class;
  for (int c = 'a'; c <= 'z'; ++c) table[static_cast<std::size_t>(c)] = letter_class;
  for (int c = 'A'; c <= 'Z'; ++c) table[static_cast<std::size_t>(c)] = letter_class;
  table['_'] = letter_class;
  for (int c = '0'; c <= '9'; ++c) table[static_cast<std::size_t>(c)] = digit_class;
  for (const char c : {'{', '}', '(', ')', '[', ']', '<', '>', ',',  ';', ':', '?', '=',  '+', '-',
                       '*', '/', '&', '|', '!', '#', '@', '`', '\\', '$', '^', '%', '\'', '~', '.'})
    table[static_cast<unsigned char>(c)] = punctuation_class;
  return table;
}();

CharClass class_of(char c) { return kClass[static_cast<unsigned char>(c)]; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_directive(Word word) {
  switch (word) {
    case Word::break_:
    case Word::case_:
    case Word::debug:
    case Word::declare:
    case Word::default_:
    case Word::else_:
    case Word::elseif:
    case Word::end:
    case Word::error:
    case Word::fclose:
    case Word::fopen:
    case Word::for_:
    case Word::if_:
    case Word::ifdef:
    case Word::ifndef:
    case Word::include:
    case Word::local:
    case Word::macro:
    case Word::range:
    case Word::read:
    case Word::render:
    case Word::statistics:
    case Word::switch_:
    case Word::undef:
    case Word::version:
    case Word::warning:
    case Word::while_:
    case Word::write:
      return true;
    default:
      return false;
  }
}

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
  static bool may_precede_vector(const Token& previous) {
    switch (previous.kind) {
      case TokenKind::punctuation:
        return previous.punctuation != ')' && previous.punctuation != ']' && previous.punctuation != '>';
      case TokenKind::word:
        return word_class(previous.word) == WordClass::keyword || word_class(previous.word) == WordClass::color;
      case TokenKind::vector:
        return true;
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
    if (terms < 2 || at < 1 || tokens[at].kind != TokenKind::punctuation || !may_precede_vector(tokens[at - 1])) return;
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
struct Scanner : x3::parser<Derived> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
  Sink* sink;
  explicit Scanner(Sink& s) : sink(&s) {}

  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RContext&, Attribute&) const {
    return first != last && !sink->failed && static_cast<const Derived*>(this)->scan(first, last);
  }
};

struct Blanks : Scanner<Blanks> {
  using Scanner::Scanner;
  bool scan(const char*& first, const char* last) const {
    const char* p = first;
    while (p != last && class_of(*p) == blank_class) ++p;
    if (p == first) return false;
    first = p;
    return true;
  }
};

struct LineComment : Scanner<LineComment> {
  using Scanner::Scanner;
  bool scan(const char*& first, const char* last) const {
    if (*first != '/' || last - first < 2 || first[1] != '/') return false;
    while (first != last && *first != '\n' && *first != '\r') ++first;
    sink->comment = true;
    return true;
  }
};

// Nests; strings and line comments inside mean nothing; the '*' of an opener cannot also start a closer.
struct BlockComment : Scanner<BlockComment> {
  using Scanner::Scanner;
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

struct WordOrIdentifier : Scanner<WordOrIdentifier> {
  using Scanner::Scanner;
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

constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                   1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Decimal digits with one optional point and an optional exponent, which may be empty (spec 01 1.2).
struct Number : Scanner<Number> {
  using Scanner::Scanner;
  bool scan(const char*& first, const char*) const {
    const char* p = first;
    if (!starts(p)) return false;
    Token token;
    double value;
    if (!read(p, value)) return sink->fail(LexError::second_point, first);
    token.kind = TokenKind::number;
    token.offset = sink->offset(first);
    token.payload = std::bit_cast<std::uint64_t>(value);
    first = p;
    return sink->put(token);
  }

  static bool starts(const char* p) { return is_digit(*p) || (*p == '.' && is_digit(p[1])); }

  // False: a second point.
  static bool read(const char*& p, double& value) {
    const char* const first = p;
    std::uint64_t mantissa = 0;
    while (is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
    std::ptrdiff_t digits = p - first;
    bool point = false, exponent = false;
    int scale = 0;
    if (*p == '.') {
      point = true;
      const char* fraction = ++p;
      while (is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
      digits += p - fraction;
      scale = static_cast<int>(std::min<std::ptrdiff_t>(p - fraction, 10000));
    }
    const char* number_end = p;
    int power = 0;
    if (*p == 'e' || *p == 'E') {
      exponent = true;
      ++p;
      bool negative = false;
      if (*p == '+' || *p == '-') negative = *p++ == '-';
      const char* exponent_digits = p;
      while (is_digit(*p)) {
        if (power < 100000) power = power * 10 + (*p - '0');
        ++p;
      }
      if (p != exponent_digits) number_end = p;
      if (negative) power = -power;
    }
    if (*p == '.' && (point || exponent)) return false;
    const int shift = power - scale;
    if (digits <= 18 && mantissa < (std::uint64_t{1} << 53) && shift >= -22 && shift <= 22) {
      // Both factors are exact doubles, so one rounding gives the correctly rounded result.
      value = static_cast<double>(mantissa);
      value = shift < 0 ? value / kPowersOfTen[-shift] : value * kPowersOfTen[shift];
    } else {
      value = convert(first, number_end, power);
    }
    return true;
  }

  static double convert(const char* first, const char* last, int power) {
    double value = 0;
    const auto result = std::from_chars(first, last, value);
    if (result.ec != std::errc::result_out_of_range) return value;
    // Out of range: inf or 0, by the decimal exponent of the first non-zero digit.
    std::ptrdiff_t magnitude = 0;
    const char* p = first;
    while (p != last && *p == '0') ++p;
    if (p != last && is_digit(*p)) {
      while (p != last && is_digit(*p)) ++p, ++magnitude;
    } else if (p != last && *p == '.') {
      ++p;
      while (p != last && *p == '0') ++p, --magnitude;
    }
    return magnitude + power > 0 ? std::numeric_limits<double>::infinity() : 0.0;
  }
};

// < > around 2 to 5 literal numbers with commas.
struct Vector : Scanner<Vector> {
  using Scanner::Scanner;
  bool scan(const char*& first, const char* last) const {
    if (*first != '<' || sink->tokens.empty() || !Sink::may_precede_vector(sink->tokens.back()) ||
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
      if (terms == 5 || !Number::starts(p) || !Number::read(p, values[terms])) return false;
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
struct String : Scanner<String> {
  using Scanner::Scanner;
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

struct Punctuation : Scanner<Punctuation> {
  using Scanner::Scanner;
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

bool opens(Word word) {
  switch (word) {
    case Word::if_:
    case Word::ifdef:
    case Word::ifndef:
    case Word::while_:
    case Word::for_:
    case Word::switch_:
    case Word::macro:
      return true;
    default:
      return false;
  }
}

bool alternative(Word word) {
  return word == Word::else_ || word == Word::elseif || word == Word::case_ || word == Word::range;
}

// Links each opener and alternative to the next alternative or #end of the same construct, so that skipping is a jump.
// What has no partner in this file keeps 0 and is found by scanning. Loops and macros have no alternatives: one inside
// them at their own level means nothing to a skip, but in a macro it is a mistake. Returns those.
std::vector<std::uint32_t> link_directives(Tokens& tokens) {
  struct Open {
    std::uint32_t last;  // the token that waits for its link
    Word word;
    bool branches;
  };
  std::vector<std::uint32_t> strays;
  std::vector<Open> stack;
  const auto link = [&tokens](std::uint32_t from, std::uint32_t to) {
    tokens[from].payload = (tokens[from].payload & 0xffffffffu) | (std::uint64_t{to} << 32);
  };
  for (std::uint32_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::directive) continue;
    const Word word = tokens[i].word;
    if (opens(word)) {
      stack.push_back({i, word, word != Word::while_ && word != Word::for_ && word != Word::macro});
    } else if (stack.empty()) {
      continue;
    } else if (alternative(word) && stack.back().branches) {
      link(stack.back().last, i);
      stack.back().last = i;
    } else if (alternative(word) && stack.back().word == Word::macro) {
      strays.push_back(i);
    } else if (word == Word::end) {
      link(stack.back().last, i);
      stack.pop_back();
    }
  }
  return strays;
}

}  // namespace

void* allocate_huge(std::size_t bytes) {
  constexpr std::size_t kHugePage = 2u << 20;
  void* p;
  if (bytes < 2 * kHugePage) {
    p = std::malloc(bytes);
  } else {
    p = std::aligned_alloc(kHugePage, (bytes + kHugePage - 1) / kHugePage * kHugePage);
    if (p) ::madvise(p, bytes, MADV_HUGEPAGE);  // a hint: failure means ordinary pages
  }
  if (!p) throw std::bad_alloc();
  return p;
}

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

std::size_t TokenFile::length(const Token& token) const {
  const std::string_view rest = source->text().substr(token.offset);
  const auto name_from = [&](std::size_t i) {
    while (i < rest.size() && (class_of(rest[i]) == letter_class || class_of(rest[i]) == digit_class)) ++i;
    return i;
  };
  switch (token.kind) {
    case TokenKind::end:
      return 0;
    case TokenKind::error:
      return rest.empty() ? 0 : 1;
    case TokenKind::punctuation:
      return token.punctuation == kLessEqual || token.punctuation == kGreaterEqual || token.punctuation == kNotEqual
                 ? 2
                 : 1;
    case TokenKind::word:
    case TokenKind::identifier:
      return name_from(0);
    case TokenKind::directive: {
      std::size_t i = 1;
      while (i < rest.size() && class_of(rest[i]) == blank_class) ++i;
      return name_from(i);
    }
    case TokenKind::number: {
      const char* p = rest.data();
      double value;
      Number::read(p, value);
      return static_cast<std::size_t>(p - rest.data());
    }
    case TokenKind::string:
      return token.id() + std::size_t{2};
    case TokenKind::vector:
      break;
  }
  // A literal vector may have comments inside.
  for (std::size_t i = 1; i < rest.size(); ++i) {
    if (rest[i] == '>') return i + 1;
    if (rest[i] != '/' || i + 1 == rest.size()) continue;
    if (rest[i + 1] == '/') {
      while (i < rest.size() && rest[i] != '\n' && rest[i] != '\r') ++i;
    } else if (rest[i + 1] == '*') {
      int nested = 0;
      do {
        const std::string_view two = rest.substr(i, 2);
        nested += two == "/*" ? 1 : two == "*/" ? -1 : 0;
        i += two == "/*" || two == "*/" ? 2 : 1;
      } while (nested && i < rest.size());
      --i;
    }
  }
  return rest.size();
}

std::size_t TokenFile::hash_before(const Token& token) const {
  const std::string_view text = source->text();
  std::size_t i = token.offset;
  while (i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\t')) --i;
  return i > 0 && text[i - 1] == '#' ? i - 1 : std::string_view::npos;
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
