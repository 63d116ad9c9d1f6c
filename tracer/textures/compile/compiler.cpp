// Turns descriptions into compiled textures, each one once.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <boost/container/deque.hpp>

#include "tracer/functions/function.h"
#include "tracer/textures/compile/compile_pattern.h"
#include "tracer/textures/compile/compiled_cache.h"
#include "tracer/textures/compile/equal_textures.h"
#include "tracer/textures/normals/normal.h"
#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/compile/pattern_signature.h"
#include "tracer/textures/compile/shared_maps.h"
#include "tracer/textures/evaluation/pigment.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {
namespace {

// Deeper nesting (pigment in pigment_map in pigment_map ...) would overflow the stack when it is evaluated.
constexpr int kMaxDepth = 1000;

bool usable_quick_color(const scene::Pigment& d) {
  return d.quick_color && d.quick_color->r != -1 && d.quick_color->g != -1 && d.quick_color->b != -1;
}

// A pattern that was compiled: what is compiled later may be the same.
struct KnownPattern {
  const scene::Pattern* description;  // part of what a cache keeps
  CompiledPattern* compiled;
};

// Several to a block: aligned blocks for each leave gaps.
using PatternBlocks = boost::container::deque_options_t<boost::container::block_size<16u>>;

}  // namespace

struct Compiler::Impl {
  Impl(const Settings& s, MapsWithoutBumpScale maps) : settings(s), maps_without_bump_scale(std::move(maps)) {}

  Settings settings;
  MapsWithoutBumpScale maps_without_bump_scale;
  CompiledCache<scene::Texture, CompiledTexture> textures;
  CompiledCache<scene::Pigment, CompiledPigment> pigments;
  CompiledCache<scene::Density, CompiledPigment> densities;
  CompiledCache<scene::Normal, CompiledNormal> normals;
  std::unordered_map<SolidColor, const CompiledPigment*, EqualTexturesHash> solid_colors;
  std::unordered_set<const CompiledTexture*, EqualTexturesHash, EqualLayers> single_layers;
  std::unordered_map<PlainNormal, const CompiledNormal*, EqualTexturesHash> plain_normals;
  std::unordered_map<std::string, ColorTable> color_tables;  // by the bytes of their maps
  TurbulenceTable turbulences;
  boost::container::deque<CompiledPattern, void, PatternBlocks> patterns;
  std::unordered_multimap<std::size_t, KnownPattern> known_patterns;  // by hashes of their signatures
  std::shared_ptr<const std::vector<WaveSource>> sources;
  int depth = 0;

  struct Deeper {
    explicit Deeper(int& d) : depth(d) {
      if (++depth > kMaxDepth) {
        --depth;
        throw std::runtime_error("textures are nested too deeply");
      }
    }
    ~Deeper() { --depth; }
    int& depth;
  };

  CompiledPattern* known_pattern(const scene::Pattern& d);
  const CompiledPattern* pattern(const scene::Pattern& d) { return known_pattern(d); }
  const CompiledPattern* pattern_with_frame(const scene::Pattern& d);
  const CompiledPigment* pigment(const scene::PigmentPtr& d);
  const CompiledPigment* density(const scene::DensityPtr& d);
  const CompiledNormal* normal(const scene::NormalPtr& d, bool no_bump_scale);
  const CompiledTexture* texture(const scene::TexturePtr& d, bool no_bump_scale);

  // Equal ones are one.
  const CompiledPigment* share(CompiledPigment c);
  const CompiledTexture* share(CompiledTexture c);
  const CompiledNormal* share(CompiledNormal c);

  bool map_lets_light_through(const scene::Pigment& d);
  CompiledPigment make_pigment(const scene::Pigment& d);
  CompiledPigment make_density(const scene::Density& d);
  CompiledNormal make_normal(const scene::Normal& d, bool no_bump_scale);
  CompiledTexture make_texture(const scene::Texture& d, bool no_bump_scale);

  template <class Entries, class CompileChild>
  void use_children(CompiledPigment& c, const scene::Pattern& d, const Entries& entries, CompileChild compile_child);
  void use_colors(CompiledPigment& c, const scene::Pattern& d, const scene::ColorMap& map);
  const ColorTable& color_table(const scene::ColorMap& map);
};

