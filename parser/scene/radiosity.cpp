// radiosity { ... } of global_settings (spec 07 section 2.1).
#include <algorithm>
#include <string>
#include <utility>

#include "parser/scene/common/common.h"
#include "parser/scene/global_settings.h"

namespace verisim::parser {

using scene::Radiosity;

namespace {

// Items that are one number above 0, some at most 1, or one flag.
struct PositiveItem {
  Word word;
  double Radiosity::*value;
  bool fraction = false;
};
constexpr PositiveItem kPositive[] = {
    {Word::adc_bailout, &Radiosity::adc_bailout},         {Word::brightness, &Radiosity::brightness},
    {Word::error_bound, &Radiosity::error_bound},         {Word::low_error_factor, &Radiosity::low_error_factor},
    {Word::maximum_reuse, &Radiosity::maximum_reuse},     {Word::pretrace_start, &Radiosity::pretrace_start, true},
    {Word::pretrace_end, &Radiosity::pretrace_end, true},
};
constexpr std::pair<Word, bool Radiosity::*> kFlags[] = {
    {Word::always_sample, &Radiosity::always_sample},
    {Word::media, &Radiosity::media},
    {Word::normal, &Radiosity::normal},
    {Word::subsurface, &Radiosity::subsurface},
};

bool parse_simple_item(Parser& parser, Radiosity& radiosity, Word word) {
  for (const PositiveItem& item : kPositive) {
    if (item.word != word) continue;
    parser.next();
    const double value = radiosity.*item.value = parser.parse_float();
    const auto refuse = [&](const char* rule) {
      parser.error(Code::bad_value, "Radiosity " + std::string(spelling(word)) + " must " + rule + ".");
    };
    if (!(value > 0)) refuse("be a positive number");
    if (item.fraction && value > 1) refuse("not be larger than 1");
    if (word == Word::maximum_reuse) radiosity.maximum_reuse_given = true;
    return true;
  }
  for (const auto& [flag, value] : kFlags) {
    if (flag != word) continue;
    parser.next();
    radiosity.*value = parser.parse_float() > 0;
    return true;
  }
  return false;
}

void parse_count(Parser& parser, Radiosity& radiosity) {
  parser.next();
  radiosity.count = parser.parse_int();
  if (radiosity.count < 1) parser.error(Code::bad_value, "Radiosity count must be a positive number.");
  radiosity.count_directions = std::max(1600, radiosity.count);
  if (accept_comma_or_number(parser)) {
    radiosity.count_directions = parser.parse_int();
    if (radiosity.count_directions < radiosity.count)
      parser.error(Code::bad_value, "Radiosity direction count must not be smaller than the sample count.");
  }
}

void parse_nearest_count(Parser& parser, Radiosity& radiosity) {
  parser.next();
  radiosity.nearest_count = parser.parse_int();
  if (radiosity.nearest_count < 1 || radiosity.nearest_count > 20)
    parser.error(Code::bad_value, "Radiosity nearest_count must be a value from 1 to 20.");
  radiosity.adaptive_nearest_count = 0;
  if (accept_comma_or_number(parser)) {
    radiosity.adaptive_nearest_count = parser.parse_int();
    if (radiosity.adaptive_nearest_count < 0 || radiosity.adaptive_nearest_count >= radiosity.nearest_count)
      parser.error(Code::bad_value,
                   "Radiosity adaptive nearest_count must not be negative and must be smaller than nearest_count.");
  }
}

void ignored_file(Parser& parser, const char* keyword, const char* option) {
  parser.next();
  parser.parse_string();
  parser.possible_error(Code::no_effect, std::string("Keyword '") + keyword +
                                             "' has no effect: use the command line or INI option " + option + ".");
}

// One item of the block. False: none.
bool parse_item(Parser& parser, Radiosity& radiosity) {
  const Word word = word_at(parser);
  switch (word) {
    case Word::count:
      parse_count(parser, radiosity);
      return true;
    case Word::gray_threshold:
      parser.next();
      radiosity.gray_threshold = parser.parse_float();
      if (!(radiosity.gray_threshold >= 0 && radiosity.gray_threshold <= 1))
        parser.error(Code::bad_value, "Radiosity gray_threshold must be from 0 to 1.");
      return true;
    case Word::max_sample:
      parser.next();
      radiosity.max_sample = parser.parse_float();
      return true;
    case Word::minimum_reuse:
      parser.next();
      radiosity.minimum_reuse = parser.parse_float();
      if (!(radiosity.minimum_reuse >= 0))
        parser.error(Code::bad_value, "Radiosity minimum_reuse must not be negative.");
      radiosity.minimum_reuse_given = true;
      return true;
    case Word::nearest_count:
      parse_nearest_count(parser, radiosity);
      return true;
    case Word::recursion_limit:
      parser.next();
      radiosity.recursion_limit = parser.parse_int();
      if (radiosity.recursion_limit < 1 || radiosity.recursion_limit > 20)
        parser.error(Code::bad_value, "Radiosity recursion_limit must be in the range 1 to 20.");
      return true;
    case Word::save_file:
      ignored_file(parser, "save_file", "+RFO");
      return true;
    case Word::load_file:
      ignored_file(parser, "load_file", "+RFI");
      return true;
    default:
      return parse_simple_item(parser, radiosity, word);
  }
}

}  // namespace

void parse_radiosity_settings(Parser& parser, Radiosity& radiosity) {
  radiosity.place = parser.place();
  parser.next();
  parser.expect('{');
  if (parser.version() < 350)
    parser.warning(Code::discontinued, "In this version of POV-Ray a radiosity block turns radiosity on.");
  radiosity.enabled = true;
  while (parse_item(parser, radiosity)) {
  }
  close_block(parser);
}

void finish_radiosity_settings(Parser& parser, Radiosity& radiosity) {
  if (!radiosity.enabled) return;
  if (radiosity.pretrace_end > radiosity.pretrace_start)
    parser.error(Code::bad_value, "Radiosity pretrace_end must be smaller than or equal to pretrace_start.");
  if (!(radiosity.minimum_reuse > radiosity.maximum_reuse / 2)) return;
  if (radiosity.maximum_reuse_given && !radiosity.minimum_reuse_given) {
    radiosity.minimum_reuse = radiosity.maximum_reuse / 2;
    parser.warning(Code::adjusted_value, "Adjusting radiosity minimum_reuse to half of maximum_reuse.");
  } else if (radiosity.minimum_reuse_given && !radiosity.maximum_reuse_given) {
    radiosity.maximum_reuse = radiosity.minimum_reuse * 2;
    parser.warning(Code::adjusted_value, "Adjusting radiosity maximum_reuse to twice minimum_reuse.");
  } else if (radiosity.minimum_reuse >= radiosity.maximum_reuse) {
    parser.error(Code::bad_value, "Radiosity minimum_reuse must be smaller than maximum_reuse.");
  } else {
    parser.warning(Code::adjusted_value, "Radiosity minimum_reuse should be no more than half of maximum_reuse.");
  }
}

}  // namespace verisim::parser
