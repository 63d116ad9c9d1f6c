#include "compare/layers/layers.h"

#include <fnmatch.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "tracer/image/layers/stored_layers.h"

namespace verisim::compare {
namespace {

namespace fs = std::filesystem;
using image::StoredLayer;
using Planes = std::vector<std::vector<double>>;

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The layer's own name, without its part.
std::string bare(const std::string& name) { return name.substr(name.rfind('/') + 1); }

const char* kind_of(const StoredLayer& layer) {
  const std::string name = lower_case(bare(layer.name));
  if (layer.integer || name == "id" || name.ends_with("ids") || name.find("index") != std::string::npos) return "id";
  if (layer.colored() && name.find("crypto") == std::string::npos) return "color";
  if (layer.channels.size() == 1 &&
      (name == "z" || name.find("depth") != std::string::npos || (layer.channels[0] == "Z" && name != "n")))
    return "depth";
  if (layer.channels.size() == 3 && layer.channels[0] == "X" &&
      (name == "n" || name.find("normal") != std::string::npos))
    return "normal";
  return name.find("crypto") != std::string::npos ? "id" : "data";
}

// What one pixel may differ by: ids by nothing, normals by about a half float's step, others by what single precision
// leaves after some thousand operations: of themselves, or of the largest value where the unit is not known.
PixelLimits usual_limits(const std::string& kind, const Planes& reference, std::size_t pixels) {
  PixelLimits out;
  out.pixels = pixels / 10000;  // as of a picture that is exact
  if (kind == "id") return out;
  if (kind == "depth") return out.relative = 1e-4, out;
  if (kind == "normal") return out.absolute = 1e-3, out;
  double largest = 0;
  for (const std::vector<double>& plane : reference)
    for (const double v : plane)
      if (std::isfinite(v)) largest = std::max(largest, std::fabs(v));
  return out.absolute = 1e-4 * largest, out;
}

// Infinity and NaN are as far from everything else as can be, and equal to themselves.
double apart(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double d = std::fabs(a - b);
  return std::isfinite(d) ? d : HUGE_VAL;
}

void compare_data(const Planes& reference, const Planes& test, const PixelLimits& limits, int width, LayerResult& out) {
  for (std::size_t i = 0; i < reference.at(0).size(); ++i) {
    bool wrong = false;
    for (std::size_t c = 0; c < reference.size(); ++c) {
      const double d = apart(reference[c][i], test[c][i]);
      wrong = wrong || std::isinf(d) || (d > limits.absolute && d > limits.relative * std::fabs(reference[c][i]));
      if (d <= out.max_abs) continue;
      out.max_abs = d;
      out.worst_x = static_cast<int>(i % static_cast<std::size_t>(width)),
      out.worst_y = static_cast<int>(i / static_cast<std::size_t>(width));
    }
    out.wrong += wrong;
  }
  out.status = out.max_abs == 0 ? Status::exact : out.wrong <= limits.pixels ? Status::match : Status::differ;
  if (out.status == Status::differ)
    out.reason = fmt::format("{} pixels differ, {} may; by {:.4g} at {}, {}", out.wrong, limits.pixels, out.max_abs,
                             out.worst_x, out.worst_y);
}

Picture picture_of(const Planes& planes, int width, int height) {
  Picture out{width, height, static_cast<int>(planes.size()), true, 16, {}};
  out.samples.reserve(planes.size() * planes[0].size());
  for (std::size_t i = 0; i < planes[0].size(); ++i)
    for (const std::vector<double>& plane : planes) out.samples.push_back(static_cast<float>(plane[i]));
  return out;
}

void compare_colors(const Picture& reference, const Picture& test, const Limits& limits, bool antialiased,
                    LayerResult& out) {
  const Metrics metrics = measure(reference, test);
  out.max_abs = metrics.max_abs;
  out.wrong =
      limits.pixels
          ? pixels_beyond(*limits.pixels, reference, test)
          : static_cast<std::uint64_t>(std::llround((1 - metrics.within_1_pct / 100) * metrics.width * metrics.height));
  if (!metrics.worst.empty()) out.worst_x = metrics.worst[0].x, out.worst_y = metrics.worst[0].y;
  Verdict verdict = judge_deterministic(metrics, antialiased);
  if (!limits.empty()) {
    const std::string broken = broken_limit(limits, metrics, reference, test);
    verdict = {!broken.empty() ? Status::differ : metrics.max_abs == 0 ? Status::exact : Status::match, broken};
  }
  out.status = verdict.status, out.reason = verdict.reason;
}

void compare_pair(const fs::path& reference, const StoredLayer& a, const fs::path& test, const StoredLayer& b,
                  const LayerRule* rule, bool antialiased, LayerResult& out) {
  if (a.channels != b.channels) {
    out.reason = fmt::format("its channels are {} and {}", fmt::join(a.channels, ""), fmt::join(b.channels, ""));
  } else if (a.width != b.width || a.height != b.height) {
    out.reason = fmt::format("sizes differ: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
  } else {
    require_memory(static_cast<std::uint64_t>(a.width) * static_cast<std::uint64_t>(a.height),
                   2 * static_cast<int>(a.channels.size()));
    const Planes x = read_layer(reference, a), y = read_layer(test, b);
    const Limits limits = rule ? rule->limits : Limits{};
    if (out.kind == "color")
      compare_colors(picture_of(x, a.width, a.height), picture_of(y, a.width, a.height), limits, antialiased, out);
    else if (!limits.figures.empty())
      out.reason = limits.figures.begin()->first + " is a limit for colours";
    else
      compare_data(x, y, limits.pixels.value_or(usual_limits(out.kind, x, x.at(0).size())), a.width, out);
  }
}

// What read_picture gives, which is judged as a picture: the colours without a name, or else the first ones.
bool is_the_picture(const StoredLayer& layer, const std::vector<StoredLayer>& all) {
  const auto unnamed = [](const StoredLayer& l) { return l.part == 0 && l.colored() && l.stored == l.channels; };
  return std::any_of(all.begin(), all.end(), unnamed) ? unnamed(layer) : &layer == all.data() && layer.colored();
}

double number(const std::string& text, const std::string& whole) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !(value >= 0) || value > 1e15)
    throw std::invalid_argument(fmt::format("layer limit '{}': '{}' is not a number from 0 on", whole, text));
  return value;
}

void add_limit(const std::string& word, const std::string& whole, LayerRule& out) {
  if (word == "ignore") {
    out.ignored = true;
    return;
  }
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos)
    throw std::invalid_argument(
        fmt::format("layer limit '{}': expected ignore, or absolute, relative, pixels or max_FIGURE = NUMBER", whole));
  const std::string name = word.substr(0, equals);
  const double value = number(word.substr(equals + 1), whole);
  if (name != "absolute" && name != "relative" && name != "pixels") {
    judge_thresholds(Metrics{}, {{name, value}});  // throws for a figure that there is not
    out.limits.figures[name] = value;
    return;
  }
  if (!out.limits.pixels) out.limits.pixels.emplace();
  if (name == "absolute") out.limits.pixels->absolute = value;
  if (name == "relative") out.limits.pixels->relative = value;
  if (name == "pixels") out.limits.pixels->pixels = static_cast<std::uint64_t>(value);
}

}  // namespace

