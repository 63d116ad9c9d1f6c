#include "parser/scene/common/nesting.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <variant>

#include "parser/scene/common/common.h"
#include "tracer/scene/parts.h"

namespace verisim::parser {
namespace {

struct Measure {
  int depth = 1;           // levels of maps
  double evaluations = 1;  // of patterns at one point, at most
};

// Visits each description once. Chains are short: the level before was checked when it was declared.
class Walk {
 public:
  Measure of(const scene::Pigment& pigment) {
    return once(&pigment, [&] { return with_pattern(pigment.pattern, pigment.pigment_map.get()); });
  }
  Measure of(const scene::Normal& normal) {
    return once(&normal, [&] {
      Measure m = with_pattern(normal.pattern, normal.normal_map.get());
      if (!normal.normal_map) m.evaluations *= 4;  // a height is asked for at four points
      return m;
    });
  }
  Measure of(const scene::Density& density) {
    return once(&density, [&] { return with_pattern(density.pattern, density.density_map.get()); });
  }
  Measure of(const scene::Texture& texture) {
    return once(&texture, [&] {
      if (texture.patterned()) return with_pattern(texture.pattern, texture.texture_map.get());
      Measure all{1, 0};
      for (const scene::TextureLayer& layer : texture.layers) {
        add(all, of(*layer.pigment));
        if (layer.normal) add(all, of(*layer.normal));
      }
      return all;
    });
  }

 private:
  static void add(Measure& all, const Measure& m) {
    all.depth = std::max(all.depth, m.depth);
    all.evaluations += m.evaluations;
  }

  template <class Make>
  Measure once(const void* description, Make make) {
    if (const auto found = known_.find(description); found != known_.end()) return found->second;
    const Measure m = make();
    known_.emplace(description, m);
    return m;
  }

  // A map evaluates two of its children, an average all.
  template <class Map>
  Measure with_pattern(const scene::Pattern& pattern, const Map* map) {
    Measure own;
    if (pattern.kind == scene::PatternKind::pigment_pattern)
      if (const auto* params = std::get_if<scene::PigmentPatternParams>(&*pattern.params); params && params->pigment) {
        own = of(*params->pigment);
        ++own.depth;
      }
    if (!map) return own;
    Measure children{0, 0};
    double largest = 0;
    for (const auto& entry : *map)
      if (entry.value) {
        const Measure m = of(*entry.value);
        add(children, m);
        largest = std::max(largest, m.evaluations);
      }
    const bool all = pattern.kind == scene::PatternKind::average;
    return {std::max(own.depth, children.depth + 1),
            own.evaluations + (all ? children.evaluations : std::min(children.evaluations, 2 * largest))};
  }

  std::unordered_map<const void*, Measure> known_;
};

template <class Description>
void check(Parser& parser, const Description& description) {
  const Measure m = Walk().of(description);
  if (m.depth > parser.options().limits.max_depth)
    parser.fatal(Code::nesting_limit,
                 "Maps of pigments, normals, densities or textures are nested deeper than " +
                     std::to_string(parser.options().limits.max_depth) + " levels.",
                 "--max-depth raises this limit.");
  if (m.evaluations > kMaxEvaluations)
    parser.fatal(Code::nesting_limit, "Maps within maps: one point would need more than 10000000 evaluations.");
}

bool is_nested(const scene::Pattern& pattern) { return pattern.kind == scene::PatternKind::pigment_pattern; }

}  // namespace

void check_nesting(Parser& parser, const scene::Pigment& pigment) {
  if (pigment.pigment_map || is_nested(pigment.pattern)) check(parser, pigment);
}
void check_nesting(Parser& parser, const scene::Normal& normal) {
  if (normal.normal_map || is_nested(normal.pattern)) check(parser, normal);
}
void check_nesting(Parser& parser, const scene::Density& density) {
  if (density.density_map || is_nested(density.pattern)) check(parser, density);
}
void check_nesting(Parser& parser, const scene::Texture& texture) {
  if (texture.patterned()) check(parser, texture);
}

void check_nesting(Parser& parser, const scene::Object& object) {
  const scene::Parts parts = scene::parts_of(object);
  if (parts.levels > kMaxObjectLevels)
    parser.fatal(Code::nesting_limit, fmt::format("Objects are nested deeper than {} levels.", kMaxObjectLevels),
                 "A union of many copies side by side needs one level only.");
  check_object_count(parser, parts.objects);
  // Few statements can make many copies; those that were made took their time.
  constexpr double kManyObjects = 1e4;
  const auto& cancelled = parser.options().cancelled;
  if (parts.objects > kManyObjects && cancelled && cancelled())
    parser.fatal(Code::time_limit, "Interrupted, or longer than --max-seconds allows.");
}

void check_object_count(Parser& parser, double objects) {
  const double most = static_cast<double>(parser.options().limits.max_memory_bytes) / scene::kBytesPerObject;
  if (objects > most)
    parser.fatal(
        Code::size_limit,
        fmt::format("With the copies written out there are {:.3g} objects; --max-memory allows {:.3g}.", objects, most),
        "--max-memory raises this limit.");
}

}  // namespace verisim::parser