CompiledPattern* Compiler::Impl::known_pattern(const scene::Pattern& d) {
  const PatternContext context{settings, [this](const scene::PigmentPtr& p) { return pigment(p); },
                               [this] {
                                 if (!sources) sources = wave_sources(settings.number_of_waves);
                                 return sources;
                               },
                               turbulences};
  const std::string signature = pattern_signature(d);
  const std::size_t hash = std::hash<std::string>()(signature);
  for (auto [known, end] = known_patterns.equal_range(hash); known != end; ++known) {
    if (pattern_signature(*known->second.description) != signature) continue;
    CompiledPattern* const pattern = known->second.compiled;
    static std::atomic<std::uint64_t> next_id{1};
    if (pattern->shared_id == 0 && worth_remembering(*pattern)) pattern->shared_id = next_id++;
    return pattern;
  }
  CompiledPattern compiled = compile_pattern(d, context);
  patterns.push_back(std::move(compiled));
  known_patterns.emplace(hash, KnownPattern{&d, &patterns.back()});
  return &patterns.back();
}

const CompiledPattern* Compiler::Impl::pattern_with_frame(const scene::Pattern& d) {
  CompiledPattern* const known = known_pattern(d);
  if (known->frame.empty()) known->frame = frame_of(d);
  return known;
}

const CompiledPigment* Compiler::Impl::pigment(const scene::PigmentPtr& d) {
  return pigments.get(d, false, [&] { return share(make_pigment(*d)); });
}

const CompiledPigment* Compiler::Impl::density(const scene::DensityPtr& d) {
  return densities.get(d, false, [&] {
    if (d) return densities.add(make_density(*d));
    CompiledPigment one;
    one.color = Color(1, 1, 1);
    return densities.add(std::move(one));
  });
}

const CompiledNormal* Compiler::Impl::normal(const scene::NormalPtr& d, bool no_bump_scale) {
  return normals.get(d, no_bump_scale, [&] { return share(make_normal(*d, no_bump_scale)); });
}

const CompiledTexture* Compiler::Impl::texture(const scene::TexturePtr& d, bool no_bump_scale) {
  return textures.get(d, no_bump_scale, [&] { return share(make_texture(*d, no_bump_scale)); });
}

const CompiledPigment* Compiler::Impl::share(CompiledPigment c) {
  // One that is transparent by what it has replaced is another than its colour tells.
  const bool told_by_color =
      c.source == CompiledPigment::Source::plain && !c.images_filter && c.transparent == lets_light_through(c.color);
  if (!told_by_color || c.pattern) return pigments.add(std::move(c));
  const CompiledPigment*& known = solid_colors[SolidColor(c.color)];
  if (!known) known = pigments.add(std::move(c));
  return known;
}

const CompiledTexture* Compiler::Impl::share(CompiledTexture c) {
  if (c.layers.size() != 1) return textures.add(std::move(c));
  if (const auto known = single_layers.find(&c); known != single_layers.end()) return *known;
  return *single_layers.insert(textures.add(std::move(c))).first;
}

const CompiledNormal* Compiler::Impl::share(CompiledNormal c) {
  if (!c.children.empty() || !c.slopes.empty()) return normals.add(std::move(c));
  const CompiledNormal*& known = plain_normals[PlainNormal(c)];
  if (!known) known = normals.add(std::move(c));
  return known;
}

const ColorTable& Compiler::Impl::color_table(const scene::ColorMap& map) {
  static_assert(sizeof map[0] == sizeof(float) + sizeof(Color));  // no bytes between
  std::string bytes(reinterpret_cast<const char*>(map.data()), map.size() * sizeof map[0]);
  if (const auto known = color_tables.find(bytes); known != color_tables.end()) return known->second;
  std::vector<Color> colors;
  for (const auto& entry : map) colors.push_back(entry.value);
  return color_tables.emplace(std::move(bytes), ColorTable(MapPositions(map), std::move(colors))).first->second;
}

void Compiler::Impl::use_colors(CompiledPigment& c, const scene::Pattern& d, const scene::ColorMap& map) {
  const ColorTable& table = color_table(map);
  c.source = CompiledPigment::Source::color_map;
  c.pattern = pattern(d);
  c.table = &table;
  c.transparent |= table.transparent();
  c.seems_transparent |= table.transparent();
  if (!table.same_everywhere()) return;
  c.source = CompiledPigment::Source::plain;
  c.color = table.colors[0];
}

