// Uncompressed OpenEXR files of any parts and channels, written byte by byte for tests (openexr.com, "OpenEXR File
// Layout").
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace verisim::compare {

struct ExrChannel {
  std::string name;
  std::vector<std::uint32_t> values;  // or the bits of floats
  bool integer = false;
};
inline ExrChannel floats(const std::string& name, const std::vector<float>& values) {
  ExrChannel out{name, {}, false};
  for (const float v : values) out.values.push_back(std::bit_cast<std::uint32_t>(v));
  return out;
}
struct ExrPart {
  std::string name;
  std::vector<ExrChannel> channels;
};

class ExrWriter {
 public:
  ExrWriter(int width, int height, std::vector<ExrPart> parts)
      : width_(width), height_(height), parts_(std::move(parts)) {
    for (ExrPart& part : parts_)
      std::sort(part.channels.begin(), part.channels.end(),
                [](const ExrChannel& a, const ExrChannel& b) { return a.name < b.name; });
  }

  void write(const std::filesystem::path& path) {
    const bool several = parts_.size() > 1;
    put<std::uint32_t>(0x01312f76), put<std::uint32_t>(2 | (several ? 0x1000 : 0));
    for (const ExrPart& part : parts_) header(part, several);
    if (several) bytes_ += '\0';
    std::size_t table = bytes_.size();
    bytes_.resize(table + parts_.size() * static_cast<std::size_t>(height_) * 8);
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (int y = 0; y < height_; ++y, table += 8) {
        const std::uint64_t at = bytes_.size();
        std::memcpy(&bytes_[table], &at, 8);
        row(parts_[p], several ? static_cast<int>(p) : -1, y);
      }
    std::ofstream(path, std::ios::binary) << bytes_;
  }

 private:
  template <class T>
  void put(T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof raw);
  }
  void text(const std::string& t) { bytes_ += t, bytes_ += '\0'; }
  void attribute(const std::string& name, const std::string& type, int size) { text(name), text(type), put(size); }
  void string_attribute(const std::string& name, const std::string& value) {
    attribute(name, "string", static_cast<int>(value.size())), bytes_ += value;
  }
  void window(const std::string& name) {
    attribute(name, "box2i", 16), put(0), put(0), put(width_ - 1), put(height_ - 1);
  }
  void header(const ExrPart& part, bool several) {
    int size = 1;
    for (const ExrChannel& c : part.channels) size += static_cast<int>(c.name.size()) + 17;
    attribute("channels", "chlist", size);
    for (const ExrChannel& c : part.channels) text(c.name), put(c.integer ? 0 : 2), put(0), put(1), put(1);
    bytes_ += '\0';
    attribute("compression", "compression", 1), bytes_ += '\0';
    window("dataWindow"), window("displayWindow");
    attribute("lineOrder", "lineOrder", 1), bytes_ += '\0';
    if (several) {
      string_attribute("name", part.name), string_attribute("type", "scanlineimage");
      attribute("chunkCount", "int", 4), put(height_);
    }
    attribute("pixelAspectRatio", "float", 4), put(1.0f);
    attribute("screenWindowCenter", "v2f", 8), put(0.0f), put(0.0f);
    attribute("screenWindowWidth", "float", 4), put(1.0f);
    bytes_ += '\0';
  }
  void row(const ExrPart& part, int number, int y) {
    if (number >= 0) put(number);
    put(y), put(static_cast<int>(part.channels.size()) * width_ * 4);
    for (const ExrChannel& c : part.channels)
      for (int x = 0; x < width_; ++x) put(c.values.at(static_cast<std::size_t>(y * width_ + x)));
  }

  int width_, height_;
  std::vector<ExrPart> parts_;
  std::string bytes_;
};

}  // namespace verisim::compare
