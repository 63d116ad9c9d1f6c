#include "compare/report/corner_page.h"

#include <nlohmann/json.hpp>

#include "compare/oracle/process.h"
#include "compare/report/display.h"
#include "compare/report/html.h"
#include "compare/report/page/page.h"

namespace verisim::compare {
namespace {

namespace fs = std::filesystem;

constexpr int kShown = 1600;  // pixels a side: more than most pages are wide

void replace(std::string& text, const std::string& mark, const std::string& by) {
  text.replace(text.find(mark), mark.size(), by);
}

std::string png_of(const Picture& picture, int side) { return base64(png_bytes(thumbnail(picture, side, side))); }

}  // namespace

std::string corner_page(const fs::path& photograph, const fs::path& render) {
  const Picture whole = displayable(image::read_picture(photograph));
  nlohmann::json data;
  data["reference"] = photograph.string();
  data["scale"] = static_cast<double>(thumbnail(whole, kShown, kShown).width) / whole.width;
  data["photograph"] = png_of(whole, kShown);
  data["render"] = png_of(displayable(image::read_picture(render)), kShown / 4);
  data["command"] = "verisim diff " + shell_quoted(photograph.string()) + " " + shell_quoted(render.string()) +
                    " --corners CORNERS --fit exposure --fit white_balance --html report.html";
  std::string page = kCornersHtml;
  replace(page, "@POLICY@", kPagePolicy);
  replace(page, "@STYLE@", std::string("<style>") + kReportCss + "</style>");
  replace(page, "@SCRIPT@", std::string("<script>") + kCornersJs + "</script>");
  replace(page, "@DATA@", script_safe(data));  // last: names of files may hold anything
  return page;
}

}  // namespace verisim::compare
