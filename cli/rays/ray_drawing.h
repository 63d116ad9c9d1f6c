// A ray tree as a drawing: rays as arrows, coloured by kind, hit points with their normals, ways to the lights.
#pragma once

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

}  // namespace verisim::cli
