#include "tracer/image/layers/stored_layers.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "tracer/image/module/module.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kMaxChannels = 1024;  // an animation system's multi-layer file has some hundred
constexpr std::string_view kColors = "YRGBA";

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw std::runtime_error("cannot read '" + path.string() + "': " + reason);
}

bool is_color(const std::string& channel) {
  return channel.size() == 1 && kColors.find(channel[0]) != std::string_view::npos;
}
std::size_t rank(const std::string& color) { return kColors.find(color[0]); }

std::vector<VerisimChannel> channels_in(const fs::path& path) {
  std::vector<VerisimChannel> out(kMaxChannels);
  char error[512] = {};
  std::int32_t count = 0;
  if (image_module(ModuleKind::exr)
          .list_channels(path.c_str(), kMaxStoredPixels, out.data(), kMaxChannels, &count, error, sizeof error) !=
      kVerisimDone)
    fail(path, error);
  if (count > kMaxChannels) fail(path, "it has too many channels");
  out.resize(static_cast<std::size_t>(count));
  return out;
}

// "part/N" and "X" of channel N.X.
std::pair<std::string, std::string> layer_and_channel(const VerisimChannel& c, bool several_parts) {
  const std::string name = c.name;
  const std::size_t dot = name.rfind('.');
  std::string layer = dot != std::string::npos ? name.substr(0, dot) : is_color(name) ? "" : name;
  if (several_parts) {
    const std::string part = *c.part_name ? c.part_name : std::to_string(c.part);
    layer = layer.empty() ? part : part + "/" + layer;
  }
  return {layer, dot == std::string::npos ? name : name.substr(dot + 1)};
}

// Colours in their usual order. Where not all are, Y is a coordinate, and channels stay in the file's order, by name.
void sort_channels(StoredLayer& layer) {
  if (!std::ranges::all_of(layer.channels, is_color)) return;
  std::vector<std::size_t> order(layer.channels.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(layer.channels[a]) < rank(layer.channels[b]); });
  StoredLayer sorted = layer;
  for (std::size_t i = 0; i < order.size(); ++i)
    sorted.channels[i] = layer.channels[order[i]], sorted.stored[i] = layer.stored[order[i]];
  layer = std::move(sorted);
}

}  // namespace

bool StoredLayer::colored() const {
  std::string names;
  for (const std::string& channel : channels) names += is_color(channel) ? channel : "?";
  return !integer && (names == "RGB" || names == "RGBA" || names == "Y" || names == "YA");
}

bool is_exr(const fs::path& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  unsigned char magic[4] = {};
  return file && std::fread(magic, 1, 4, file.get()) == 4 && magic[0] == 0x76 && magic[1] == 0x2f && magic[2] == 0x31 &&
         magic[3] == 0x01;
}

std::vector<StoredLayer> stored_layers(const fs::path& path) {
  const std::vector<VerisimChannel> channels = channels_in(path);
  const bool several_parts = !channels.empty() && channels.back().part > 0;
  std::vector<StoredLayer> out;
  for (const VerisimChannel& c : channels) {
    const auto [name, channel] = layer_and_channel(c, several_parts);
    auto layer = std::find_if(out.begin(), out.end(), [&, wanted = name](const StoredLayer& l) {
      return l.name == wanted && l.part == c.part;
    });
    if (layer == out.end()) layer = out.insert(out.end(), {name, {}, {}, c.part, c.width, c.height, true});
    layer->channels.push_back(channel), layer->stored.emplace_back(c.name);
    layer->integer = layer->integer && c.integer;
  }
  for (StoredLayer& layer : out) sort_channels(layer);
  return out;
}

std::vector<std::vector<double>> read_layer(const fs::path& path, const StoredLayer& layer) {
  const std::size_t pixels = static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height);
  std::vector<std::vector<double>> out;
  for (const VerisimChannel& c : channels_in(path)) {
    if (c.part != layer.part) continue;
    const auto at = std::find(layer.stored.begin(), layer.stored.end(), c.name);
    if (at == layer.stored.end()) continue;
    std::vector<std::uint32_t> bits(pixels);  // or floats
    void* const values = bits.data();
    const char* const name = c.name;
    char error[512] = {};
    if (image_module(ModuleKind::exr).read_channels(path.c_str(), c.part, &name, &values, 1, error, sizeof error) !=
        kVerisimDone)
      fail(path, error);
    out.resize(layer.stored.size());
    std::vector<double>& plane = out[static_cast<std::size_t>(at - layer.stored.begin())];
    plane.reserve(pixels);
    for (const std::uint32_t value : bits)
      plane.push_back(c.integer ? static_cast<double>(value) : static_cast<double>(std::bit_cast<float>(value)));
  }
  return out;
}

}  // namespace verisim::image
