// The pixels of a picture in memory or, if they are many, in a file without a name, as POV-Ray keeps them
// (Max_Image_Buffer_Memory).
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "tracer/math/color.h"

namespace verisim::render {

// A pixel: the light that arrives, and how much of what is behind the picture passes, unfiltered.
struct PixelColor {
  float r = 0, g = 0, b = 0, t = 0;

  PixelColor() = default;
  constexpr PixelColor(float red, float green, float blue, float transmit) : r(red), g(green), b(blue), t(transmit) {}
  constexpr PixelColor(const Color& c) : PixelColor(c.r, c.g, c.b, c.t) {}  // NOLINT: as samples are taken
  constexpr operator Color() const { return {r, g, b, 0, t}; }              // NOLINT: as colours are read
  constexpr Rgb rgb() const { return {r, g, b}; }
  float grey() const { return rgb().grey(); }
  friend bool operator==(const PixelColor&, const PixelColor&) = default;
  friend bool operator==(const PixelColor& a, const Color& b) { return Color(a) == b; }
};

class Pixels {
 public:
  Pixels() = default;
  Pixels(const std::vector<Color>& colors) : memory_(colors.begin(), colors.end()) {}
  Pixels(const Pixels& other) : memory_(other.begin(), other.end()) {}
  Pixels(Pixels&& other) noexcept : memory_(std::move(other.memory_)), file_(std::move(other.file_)) {}
  Pixels& operator=(Pixels other) noexcept {
    memory_.swap(other.memory_), file_.swap(other.file_);
    return *this;
  }
  ~Pixels() = default;

  // So many of one colour, in memory.
  void assign(std::size_t count, const PixelColor& color);
  // So many, black, in a file in this folder. False, and nothing changes, if there can be none or no room for it.
  bool assign_in_file(std::size_t count, const std::filesystem::path& folder);
  // Of those in memory, as of a vector.
  void append(const PixelColor* first, std::size_t count) { memory_.insert(memory_.end(), first, first + count); }
  void push_back(const PixelColor& color) { memory_.push_back(color); }
  void resize(std::size_t count) { memory_.resize(count); }
  void clear() { memory_.clear(), file_.reset(); }
  // So many pixels are done with for the time being: now and then, what lies in the file gives its memory back. From
  // any thread; what others are reading or writing stays as it is.
  void done_with(std::size_t count) const;

  bool in_file() const { return file_ != nullptr; }
  std::size_t size() const { return file_ ? file_.get_deleter().count : memory_.size(); }
  bool empty() const { return size() == 0; }
  PixelColor* data() { return file_ ? file_.get() : memory_.data(); }
  const PixelColor* data() const { return file_ ? file_.get() : memory_.data(); }
  PixelColor& operator[](std::size_t i) { return data()[i]; }
  const PixelColor& operator[](std::size_t i) const { return data()[i]; }
  PixelColor* begin() { return data(); }
  PixelColor* end() { return data() + size(); }
  const PixelColor* begin() const { return data(); }
  const PixelColor* end() const { return data() + size(); }
  operator std::vector<Color>() const { return {begin(), end()}; }
  friend bool operator==(const Pixels& a, const Pixels& b) { return std::ranges::equal(a, b); }

 private:
  struct Unmap {
    std::size_t count;
    void operator()(PixelColor* colors) const;
  };

  std::vector<PixelColor> memory_;
  std::unique_ptr<PixelColor[], Unmap> file_;  // where it is mapped
  mutable std::atomic<std::size_t> kept_ = 0;  // that were worked at since memory was given back
};

}  // namespace verisim::render
