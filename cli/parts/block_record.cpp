#include "cli/parts/block_record.h"

#include <array>

#include "cli/parts/fingerprint.h"
#include "tracer/base/bytes.h"

namespace verisim::cli {
namespace {

std::string head_of(const Block& block, std::size_t pixel_bytes) {
  std::string record;
  record.reserve(record_bytes(block, pixel_bytes));
  for (const std::int32_t value : {block.x, block.y, block.width, block.height}) put_bytes(record, value);
  return record;
}

template <class F>
void each_pixel(const Block& block, int width, F f) {
  for (int y = block.y; y < block.y + block.height; ++y)
    for (int x = block.x; x < block.x + block.width; ++x)
      f(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
}

}  // namespace

std::optional<Block> block_of_head(std::string_view head, int width, int height) {
  ByteSource in(head);
  Block b;
  for (int* value : {&b.x, &b.y, &b.width, &b.height}) *value = in.take<std::int32_t>();
  const bool inside =
      b.x >= 0 && b.y >= 0 && b.width > 0 && b.height > 0 && b.x <= width - b.width && b.y <= height - b.height;
  return inside ? std::optional(b) : std::nullopt;
}

bool record_is_whole(std::string_view record, std::uint64_t key) {
  if (record.size() < kRecordHead + kRecordTail) return false;
  const std::size_t body = record.size() - kRecordTail;
  return ByteSource(record.substr(body)).take<std::uint64_t>() == checksum(record.substr(0, body), key);
}

std::string color_record(const Block& block, const Block& place, const render::Framebuffer& framebuffer,
                         std::uint64_t key) {
  std::string record = head_of(block, kColorBytes);
  each_pixel(place, framebuffer.width, [&](std::size_t i) {
    const render::PixelColor& c = framebuffer.pixels[i];
    put_bytes(record, std::array{c.r, c.g, c.b, c.t});
  });
  put_bytes(record, checksum(record, key));
  return record;
}

void read_colors(std::string_view record, const Block& block, render::PixelColor* to, std::size_t stride) {
  ByteSource in(record.substr(kRecordHead));
  for (int y = 0; y < block.height; ++y, to += stride) {
    for (int x = 0; x < block.width; ++x) {
      for (float* value : {&to[x].r, &to[x].g, &to[x].b, &to[x].t}) *value = in.take<float>();
    }
  }
}

std::size_t layer_bytes(const render::Layers& wanted) {
  return (wanted.depth ? 4u : 0u) + (wanted.normal ? 12u : 0u) + (wanted.albedo ? 12u : 0u) + (wanted.id ? 4u : 0u);
}

std::string layer_record(const Block& block, const render::Layers& layers, int width, std::uint64_t key) {
  std::string record = head_of(block, layer_bytes(layers));
  each_pixel(block, width, [&](std::size_t i) {
    if (layers.depth) put_bytes(record, layers.depths[i]);
    if (layers.normal)
      for (int a = 0; a < 3; ++a) put_bytes(record, static_cast<float>(layers.normals[i][a]));  // as files have them
    if (layers.albedo)
      for (const float c : {layers.albedos[i].r, layers.albedos[i].g, layers.albedos[i].b}) put_bytes(record, c);
    if (layers.id) put_bytes(record, layers.ids[i]);
  });
  put_bytes(record, checksum(record, key));
  return record;
}

void read_layers(std::string_view record, const Block& block, render::Layers& layers, int width) {
  ByteSource in(record.substr(kRecordHead));
  each_pixel(block, width, [&](std::size_t i) {
    if (layers.depth) layers.depths[i] = in.take<float>();
    if (layers.normal)
      for (int a = 0; a < 3; ++a) layers.normals[i][a] = static_cast<double>(in.take<float>());
    if (layers.albedo)
      for (float* c : {&layers.albedos[i].r, &layers.albedos[i].g, &layers.albedos[i].b}) *c = in.take<float>();
    if (layers.id) layers.ids[i] = in.take<std::uint32_t>();
  });
}

}  // namespace verisim::cli
