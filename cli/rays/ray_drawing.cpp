#include "cli/rays/ray_drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

using Json = nlohmann::json;

Vec3 vector_of(const Json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

struct Segment {
  Vec3 from, to;
  std::string kind;
};
struct Normal {
  Vec3 point, direction;
};
struct Drawing {
  std::vector<Segment> segments;
  std::vector<Normal> normals;
};

// What is near in a tree: the way from the eye to what it sees, or else that of the first ray that hits anything.
double reach(const Json& rays) {
  for (const Json& ray : rays) {
    if (!ray.contains("distance")) continue;
    if (ray["distance"].is_number()) return ray["distance"];
    if (const double length = reach(ray["rays"]); length > 0) return length;
  }
  return 0;
}

// A ray that sees the sky is drawn `far` long.
void collect(const Json& rays, double far, Drawing& drawing) {
  for (const Json& ray : rays) {
    if (ray["kind"] == "cut off") continue;
    const Vec3 origin = vector_of(ray["origin"]), direction = vector_of(ray["direction"]);
    const double distance = ray["distance"].is_number() ? ray["distance"].get<double>() : far;
    drawing.segments.push_back({origin, origin + direction * distance, ray["kind"]});
    if (const Json& layers = ray["layers"]; !layers.empty()) {  // all layers are at the same place
      const Json& layer = layers[0];
      const Vec3 point = vector_of(layer["point"]);
      drawing.normals.push_back({point, vector_of(layer["normal"])});
      for (const Json& light : layer["lights"]) {
        const std::string state = light["state"];
        if (state == "lit") drawing.segments.push_back({vector_of(light["position"]), point, state});
        if (state == "shadow")
          drawing.segments.push_back(
              {vector_of(light.contains("blocked_at") ? light["blocked_at"] : light["position"]), point, state});
      }
    }
    collect(ray["rays"], far, drawing);
  }
}

double scale_of(const Json& rays) {
  const double length = reach(rays);
  return length > 0 ? length : 1;
}

Drawing drawing_of(const Json& rays) {
  constexpr double kSky = 0.4;
  Drawing drawing;
  collect(rays, kSky * scale_of(rays), drawing);
  return drawing;
}

std::string arrow(const Vec2& a, const Vec2& b, const std::string& kind) {
  std::string svg = fmt::format(R"(<line class="ray {}" x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}"/>)", kind, a.x,
                                a.y, b.x, b.y);
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  constexpr double kShortest = 12, kFarthest = 120, kAt = 0.55;  // pixels; of the length
  if (length >= kShortest) {
    const double head = std::min(kAt * length, kFarthest);
    const Vec2 d{(b.x - a.x) / length, (b.y - a.y) / length}, m{a.x + d.x * head, a.y + d.y * head};
    svg += fmt::format(R"(<polygon class="head {}" points="{:.2f},{:.2f} {:.2f},{:.2f} {:.2f},{:.2f}"/>)", kind,
                       m.x + 6 * d.x, m.y + 6 * d.y, m.x - 4 * d.x - 4 * d.y, m.y - 4 * d.y + 4 * d.x,
                       m.x - 4 * d.x + 4 * d.y, m.y - 4 * d.y - 4 * d.x);
  }
  return svg;
}

// A light may be far away: only the end of its way is drawn.
Vec2 clipped(const Vec2& from, const Vec2& to, double most) {
  const double length = std::hypot(from.x - to.x, from.y - to.y);
  if (length <= most) return from;
  return {to.x + (from.x - to.x) * most / length, to.y + (from.y - to.y) * most / length};
}

