// #fopen, #fclose, #read and #write (spec 01 section 18).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "parser/language/impl.h"
#include "parser/source/confinement.h"

namespace verisim::parser {
namespace fs = std::filesystem;
namespace {

struct BinaryType {
  double low, high;
  int bytes;
  bool big_endian;
};

std::optional<BinaryType> binary_type(Word word) {
  switch (word) {
    case Word::uint8:
      return BinaryType{0, 255, 1, false};
    case Word::sint8:
      return BinaryType{-128, 127, 1, false};
    case Word::uint16le:
      return BinaryType{0, 65535, 2, false};
    case Word::uint16be:
      return BinaryType{0, 65535, 2, true};
    case Word::sint16le:
      return BinaryType{-32768, 32767, 2, false};
    case Word::sint16be:
      return BinaryType{-32768, 32767, 2, true};
    case Word::sint32le:
      return BinaryType{-2147483648.0, 2147483647.0, 4, false};
    case Word::sint32be:
      return BinaryType{-2147483648.0, 2147483647.0, 4, true};
    default:
      return std::nullopt;
  }
}

std::string general(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

constexpr std::size_t kBlockOfDisk = 4096;

}  // namespace

void Parser::Impl::end_if_failed() const {
  if (!report.errors.empty()) throw ParseError{{}, true};
}

void Parser::Impl::fopen() {
  const Token name = take_raw();
  if (name.kind != TokenKind::identifier) {
    if (name.kind != TokenKind::end) --position;
    expected("undeclared identifier");
  }
  if (names[name.id()].symbol)
    error(Code::redeclared, fmt::format("'{}' is declared already: it cannot become a file.", names[name.id()].text));
  const std::string file_name = utf8(string(true));
  auto handle = std::make_shared<FileHandle>();
  const Token& mode = peek();
  if (mode.word == Word::read) {
    skip_token();
    const auto found = search->find_exact(file_name);
    if (!found) error(Code::file_failed, fmt::format("Cannot open file '{}' for reading.", file_name));
    handle->path = *found;
    handle->input = load(*found, found->string(), false);
  } else if (mode.word == Word::write || mode.word == Word::append) {
    skip_token();
    end_if_failed();
    handle->path = parser.writable_file(file_name);
    if (!confinement.may_write(kBlockOfDisk)) fatal(Code::size_limit, confinement.refusal());
    handle->output.open(handle->path, std::ios::binary | (mode.word == Word::append ? std::ios::app : std::ios::trunc));
    if (!handle->output) error(Code::file_failed, fmt::format("Cannot open file '{}' for writing.", file_name));
    file_cache.erase(handle->path.string());
  } else {
    expected("read, write or append");
  }
  symbols.create(name.id(), 0).value() = std::move(handle);
}

void Parser::Impl::fclose() {
  const Token name = take_raw();
  if (name.kind != TokenKind::identifier) return;
  Symbol* symbol = names[name.id()].symbol;
  if (!symbol || !std::holds_alternative<std::shared_ptr<FileHandle>>(symbol->value())) return;
  const auto handle = std::get<std::shared_ptr<FileHandle>>(symbol->value());
  symbols.remove(name.id());
  if (handle->output.is_open()) {
    handle->output.close();
    // The time stamps of files are coarse: a file rewritten at once must be read anew.
    file_cache.erase(handle->path.string());
    if (!handle->output) error(Code::file_failed, fmt::format("Writing file '{}' failed.", handle->path.string()));
  }
}

// One datum: a signed number, a vector of such, or a string. False: the end of the file.
bool Parser::Impl::read_value(FileHandle& handle, Value& value) {
  const Tokens& tokens = handle.input->tokens;
  const auto at = [&]() -> const Token& { return tokens[handle.position]; };
  const auto fail = [&](const std::string& what) {
    const Position where = handle.input->source->position(at().offset);
    error(Code::bad_file, fmt::format("In file '{}', line {}: {}", handle.path.string(), where.line, what));
  };
  const auto signed_number = [&] {
    double sign = 1;
    if (at().punctuation == '-' || at().punctuation == '+')
      sign = tokens[handle.position++].punctuation == '-' ? -1 : 1;
    if (at().kind != TokenKind::number) fail("number expected.");
    return sign * tokens[handle.position++].number();
  };
  switch (at().kind) {
    case TokenKind::end:
      return false;
    case TokenKind::error:
      fail(parser::describe(static_cast<LexError>(at().id())));
      break;
    case TokenKind::string: {
      const TokenFile* const parsed = std::exchange(file, handle.input.get());  // the bytes are in that file
      const Token token = at();
      std::u16string text;
      try {
        text = decode(token, false);
      } catch (...) {
        file = parsed;
        throw;
      }
      file = parsed;
      ++handle.position;
      value = std::move(text);
      return true;
    }
    default:
      break;
  }
  Numeric numeric;
  if (at().kind == TokenKind::vector) {
    numeric.terms = static_cast<int>(at().terms());
    std::copy_n(handle.input->vector(at()), at().terms(), numeric.v.begin());
    ++handle.position;
    if (numeric.terms == 5)
      for (double& v : numeric.v) v = static_cast<double>(static_cast<float>(v));
  } else if (at().punctuation == '<') {
    ++handle.position;
    numeric.terms = 0;
    while (at().punctuation != '>') {
      if (numeric.terms == 5) fail("a vector has at most 5 components.");
      numeric.v[static_cast<std::size_t>(numeric.terms++)] = signed_number();
      if (at().punctuation == ',') ++handle.position;
    }
    if (numeric.terms < 2) fail("a vector has at least 2 components.");
    ++handle.position;
    if (numeric.terms == 5)
      for (double& v : numeric.v) v = static_cast<double>(static_cast<float>(v));
  } else {
    numeric.v[0] = signed_number();
  }
  value = numeric;
  return true;
}

std::shared_ptr<FileHandle> Parser::Impl::opened_file(const Token& name) {
  Symbol* const symbol = name.kind == TokenKind::identifier ? names[name.id()].symbol : nullptr;
  if (symbol)
    if (const auto* handle = std::get_if<std::shared_ptr<FileHandle>>(&symbol->value())) return *handle;
  --position;
  ready = true;
  error(Code::wrong_type, fmt::format("Expected a file opened by #fopen, {} found instead.", describe(name)));
}

void Parser::Impl::read() {
  if (take_raw().punctuation != '(') error(Code::unexpected_token, "Expected '(' behind #read.");
  const Token name = take_raw();
  const std::shared_ptr<FileHandle> handle = opened_file(name);
  if (!handle->input) error(Code::file_failed, "The file is not open for reading.");
  if (peek_blocked().punctuation == ',') skip_token();
  bool open = true;
  const auto close = [&] {
    open = false;
    symbols.remove(name.id());
  };
  do {
    const Token id = peek_blocked();
    if (id.kind != TokenKind::identifier) expected("identifier");
    if (!names[id.id()].symbol) symbols.create(id.id(), 0);
    Symbol& symbol = *names[id.id()].symbol;
    if (symbol.is_macro) error(Code::macro_arguments, "A macro cannot be read into.");
    skip_token();
    Value* place = &symbol.value();
    std::shared_ptr<Array> array;
    while (std::holds_alternative<std::shared_ptr<Array>>(*place)) {
      std::shared_ptr<Array> next = std::get<std::shared_ptr<Array>>(*place);
      place = &next->elements.at(subscripts(*next));
      array = std::move(next);
    }
    const auto* old = std::get_if<Numeric>(place);
    const bool fits = (place->index() == 0 && !array) || (old && (old->terms == 1 || old->terms == 3)) ||
                      std::holds_alternative<std::u16string>(*place);
    if (!fits)
      error(Code::wrong_type, "#read needs an undeclared identifier, or one that holds a float, a vector or a string.");
    if (open) {
      Value value;
      if (!read_value(*handle, value)) {
        close();
      } else {
        if (array && array->type != type_key(value))
          error(Code::array_type, "The value read has another type than the array.");
        *place = std::move(value);
        // One comma is consumed; anything else in its place is thrown away.
        const Token& behind = handle->input->tokens[handle->position];
        if (behind.kind == TokenKind::end)
          close();
        else if (behind.kind != TokenKind::error)
          ++handle->position;
      }
    }
    if (peek_blocked().punctuation == ',') skip_token();
    count_steps(1);
  } while (peek_blocked().punctuation != ')');
  skip_token();
}

void Parser::Impl::write() {
  if (peek().punctuation != '(') expected("(");
  skip_token();
  const Token name = take_raw();
  const std::shared_ptr<FileHandle> handle = opened_file(name);
  if (!handle->output.is_open()) error(Code::file_failed, "The file is not open for writing.");
  end_if_failed();
  std::ofstream& out = handle->output;
  if (peek().punctuation == ',') skip_token();
  while (peek().punctuation != ')') {
    const Token token = peek();
    if (at_string()) {
      const std::u16string text = string(false);
      if (!confinement.may_write(text.size())) fatal(Code::size_limit, confinement.refusal());
      for (const char16_t c : text) out.put(static_cast<char>(c > 127 && language_version >= 350 ? ' ' : c));
    } else if (const auto type = token.kind == TokenKind::word ? binary_type(token.word) : std::nullopt) {
      skip_token();
      while (peek().punctuation != ',' && peek().punctuation != ')') {
        Numeric n;
        additive(1, n);
        if (!confinement.may_write(static_cast<std::size_t>(n.terms * type->bytes)))
          fatal(Code::size_limit, confinement.refusal());
        for (std::size_t i = 0; i < static_cast<std::size_t>(n.terms); ++i) {
          const double v = std::isnan(n.v[i]) ? type->low : std::clamp(std::floor(n.v[i] + 0.5), type->low, type->high);
          const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(v));
          for (int b = 0; b < type->bytes; ++b)
            out.put(static_cast<char>(bits >> 8 * (type->big_endian ? type->bytes - 1 - b : b) & 0xff));
        }
      }
    } else {
      if (token.kind == TokenKind::identifier) {
        const Value* value = peek_value();
        const Numeric* n = value ? std::get_if<Numeric>(value) : nullptr;
        if (n && n->terms == 5)
          error(Code::wrong_type, "A colour identifier cannot be written as it is.", "Put it in parentheses.");
      }
      if (token.kind == TokenKind::word && word_class(token.word) == WordClass::color)
        expected("string or numeric expression");
      Numeric n;
      additive(1, n);
      std::string text = n.terms == 1 ? general(n.v[0]) : "<";
      if (n.terms > 1) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(n.terms); ++i) text += (i ? "," : "") + general(n.v[i]);
        text += "> ";
      }
      if (!confinement.may_write(text.size())) fatal(Code::size_limit, confinement.refusal());
      out << text;
    }
    if (peek().punctuation == ',') skip_token();
  }
  skip_token();
  if (!out) error(Code::file_failed, fmt::format("Writing file '{}' failed.", handle->path.string()));
}

}  // namespace verisim::parser
