// text (spec 04 section 9): extruded TrueType outlines, intersected exactly as lines and parabolas.
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/tree_primitive.h"
#include "tracer/shapes/text/truetype.h"

namespace verisim::shapes {

namespace {

constexpr double kNearest = 1e-6;
constexpr int kFront = 0, kBack = 1;  // parts of a glyph; 2 + i: segment i

struct PlacedGlyph {
  std::shared_ptr<const Glyph> glyph;
  Vec2 origin;
};

std::string font_path(const scene::Text& text) {
  if (!text.font.empty()) return text.font;
  constexpr const char* kFiles[] = {"timrom.ttf", "cyrvetic.ttf", "crystal.ttf", "povlogo.ttf"};
  const std::string file = kFiles[text.builtin_font >= 1 && text.builtin_font <= 3 ? text.builtin_font - 1 : 3];
  for (const char* folder :
       {"/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include", "/usr/share/povray/include"}) {
    const auto path = std::filesystem::path(folder) / file;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) return path.string();
  }
  throw std::runtime_error("Cannot open font file. (" + file + " comes with the package povray-includes)");
}

std::vector<PlacedGlyph> layout(const scene::Text& text) {
  const auto font = TrueTypeFont::open(font_path(text));
  std::vector<PlacedGlyph> result;
  if (text.place) return {{font->character(text.text.front(), text.unicode), *text.place}};
  Vec2 pen(0, 0);
  std::uint16_t previous = 0;
  for (std::size_t i = 0; i < text.text.size(); ++i) {
    const std::shared_ptr<const Glyph> glyph = font->character(text.text[i], text.unicode);
    double x;
    if (i == 0) {
      x = -glyph->x_min;
      pen.x = glyph->advance - glyph->left_bearing;
    } else {
      const double kern = font->kerning(previous, glyph->metrics_glyph);
      x = pen.x + (glyph->left_bearing - glyph->x_min + kern);
      pen.x += glyph->advance + kern;
    }
    result.push_back({glyph, Vec2(x, pen.y)});
    previous = glyph->metrics_glyph;
    pen += Vec2(text.offset.x, text.offset.y);
  }
  return result;
}

Box3 box_of(const Glyph& g, const Vec2& origin, double thickness) {
  // A negative thickness leaves the caps, but no sides between them.
  const double near = std::min(-1e-6, thickness + 1e-6), far = std::max(-1e-6, thickness + 1e-6);
  return Box3({origin.x + g.x_min, origin.y + g.y_min, near}, {origin.x + g.x_max, origin.y + g.y_max, far});
}
Box3 box_of(const PlacedGlyph& g, double thickness) { return box_of(*g.glyph, g.origin, thickness); }

// In the space of the outlines.
Box3 glyphs_box(const std::vector<PlacedGlyph>& glyphs, double thickness) {
  Box3 box;
  for (const PlacedGlyph& g : glyphs) box.extendBy(box_of(g, thickness));
  return box.isEmpty() ? everywhere() : box;
}

// Roots of a s^2 + b s + c within [0, 1]. Of a nearly straight curve, whose a is a rounding error, the root is off by
// some per cent, in POV-Ray by the same ones.
int unit_roots(double a, double b, double c, double (&roots)[2]) {
  int count = 0;
  const auto keep = [&](double s) {
    if (s >= 0 && s <= 1) roots[count++] = s;
  };
  if (std::fabs(a) < 1e-20) {
    if (b != 0) keep(-c / b);
    return count;
  }
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 1e-10)) return 0;
  const double root = std::sqrt(discriminant);
  keep((-b + root) / (2 * a));
  keep((-b - root) / (2 * a));
  return count;
}

class Text final : public TreePrimitive<Text> {
 public:
  Text(const scene::Object& description, const scene::Text& text) : Text(description, text.thickness, layout(text)) {}
  Text(const scene::Object& description, double thickness, std::vector<PlacedGlyph> glyphs)
      : TreePrimitive(description, {glyphs_box(glyphs, thickness), true}),
        thickness_(thickness),
        glyphs_(std::move(glyphs)) {
    tree_ = accel::Bvh(
        glyphs_.size(),
        [&](std::size_t i) { return glyphs_[i].glyph->segments.empty() ? Box3() : box_of(glyphs_[i], thickness_); }, 1);
    const Affine& inverse = matrix().inv;
    for (const PlacedGlyph& g : glyphs_)
      shifts_.emplace_back(inverse[3][0] - g.origin.x, inverse[3][1] - g.origin.y, inverse[3][2]);
  }