LayerRule layer_rule(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == text.size())
    throw std::invalid_argument(fmt::format("layer limit '{}': expected LAYER:LIMIT, as in Z:relative=0.001", text));
  LayerRule out{text, text.substr(0, colon)};
  for (std::size_t at = colon + 1; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    std::string word = text.substr(at, end - at);
    std::erase(word, ' ');
    add_limit(word, text, out);
    at = end + 1;
  }
  return out;
}

Layers compare_layers(const fs::path& reference, const fs::path& test, const std::vector<LayerRule>& rules,
                      bool antialiased) {
  if (!image::is_exr(reference) || !image::is_exr(test)) return {};
  const std::vector<StoredLayer> ours = image::stored_layers(test), theirs = image::stored_layers(reference);
  const auto rule_of = [&](const std::string& name) -> const LayerRule* {
    const auto found = std::find_if(rules.begin(), rules.end(), [&](const LayerRule& rule) {
      return fnmatch(rule.pattern.c_str(), name.c_str(), 0) == 0;
    });
    return found == rules.end() ? nullptr : &*found;
  };
  const auto named = [](const std::vector<StoredLayer>& layers, const std::string& name) {
    return std::find_if(layers.begin(), layers.end(), [&](const StoredLayer& l) { return l.name == name; });
  };
  Layers out;
  out.picture = std::any_of(theirs.begin(), theirs.end(),
                            [&](const StoredLayer& layer) { return is_the_picture(layer, theirs); });
  for (const StoredLayer& layer : theirs) {
    const LayerRule* rule = rule_of(layer.name);
    if (is_the_picture(layer, theirs) || (rule && rule->ignored)) continue;
    LayerResult& result = out.all.emplace_back(LayerResult{layer.name, kind_of(layer)});
    const auto other = named(ours, layer.name);
    if (other == ours.end())
      result.status = Status::removed, result.reason = "it is missing";
    else
      compare_pair(reference, layer, test, *other, rule, antialiased, result);
  }
  for (const StoredLayer& layer : ours) {
    const LayerRule* rule = rule_of(layer.name);
    if (is_the_picture(layer, ours) || (rule && rule->ignored) || named(theirs, layer.name) != theirs.end()) continue;
    out.all.push_back({layer.name, kind_of(layer), Status::added, "the reference has none"});
  }
  return out;
}

Verdict with_layers(Verdict picture, const Layers& layers) {
  if (!layers.picture) picture = {Status::exact, ""};
  for (const LayerResult& layer : layers.all) {
    if (layer.status == Status::match && picture.status == Status::exact) picture.status = Status::match;
    if (layer.passed()) continue;
    picture.status = Status::differ;
    picture.reason += fmt::format("{}layer {}: {}", picture.reason.empty() ? "" : "; ", layer.name, layer.reason);
  }
  return picture;
}

}  // namespace verisim::compare
