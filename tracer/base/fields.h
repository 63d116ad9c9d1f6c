// Plain structs that name their members: `template <class V> void fields(V&& visit) const` calls visit("name", member)
// for each, and visit("name", a, b) for members that SDL writes as one item. What only wants the members (a dump, a
// comparison) need not know the struct.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

namespace verisim {

// The name of a member that is no item of SDL.
struct Unnamed {};

namespace detail {

struct Ignore {
  void operator()(auto, const auto&...) const {}
};

struct Anything {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor): stands for a member of any type
};

// How many members an aggregate has, those of arrays one by one.
template <class T, class... Members>
constexpr std::size_t member_count() {
  if constexpr (requires { T{Members{}..., Anything{}}; })
    return member_count<T, Members..., Anything>();
  else
    return sizeof...(Members);
}

template <class T>
const T kSample{};

template <class Variant, class... More>
struct Distinct {
  using type = Variant;
};
template <class... Kept, class First, class... More>
struct Distinct<std::variant<Kept...>, First, More...>
    : std::conditional_t<(std::is_same_v<Kept, First> || ...), Distinct<std::variant<Kept...>, More...>,
                         Distinct<std::variant<Kept..., First>, More...>> {};

template <class Nothing, class... T>
struct VariantAfter {
  using type = std::variant<T...>;
};

}  // namespace detail

template <class T>
concept HasFields = requires(const T& t) {
  t.fields(detail::Ignore{});
};

// Whether fields() visits every member.
template <class T>
constexpr bool names_all_fields() {
  std::size_t visited = 0;
  const auto count = [&visited](auto, const auto&... members) { visited += sizeof...(members); };
  detail::kSample<T>.fields(count);
  return visited == detail::member_count<T>();
}

// A variant with further alternatives, as far as it has not got them.
template <class Variant, class... More>
using DistinctVariant = typename detail::Distinct<Variant, More...>::type;

// A variant of what a list macro writes with a comma before each: VariantOf<void LIST(X)>.
template <class... Listed>
using VariantOf = typename detail::VariantAfter<Listed...>::type;

}  // namespace verisim
