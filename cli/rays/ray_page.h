// A pixel's rays as a page of its own: the picture, the rays from all sides, the sum that makes the colour.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "cli/rays/side_view.h"

namespace verisim::cli {

struct PixelStory {
  nlohmann::json json;  // RayTree::json() with "text", "linear", "stored" and, where POV-Ray was asked, "oracle"
  std::string title;
  std::string picture;  // PNG of the whole picture
  int width = 0, height = 0;
  double x = 0, y = 0;  // pixels, whole numbers are centres
};

// One HTML file that asks nothing of others.
std::string ray_page(const PixelStory& story, SideView& scene);

}  // namespace verisim::cli
