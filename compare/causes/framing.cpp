// Where the camera looks. The fewer numbers a motion needs, the more it counts.
#include <fmt/format.h>

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
        [&](std::size_t i) {
          const int x = static_cast<int>(i % static_cast<std::size_t>(c.width)),
                    y = static_cast<int>(i / static_cast<std::size_t>(c.width));
          return c.reference[c.at(left ? c.width - 1 - x : x, top ? c.height - 1 - y : y)];
        },
        weight::kRepaired));
}

std::string percent(double part) {
  return fmt::format("{:.1f} % {}", 100 * std::fabs(part), part > 0 ? "larger" : "smaller");
}

}  // namespace

void suspect_framing(const Case& c, Suspicions& out) {
  mirror_images(c, out);
  const double mx = (c.width - 1) / 2.0, my = (c.height - 1) / 2.0, f = c.reduced;
  double known = 0;  // what fewer numbers explain
  const auto attempt = [&](const char* what, const Freedom& freedom,
                           const std::function<std::string(const Motion&)>& detail) {
    const Registered r = registered(c, freedom, mx, my);
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
}

}  // namespace verisim::compare
