#include "cli/rays/ray_page.h"

#include <map>

#include <fmt/format.h>

#include "cli/page/page.h"
#include "cli/rays/ray_drawing.h"
#include "compare/report/html.h"
#include "compare/report/markup.h"

namespace verisim::cli {
namespace {

std::string filled(const std::string& page, const std::map<std::string, std::string>& places) {
  std::string out;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t begin = page.find('@', at), end = begin == std::string::npos ? begin : page.find('@', begin + 1);
    const auto place = end == std::string::npos ? places.end() : places.find(page.substr(begin + 1, end - begin - 1));
    if (place == places.end()) {  // no place: an @ of the text
      const std::size_t next = begin == std::string::npos ? page.size() : begin + 1;
      out.append(page, at, next - at), at = next;
    } else {
      out.append(page, at, begin - at).append(place->second), at = end + 1;
    }
  }
  return out;
}

}  // namespace

std::string ray_page(const PixelStory& story, SideView& scene) {
  constexpr int kViews = 12, kWidth = 480, kHeight = 360;
  constexpr double kElevation = 25;
  const nlohmann::json& rays = story.json["rays"];
  const std::vector<Vec3> points = points_of(rays);
  std::string views;
  for (int i = 0; i <= kViews; ++i) {  // the last one from above
    const bool top = i == kViews;
    const Viewpoint view = viewpoint_of(points, top ? 0 : 360.0 * i / kViews, top ? 90 : kElevation, kWidth, kHeight);
    const std::string behind = data_address(scene.png(view, kWidth, kHeight));
    views += fmt::format("<div{}>{}</div>\n", i == 0 ? "" : " hidden",
                         ray_svg(rays, view, {kWidth, kHeight, behind, false}));
  }
  return filled(kRaysHtml, {{"TITLE", compare::markup_escaped(story.title)},
                            {"CSS", kViewCss},
                            {"SCRIPT", kStoryJs},
                            {"STORY", compare::script_safe(story.json)},
                            {"PICTURE", data_address(story.picture)},
                            {"WIDTH", std::to_string(story.width)},
                            {"HEIGHT", std::to_string(story.height)},
                            {"X", fmt::format("{:.2f}", story.x + 0.5)},
                            {"Y", fmt::format("{:.2f}", story.y + 0.5)},
                            {"RADIUS", fmt::format("{:.1f}", story.width / 60.0)},
                            {"VIEWS", views},
                            {"LAST", std::to_string(kViews)}});
}

}  // namespace verisim::cli
