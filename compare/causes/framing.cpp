// Where the camera looks. The fewer numbers a motion needs, the more it counts.
#include <fmt/format.h>

#include <cstring>
#include <numbers>

#include "compare/causes/families.h"
#include "compare/causes/registration.h"

namespace verisim::compare {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

void mirror_images(const Case& c, Suspicions& out) {
  for (const auto& [left, top, name] : {std::tuple(true, false, "left and right are exchanged"),
                                        std::tuple(false, true, "top and bottom are exchanged"),
                                        std::tuple(true, true, "the picture is turned by 180 degrees")})
    out.push_back(c.repaired(
        "mirrored", name,
        [&, left = left, top = top](std::size_t i) {  // Clang 14 refuses names of bindings without
          const int x = static_cast<int>(i % static_cast<std::size_t>(c.width)),
                    y = static_cast<int>(i / static_cast<std::size_t>(c.width));
          return c.reference[c.at(left ? c.width - 1 - x : x, top ? c.height - 1 - y : y)];
        },
        weight::kRepaired));
}

std::string percent(double part) {
  return fmt::format("{:.1f} % {}", 100 * std::fabs(part), part > 0 ? "larger" : "smaller");
}

struct CameraTag {
  std::array<double, 3> location{}, direction{}, right{}, up{};
};
std::optional<CameraTag> camera_of(const PixelTags& tags) {
  for (const PixelTags::Tag& tag : tags.tags) {
    CameraTag t;
    const auto read = [&](std::array<double, 3>& v, const char* word) {
      const std::size_t at = tag.name.find(word);
      return at != std::string::npos &&
             std::sscanf(tag.name.c_str() + at + std::strlen(word), " <%lf, %lf, %lf>", &v[0], &v[1], &v[2]) == 3;
    };
    if (tag.kind == "camera" && read(t.location, "location") && read(t.direction, "direction") &&
        read(t.right, "right") && read(t.up, "up"))
      return t;
  }
  return std::nullopt;
}
double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }
double apart(std::array<double, 3> a, std::array<double, 3> b, bool as_directions) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += std::pow(as_directions ? a[k] / length(a) - b[k] / length(b) : a[k] - b[k], 2);
  return std::sqrt(sum);
}

// What both programs say of their cameras.
void cameras(const Case& c, Suspicions& out) {
  constexpr double kSame = 1e-5, kSure = 0.97;
  if (!c.tags.both()) return;
  const auto was = camera_of(*c.tags.reference), is = camera_of(*c.tags.test);
  if (!was || !is) return;
  const auto add = [&](const char* what, const std::string& detail) {
    Suspicion s = c.placed(what, detail, c.wrong, 1);
    s.sure = kSure;
    out.push_back(std::move(s));
  };
  const auto text = [](const std::array<double, 3>& v) {
    return fmt::format("<{:.4g}, {:.4g}, {:.4g}>", v[0], v[1], v[2]);
  };
  if (apart(was->location, is->location, false) > kSame * (1 + length(was->location)))
    add("camera moved", fmt::format("it stands at {}, not at {}", text(is->location), text(was->location)));
  else if (apart(was->direction, is->direction, true) > kSame)
    add("camera turned", fmt::format("it looks along {}, not {}", text(is->direction), text(was->direction)));
  else if (const double ratio = (length(is->right) / length(is->up)) / (length(was->right) / length(was->up));
           std::fabs(ratio - 1) > kSame)
    add("camera stretched", fmt::format("its pictures are {:.2f} times as wide", ratio));
  else if (const double zoom =
               (length(is->direction) / length(is->right)) / (length(was->direction) / length(was->right));
           std::fabs(zoom - 1) > kSame)
    add("camera zoom", fmt::format("its pictures are {:.3f} times as large", zoom));
  else if (apart(was->right, is->right, true) > kSame)
    add("camera rotation", fmt::format("its right is {}, not {}", text(is->right), text(was->right)));
}

