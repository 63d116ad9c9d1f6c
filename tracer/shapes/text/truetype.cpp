#include "tracer/shapes/text/truetype.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <stdexcept>

#include "tracer/image/shared_files.h"

namespace verisim::shapes {

namespace {

constexpr std::size_t kMaxFile = 256u << 20, kMaxPoints = 200000;
constexpr int kMaxDepth = 8, kMaxTables = 40;

}  // namespace

std::shared_ptr<const TrueTypeFont> TrueTypeFont::open(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const TrueTypeFont>> known;
  const std::string state = image::file_state(path.c_str());  // a file of this name may be another one by now
  const std::lock_guard lock(mutex);
  if (const auto at = known.find(state); at != known.end()) return at->second;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  if (size <= 0 || static_cast<std::size_t>(size) > kMaxFile)
    throw std::runtime_error("Cannot open font file. (" + path + ")");
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  file.seekg(0);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), size))
    throw std::runtime_error("Cannot open font file. (" + path + ")");
  auto font = std::make_shared<const TrueTypeFont>(std::move(bytes));
  if (known.size() >= 16) known.clear();
  return known[state] = font;
}

TrueTypeFont::TrueTypeFont(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {
  if (bytes_.size() >= 16 && std::memcmp(bytes_.data(), "ttcf", 4) == 0)
    directory_ = u32(12);  // the first font of a collection
  const Table head = table("head"), maxp = table("maxp"), hhea = table("hhea");
  cmap_ = table("cmap"), glyf_ = table("glyf"), loca_ = table("loca"), hmtx_ = table("hmtx"), kern_ = table("kern");
  units_ = u16(head.begin + 18);
  if (head.size < 54 || maxp.size < 6 || hhea.size < 36 || cmap_.size == 0 || loca_.size == 0 || hmtx_.size < 4 ||
      units_ == 0) {
    throw std::runtime_error("Invalid TrueType font headers.");
  }
  long_offsets_ = u16(head.begin + 50) != 0;
  glyphs_ = u16(maxp.begin + 4);
  metrics_ = u16(hhea.begin + 34);
}

std::shared_ptr<const Glyph> TrueTypeFont::character(char16_t character, bool unicode) const {
  const std::lock_guard lock(mutex_);
  if (kept_ > kMaxKept) characters_.clear(), kept_ = 0;
  std::shared_ptr<const Glyph>& kept = characters_[{character, unicode}];
  if (!kept) {
    auto made = std::make_shared<Glyph>(glyph(glyph_index(character, unicode)));
    if (character == u' ') made->segments.clear(), made->x_min = made->y_min = made->x_max = made->y_max = 0;
    made->make_index();
    kept_ += made->segments.size() + 1;
    kept = made;
  }
  return kept;
}

TrueTypeFont::Table TrueTypeFont::table(const char (&tag)[5]) const {
  const int count = std::min<int>(u16(directory_ + 4), kMaxTables);
  for (int i = 0; i < count; ++i) {
    const std::size_t entry = directory_ + 12 + 16 * static_cast<std::size_t>(i);
    if (entry + 16 > bytes_.size()) break;
    if (std::memcmp(&bytes_[entry], tag, 4) != 0) continue;
    const std::size_t begin = u32(entry + 8), size = u32(entry + 12);
    if (begin >= bytes_.size()) break;
    return {begin, std::min(size, bytes_.size() - begin)};
  }
  return {};
}

std::uint16_t TrueTypeFont::glyph_index(char16_t character, bool unicode) const {
  // Only the platform decides: Mac 1, Microsoft 3, Unicode 0.
  constexpr std::array<int, 4> kAscii{1, 3, 0, 3}, kUnicode{0, 3, 1, 3};
  const int count = u16(cmap_.begin + 2);
  for (const int platform : unicode ? kUnicode : kAscii) {
    for (int i = 0; i < count; ++i) {
      const std::size_t entry = cmap_.begin + 4 + 8 * static_cast<std::size_t>(i);
      if (u16(entry) != platform) continue;
      if (const int index = look_up(cmap_.begin + u32(entry + 4), character); index >= 0)
        return static_cast<std::uint16_t>(index);
    }
  }
  return 0;
}

int TrueTypeFont::look_up(std::size_t at, char16_t character) const {
  switch (u16(at)) {
    case 0:
      return character < 256 ? u8(at + 6 + character) : 0;
    case 4: {
      const int index = look_up_segments(at, character);
      return index == 0 && character < 0x100 ? look_up_segments(at, 0xf000u + character) : index;
    }
    case 6: {
      const unsigned first = u16(at + 6), count = u16(at + 8);
      return character >= first && character < first + count ? u16(at + 10 + 2 * (character - first)) : 0;
    }
    default:
      return -1;
  }
}

int TrueTypeFont::look_up_segments(std::size_t at, unsigned character) const {
  const std::size_t segments = u16(at + 6) / 2;
  const std::size_t ends = at + 14, starts = ends + 2 * segments + 2, deltas = starts + 2 * segments,
                    ranges = deltas + 2 * segments;
  for (std::size_t i = 0; i < segments; ++i) {
    if (character > u16(ends + 2 * i)) continue;
    const unsigned start = u16(starts + 2 * i);
    if (character < start) return 0;
    const unsigned range = u16(ranges + 2 * i), delta = u16(deltas + 2 * i);
    if (range == 0) return static_cast<int>((character + delta) & 0xffff);
    const unsigned index = u16(ranges + 2 * i + range + 2 * (character - start));
    return index == 0 ? 0 : static_cast<int>((index + delta) & 0xffff);
  }
  return 0;
}

TrueTypeFont::Outline TrueTypeFont::outline(std::uint16_t index, int depth, std::size_t& budget) const {
  Outline result;
  result.metrics_glyph = index;
  if (index >= glyphs_) return result;
  const auto offset = [&](std::size_t i) -> std::size_t {
    return long_offsets_ ? u32(loca_.begin + 4 * i) : std::size_t{2} * u16(loca_.begin + 2 * i);
  };
  const std::size_t begin = offset(index), end = std::min(offset(std::size_t{index} + 1), glyf_.size);
  if (begin + 10 > end) return result;
  const std::size_t at = glyf_.begin + begin, limit = glyf_.begin + end;
  const int contours = i16(at);
  result.x_min = i16(at + 2), result.y_min = i16(at + 4), result.x_max = i16(at + 6), result.y_max = i16(at + 8);
  if (contours >= 0)
    simple_outline(at + 10, limit, contours, result, budget);
  else if (depth < kMaxDepth)
    composite_outline(at + 10, limit, depth, result, budget);
  return result;
}

void TrueTypeFont::simple_outline(std::size_t at, std::size_t end, int contours, Outline& result,
                                  std::size_t& budget) const {
  std::vector<std::size_t> ends;
  for (int i = 0; i < contours && at + 2 <= end; ++i, at += 2) ends.push_back(u16(at));
  if (ends.empty() || !std::is_sorted(ends.begin(), ends.end())) return;
  const std::size_t count = ends.back() + 1;
  if (count > budget) return;
  budget -= count;
  at += 2 + std::size_t{u16(at)};  // instructions
  std::vector<std::uint8_t> flags;
  while (flags.size() < count && at < end) {
    const std::uint8_t flag = u8(at++);
    flags.push_back(flag);
    if (flag & 8) {
      for (int repeat = u8(at++); repeat > 0 && flags.size() < count; --repeat) flags.push_back(flag);
    }
  }
  if (flags.size() < count) return;
  const auto coordinates = [&](int short_bit, int same_bit) {
    std::vector<int> values(count);
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (flags[i] & short_bit)
        value += flags[i] & same_bit ? u8(at) : -static_cast<int>(u8(at)), ++at;
      else if (!(flags[i] & same_bit))
        value += i16(at), at += 2;
      values[i] = value;
    }
    return values;
  };
  const std::vector<int> x = coordinates(2, 16), y = coordinates(4, 32);
  std::size_t first = 0;
  for (const std::size_t last : ends) {
    std::vector<Point> contour;
    for (std::size_t i = first; i <= last; ++i) {
      contour.push_back({double(x[i]), double(y[i]), (flags[i] & 1) != 0});
      result.x_min = std::min(result.x_min, x[i]), result.x_max = std::max(result.x_max, x[i]);
      result.y_min = std::min(result.y_min, y[i]), result.y_max = std::max(result.y_max, y[i]);
    }
    if (!contour.empty()) result.contours.push_back(std::move(contour));
    first = last + 1;
  }
}

