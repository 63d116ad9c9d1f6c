// str, vstr, concat, chr, substr, strupr, strlwr and datetime (spec 01 section 12.3).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "parser/language/impl.h"

namespace verisim::parser {
namespace {

constexpr int kMaxNumberText = 254;  // of str()
constexpr int kMaxWidth = 1 << 20;   // of vstr(), which POV-Ray leaves to memory

// printf's %[0]width.precisionf or g.
std::string print(char conversion, double value, int length, int precision) {
  const int width = std::abs(length);
  const auto write = [&](char* to, std::size_t size) {
    if (conversion == 'f') return std::snprintf(to, size, length < 0 ? "%0*.*f" : "%*.*f", width, precision, value);
    return std::snprintf(to, size, length < 0 ? "%0*.*g" : "%*.*g", width, precision, value);
  };
  std::string text(static_cast<std::size_t>(std::max(write(nullptr, 0), 0)), '\0');
  write(text.data(), text.size() + 1);
  return text;
}

// `limited`: a text that is too long becomes %g, then "<invalid>"; only str() does that, vstr() does not (measured).
std::string format_number(Parser::Impl& p, double value, int length, int precision, bool limited) {
  if (precision < 0) precision = 6;
  if (limited) {
    length = std::clamp(length, -kMaxNumberText - 1, kMaxNumberText + 1);  // wider is too long in any case
    precision = std::min(precision, 2000);                                 // a double has no more digits than that
  } else if (length < -kMaxWidth || length > kMaxWidth || precision > kMaxWidth) {
    p.error(Code::size_limit, "vstr() is asked for a longer text than 1048576 characters a number.");
  }
  std::string text = print('f', value, length, precision);
  if (!limited || text.size() <= kMaxNumberText) return text;
  text = print('g', value, length, precision);
  return text.size() <= kMaxNumberText ? text : "<invalid>";
}

void append(std::u16string& to, const std::string& ascii) { to.append(ascii.begin(), ascii.end()); }

std::u16string date_text(Parser::Impl& p, double days, const std::string& format) {
  if (format.empty() || format.size() > 200)
    p.error(Code::domain_error, "The format of datetime() must have 1 to 200 characters.");
  const double seconds = std::floor(days * 86400 + 0.5) + 946684800;
  if (!(std::fabs(seconds) < 6e16)) p.error(Code::domain_error, "The date of datetime() is out of range.");
  const auto time = static_cast<std::time_t>(seconds);
  std::tm parts{};
  if (!gmtime_r(&time, &parts)) p.error(Code::domain_error, "The date of datetime() is out of range.");
  char text[512];
  const std::size_t count = std::strftime(text, sizeof text, format.c_str(), &parts);
  if (count == 0) p.error(Code::domain_error, "datetime() gives no text with this format.");
  return {text, text + count};
}

void change_case(Parser::Impl& p, char16_t& c, bool upper) {
  if (c > 127)
    p.message(Severity::warning, Code::non_ascii,
              "Non-ASCII character in string: strupr() and strlwr() leave it as it is.");
  if (upper && c >= u'a' && c <= u'z') c = static_cast<char16_t>(c - u'a' + u'A');
  if (!upper && c >= u'A' && c <= u'Z') c = static_cast<char16_t>(c - u'A' + u'a');
}

// The arguments of vstr().
std::u16string vector_text(Parser::Impl& p) {
  const auto comma = [&p] {
    if (p.peek().punctuation == ',') p.skip_token();
  };
  const int terms = std::clamp(to_int(p.scalar()), 2, 5);
  comma();
  if (word_class(p.peek().word) == WordClass::color && p.peek().kind == TokenKind::word)
    p.expected("vector expression");
  Numeric vector;
  p.additive(1, vector);
  for (int i = vector.terms; i < 5; ++i) vector.v[static_cast<std::size_t>(i)] = 0;
  comma();
  const std::u16string separator = p.string(false);
  comma();
  const int length = to_int(p.scalar());
  comma();
  const int precision = to_int(p.scalar());
  std::u16string out;
  for (int i = 0; i < terms; ++i) {
    if (i) out += separator;
    append(out, format_number(p, vector.v[static_cast<std::size_t>(i)], length, precision, false));
  }
  return out;
}

}  // namespace

std::u16string Parser::Impl::string_function(Word word, bool path) {
  const auto comma = [this] {
    if (peek().punctuation == ',') skip_token();
  };
  open_arguments();
  const Live live(*this);
  std::u16string out;
  switch (word) {
    case Word::str: {
      const double value = scalar();
      comma();
      const int length = to_int(scalar());
      comma();
      append(out, format_number(*this, value, length, to_int(scalar()), true));
      break;
    }
    case Word::vstr:
      out = vector_text(*this);
      break;
    case Word::concat:
      // Of a path, only the second and later literals keep their backslashes.
      out = string(false);
      while (peek().punctuation != ')') {
        if (peek().punctuation == ',') skip_token();
        out += string(path);
        check_length(out.size());
      }
      break;
    case Word::chr: {
      const int code = to_int(scalar());
      if (code < 0 || code > 65535) error(Code::bad_value, "The argument of chr() must be 0 to 65535.");
      out = static_cast<char16_t>(code);
      break;
    }
    case Word::substr: {
      const std::u16string text = string(false);
      comma();
      const int start = to_int(scalar());
      comma();
      const int length = to_int(scalar());
      if (start < 0 || length < 0 || static_cast<double>(start) + length - 1 > static_cast<double>(text.size()))
        error(Code::bad_value, "substr() is asked for more than the string has.");
      // Positions count from 1; from 0 on there is nothing, however long.
      if (start > 0) out = text.substr(static_cast<std::size_t>(start - 1), static_cast<std::size_t>(length));
      break;
    }
    case Word::strupr:
    case Word::strlwr:
      out = string(false);
      for (char16_t& c : out) change_case(*this, c, word == Word::strupr);
      break;
    case Word::datetime: {
      const double days = scalar();
      comma();
      std::string format = "%Y-%m-%d %H:%M:%SZ";
      if (peek().punctuation != ')') format = utf8(string(false));
      out = date_text(*this, days, format);
      break;
    }
    default:
      error(Code::internal, "Unknown string function.");
  }
  close_arguments();
  return out;
}

}  // namespace verisim::parser