template <class Entries, class CompileChild>
void Compiler::Impl::use_children(CompiledPigment& c, const scene::Pattern& d, const Entries& entries,
                                  CompileChild compile_child) {
  if (entries.empty()) throw std::invalid_argument("an empty map");
  using enum CompiledPigment::Source;
  c.positions = MapPositions(entries);
  bool all_plain = true;
  for (const auto& entry : entries) {
    c.children.push_back(compile_child(entry.value));
    c.transparent |= c.children.back()->transparent;
    c.seems_transparent |= c.children.back()->seems_transparent;
    all_plain &= c.children.back()->source == plain;
    c.total_weight += entry.position;
  }
  if (d.kind == scene::PatternKind::uv_mapping) {
    c.source = uv_mapping;
    return;
  }
  c.pattern = pattern(d);
  c.source = d.kind == scene::PatternKind::average ? average : pigment_map;
  if (c.source == pigment_map && all_plain) {  // the same blend without visiting children
    c.source = color_map;
    scene::ColorMap map;
    for (std::size_t i = 0; i < c.children.size(); ++i) map.push_back({entries[i].position, c.children[i]->color});
    c.table = &color_table(map);
    c.children = {}, c.positions = {};
  }
}

bool Compiler::Impl::map_lets_light_through(const scene::Pigment& d) {
  if (d.pigment_map)
    return std::ranges::any_of(*d.pigment_map,
                               [this](const auto& entry) { return pigment(entry.value)->seems_transparent; });
  return d.color_map &&
         std::ranges::any_of(*d.color_map, [](const auto& entry) { return lets_light_through(entry.value); });
}

CompiledPigment Compiler::Impl::make_pigment(const scene::Pigment& d) {
  const Deeper deeper(depth);
  CompiledPigment c;
  if (settings.use_quick_color && usable_quick_color(d)) {
    c.color = *d.quick_color;
    c.transparent = c.seems_transparent = lets_light_through(c.color);
    return c;
  }
  // A pattern keeps the solid colour that it has taken the place of, a solid colour (also the black of a pigment
  // without a type) and an image the map, and POV-Ray heeds them still.
  c.transparent = c.seems_transparent = lets_light_through(d.color) || map_lets_light_through(d);
  c.images_filter = d.pigment_map && std::ranges::any_of(*d.pigment_map, [this](const auto& entry) {
                      const CompiledPigment& child = *pigment(entry.value);
                      return child.images_filter || image_filters(*entry.value, child);
                    });
  switch (d.pattern.kind) {
    case scene::PatternKind::none:
    case scene::PatternKind::plain:
      c.color = d.color;
      return c;
    case scene::PatternKind::image_map: {
      c.source = CompiledPigment::Source::image;
      c.pattern = pattern(d.pattern);
      const ImageLookup& lookup = c.pattern->as<ImageLookup>();
      c.transparent |= lookup.transparent || lookup.once;
      c.seems_transparent |= lookup.transmits || lookup.once;
      return c;
    }
    default:
      break;
  }
  if (d.pigment_map && !d.pigment_map->empty())
    use_children(c, d.pattern, *d.pigment_map, [this](const scene::PigmentPtr& p) { return pigment(p); });
  else
    use_colors(c, d.pattern, d.color_map && !d.color_map->empty() ? *d.color_map : built_in_map(d.pattern));
  return c;
}

CompiledPigment Compiler::Impl::make_density(const scene::Density& d) {
  const Deeper deeper(depth);
  CompiledPigment c;
  if (d.pattern.kind == scene::PatternKind::plain || d.pattern.kind == scene::PatternKind::none) {
    c.color = d.color;
    return c;
  }
  if (d.density_map && !d.density_map->empty())
    use_children(c, d.pattern, *d.density_map, [this](const scene::DensityPtr& p) { return density(p); });
  else
    use_colors(c, d.pattern, d.color_map && !d.color_map->empty() ? *d.color_map : built_in_map(d.pattern));
  return c;
}

