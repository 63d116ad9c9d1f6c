#include "parser/scene/common/common.h"

#include <cmath>

namespace verisim::parser {

void open_block(Parser& parser) {
  parser.next();
  parser.expect('{');
}

void close_block(Parser& parser) {
  if (!parser.accept('}')) parser.error_unclosed();
}

void error_only_in(Parser& parser, Word word, std::string_view where) {
  parser.error(Code::misplaced_keyword,
               "Keyword '" + std::string(spelling(word)) + "' can only be used in " + std::string(where) + ".");
}

bool at_color(Parser& parser) {
  if (parser.at_color_keyword()) return true;
  const Value* value = parser.peek_value();
  if (!value) return false;
  const auto* number = std::get_if<Numeric>(value);
  return number && number->terms == 5;
}

bool accept_comma_or_number(Parser& parser) { return parser.accept(',') || parser.at_number_start(); }

float to_float(double value) { return static_cast<float>(value); }

std::size_t checked_count(Parser& parser, double count, std::string_view what, std::size_t item_bytes) {
  const double limit = static_cast<double>(parser.options().limits.max_memory_bytes) / static_cast<double>(item_bytes);
  if (!(count >= 0)) parser.error(Code::bad_value, "The number of " + std::string(what) + " must not be negative.");
  if (count > limit)
    parser.error(Code::size_limit, "Too many " + std::string(what) + ".", "--max-memory sets the limit");
  return static_cast<std::size_t>(count);
}

}  // namespace verisim::parser