constexpr const char* kStyle = R"(<style>
.ray { fill: none; stroke-width: 2; stroke: var(--c) } .head { fill: var(--c) } .ray.shadow { stroke-dasharray: 5 4 }
.camera { --c: #1a5fb4 } .reflected { --c: #b35900 } .refracted { --c: #1a7a33 } .transmitted { --c: #00697a }
.lit { --c: #b38f00 } .shadow { --c: #6b6f78 } .gathering { --c: #565d6b } .normal { stroke: #1b1e25 }
.hit { fill: #1b1e25 }
</style>)";

}  // namespace

std::vector<Vec3> points_of(const Json& rays) {
  constexpr double kFar = 1.2;  // what goes on for longer leaves the drawing
  std::vector<Vec3> points;
  const double most = kFar * scale_of(rays);
  for (const Segment& s : drawing_of(rays).segments) {
    if (s.kind == "lit" || s.kind == "shadow") continue;
    const double way = length(s.to - s.from);
    if (std::any_of(points.begin(), points.end(), [&](const Vec3& p) { return length(p - s.from) <= most; }) ||
        points.empty()) {
      points.push_back(s.from);
      points.push_back(way <= most ? s.to : s.from + (s.to - s.from) * (most / way));
    }
  }
  return points;
}

std::string ray_svg(const Json& rays, const Viewpoint& view, const DrawingStyle& style) {
  const Drawing drawing = drawing_of(rays);
  std::string svg =
      fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}"{2} role="img" )"
                  R"(aria-label="The rays of the pixel">)",
                  style.width, style.height,
                  style.alone ? fmt::format(R"( width="{}" height="{}")", style.width, style.height) : "");
  if (style.alone) svg += kStyle;
  if (!style.picture.empty())
    svg += fmt::format(
        R"(<image class="behind" href="{}" width="{}" height="{}" preserveAspectRatio="none" opacity="0.5"/>)",
        style.picture, style.width, style.height);
  const auto draw = [&](bool light) {
    for (const Segment& s : drawing.segments) {
      const bool from_light = s.kind == "lit" || s.kind == "shadow";
      if (from_light != light) continue;
      const Vec2 to = view.project(s.to, style.width);
      svg += arrow(clipped(view.project(s.from, style.width), to, 2.0 * style.width), to, s.kind);
    }
  };
  draw(true), draw(false);        // the ways to lights lie below the rays
  constexpr double kNormal = 26;  // pixels
  for (const Normal& n : drawing.normals) {
    const Vec2 a = view.project(n.point, style.width);
    const Vec2 d{dot(n.direction, view.right), -dot(n.direction, view.up)};
    svg += fmt::format(R"(<line class="normal" x1="{0:.2f}" y1="{1:.2f}" x2="{2:.2f}" y2="{3:.2f}"/>)"
                       R"(<circle class="hit" cx="{0:.2f}" cy="{1:.2f}" r="3"/>)",
                       a.x, a.y, a.x + kNormal * d.x, a.y + kNormal * d.y);
  }
  return svg + "</svg>\n";
}

std::string overlay_svg(const Json& rays, const Projection& project, int width, int height) {
  constexpr double kNear = 1e-6;
  const Drawing drawing = drawing_of(rays);
  std::string svg = fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {} {}">)", width, height);
  for (const Segment& s : drawing.segments) {
    if (s.kind == "camera") continue;
    Seen from = project(s.from), to = project(s.to);
    if (from.depth < kNear && to.depth < kNear) continue;
    // What is behind the eye is cut off.
    const auto cut = [&](const Seen& behind, const Seen& front) {
      const double t = (kNear - behind.depth) / (front.depth - behind.depth);
      return project(s.from + (s.to - s.from) * (&behind == &from ? t : 1 - t));
    };
    if (from.depth < kNear)
      from = cut(from, to);
    else if (to.depth < kNear)
      to = cut(to, from);
    const double most = 4.0 * (width + height);
    svg += arrow(clipped(from.at, to.at, most), clipped(to.at, from.at, most), s.kind);
  }
  for (const Normal& n : drawing.normals)
    if (const Seen at = project(n.point); at.depth >= kNear)
      svg += fmt::format(R"(<circle class="hit" cx="{:.2f}" cy="{:.2f}" r="2"/>)", at.at.x, at.at.y);
  return svg + "</svg>\n";
}

}  // namespace verisim::cli