CompiledNormal Compiler::Impl::make_normal(const scene::Normal& d, bool no_bump_scale) {
  using enum scene::PatternKind;
  const Deeper deeper(depth);
  CompiledNormal c;
  c.amount = d.amount;
  c.accuracy = d.accuracy;
  c.no_bump_scale = no_bump_scale || d.no_bump_scale;
  if (d.normal_map && !d.normal_map->empty()) {
    c.positions = MapPositions(*d.normal_map);
    const bool entries = c.no_bump_scale || maps_without_bump_scale.contains(d.normal_map);
    for (const auto& entry : *d.normal_map) c.children.push_back(normal(entry.value, entries));
    if (d.pattern.kind == uv_mapping) {
      c.method = CompiledNormal::Method::uv_mapping;
      return c;
    }
    if (d.pattern.kind == bump_map || d.pattern.kind == facets) {
      c.method = CompiledNormal::Method::unusable;
      return c;
    }
    c.method =
        d.pattern.kind == scene::PatternKind::average ? CompiledNormal::Method::average : CompiledNormal::Method::map;
    c.pattern = pattern_with_frame(d.pattern);
    return c;
  }
  c.pattern = pattern_with_frame(d.pattern);
  switch (d.pattern.kind) {
    case bumps:
    case dents:
    case wrinkles:
    case ripples:
    case waves:
    case quilted:
    case facets:
    case bump_map:
      c.method = CompiledNormal::Method::displacement;
      return c;
    default:
      break;
  }
  if (d.slope_map && !d.slope_map->empty()) {
    c.positions = MapPositions(*d.slope_map);
    for (const auto& entry : *d.slope_map) c.slopes.push_back(entry.value);
  }
  return c;
}

CompiledTexture Compiler::Impl::make_texture(const scene::Texture& d, bool no_bump_scale) {
  const Deeper deeper(depth);
  no_bump_scale |= d.no_bump_scale;
  CompiledTexture c;
  c.no_bump_scale = no_bump_scale;
  for (auto layer = d.layers.rbegin(); layer != d.layers.rend(); ++layer) {
    const CompiledPigment* compiled = pigment(layer->pigment);
    c.layers.push_back({compiled, layer->normal ? normal(layer->normal, no_bump_scale) : nullptr, *layer->finish});
    c.opaque |= flagged_opaque(*layer->pigment, *compiled);
    c.solid |= !compiled->transparent;
    c.images_filter |= compiled->images_filter;
  }
  if (!d.patterned()) return c;
  if (!d.texture_map || d.texture_map->empty()) throw std::invalid_argument("a patterned texture without map");
  c.uv_mapping = d.pattern.kind == scene::PatternKind::uv_mapping;
  c.average = d.pattern.kind == scene::PatternKind::average;
  c.material_map = d.pattern.kind == scene::PatternKind::image_map;
  c.pattern = pattern_with_frame(d.pattern);
  // Of these POV-Ray flags material maps alone. Of others it is what the entries filter that counts, and only what has
  // no filter at all need not be asked.
  c.solid = c.opaque = true;
  const bool entries = no_bump_scale || maps_without_bump_scale.contains(d.texture_map);
  for (const auto& entry : *d.texture_map) {
    c.map.push_back({entry.position, texture(entry.value, entries)});
    c.solid = c.solid && c.map.back().value->solid;
    c.opaque = c.opaque && c.map.back().value->opaque;
    c.images_filter |= c.map.back().value->images_filter;
  }
  if (!c.material_map) c.opaque = c.solid;
  c.positions = MapPositions(c.map);
  return c;
}

bool flagged_opaque(const scene::Pigment& description, const CompiledPigment& compiled) {
  const bool image = compiled.source == CompiledPigment::Source::image;
  return !description.image_filters && !(image ? compiled.transparent : compiled.seems_transparent);
}

bool image_filters(const scene::Pigment& description, const CompiledPigment& compiled) {
  return description.image_filters || (compiled.source == CompiledPigment::Source::image && compiled.transparent);
}

Compiler::Compiler(const Settings& settings) : Compiler(settings, MapsWithoutBumpScale()) {}
Compiler::Compiler(const Settings& settings, MapsWithoutBumpScale maps)
    : impl_(std::make_unique<Impl>(settings, std::move(maps))) {}
Compiler::~Compiler() = default;

const CompiledTexture* Compiler::texture(const scene::TexturePtr& description) {
  return impl_->texture(description, false);
}
const CompiledPigment* Compiler::pigment(const scene::PigmentPtr& description) { return impl_->pigment(description); }
const CompiledNormal* Compiler::normal(const scene::NormalPtr& description) {
  return impl_->normal(description, false);
}
const CompiledPattern* Compiler::pattern(const scene::Pattern& description) { return impl_->pattern(description); }
const CompiledPigment* Compiler::density(const scene::DensityPtr& description) { return impl_->density(description); }

}  // namespace verisim::textures
