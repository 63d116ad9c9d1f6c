// Strings: literals with escapes and charsets, and where a string is accepted (spec 01 sections 1.1 and 12). Code units
// are 16 bits.
#include <fmt/format.h>

#include "parser/language/impl.h"

namespace verisim::parser {
namespace {

// One character of the charset utf8; longer sequences than three bytes give one replacement character.
char16_t decode_utf8(std::string_view bytes, std::size_t& i) {
  const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u; };
  const unsigned first = byte(0);
  const auto follows = [&](std::size_t count) {
    for (std::size_t k = 1; k <= count; ++k)
      if ((byte(k) & 0xc0) != 0x80) return false;
    return true;
  };
  if (first < 0x80) {
    ++i;
    return static_cast<char16_t>(first);
  }
  if ((first & 0xe0) == 0xc0 && follows(1)) {
    const unsigned c = (first & 0x1f) << 6 | (byte(1) & 0x3f);
    i += 2;
    return static_cast<char16_t>(c);
  }
  if ((first & 0xf0) == 0xe0 && follows(2)) {
    const unsigned c = (first & 0x0f) << 12 | (byte(1) & 0x3f) << 6 | (byte(2) & 0x3f);
    i += 3;
    return static_cast<char16_t>(c);
  }
  ++i;
  while (i < bytes.size() && (static_cast<unsigned char>(bytes[i]) & 0xc0) == 0x80) ++i;
  return 0xfffd;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::u16string from_utf8(std::string_view text) {
  std::u16string out;
  for (std::size_t i = 0; i < text.size();) out += decode_utf8(text, i);
  return out;
}

std::u16string Parser::Impl::decode(const Token& token, bool path) {
  const std::string_view bytes = file->raw_string(token);
  if (charset == Charset::sys && !bytes.empty())
    error(Code::non_ascii, "Strings cannot be read in charset sys.", "Use charset utf8.");
  std::u16string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size();) {
    const char c = bytes[i];
    if (c == '\\' && i + 1 < bytes.size() && (!path || bytes[i + 1] == '"')) {
      const char escape = bytes[i + 1];
      i += 2;
      switch (escape) {
        case 'a':
          text += u'\a';
          break;
        case 'b':
          text += u'\b';
          break;
        case 'f':
          text += u'\f';
          break;
        case 'n':
          text += u'\n';
          break;
        case 'r':
          text += u'\r';
          break;
        case 't':
          text += u'\t';
          break;
        case 'v':
          text += u'\v';
          break;
        case '\'':
        case '"':
        case '\\':
          text += static_cast<char16_t>(escape);
          break;
        case 'u': {
          if (i + 4 > bytes.size())
            error(Code::bad_escape, "Unexpected end of escape sequence in string: \\u needs four hexadecimal digits.");
          int code = 0;
          for (std::size_t k = 0; k < 4 && code >= 0; ++k) {
            const int digit = hex_digit(bytes[i + k]);
            code = digit < 0 ? (k ? -1 - code : -1) : code * 16 + digit;
          }
          text += static_cast<char16_t>(code < 0 ? -1 - code : code);
          i += 4;
          break;
        }
        default:
          error(Code::bad_escape, fmt::format("Illegal escape sequence '\\{}' in string.", escape));
      }
      continue;
    }
    if (static_cast<unsigned char>(c) < 0x80) {
      text += static_cast<char16_t>(c);
      ++i;
    } else if (charset == Charset::utf8) {
      text += decode_utf8(bytes, i);
    } else if (language_version < 350) {
      text += static_cast<char16_t>(static_cast<unsigned char>(c));
      ++i;
    } else {
      message(Severity::possible_error, Code::non_ascii, "Non-ASCII character in string: it becomes a blank.",
              "Set charset utf8 in global_settings.");
      text += u' ';
      ++i;
    }
  }
  return text;
}

std::string Parser::Impl::utf8(std::u16string_view text) const {
  std::string out;
  out.reserve(text.size());
  for (const char16_t c : text) {
    if (c < 0x80) {
      out += static_cast<char>(c);
    } else if (c < 0x800) {
      out += static_cast<char>(0xc0 | c >> 6);
      out += static_cast<char>(0x80 | (c & 0x3f));
    } else {
      out += static_cast<char>(0xe0 | c >> 12);
      out += static_cast<char>(0x80 | (c >> 6 & 0x3f));
      out += static_cast<char>(0x80 | (c & 0x3f));
    }
  }
  return out;
}

void Parser::Impl::check_length(std::size_t characters) {
  if (characters > options.limits.max_memory_bytes / 1024)
    error(Code::size_limit, "The string is longer than --max-memory allows.");
}

bool Parser::Impl::at_string() {
  const Token& token = peek();
  switch (token.kind) {
    case TokenKind::string:
      return true;
    case TokenKind::word:
      return word_class(token.word) == WordClass::string_function;
    case TokenKind::identifier: {
      Symbol* symbol = names[token.id()].symbol;
      if (!symbol) return false;
      const Value* value = &symbol->value();
      if (const auto* array = std::get_if<std::shared_ptr<Array>>(value)) {
        if ((&token)[1].punctuation != '[' || (*array)->type > 100 || (*array)->type == 0) return false;
        value = peek_value();
      }
      return value && std::holds_alternative<std::u16string>(*value);
    }
    default:
      return false;
  }
}

// `path`: literals keep their backslashes (spec 01 section 12.1).
std::u16string Parser::Impl::string(bool path) {
  look_at_clock();
  const Token token = peek();
  if (!at_string()) expected("string expression");
  if (token.kind == TokenKind::identifier) return std::get<std::u16string>(resolve().value());
  if (token.kind == TokenKind::word) {
    const Nesting nesting(*this);
    skip_token();
    return string_function(token.word, path);
  }
  skip_token();
  return decode(token, path);
}

// ---- The public face ----

bool Parser::at_string() { return !impl_->stopped() && impl_->at_string(); }
std::u16string Parser::parse_string() {
  impl_->value_read = impl_->next();
  return impl_->string(false);
}
std::string Parser::parse_path() {
  impl_->path_read = impl_->next();
  return impl_->utf8(impl_->string(true));
}

}  // namespace verisim::parser
