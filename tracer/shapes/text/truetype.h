// TrueType outlines as POV-Ray's text reads them (spec 04 section 9). Not a general font library: the selection of
// character tables, the extents of composite glyphs and unsigned offsets are POV-Ray's own, so a library that does
// better would move glyphs.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tracer/math/vec.h"
#include "tracer/shapes/swept/outline_index.h"

namespace verisim::shapes {

// A piece of an outline in em units: a straight line (middle unused) or a parabola with Bezier points.
struct OutlineSegment {
  Vec2 begin, middle, end;
  bool straight = true;
};

struct Glyph {
  std::vector<OutlineSegment> segments;
  double x_min = 0, y_min = 0, x_max = 0, y_max = 0;  // em units, as POV-Ray takes them
  double advance = 0, left_bearing = 0;               // em units; a composite may take them from a component
  std::uint16_t metrics_glyph = 0;                    // whose kerning applies
  // Of the segments; made for characters.
  OutlineIndex index;
  double size = 0;  // at least the size of any coordinate of a segment

  void make_index();
};

class TrueTypeFont {
 public:
  // The font in a file; read once. Throws std::runtime_error with POV-Ray's message if it cannot be used.
  static std::shared_ptr<const TrueTypeFont> open(const std::string& path);
  explicit TrueTypeFont(std::vector<std::uint8_t> bytes);

  std::uint16_t glyph_index(char16_t character, bool unicode) const;  // 0: missing
  Glyph glyph(std::uint16_t index) const;
  // What a text shows for a character, kept for the next text: a blank has no outline.
  std::shared_ptr<const Glyph> character(char16_t character, bool unicode) const;
  // Extra distance between neighbours, em units.
  double kerning(std::uint16_t left, std::uint16_t right) const;

 private:
  struct Table {
    std::size_t begin = 0, size = 0;
  };
  struct Point {
    double x, y;
    bool on_curve;
  };
  struct Outline {
    std::vector<std::vector<Point>> contours;  // font units
    int x_min = 0, y_min = 0, x_max = 0, y_max = 0;
    bool composite = false;
    std::uint16_t metrics_glyph = 0;
  };

  Table table(const char (&tag)[5]) const;
  std::uint8_t u8(std::size_t at) const { return at < bytes_.size() ? bytes_[at] : 0; }
  std::uint16_t u16(std::size_t at) const { return static_cast<std::uint16_t>(u8(at) << 8 | u8(at + 1)); }
  int i16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }
  std::uint32_t u32(std::size_t at) const { return static_cast<std::uint32_t>(u16(at)) << 16 | u16(at + 2); }
  // -1: this table has no format that is understood.
  int look_up(std::size_t cmap, char16_t character) const;
  int look_up_segments(std::size_t cmap, unsigned character) const;
  Outline outline(std::uint16_t index, int depth, std::size_t& budget) const;
  void simple_outline(std::size_t at, std::size_t end, int contours, Outline& result, std::size_t& budget) const;
  void composite_outline(std::size_t at, std::size_t end, int depth, Outline& result, std::size_t& budget) const;

  static constexpr std::size_t kMaxKept = 1 << 20;  // segments of outlines

  mutable std::mutex mutex_;
  mutable std::map<std::pair<char16_t, bool>, std::shared_ptr<const Glyph>> characters_;
  mutable std::size_t kept_ = 0;
  std::vector<std::uint8_t> bytes_;
  std::size_t directory_ = 0;
  Table cmap_, glyf_, loca_, hmtx_, kern_;
  double units_ = 1;
  bool long_offsets_ = false;
  std::uint16_t glyphs_ = 0, metrics_ = 0;
};

}  // namespace verisim::shapes
