// A part of a picture as a file (`verisim render --part K/N`), for `verisim merge` to make the whole of.
//
//   verisim-part-1\n | bytes of the header | header: JSON | checksum
//   of a part of the picture: records of its blocks in their order (block_record.h), then those of its layers
//   of the prepasses: number of bytes | bytes | checksum
//
// The header names the picture, all that its file will hold beside the pixels, and which part this is. Which blocks
// those are follows from it (render::parts_of), and so does the size of the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/parts/block_record.h"
#include "cli/settings/part_option.h"
#include "cli/settings/region.h"
#include "tracer/base/descriptor.h"
#include "tracer/image/output.h"

namespace verisim::cli {

// What all parts of one picture have in common.
struct PartPicture {
  std::string version;                       // of the program that renders
  std::string scene;                         // the name of its file
  std::map<std::string, std::string> files;  // read by the scene: name, and what is in it (Fingerprint)
  std::uint64_t key = 0;                     // everything that the pixels depend on
  int width = 0, height = 0;
  Region region;
  int block_size = 0;
  std::string layers;          // as --layers has them
  bool format_chosen = false;  // by +F; else the extension of the picture's name tells the format
  bool stamp = false;          // the file is to have a date
  image::OutputOptions output;
};

// In which respect two pictures differ, in words; empty: they are the same.
std::string difference(const PartPicture& a, const PartPicture& b);

struct PartHeader {
  PartPicture picture;
  PartChoice part;
};

// The blocks of a part of the picture, and those of its layers (of the whole picture, whatever region is rendered).
std::vector<Block> part_blocks(const PartHeader& header);
std::vector<Block> part_layer_blocks(const PartHeader& header);
// Where those of the picture lie in the framebuffer of the part (render::render), in the same order.
std::vector<Block> part_places(const PartHeader& header);

// All throw std::runtime_error naming the file and the reason.
void write_part(const std::filesystem::path& path, const PartHeader& header, const render::Framebuffer& framebuffer,
                const render::Layers& layers);
void write_prepass_part(const std::filesystem::path& path, const PartHeader& header, const std::string& prepasses);

// Reads a part; what is damaged is found when it is read.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  const PartHeader& header() const { return header_; }
  const std::vector<Block>& blocks() const { return blocks_; }
  const std::vector<Block>& layer_blocks() const { return layer_blocks_; }
  // Records by number of the block in these lists, for block_record.h to read.
  std::string color_record(std::size_t number);
  std::string layer_record(std::size_t number);
  std::string prepasses();
  void check();  // reads all of it
  // Few files can be open at a time; the next read opens it again.
  void close() { file_.close(); }
  bool is_open() const { return static_cast<bool>(file_); }

 private:
  [[noreturn]] void fail(const std::string& why) const;
  std::string read(std::uint64_t at, std::size_t bytes);
  std::string record(std::uint64_t at, const Block& block, std::size_t pixel_bytes);

  std::filesystem::path path_;
  Descriptor file_;
  PartHeader header_;
  std::size_t layer_bytes_ = 0;  // of a pixel
  std::vector<Block> blocks_, layer_blocks_;
  std::vector<std::uint64_t> offsets_, layer_offsets_;
  std::uint64_t body_ = 0;  // where it begins
};

}  // namespace verisim::cli