void TrueTypeFont::composite_outline(std::size_t at, std::size_t end, int depth, Outline& result,
                                     std::size_t& budget) const {
  constexpr unsigned kWords = 1, kOffsets = 2, kScale = 8, kMore = 32, kTwoScales = 64, kMatrix = 128, kMetrics = 512;
  result.composite = true;
  // Points in em units are compared with extents in font units: a positive lower limit becomes (almost) 0.
  result.x_min = std::min(result.x_min, 0), result.y_min = std::min(result.y_min, 0);
  unsigned flags = kMore;
  while ((flags & kMore) && at + 4 <= end) {
    flags = u16(at);
    const std::uint16_t part = u16(at + 2);
    at += 4;
    double dx, dy, sx = 1, s01 = 0, s10 = 0, sy = 1;
    if (flags & kWords)
      dx = i16(at), dy = i16(at + 2), at += 4;
    else
      dx = u8(at), dy = u8(at + 1), at += 2;  // read unsigned
    const auto fraction = [&] {
      const double v = i16(at) / 16384.0;
      at += 2;
      return v;
    };
    if (flags & kScale)
      sx = sy = fraction();
    else if (flags & kTwoScales)
      sx = fraction(), sy = fraction();
    else if (flags & kMatrix)
      sx = fraction(), s01 = fraction(), s10 = fraction(), sy = fraction();
    if (budget == 0) return;
    --budget;
    const Outline component = outline(part, depth + 1, budget);
    if (flags & kMetrics) result.metrics_glyph = component.metrics_glyph;
    if (!(flags & kOffsets)) continue;  // placed by matching points: left out
    for (const auto& contour : component.contours) {
      auto& moved = result.contours.emplace_back();
      for (const Point& p : contour)
        moved.push_back({sx * p.x + s01 * p.y + dx, s10 * p.x + sy * p.y + dy, p.on_curve});
    }
  }
}

