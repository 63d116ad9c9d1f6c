#include "cli/rays/ray_page.h"

#include <map>

#include <fmt/format.h>

#include "cli/page/page.h"
#include "cli/rays/ray_drawing.h"

namespace verisim::cli {
namespace {

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '"')
      html += "&quot;";
    else
      html += c;
  }
  return html;
}

// JSON in a script element: nothing in it may look like the element's end.
std::string inert(const nlohmann::json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

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
  return filled(kRaysHtml, {{"TITLE", escaped(story.title)},
                            {"CSS", kViewCss},
                            {"SCRIPT", kStoryJs},
                            {"STORY", inert(story.json)},
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
