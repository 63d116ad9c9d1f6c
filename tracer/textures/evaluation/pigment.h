// A compiled pigment or density: where its colour comes from.
#pragma once

#include <memory>

#include "tracer/textures/lookup/blend_map.h"
#include "tracer/textures/patterns/pattern.h"

namespace verisim::textures {

// What lies between an entry of a colour map and the one before: lower + rise * t in five components and three of
// nothing, t = (v - low) / width.
struct ColorSegment {
  alignas(32) float lower[8] = {}, rise[8] = {};
  double position = 0, low = 0, width = 0;  // singles, widened
  bool constant = false;                    // it rises nowhere
};

// A colour map, ready for look-up. Pigments that differ in where their patterns lie share one.
struct ColorTable {
  static constexpr int kFew = 32;  // one more entry than these are few
  struct alignas(64) Maxima {
    double of[kFew];
  };

  ColorTable(MapPositions positions, std::vector<Color> colors);  // one for each position, at least one

  bool same_everywhere() const;
  bool transparent() const;  // some entry filters or transmits

  MapPositions positions;
  std::vector<Color> colors;
  std::vector<ColorSegment> segments;    // of few entries: from the entry before to this one
  std::unique_ptr<Maxima> first_maxima;  // with segments: the largest position up to each entry but the last; infinite
                                         // beyond
  double flat = 0;                       // for values from 0 up to here the colour is the same
};

struct CompiledPigment {
  enum class Source : std::uint8_t { plain, color_map, pigment_map, average, uv_mapping, image };
  Source source = Source::plain;
  bool transparent = false;  // some entry filters or transmits, or may have no colour (spec 05 11.4)
  bool seems_transparent =
      false;                   // so POV-Ray finds in entries of maps, where of images only transmitting pixels count
  bool images_filter = false;  // some image in an entry of its map does, or of a map that it has taken the place of
  Color color;                 // plain
  const CompiledPattern* pattern = nullptr;      // all but plain
  const ColorTable* table = nullptr;             // color_map
  MapPositions positions;                        // pigment_map; the weights of average
  std::vector<const CompiledPigment*> children;  // pigment_map, average, uv_mapping
  float total_weight = 0;                        // average
};

bool lets_light_through(const Color& color);  // it filters or transmits
// The colour of an image_map at a warped point; false: outside.
bool image_color(const CompiledPigment& pigment, const Vec3& warped_point, Color& color);

// The map that a pattern brings when none is written (spec 05 4.3).
scene::ColorMap built_in_map(const scene::Pattern& pattern);

}  // namespace verisim::textures
