#include "cli/settings/region.h"

#include <cmath>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

// Values below 1 are fractions of the picture, others are one-based columns or rows; an end of exactly 1 means "all".
// Fractions are numbers of single precision, as POV-Ray keeps its settings: 0.35 of 120 rows are 41.
double first(double given, int size) {
  const double value = static_cast<float>(given);
  return value >= 0 && value < 1 ? std::floor(value * size) : std::floor(value) - 1;
}
double last(double given, int size) {
  const double value = static_cast<float>(given);
  return value >= 0 && value <= 1 ? std::floor(value * size) - 1 : std::floor(value - 1);
}

int checked(double value, int size, const char* which) {
  if (!(value >= 0 && value < size)) throw OptionError(fmt::format("Invalid {} column or row", which));
  return static_cast<int>(value);
}

}  // namespace

Region region(const Options& options) {
  Region result{0, options.width - 1, 0, options.height - 1};
  if (options.start_column)
    result.first_column = checked(first(*options.start_column, options.width), options.width, "start");
  if (options.start_row) result.first_row = checked(first(*options.start_row, options.height), options.height, "start");
  if (options.end_column) result.last_column = checked(last(*options.end_column, options.width), options.width, "end");
  if (options.end_row) result.last_row = checked(last(*options.end_row, options.height), options.height, "end");
  return result;
}

}  // namespace verisim::cli
