#include "tests/fuzz/targets.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "tests/fuzz/limited_parse.h"
#include "tests/fuzz/promise.h"
#include "tracer/functions/function.h"

namespace verisim::fuzz {
namespace {

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

FunctionPtr function_of(const scene::Object& object) {
  if (!object.texture || object.texture->layers.empty()) return nullptr;
  const auto* params = std::get_if<scene::FunctionParams>(&*object.texture->layers.back().pigment->pattern.params);
  return params ? params->function : nullptr;
}

}  // namespace

void function(std::string_view bytes) {
  const std::string body(bytes);
  // Once as a pattern's function, once called by another function, which may inline it.
  const std::string declared =
      "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare F = function(x, y, z) {" + body +
      "}\nsphere { 0, 1 pigment { function { F(x, y, z) } } }\nsphere { 0, 1 pigment { function {" + body + "} } }\n";
  const parser::ParseResult result = parse(declared);
  if (!result.scene || result.scene->objects.size() != 2) return;
  const FunctionPtr caller = function_of(*result.scene->objects[0]), direct = function_of(*result.scene->objects[1]);
  if (!caller || !direct || caller->components() != 1 || direct->components() != 1 || direct->parameters() != 3 ||
      caller->parameters() != 3)
    return;
  // Loops over huge ranges are legal and endless: they are not run.
  if (body.find("sum") != std::string::npos || body.find("prod") != std::string::npos) return;
  constexpr std::size_t kPoints = 37;
  std::vector<double> points(3 * kPoints), batch(kPoints);
  constexpr double kSpecial[] = {0, -0.0, 1, -1, 0.5, 1e-300, -1e300, INFINITY, -INFINITY, NAN, 2147483648.0, 1e-10};
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = i % 5 == 0 ? kSpecial[i / 5 % std::size(kSpecial)] : std::sin(static_cast<double>(i) * 12.9898) * 7;
  direct->evaluate_batch(points.data(), kPoints, kPoints, batch.data());
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double argument[3] = {points[i], points[kPoints + i], points[2 * kPoints + i]};
    double one, through;
    direct->evaluate(argument, &one);
    caller->evaluate(argument, &through);
    require(same(one, batch[i]), "a batch gives what single points give");
    require(same(one, through), "a call gives what the function gives");
  }
}

}  // namespace verisim::fuzz
