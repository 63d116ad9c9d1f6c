// media { ... } (spec 07 section 4.1).
#include <utility>

#include "parser/scene/common/common.h"
#include "parser/scene/interior.h"

namespace verisim::parser {

using scene::Media;

namespace {

void parse_scattering(Parser& parser, Media& media) {
  parser.next();
  parser.expect('{');
  media.scattering_type = parser.parse_int();
  if (media.scattering_type < 1 || media.scattering_type > 5) {
    parser.warning(Code::bad_value, "Unknown atmospheric scattering type.");
    media.scattering_type = 1;
  }
  parser.optional_comma();
  media.scattering = parser.parse_rgb();
  media.has_scattering = true;
  for (;;) {
    if (parser.accept(Word::eccentricity)) {
      if (media.scattering_type != 5)
        parser.error(Code::incompatible, "Eccentricity cannot be used with this scattering type.");
      media.eccentricity = parser.parse_float();
    } else if (parser.accept(Word::extinction)) {
      media.extinction = parser.parse_float();
    } else {
      break;
    }
  }
  close_block(parser);
}

void parse_samples(Parser& parser, Media& media) {
  parser.next();
  media.samples_min = media.samples_max = parser.parse_int();
  if (accept_comma_or_number(parser)) media.samples_max = parser.parse_int();
  if (media.samples_min < 1) parser.error(Code::too_few, "At least one sample is needed in media.");
  if (media.samples_max < media.samples_min)
    parser.error(Code::bad_value, "The maximum number of samples in media is smaller than the minimum.");
}

// Items that are one number or one colour, whatever it is.
constexpr std::pair<Word, double Media::*> kNumbers[] = {
    {Word::jitter, &Media::jitter}, {Word::ratio, &Media::ratio}, {Word::variance, &Media::variance}};
constexpr std::pair<Word, Rgb Media::*> kColors[] = {{Word::absorption, &Media::absorption},
                                                     {Word::emission, &Media::emission}};

bool parse_simple_item(Parser& parser, Media& media, Word word) {
  for (const auto& [item, value] : kNumbers)
    if (item == word) return parser.next(), media.*value = parser.parse_float(), true;
  for (const auto& [item, value] : kColors)
    if (item == word) return parser.next(), media.*value = parser.parse_rgb(), true;
  return false;
}

// One item of the block, transformations apart. False: none.
bool parse_item(Parser& parser, Media& media) {
  const Word word = word_at(parser);
  switch (word) {
    case Word::method:
      parser.next();
      media.method = parser.parse_int();
      if (media.method < 1 || media.method > 3) parser.error(Code::bad_value, "Unknown media method: it is 1, 2 or 3.");
      return true;
    case Word::intervals:
      parser.next();
      media.intervals = parser.parse_int();
      if (media.intervals < 1) parser.error(Code::too_few, "At least one interval is needed in media.");
      return true;
    case Word::samples:
      parse_samples(parser, media);
      return true;
    case Word::aa_level:
      parser.next();
      media.aa_level = parser.parse_int();
      if (media.aa_level < 1) parser.error(Code::bad_value, "Media aa_level must be positive.");
      return true;
    case Word::aa_threshold:
      parser.next();
      media.aa_threshold = parser.parse_float();
      if (!(media.aa_threshold > 0)) parser.error(Code::bad_value, "Media aa_threshold must be positive.");
      return true;
    case Word::confidence:
      parser.next();
      media.confidence = parser.parse_float();
      if (!(media.confidence >= 0 && media.confidence < 1))
        parser.error(Code::bad_value, "Illegal confidence value in media.");
      return true;
    case Word::scattering:
      parse_scattering(parser, media);
      return true;
    case Word::density:
      media.densities.push_back(parse_density(parser));
      return true;
    case Word::collect:
      parser.next();
      media.collect = parser.parse_flag();
      return true;
    default:
      return parse_simple_item(parser, media, word);
  }
}

}  // namespace

void transform_media(Media& media, const Transform& t) {
  for (scene::DensityPtr& density : media.densities) {
    auto result = std::make_shared<scene::Density>(*density);
    result->pattern.prepend(t);
    density = result;
  }
}

scene::Media parse_media(Parser& parser) {
  const scene::SourceLocation place = parser.place();
  Block block(parser);
  Media media;
  if (parser.version() < 350) {  // an emulation of the older defaults
    media.method = 1;
    media.intervals = 10;
    media.samples_min = media.samples_max = 1;
  }
  if (const auto* value = parser.accept_value<Shared<Media>>()) media = **value;
  media.place = place;
  for (;;) {
    if (parse_item(parser, media)) continue;
    Transform item;
    if (!parse_transform_item(parser, item)) break;
    transform_media(media, item);
  }
  block.close();
  return media;
}

}  // namespace verisim::parser
