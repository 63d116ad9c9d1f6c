#include "tracer/scene/pattern.h"

namespace verisim::scene {
namespace {

template <class... Params>
constexpr bool all_named(const std::variant<NoParams, Params...>*) {
  return (names_all_fields<Params>() && ...);
}
static_assert(all_named(static_cast<const PatternParams*>(nullptr)), "fields() leaves out a parameter of a pattern");

}  // namespace

PatternParams default_params(PatternKind kind) {
  switch (kind) {
#define VERISIM_PATTERN(name, params, list, traits) \
  case PatternKind::name:                           \
    return params{};
    VERISIM_PATTERNS(VERISIM_PATTERN)
#undef VERISIM_PATTERN
  }
  return NoParams{};
}

std::span<const Color> built_in_list(PatternKind kind) {
  static constexpr Color kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlue{0, 0, 1}, kYellow{1, 1, 0}, kCyan{0, 1, 1},
      kMagenta{1, 0, 1};
  static constexpr Color kBrick[] = {{0.5f, 0.5f, 0.5f}, {0.6f, 0.15f, 0.15f}}, kFromBlue[] = {kBlue, kGreen, kRed},
                         kFromRed[] = {kRed, kGreen, kBlue, kYellow, kCyan, kMagenta};
  const std::span<const Color> colors = kind == PatternKind::brick ? std::span<const Color>(kBrick)
                                        : info(kind).list > 3      ? std::span<const Color>(kFromRed)
                                                                   : std::span<const Color>(kFromBlue);
  return colors.first(static_cast<std::size_t>(info(kind).list));
}

void Pattern::prepend(Transforms steps) {
  const bool merges = !warps.empty() && std::holds_alternative<Transform>(warps.front());
  if (!merges) warps.prepend(*steps.front());
  auto& front = std::get<Transform>(warps.front());
  for (const Transform* const t : steps.subspan(merges ? 0 : 1)) front = front.then(*t);
}

void Pattern::prepend(Warp warp) {
  if (const auto* t = std::get_if<Transform>(&warp)) return prepend(*t);
  warps.prepend(std::move(warp));
}

}  // namespace verisim::scene
