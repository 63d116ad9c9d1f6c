// warp { ... } (spec 05 section 6).
#include <algorithm>

#include "parser/scene/common/common.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

namespace {

scene::RepeatWarp parse_repeat(Parser& parser) {
  scene::RepeatWarp warp;
  const Vec3 axes = parser.parse_vec3();
  int found = -1;
  for (int i = 0; i < 3; ++i) {
    if (axes[static_cast<unsigned>(i)] == 0) continue;
    if (found >= 0) parser.error(Code::bad_value, "Can only repeat along 1 axis.");
    found = i;
  }
  if (found < 0) parser.error(Code::missing_item, "No axis specified in repeat.");
  warp.axis = found;
  warp.width = to_float(axes[static_cast<unsigned>(found)]);
  for (;;) {
    if (parser.accept(Word::offset)) {
      warp.offset = parser.parse_vec3();
    } else if (parser.accept(Word::flip)) {
      warp.flip = parser.parse_vec3();
    } else {
      return warp;
    }
  }
}

// The centre must lie inside its block with room for the radius and the random shift (spec 05 section 6).
void fit_black_hole(Parser& parser, scene::BlackHoleWarp& warp) {
  constexpr char kAxis[] = {'X', 'Y', 'Z'};
  for (unsigned i = 0; i < 3; ++i) {
    if (!(warp.repeat[i] > 0)) continue;
    warp.center[i] = std::max(warp.center[i], warp.radius);
    const double least = warp.center[i] + warp.radius + warp.turbulence[i];
    if (warp.repeat[i] < least) {
      parser.warning(Code::adjusted_value, std::string("Black Hole repeat vector ") + kAxis[i] +
                                               " too small ; increased to " + std::to_string(least));
      warp.repeat[i] = least;
    }
  }
}

scene::BlackHoleWarp parse_black_hole(Parser& parser) {
  scene::BlackHoleWarp warp;
  warp.center = parser.parse_vec3();
  parser.optional_comma();
  warp.radius = parser.parse_float();
  for (;;) {
    switch (word_at(parser)) {
      case Word::strength:
        parser.next();
        warp.strength = parser.parse_float();
        break;
      case Word::falloff:
        parser.next();
        warp.falloff = parser.parse_float();
        break;
      case Word::type:
        parser.next();
        warp.type = parser.parse_int();
        break;
      case Word::inverse:
        parser.next();
        warp.inverse = true;
        break;
      case Word::repeat:
        parser.next();
        warp.repeat = parser.parse_vec3();
        warp.repeats = true;
        fit_black_hole(parser, warp);
        break;
      case Word::turbulence:
        parser.next();
        warp.turbulence = parser.parse_vec3();
        warp.turbulent = true;
        if (warp.repeats) fit_black_hole(parser, warp);
        break;
      default:
        return warp;
    }
  }
}

scene::ProjectionWarp parse_projection(Parser& parser, scene::ProjectionWarpKind kind) {
  scene::ProjectionWarp warp;
  warp.kind = kind;
  const auto unit = [&parser](const Vec3& v) {
    if (length(v) < kEpsilon) parser.error(Code::bad_value, "The orientation of a warp must not be a zero vector.");
    return normalize(v);
  };
  if (kind == scene::ProjectionWarpKind::planar) {
    if (!accept_comma_or_number(parser) && !parser.at('<')) return warp;
    warp.orientation = unit(parser.parse_vec3());
    parser.optional_comma();
    warp.offset = parser.parse_float();
    return warp;
  }
  for (;;) {
    if (parser.accept(Word::orientation)) {
      warp.orientation = unit(parser.parse_vec3());
    } else if (parser.accept(Word::dist_exp)) {
      warp.distance_exponent = parser.parse_float();
    } else if (kind == scene::ProjectionWarpKind::toroidal && parser.accept(Word::major_radius)) {
      warp.major_radius = parser.parse_float();
    } else {
      return warp;
    }
  }
}

}  // namespace

scene::Warp parse_warp(Parser& parser) {
  Block block(parser);
  scene::Warp result;
  switch (word_at(parser)) {
    case Word::turbulence: {
      scene::TurbulenceWarp warp;
      parse_turbulence_item(parser, warp);
      while (!parser.at(Word::turbulence) && parse_turbulence_item(parser, warp)) {
      }
      result = warp;
      break;
    }
    case Word::repeat:
      parser.next();
      result = parse_repeat(parser);
      break;
    case Word::black_hole:
      parser.next();
      result = parse_black_hole(parser);
      break;
    case Word::cylindrical:
      parser.next();
      result = parse_projection(parser, scene::ProjectionWarpKind::cylindrical);
      break;
    case Word::spherical:
      parser.next();
      result = parse_projection(parser, scene::ProjectionWarpKind::spherical);
      break;
    case Word::toroidal:
      parser.next();
      result = parse_projection(parser, scene::ProjectionWarpKind::toroidal);
      break;
    case Word::planar:
      parser.next();
      result = parse_projection(parser, scene::ProjectionWarpKind::planar);
      break;
    case Word::cubic:
      parser.next();
      result = scene::CubicWarp{};
      break;
    default:
      parser.error_expected("warp type");
  }
  block.close();
  return result;
}

}  // namespace verisim::parser
