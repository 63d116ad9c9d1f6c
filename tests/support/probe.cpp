#include "tests/support/probe.h"

#include <algorithm>
#include <stdexcept>

#include "parser/source/diagnostic.h"

namespace verisim::test {

render::Framebuffer render_text(const std::string& text, int width, int height, const render::Options& options,
                                render::Statistics* statistics) {
  parser::ParseOptions parse;
  parse.width = width, parse.height = height;
  const parser::ParseResult result = parser::parse_text(text, "probe.pov", parse);
  if (!result.errors.empty()) throw std::runtime_error(parser::format(result.errors.front()));
  if (!result.scene) throw std::runtime_error("the probe did not parse");
  render::Options o = options;
  o.width = width, o.height = height;
  if (o.threads == 0) o.threads = 1;
  render::Framebuffer picture;
  const render::Statistics counted = render::render(*result.scene, o, picture);
  if (statistics) *statistics = counted;
  return picture;
}

std::vector<double> lin16(const render::Framebuffer& picture, int x, int y) {
  const Color c = picture.at(x, y);
  const auto code = [](float v) { return std::clamp(static_cast<double>(v), 0.0, 1.0) * 65535.0; };
  return {code(c.r), code(c.g), code(c.b)};
}

}  // namespace verisim::test