  const accel::Bvh& tree() const { return tree_; }
  bool turned() const { return true; }
  Vec3 to_tree(const Vec3& p) const { return matrix().inverse_point(p); }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink, const accel::EntryPoints* entry = nullptr) const {
    // The direction is not normalised: depths are world distances.
    const Vec3 o = matrix().inverse_point(ray.origin), d = matrix().inverse_direction(ray.direction);
    const Vec3 turned = matrix().inverse_direction(ray.origin);
    tree_.traverse(
        {o, d}, 0, sink.upper(),
        [&](std::uint32_t g, double) {
          const Vec3 local_origin = turned + shifts_[g];
          caps(g, ray, local_origin, d, sink);
          sides(g, ray, local_origin, d, sink);
          return sink.upper();
        },
        entry);
  }

  bool contains(const Vec3& p) const {
    const Vec3 turned = matrix().inverse_direction(p);
    const double z = turned.z + matrix().inv[3][2];
    if (!(z >= 0 && z <= thickness_)) return false;
    for (std::size_t g = 0; g < glyphs_.size(); ++g)
      if (in_outline(*glyphs_[g].glyph, turned.x + shifts_[g].x, turned.y + shifts_[g].y)) return true;
    return false;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    Vec3 n(0, 0, hit.part == kFront ? -1 : 1);
    if (hit.part > kBack) {
      const OutlineSegment& s =
          glyphs_[static_cast<std::size_t>(hit.v)].glyph->segments[static_cast<std::size_t>(hit.part - 2)];
      const Vec2 way =
          s.straight ? s.end - s.begin : 2 * hit.u * (s.begin - 2.0 * s.middle + s.end) + 2.0 * (s.middle - s.begin);
      n = Vec3(way.y, -way.x, 0);
    }
    return normalize(matrix().normal(n));
  }

 private:
  template <class Sink>
  void caps(std::uint32_t g, const Ray& ray, const Vec3& o, const Vec3& d, Sink& sink) const {
    if (std::fabs(d.z) < kEpsilon) return;
    const auto cap = [&](int part, double t) {
      if (!(t > kNearest && t >= sink.lower() && t <= sink.upper()) ||
          !in_outline(*glyphs_[g].glyph, o.x + t * d.x, o.y + t * d.y))
        return;
      sink.add(
          t, [&] { return ray.at(t); }, part, 0, g);
    };
    const double front = (0 - o.z) / d.z, back = front + thickness_ / d.z;
    // Where only the nearest hit is wanted, the nearer cap may spare the other one.
    const bool back_first = Sink::kNearest && back < front;
    if (back_first) cap(kBack, back);
    cap(kFront, front);
    if (!back_first) cap(kBack, back);
  }

  template <class Sink>
  void sides(std::uint32_t g, const Ray& ray, const Vec3& o, const Vec3& d, Sink& sink) const {
    if ((std::fabs(d.x) < kEpsilon && std::fabs(d.y) < kEpsilon) || sink.upper() < sink.lower()) return;
    const Glyph& glyph = *glyphs_[g].glyph;
    // On which side of the ray's line, seen along z, a point lies.
    const auto side = [&](const Vec2& p) { return p.x * d.y - p.y * d.x - (o.x * d.y - o.y * d.x); };
    const auto report = [&](double t, std::size_t i, double s) {
      if (!(t > kNearest)) return;
      const double z = o.z + t * d.z;
      if (z >= 0 && z <= thickness_)
        sink.add(
            t, [&] { return ray.at(t); }, static_cast<std::int32_t>(i) + 2, s, g);
    };
    glyph.index.overlapping(seen_from_front(o, d, glyph.size, sink), [&](std::size_t i) {
      const OutlineSegment& p = glyph.segments[i];
      if (p.straight) {
        const double ex = p.end.x - p.begin.x, ey = p.end.y - p.begin.y, det = d.x * ey - d.y * ex;
        if (std::fabs(det) < kEpsilon) return;
        const double s = ((p.begin.x - o.x) * d.y - (p.begin.y - o.y) * d.x) / det;
        if (!(s >= 0 && s <= 1)) return;
        const bool by_x = std::fabs(d.x) > kEpsilon;
        return report(by_x ? (p.begin.x + s * ex - o.x) / d.x : (p.begin.y + s * ey - o.y) / d.y, i, s);
      }
      const double s0 = side(p.begin), s1 = side(p.middle), s2 = side(p.end);
      if ((s0 > 0 && s1 > 0 && s2 > 0) || (s0 < 0 && s1 < 0 && s2 < 0)) return;
      const Vec2 a = p.begin - 2.0 * p.middle + p.end, b = 2.0 * (p.middle - p.begin);
      double roots[2];
      const int count = unit_roots(a.x * d.y - a.y * d.x, b.x * d.y - b.y * d.x, s0, roots);
      for (int k = 0; k < count; ++k) {
        const double s = roots[k];
        const bool by_x = std::fabs(d.x) > kEpsilon;
        const double at = by_x ? s * s * a.x + b.x * s + p.begin.x - o.x : s * s * a.y + b.y * s + p.begin.y - o.y;
        report(at / (by_x ? d.x : d.y), i, s);
      }
    });
  }

  // What the interval of a ray that lies between the caps and may still matter covers, seen along z. Widened by more
  // than rounding moves an intersection with a piece of an outline, even with one that the ray nearly runs along.
  template <class Sink>
  Rectangle seen_from_front(const Vec3& o, const Vec3& d, double size, const Sink& sink) const {
    const double across = std::fabs(d.x) + std::fabs(d.y);
    double from = std::max(sink.lower(), 0.0), to = sink.upper();
    if (std::fabs(d.z) > 1e-9 * across) {
      const double front = (0 - o.z) / d.z, back = front + thickness_ / d.z;
      from = std::max(from, std::min(front, back)), to = std::min(to, std::max(front, back));
    }
    if (!(to < 1e30)) return Rectangle(Vec2(-HUGE_VAL), Vec2(HUGE_VAL));
    const double slack = 1e-5 * (std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z) + size) * (1 + across * size);
    Rectangle r(Vec2(o.x + from * d.x, o.y + from * d.y));
    r.extendBy(Vec2(o.x + to * d.x, o.y + to * d.y));
    return Rectangle(r.min - Vec2(slack), r.max + Vec2(slack));
  }

  // Whether the scan line from (x, y) towards +x meets a straight piece that spans its height. POV-Ray's operations one
  // by one, because points of a letter's own walls are asked, too: a slanting piece counts from a little behind the
  // point on, an upright one does not.
  static bool line_beyond(const OutlineSegment& p, double x, double y) {
    if (p.begin.x == p.end.x) return p.end.x > x;
    const double slope = (p.end.y - p.begin.y) / (p.end.x - p.begin.x);
    return ((x - p.end.x) * slope - (y - p.end.y)) / slope < kEpsilon;
  }

  // Even-odd rule with a scan line towards +x.
  static bool in_outline(const Glyph& glyph, double x, double y) {
    if (x < glyph.x_min || x > glyph.x_max || y < glyph.y_min || y > glyph.y_max) return false;
    bool in = false;
    const double left = x - 1e-9 * (std::fabs(x) + glyph.size);
    glyph.index.overlapping(Rectangle(Vec2(left, y), Vec2(HUGE_VAL, y)), [&](std::size_t i) {
      const OutlineSegment& p = glyph.segments[i];
      const double y0 = p.begin.y, y1 = p.end.y;
      if (p.straight) {
        if ((y0 < y) == (y1 < y)) return;
        if (line_beyond(p, x, y)) in = !in;
        return;
      }
      const double ym = p.middle.y;
      if ((y0 < y && ym < y && y1 < y) || (y0 > y && ym > y && y1 > y)) return;
      const double a = y0 - 2 * ym + y1, b = 2 * (ym - y0);
      double roots[2];
      const int count = unit_roots(a, b, y0 - y, roots);
      for (int k = 0; k < count; ++k) {
        const double s = roots[k];
        if (y == y0 && s < 0.5) continue;  // level with its begin: the end of the piece before counts
        const double bend = p.begin.x - 2 * p.middle.x + p.end.x;
        if ((bend * s + 2 * (p.middle.x - p.begin.x)) * s + p.begin.x > x) in = !in;
      }
    });
    return in;
  }

  double thickness_;
  std::vector<PlacedGlyph> glyphs_;
  std::vector<Vec3> shifts_;  // the translation of the inverse and each glyph's own, which is part of its matrix
  accel::Bvh tree_;
};

}  // namespace

std::unique_ptr<Shape> compile_text(const scene::Object& object) {
  const auto frame = [](const scene::Text&) { return text_frame(); };
  return compile_in_frame<Text>(object, **object.as<std::shared_ptr<const scene::Text>>(), frame);
}

// Every text is turned a little before its modifiers apply.
Transform text_frame() { return Transform::rotation({0.001, 0.001, 0.001}); }

std::vector<LetterBox> letter_boxes(const scene::Text& text) {
  std::vector<LetterBox> boxes;
  for (const PlacedGlyph& g : layout(text)) boxes.push_back({box_of(*g.glyph, Vec2(0), text.thickness), g.origin});
  return boxes;
}

}  // namespace verisim::shapes
