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
  using DumpJson = SceneDump::Json;
  SceneDump& dumper;
  template <class T>
  requires std::is_arithmetic_v<T> DumpJson operator()(T v) const { return v; }
  DumpJson operator()(const Vec2& v) const { return dump(v); }
  DumpJson operator()(const Vec3& v) const { return dump(v); }
  DumpJson operator()(const FunctionPtr& f) const { return dump(f); }
  DumpJson operator()(const scene::ObjectPtr& o) const { return o ? dumper.object(*o) : DumpJson(nullptr); }
  DumpJson operator()(const scene::PigmentPtr& p) const { return p ? dumper.pigment(*p) : DumpJson(nullptr); }
  DumpJson operator()(const ImagePtr& i) const { return i ? DumpJson{i->width, i->height} : DumpJson(nullptr); }
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