// How near each pixel is to the camera that the tags tell of: 1 at the middle depth, 0 where nothing is seen.
struct Depths {
  std::vector<float> nearness;
  double middle = 0, focal = 0;  // the depth where it is 1; the distance of the picture in pixels
};
std::optional<Depths> depths(const Case& c) {
  constexpr float kNearest = 10;
  const PixelTags* const tags = c.tags.any();
  const auto camera = tags ? camera_of(*tags) : std::nullopt;
  if (!camera || tags->surfaces.point.empty()) return std::nullopt;
  const Pixels points = c.numbers_of(*tags, tags->surfaces.point), normals = c.numbers_of(*tags, tags->surfaces.normal);
  const double unit = length(camera->direction);
  std::vector<double> depth(c.size()), seen;
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) depth[i] += (points[i][k] - camera->location[k]) * camera->direction[k] / unit;
    if (normals[i] == Pixel{} || !(depth[i] > 0)) depth[i] = 0;
    if (depth[i] > 0) seen.push_back(depth[i]);
  }
  if (2 * seen.size() < c.size() || !(unit > 0)) return std::nullopt;
  Depths out;
  std::nth_element(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2), seen.end());
  out.middle = seen[seen.size() / 2], out.focal = c.width * unit / length(camera->right);
  for (const double d : depth)
    out.nearness.push_back(d > 0 ? std::min(kNearest, static_cast<float>(out.middle / d)) : 0);
  return out;
}

}  // namespace

void suspect_framing(const Case& c, Suspicions& out) {
  cameras(c, out);
  mirror_images(c, out);
  const double mx = (c.width - 1) / 2.0, my = (c.height - 1) / 2.0, f = c.reduced;
  double known = 0;  // what fewer numbers explain
  const auto depth = depths(c);
  const auto attempt = [&](const char* what, const Freedom& freedom,
                           const std::function<std::string(const Motion&)>& detail) {
    const Registered r = registered(c, freedom, mx, my, {}, depth ? depth->nearness : std::vector<float>());
    Suspicion s = c.repaired(what, detail(r.motion), r.moved, 1);
    s.explained = std::max(s.explained, r.explained);
    // More numbers must explain clearly more.
    s.sure =
        weight::kRepaired * std::max(0.0, s.explained) * (known > 0 && 1 - s.explained > 0.6 * (1 - known) ? 0.8 : 1);
    known = std::max(known, s.explained);
    out.push_back(std::move(s));
  };
  const auto shifted = [f](const Motion& m) {
    return std::hypot(m.dx, m.dy) < 0.1 ? std::string()
                                        : fmt::format(", and moved by {:.2f}, {:.2f} pixels", f * m.dx, f * m.dy);
  };
  attempt("shift", {true, false, false, false}, [&](const Motion& m) {
    return fmt::format("the picture is moved by {:.2f}, {:.2f} pixels (right, down)", f * m.dx, f * m.dy);
  });
  attempt("zoom", {true, true, false, false},
          [&](const Motion& m) { return "the picture is " + percent(m.zoom_x) + shifted(m); });
  attempt("rotation", {true, false, false, true}, [&](const Motion& m) {
    return fmt::format("the picture is turned by {:.2f} degrees {}{}", std::fabs(kDegrees * m.turn),
                       m.turn > 0 ? "clockwise" : "anticlockwise", shifted(m));
  });
  attempt("stretched", {true, false, true, false}, [&](const Motion& m) {
    return fmt::format("the picture is {} in width and {} in height{}", percent(m.zoom_x), percent(m.zoom_y),
                       shifted(m));
  });
  if (depth)
    attempt("camera moved", {.parallax = true}, [&](const Motion& m) {
      const double unit = depth->middle / depth->focal;
      return fmt::format("it stands {:.2g} further to the {} and {:.2g} {} than in the reference",
                         std::fabs(m.parallax_x) * unit, m.parallax_x < 0 ? "right" : "left",
                         std::fabs(m.parallax_y) * unit, m.parallax_y > 0 ? "higher" : "lower");
    });
}

}  // namespace verisim::compare
