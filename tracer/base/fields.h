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

template <class... Kept, class First>
auto with(std::variant<Kept...>, First*)
    -> std::conditional_t<(std::is_same_v<Kept, First> || ...), std::variant<Kept...>, std::variant<Kept..., First>>;

template <class Variant, class... More>
struct Distinct {
  using type = Variant;
};
template <class Variant, class First, class... More>
struct Distinct<Variant, First, More...>
    : Distinct<decltype(with(std::declval<Variant>(), static_cast<First*>(nullptr))), More...> {};

}  // namespace detail

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

}  // namespace verisim
