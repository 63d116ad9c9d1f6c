// Files that are not on disk: what a program gives a scene under a name.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <variant>

#include "tracer/image/in_memory.h"
#include "tracer/scene/pattern.h"

namespace verisim::parser {

// The bytes of a file of any kind (an include file, a PNG, a font, a DF3 ...), or samples that need no file format:
// pixels for image_map, bump_map, image_pattern, material_map and height_field, voxels for density_file. Immutable; may
// be used by any number of parses at a time.
class MemoryFile {
 public:
  explicit MemoryFile(std::string bytes) : content_(std::move(bytes)) {}
  explicit MemoryFile(image::PixelArray pixels) : content_(std::move(pixels)) {}
  explicit MemoryFile(scene::DensityFileParams voxels) : content_(std::move(voxels)) {}
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  // Null where it holds something else.
  const std::string* bytes() const { return std::get_if<std::string>(&content_); }
  const image::PixelArray* pixels() const { return std::get_if<image::PixelArray>(&content_); }
  const scene::DensityFileParams* voxels() const { return std::get_if<scene::DensityFileParams>(&content_); }

  // A name under which this process can open the bytes as a file, for libraries that want one; good as long as this
  // object lives. Throws std::runtime_error.
  std::filesystem::path path() const;

 private:
  std::variant<std::string, image::PixelArray, scene::DensityFileParams> content_;
  mutable std::mutex mutex_;
  mutable int descriptor_ = -1;
};

// By the name that the scene uses. They are found before files on disk.
using MemoryFiles = std::map<std::string, std::shared_ptr<const MemoryFile>>;

}  // namespace verisim::parser
