// photons { ... } of global_settings, objects and light sources (spec 07 section 3).
#include "parser/scene/common/common.h"
#include "parser/scene/global_settings.h"
#include "tracer/scene/parts.h"

namespace verisim::parser {

using scene::Flag;
using scene::Photons;

namespace {

void parse_gather(Parser& parser, Photons& photons) {
  parser.next();
  photons.gather_min = parser.parse_int();
  parser.optional_comma();
  photons.gather_max = parser.parse_int();
  if (photons.gather_min < 0 || photons.gather_max < photons.gather_min)
    parser.error(Code::bad_value,
                 "Photon gather numbers must not be negative, and the second must not be smaller than the first.");
  if (photons.gather_max == 0) {
    photons.enabled = false;
    parser.warning(Code::adjusted_value, "Photons are switched off: the largest number to gather is 0.");
  }
}

void parse_radius(Parser& parser, Photons& photons) {
  parser.next();
  double* const values[] = {&photons.radius, &photons.radius_gather_multiplier, &photons.media_radius,
                            &photons.media_radius_gather_multiplier};
  for (double* value : values) {
    if (parser.at_number_start()) *value = parser.parse_float();
    parser.optional_comma();
  }
}

void parse_photon_media(Parser& parser, Photons& photons) {
  parser.next();
  photons.media_count = parser.parse_int();
  if (photons.media_count < 0) parser.error(Code::bad_value, "The number of photon media steps must not be negative.");
  parser.optional_comma();
  photons.media_factor = parser.parse_optional_float(photons.media_factor);
  if (!(photons.media_factor > 0)) parser.error(Code::bad_value, "The photon media factor must be positive.");
}

void parse_expand_thresholds(Parser& parser, Photons& photons) {
  parser.next();
  photons.expand_increase = parser.parse_float();
  parser.optional_comma();
  photons.expand_min = parser.parse_int();
  if (photons.expand_increase < 0) {
    parser.warning(Code::adjusted_value, "The first value of expand_thresholds must not be negative; using 0.");
    photons.expand_increase = 0;
  }
  if (photons.expand_min < 0) {
    parser.warning(Code::adjusted_value, "The second value of expand_thresholds must not be negative; using 0.");
    photons.expand_min = 0;
  }
}

void parse_file(Parser& parser, bool save, std::string& target, const std::string& other) {
  parser.next();
  const std::string name = parser.parse_path();
  target = (save ? parser.writable_file(name) : parser.find_file(name)).string();
  if (!other.empty())
    parser.warning(Code::duplicate, "Both load_file and save_file of photons were given; the last one is used.");
}

}  // namespace

void parse_photon_settings(Parser& parser, Photons& photons) {
  photons = Photons();  // a second block does not inherit from the first
  photons.place = parser.place();
  photons.enabled = true;
  parser.next();
  parser.expect('{');
  const auto number = [&](double& target) {
    parser.next();
    target = parser.parse_float();
  };
  for (;;) {
    switch (word_at(parser)) {
      case Word::spacing:
        number(photons.spacing);
        continue;
      case Word::count:
        parser.next();
        photons.count = parser.parse_int();
        continue;
      case Word::gather:
        parse_gather(parser, photons);
        continue;
      case Word::radius:
        parse_radius(parser, photons);
        continue;
      case Word::media:
        parse_photon_media(parser, photons);
        continue;
      case Word::jitter:
        number(photons.jitter);
        continue;
      case Word::max_trace_level:
        parser.next();
        photons.max_trace_level = parser.parse_int();
        continue;
      case Word::adc_bailout:
        number(photons.adc_bailout);
        continue;
      case Word::autostop:
        number(photons.autostop);
        continue;
      case Word::expand_thresholds:
        parse_expand_thresholds(parser, photons);
        continue;
      case Word::save_file:
        parse_file(parser, true, photons.save_file, photons.load_file);
        photons.load_file.clear();
        continue;
      case Word::load_file:
        parse_file(parser, false, photons.load_file, photons.save_file);
        photons.save_file.clear();
        continue;
      default:
        break;
    }
    break;
  }
  close_block(parser);
}

namespace {

using TurnedOff = scene::PhotonFlags::TurnedOff;

void warn_of_photons(Parser& parser, TurnedOff what) {
  if (what == TurnedOff::nothing) return;
  parser.warning(Code::incompatible, std::string("Cannot use pass_through with refraction & target. Turning off ") +
                                         (what == TurnedOff::refraction ? "refraction." : "pass_through."));
}

// What a statement's flags will turn off in the parts of its object. They are handed down when the statement ends
// (finish_statement), POV-Ray does it at once. `before`: flags that objects between them have handed down already.
void note_in_parts(const scene::Object& object, const scene::PhotonFlags& flags, const scene::PhotonFlags& before,
                   scene::SharedLists& seen, std::vector<TurnedOff>& turned_off) {
  if (!seen.first(object)) return;  // else nested copies of copies are as many as 2 to the power of their levels
  const auto part = [&](const scene::Object& o, bool passes) {
    scene::PhotonFlags own = *o.photons;
    own.pass_through |= passes;
    own.inherit(before);
    scene::PhotonFlags changed = own;
    changed.inherit(flags, &turned_off);
    note_in_parts(o, flags, own, seen, turned_off);
  };
  for (const scene::ObjectPtr& child : scene::declared_children(object)) {
    const auto* light = child->as<scene::LightSource>();
    part(*child, light && (light->looks_like || light->projected_through));  // spec 07 3.2
    if (light && light->looks_like) part(*light->looks_like, false);
  }
}

void warn_of_parts(Parser& parser, const scene::Object& object, const scene::PhotonFlags& flags) {
  std::vector<TurnedOff> turned_off;
  scene::SharedLists seen;
  note_in_parts(object, flags, {}, seen, turned_off);
  for (const TurnedOff what : turned_off) warn_of_photons(parser, what);
}

}  // namespace

void let_photons_pass(Parser& parser, scene::Object& object) {
  scene::PhotonFlags passing;
  passing.pass_through = passing.given = true;
  warn_of_parts(parser, object, passing);
  scene::PhotonFlags& photons = object.photons.edit();
  warn_of_photons(parser, photons.set_pass_through(true));
  photons.given = true;
}

void parse_object_photons(Parser& parser, scene::Object& object) {
  Block block(parser);
  scene::PhotonFlags& photons = object.photons.edit();
  photons.given = true;
  for (;;) {
    switch (word_at(parser)) {
      case Word::target:
        parser.next();
        warn_of_photons(parser, photons.set_target(parser.parse_optional_float(1)));
        continue;
      case Word::refraction:
        parser.next();
        warn_of_photons(parser, photons.set_refraction(parser.parse_float() > 0));
        continue;
      case Word::reflection:
        parser.next();
        photons.reflection = parser.parse_float() > 0 ? Flag::on : Flag::off;
        continue;
      case Word::collect:
        parser.next();
        photons.collect = parser.parse_flag();
        continue;
      case Word::pass_through:
        parser.next();
        warn_of_photons(parser, photons.set_pass_through(parser.parse_flag()));
        continue;
      default:
        break;
    }
    break;
  }
  block.close();
  warn_of_parts(parser, object, photons);
}

void parse_light_photons(Parser& parser, scene::LightSource& light) {
  Block block(parser);
  light.photons_given = true;
  for (;;) {
    switch (word_at(parser)) {
      case Word::refraction:
        parser.next();
        light.photon_refraction = parser.parse_float() > 0 ? Flag::on : Flag::off;
        continue;
      case Word::reflection:
        parser.next();
        light.photon_reflection = parser.parse_float() > 0 ? Flag::on : Flag::off;
        continue;
      case Word::area_light:
        parser.next();
        light.photon_area = true;
        continue;
      default:
        break;
    }
    break;
  }
  block.close();
}

}  // namespace verisim::parser
