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

class Pixels {
 public:
  Pixels() = default;
  Pixels(std::vector<Color> colors) : memory_(std::move(colors)) {}
  Pixels(const Pixels& other) : memory_(other.begin(), other.end()) {}
  Pixels(Pixels&& other) noexcept : memory_(std::move(other.memory_)), file_(std::move(other.file_)) {}
  Pixels& operator=(Pixels other) noexcept {
    memory_.swap(other.memory_), file_.swap(other.file_);
    return *this;
  }
  ~Pixels() = default;

  // So many of one colour, in memory.
  void assign(std::size_t count, const Color& color);
  // So many, black, in a file in this folder. False, and nothing changes, if there can be none or no room for it.
  bool assign_in_file(std::size_t count, const std::filesystem::path& folder);
  // Of those in memory, as of a vector.
  void append(const Color* first, std::size_t count) { memory_.insert(memory_.end(), first, first + count); }
  void push_back(const Color& color) { memory_.push_back(color); }
  void resize(std::size_t count) { memory_.resize(count); }
  void clear() { memory_.clear(), file_.reset(); }
  // So many pixels are done with for the time being: now and then, what lies in the file gives its memory back. From
  // any thread; what others are reading or writing stays as it is.
  void done_with(std::size_t count) const;

  bool in_file() const { return file_ != nullptr; }
  std::size_t size() const { return file_ ? file_.get_deleter().count : memory_.size(); }
  bool empty() const { return size() == 0; }
  Color* data() { return file_ ? file_.get() : memory_.data(); }
  const Color* data() const { return file_ ? file_.get() : memory_.data(); }
  Color& operator[](std::size_t i) { return data()[i]; }
  const Color& operator[](std::size_t i) const { return data()[i]; }
  Color* begin() { return data(); }
  Color* end() { return data() + size(); }
  const Color* begin() const { return data(); }
  const Color* end() const { return data() + size(); }
  operator std::vector<Color>() const { return {begin(), end()}; }
  friend bool operator==(const Pixels& a, const Pixels& b) { return std::ranges::equal(a, b); }

 private:
  struct Unmap {
    std::size_t count;
    void operator()(Color* colors) const;
  };

  std::vector<Color> memory_;
  std::unique_ptr<Color[], Unmap> file_;       // where it is mapped
  mutable std::atomic<std::size_t> kept_ = 0;  // that were worked at since memory was given back
};

}  // namespace verisim::render
