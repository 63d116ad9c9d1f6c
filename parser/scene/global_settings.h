// Parts of global_settings, and the two of its words that may stand outside of it.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

void parse_max_trace_level(Parser& parser);
void parse_max_intersections(Parser& parser);
void parse_radiosity_settings(Parser& parser, scene::Radiosity& radiosity);
void parse_photon_settings(Parser& parser, scene::Photons& photons);
// The checks POV-Ray makes when the whole scene has been read (spec 07 2.1).
void finish_radiosity_settings(Parser& parser, scene::Radiosity& radiosity);
// photons { ... } of an object and of a light source (spec 07 3.2).
void parse_object_photons(Parser& parser, scene::Object& object);
// As what a light looks like does, with its parts.
void let_photons_pass(Parser& parser, scene::Object& object);
void parse_light_photons(Parser& parser, scene::LightSource& light);

}  // namespace verisim::parser
