// Layers of textures up to version 3.1: only the bottom one filters, the others transmit (spec 05 11.2).
#include <unordered_set>

#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

namespace {

void move_to_transmit(Color& color) {
  color.t += color.f;
  color.f = 0;
}

// Maps belong to all that share them: a declared map, or one of a declared pigment or texture, is changed for
// everybody.
template <class Map>
Map& shared_map(const std::shared_ptr<const Map>& map) {
  return const_cast<Map&>(*map);
}

struct FilterToTransmit {
  std::unordered_set<const void*> seen;  // maps that are done: a map may be reached in many ways

  scene::PigmentPtr operator()(const scene::PigmentPtr& pigment) {
    auto result = std::make_shared<scene::Pigment>(*pigment);
    move_to_transmit(result->color);
    if (result->pattern.kind == scene::PatternKind::plain) return result;  // a map from before is not its own
    if (result->color_map && seen.insert(result->color_map.get()).second)
      for (auto& entry : shared_map(result->color_map)) move_to_transmit(entry.value);
    if (result->pigment_map && seen.insert(result->pigment_map.get()).second)
      for (auto& entry : shared_map(result->pigment_map)) entry.value = (*this)(entry.value);
    return result;
  }
};

}  // namespace

scene::PigmentPtr filter_to_transmit(const scene::PigmentPtr& pigment) { return FilterToTransmit()(pigment); }

}  // namespace verisim::parser
