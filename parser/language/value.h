// Typed values of SDL identifiers (spec 01 section 6). Values are shared and immutable; assignment replaces the
// pointer.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "tracer/functions/function.h"
#include "tracer/functions/splines/spline.h"
#include "tracer/scene/scene.h"

namespace verisim::parser {

struct Array;  // array.h
struct Macro;  // macro.h
struct FileHandle;

// A numeric value: 1 float, 2..4 a vector, 5 a colour (stored in single precision once declared).
struct Numeric {
  std::array<double, 5> v{};
  int terms = 1;
};

struct Material {
  scene::TexturePtr texture, interior_texture;
  scene::InteriorPtr interior;
  scene::Rare<Transform> solid_steps;  // as scene::Object::solid_steps
};

template <class T>
using Shared = std::shared_ptr<const T>;

struct SlopeMap {
  Shared<scene::BlendMap<scene::SlopeEntry>> map;
};
struct ColorMapValue {
  Shared<scene::ColorMap> map;
};
struct PigmentMapValue {
  Shared<scene::BlendMap<scene::PigmentPtr>> map;
};
struct NormalMapValue {
  Shared<scene::BlendMap<scene::NormalPtr>> map;
};
struct TextureMapValue {
  Shared<scene::BlendMap<scene::TexturePtr>> map;
};
struct DensityMapValue {
  Shared<scene::BlendMap<scene::DensityPtr>> map;
};

using Value = std::variant<std::monostate,  // declared, without a value yet
                           Numeric, std::u16string, std::shared_ptr<Array>, FunctionPtr, Shared<Spline>,
                           scene::PigmentPtr, scene::NormalPtr, Shared<scene::Finish>, scene::TexturePtr,
                           scene::DensityPtr, Shared<scene::Interior>, Shared<scene::Media>, Shared<Material>,
                           ColorMapValue, PigmentMapValue, NormalMapValue, SlopeMap, TextureMapValue, DensityMapValue,
                           Shared<Transform>, Shared<scene::Camera>, Shared<scene::Fog>, Shared<scene::Rainbow>,
                           Shared<scene::SkySphere>, scene::ObjectPtr, Shared<Macro>, std::shared_ptr<FileHandle>>;

}  // namespace verisim::parser
