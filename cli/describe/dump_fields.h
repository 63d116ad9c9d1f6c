// Members of a description in the scene dump, under the names that its fields() gives them.
#pragma once

#include <type_traits>

#include <nlohmann/json.hpp>

#include "cli/describe/dump.h"
#include "tracer/base/fields.h"
#include "tracer/image/image.h"

namespace verisim::cli {

// The JSON of one member.
struct MemberDump {
  using Json = SceneDump::Json;
  SceneDump& dumper;
  template <class T>
  requires std::is_arithmetic_v<T> Json operator()(T v) const { return v; }
  Json operator()(const Vec2& v) const { return dump(v); }
  Json operator()(const Vec3& v) const { return dump(v); }
  Json operator()(const FunctionPtr& f) const { return dump(f); }
  Json operator()(const scene::ObjectPtr& o) const { return o ? dumper.object(*o) : Json(nullptr); }
  Json operator()(const scene::PigmentPtr& p) const { return p ? dumper.pigment(*p) : Json(nullptr); }
  Json operator()(const ImagePtr& i) const { return i ? Json{i->width, i->height} : Json(nullptr); }
};

// Several members that SDL writes as one item become an array.
template <class Description>
void add_fields(SceneDump::Json& out, const Description& description, SceneDump& dumper) {
  const MemberDump convert{dumper};
  description.fields([&](auto name, const auto&... members) {
    if constexpr (std::is_same_v<decltype(name), Unnamed>)
      return;
    else if constexpr (sizeof...(members) == 1)
      out[name] = (convert(members), ...);
    else
      out[name] = SceneDump::Json::array({convert(members)...});
  });
}

}  // namespace verisim::cli