void Glyph::make_index() {
  std::vector<Rectangle> pieces;
  pieces.reserve(segments.size());
  for (const OutlineSegment& s : segments) {
    Rectangle r(s.begin);
    r.extendBy(s.end);
    if (!s.straight) r.extendBy(s.middle);
    for (const double v : {r.min.x, r.min.y, r.max.x, r.max.y}) size = std::max(size, std::fabs(v));
    pieces.push_back(r);
  }
  index = OutlineIndex(pieces);
}

Glyph TrueTypeFont::glyph(std::uint16_t index) const {
  std::size_t budget = kMaxPoints;
  const Outline o = outline(index, 0, budget);
  const double e = 1 / units_;
  Glyph g;
  g.x_min = o.x_min * e, g.y_min = o.y_min * e, g.x_max = o.x_max * e, g.y_max = o.y_max * e;
  g.metrics_glyph = o.metrics_glyph;
  if (metrics_ > 0) {
    const std::size_t i = o.metrics_glyph, last = metrics_ - 1u;
    g.advance = u16(hmtx_.begin + 4 * std::min(i, last)) * e;
    g.left_bearing =
        (i <= last ? i16(hmtx_.begin + 4 * i + 2) : i16(hmtx_.begin + 4 * std::size_t{metrics_} + 2 * (i - metrics_))) *
        e;
  }
  for (const auto& contour : o.contours) {
    const auto at = [&](std::size_t i) { return Vec2(contour[i].x / units_, contour[i].y / units_); };
    const std::size_t n = contour.size();
    Vec2 pen = at(0);  // taken as on the curve, whatever its flag
    for (std::size_t i = 1; i <= n; ++i) {
      if (i == n) {
        if (pen != at(0)) g.segments.push_back({pen, Vec2(0), at(0), true});
        break;
      }
      if (contour[i].on_curve) {
        g.segments.push_back({pen, Vec2(0), at(i), true});
        pen = at(i);
        continue;
      }
      const Vec2 control = at(i);
      Vec2 end = at(0);
      bool closed = false;
      if (i + 1 == n)
        closed = true;
      else if (contour[i + 1].on_curve)
        end = at(i + 1), ++i;
      else
        end = (control + at(i + 1)) / 2.0;
      g.segments.push_back({pen, control, end, false});
      pen = end;
      if (closed) break;
    }
  }
  return g;
}

double TrueTypeFont::kerning(std::uint16_t left, std::uint16_t right) const {
  if (kern_.size < 4 || u16(kern_.begin) != 0) return 0;
  constexpr unsigned kHorizontal = 1, kMinimum = 2, kOverride = 8;
  const int count = u16(kern_.begin + 2);
  std::size_t at = kern_.begin + 4;
  const std::size_t end = kern_.begin + kern_.size;
  const unsigned coverage = u16(at + 4);  // of the first, used for all
  if (!(coverage & kHorizontal) || coverage >> 8 != 0) return 0;
  int total = 0;
  for (int t = 0; t < count && at + 14 <= end; ++t) {
    const std::size_t pairs = u16(at + 6);
    std::size_t pair = at + 14;
    for (std::size_t i = 0; i < pairs && pair + 6 <= end; ++i, pair += 6) {
      if (u16(pair) != left || u16(pair + 2) != right) continue;
      const int value = i16(pair + 4);
      if (coverage & kMinimum)
        total = std::max(total, value);
      else if (coverage & kOverride)
        total = value;
      else
        total += value;
      break;
    }
    at += std::max<std::size_t>(u16(at + 2), 14);
  }
  return total / units_;
}

}  // namespace verisim::shapes
