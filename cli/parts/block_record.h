// A finished block of pixels as a record of a file: its place and size, the values of its pixels row by row, and a
// checksum that also hangs on a key, so that a record of another picture is none of this one.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tracer/film/framebuffer.h"
#include "tracer/film/layers.h"

namespace verisim::cli {

struct Block {
  int x = 0, y = 0, width = 0, height = 0;
  constexpr std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  friend auto operator<=>(const Block&, const Block&) = default;
};

inline constexpr std::size_t kRecordHead = 4 * sizeof(std::int32_t), kRecordTail = sizeof(std::uint64_t);
inline constexpr std::size_t kColorBytes = 4 * sizeof(float);  // of a pixel: r g b transmit
constexpr std::size_t record_bytes(const Block& block, std::size_t pixel_bytes) {
  return kRecordHead + block.pixels() * pixel_bytes + kRecordTail;
}

// The block that the head of a record names; nothing when it does not lie in a picture of this size.
std::optional<Block> block_of_head(std::string_view head, int width, int height);
// The whole record has the checksum that it should have.
bool record_is_whole(std::string_view record, std::uint64_t key);

// `place`: where the block's pixels lie in the framebuffer.
std::string color_record(const Block& block, const Block& place, const render::Framebuffer& framebuffer,
                         std::uint64_t key);
// Of a whole record of the block; row y of the block goes to `to + y * stride`.
void read_colors(std::string_view record, const Block& block, render::PixelColor* to, std::size_t stride);

// Of the layers that are wanted.
std::size_t layer_bytes(const render::Layers& wanted);
std::string layer_record(const Block& block, const render::Layers& layers, int width, std::uint64_t key);
void read_layers(std::string_view record, const Block& block, render::Layers& layers, int width);

}  // namespace verisim::cli
