// A ray tree as a drawing: rays as arrows, coloured by kind, hit points with their normals, ways to the lights.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/rays/viewpoint.h"

namespace verisim::cli {

// `rays`: RayTree::json()["rays"]. The points that a drawing shows: not lights, nor
// what is much farther than the eye from what it sees.
std::vector<Vec3> points_of(const nlohmann::json& rays);

struct DrawingStyle {
  int width = 480, height = 360;  // pixels
  std::string picture;            // of what is behind the rays, an address or data; empty: none
  bool alone = false;             // a file of its own, with its colours; else those of the page around it
};
// SVG. Elements have the class `ray` and one of camera, reflected, refracted, transmitted, gathering, lit, shadow.
std::string ray_svg(const nlohmann::json& rays, const Viewpoint& view, const DrawingStyle& style);

// Where a camera shows a point, in pixels of its picture, and how far in front of it that is (below 0: behind).
struct Seen {
  Vec2 at;
  double depth = 0;
};
using Projection = std::function<Seen(const Vec3&)>;
// The rays as they lie in the picture itself, but for that from the eye, which is a point there: an SVG of `width` by
// `height` pixels that is laid over it.
std::string overlay_svg(const nlohmann::json& rays, const Projection& project, int width, int height);

}  // namespace verisim::cli
