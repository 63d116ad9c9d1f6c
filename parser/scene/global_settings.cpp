// global_settings { ... } (spec 02 section 7, 07 section 5.1).
#include "parser/scene/common/common.h"
#include "parser/scene/global_settings.h"

namespace verisim::parser {

using scene::Settings;

namespace {

void parse_assumed_gamma(Parser& parser, Settings& settings) {
  parser.next();
  const bool again = settings.gamma_given;
  scene::Gamma gamma = scene::Gamma::power;
  double value = 1;
  if (parser.accept(Word::srgb)) {
    gamma = scene::Gamma::srgb;
    value = 2.2;
  } else {
    value = parser.parse_float();
    if (!(value > 0)) parser.error(Code::bad_value, "gamma value must be positive.");
    if (value < 1) parser.possible_error(Code::adjusted_value, "Suspicious value for assumed_gamma: below 1.");
  }
  if (again) {
    parser.warning(Code::duplicate, "New instance of assumed_gamma ignored.");
    return;
  }
  settings.gamma = gamma;
  settings.assumed_gamma = value;
  settings.gamma_given = true;
}

void parse_charset(Parser& parser) {
  parser.next();
  if (parser.accept(Word::ascii))
    parser.set_charset(Parser::Charset::ascii);
  else if (parser.accept(Word::utf8))
    parser.set_charset(Parser::Charset::utf8);
  else if (parser.accept(Word::sys))
    parser.set_charset(Parser::Charset::sys);
  else
    parser.error_expected("charset type");
}

void parse_noise_generator(Parser& parser, Settings& settings) {
  parser.next();
  const int generator = parser.parse_int();
  if (generator < 1 || generator > 3)
    parser.error(Code::bad_value, "Value for noise_generator in global_settings must be 1, 2, or 3.");
  settings.noise_generator = generator;
  parser.set_noise_generator(generator);
}

void parse_number_of_waves(Parser& parser, Settings& settings) {
  parser.next();
  settings.number_of_waves = parser.parse_int();
  if (settings.number_of_waves < 1) {
    parser.warning(Code::adjusted_value, "Illegal value: number_of_waves must be positive. Changed to 1.");
    settings.number_of_waves = 1;
  }
}

void parse_subsurface_settings(Parser& parser, Settings& settings) {
  parser.next();
  parser.expect('{');
  settings.subsurface = true;
  for (;;) {
    if (parser.accept(Word::samples)) {
      settings.subsurface_samples_diffuse = parser.parse_int();
      parser.optional_comma();
      settings.subsurface_samples_single = parser.parse_int();
    } else if (parser.accept(Word::radiosity)) {
      settings.subsurface_radiosity = parser.parse_float() > 0;
    } else {
      break;
    }
  }
  close_block(parser);
}

}  // namespace

void parse_max_trace_level(Parser& parser) {
  parser.next();
  int& level = parser.scene().settings.max_trace_level;
  level = parser.parse_int();
  level = std::max(level, 1);
  if (level > 256) {
    parser.warning(Code::adjusted_value, "Maximum max_trace_level is 256 but a higher value was specified.");
    level = 256;
  }
}

void parse_max_intersections(Parser& parser) {
  parser.next();
  parser.parse_float();
  if (parser.version() >= 370)
    parser.warning(Code::no_effect, "'max_intersections' is no longer needed and has no effect.");
}

void parse_global_settings(Parser& parser) {
  Block block(parser);
  Settings& settings = parser.scene().settings;
  for (;;) {
    switch (word_at(parser)) {
      case Word::adc_bailout:
        parser.next();
        settings.adc_bailout = to_float(parser.parse_float());
        continue;
      case Word::ambient_light:
        parser.next();
        settings.ambient_light = parser.parse_rgb();
        continue;
      case Word::assumed_gamma:
        parse_assumed_gamma(parser, settings);
        continue;
      case Word::charset:
        parse_charset(parser);
        continue;
      case Word::hf_gray_16:
        parser.next();
        parser.parse_flag();
        parser.possible_error(
            Code::no_effect,
            "In POV-Ray v3.7 and later, hf_gray_16 has no effect; use the grayscale output option (+FNg) instead.");
        continue;
      case Word::irid_wavelength:
        parser.next();
        settings.irid_wavelength = parser.parse_rgb();
        continue;
      case Word::max_intersections:
        parse_max_intersections(parser);
        continue;
      case Word::max_trace_level:
        parse_max_trace_level(parser);
        continue;
      case Word::mm_per_unit:
        parser.next();
        settings.mm_per_unit = parser.parse_float();
        continue;
      case Word::noise_generator:
        parse_noise_generator(parser, settings);
        continue;
      case Word::number_of_waves:
        parse_number_of_waves(parser, settings);
        continue;
      case Word::photons:
        parse_photon_settings(parser, settings.photons);
        continue;
      case Word::radiosity:
        parse_radiosity_settings(parser, settings.radiosity);
        continue;
      case Word::subsurface:
        parse_subsurface_settings(parser, settings);
        continue;
      default:
        break;
    }
    break;
  }
  block.close();
}

}  // namespace verisim::parser
