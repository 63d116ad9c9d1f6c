#include "cli/parts/merge.h"

#include <algorithm>
#include <ctime>
#include <deque>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/parts/part_file.h"
#include "cli/settings/layers_option.h"
#include "cli/settings/reading/scene_words.h"
#include "cli/settings/source_date.h"
#include "tracer/base/output_file.h"
#include "tracer/image/formats/layers_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// All parts of one picture, by number.
class Parts {
 public:
  explicit Parts(const std::vector<fs::path>& paths) {
    const PartFile* first = nullptr;
    for (const fs::path& path : paths) {
      auto part = std::make_unique<PartFile>(path);
      part->close();
      const PartHeader& header = part->header();
      if (first) {
        if (const std::string what = difference(first->header().picture, header.picture); !what.empty())
          throw std::runtime_error(fmt::format("'{}' and '{}' are parts of different pictures: they differ in {}",
                                               first->path().string(), path.string(), what));
      } else {
        picture_ = header.picture;
      }
      if (!header.part.prepasses) add(*part);
      all_.push_back(std::move(part));
      if (!first) first = all_.front().get();
    }
    std::vector<int> missing;
    for (std::size_t i = 0; i < by_number_.size(); ++i)
      if (!by_number_[i]) missing.push_back(static_cast<int>(i) + 1);
    if (by_number_.empty()) throw std::runtime_error("there is no part of a picture among the files");
    constexpr std::size_t kNamed = 20;
    if (!missing.empty())
      throw std::runtime_error(fmt::format(
          "of {} parts {} {} missing: {}{}", by_number_.size(), missing.size(), missing.size() == 1 ? "is" : "are",
          fmt::join(missing.begin(), missing.begin() + static_cast<std::ptrdiff_t>(std::min(missing.size(), kNamed)),
                    ", "),
          missing.size() > kNamed ? " ..." : ""));
  }

  const PartPicture& picture() const { return picture_; }
  std::size_t count() const { return by_number_.size(); }
  // Asked before a part is read: few files may be open at a time.
  PartFile& open(std::size_t i) {
    constexpr std::size_t kOpen = 256;
    PartFile& part = *by_number_[i];
    if (!part.is_open()) {
      if (opened_.size() >= kOpen) opened_.front()->close(), opened_.pop_front();
      opened_.push_back(&part);
    }
    return part;
  }

 private:
  void add(PartFile& part) {
    const PartChoice& which = part.header().part;
    const auto of = static_cast<std::size_t>(which.of);
    if (by_number_.empty()) by_number_.resize(of);
    if (by_number_.size() != of)
      throw std::runtime_error(
          fmt::format("'{}' is {}, but another one is of {}", part.path().string(), which.name(), by_number_.size()));
    PartFile*& place = by_number_[static_cast<std::size_t>(which.number - 1)];
    if (place)
      throw std::runtime_error(
          fmt::format("{} is there twice: '{}' and '{}'", which.name(), place->path().string(), part.path().string()));
    place = &part;
  }

  PartPicture picture_;
  std::vector<std::unique_ptr<PartFile>> all_;
  std::vector<PartFile*> by_number_;
  std::deque<PartFile*> opened_;
};

// The picture's rows from the top; those of a row of blocks are in memory.
class MergedRows {
 public:
  MergedRows(Parts& parts, const std::atomic<bool>& stop)
      : parts_(parts), stop_(stop), width_(static_cast<std::size_t>(parts.picture().width)) {
    for (std::size_t i = 0; i < parts.count(); ++i) {
      const std::vector<Block>& blocks = parts.open(i).blocks();
      for (std::size_t k = 0; k < blocks.size(); ++k) places_.push_back({blocks[k], i, k});
    }
    std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
      return std::pair(a.block.y, a.block.x) < std::pair(b.block.y, b.block.x);
    });
  }

  const render::PixelColor* row(int y) {
    while (y >= end_ && next_ < places_.size() && places_[next_].block.y <= y) load();
    if (y < first_ || y >= end_) {  // beside the region that was rendered
      blank_.assign(width_, {});
      return blank_.data();
    }
    return band_.data() + static_cast<std::size_t>(y - first_) * width_;
  }

 private:
  struct Place {
    Block block;
    std::size_t part, number;
  };

  // The next row of blocks.
  void load() {
    if (stop_) throw std::runtime_error("interrupted");
    const Block& head = places_[next_].block;
    first_ = head.y, end_ = head.y + head.height;
    band_.assign(width_ * static_cast<std::size_t>(head.height), {});
    for (; next_ < places_.size() && places_[next_].block.y == first_; ++next_) {
      const Place& p = places_[next_];
      read_colors(parts_.open(p.part).color_record(p.number), p.block, band_.data() + p.block.x, width_);
    }
  }

  Parts& parts_;
  const std::atomic<bool>& stop_;
  std::size_t width_;
  std::vector<Place> places_;
  std::size_t next_ = 0;
  int first_ = 0, end_ = 0;
  std::vector<render::PixelColor> band_, blank_;
};

// What a render of the whole picture to this file would have been told.
image::OutputOptions output_options(const PartPicture& picture, const fs::path& output) {
  Options options;
  options.format = picture.output.format;
  options.greyscale = picture.output.greyscale;
  options.layers = picture.layers;
  options.exact_output = output.string();
  if (picture.format_chosen) options.given.emplace_back("Output_File_Type", "");
  choose_format(options);
  validate(options);
  image::OutputOptions result = picture.output;
  result.format = options.format;
  if (picture.stamp) result.time = source_date().value_or(std::time(nullptr));
  return result;
}

void write_with_layers(Parts& parts, MergedRows& rows, const fs::path& output, const image::OutputOptions& options) {
  const PartPicture& picture = parts.picture();
  LayerChoice choice = layer_choice(picture.layers);
  render::resize_layers(choice.layers, picture.width, picture.height);
  for (std::size_t i = 0; i < parts.count(); ++i) {
    PartFile& part = parts.open(i);
    for (std::size_t k = 0; k < part.layer_blocks().size(); ++k)
      read_layers(part.layer_record(k), part.layer_blocks()[k], choice.layers, picture.width);
  }
  render::Framebuffer frame;
  frame.width = picture.width, frame.height = picture.height;
  for (int y = 0; y < picture.height; ++y) frame.pixels.append(rows.row(y), static_cast<std::size_t>(picture.width));
  image::write_layers(frame, choice.layers, choice.beauty, output, options);
}

}  // namespace

Merged merge_parts(const std::vector<fs::path>& paths, const fs::path& output, const std::atomic<bool>& stop) {
  Parts parts(paths);
  const PartPicture& picture = parts.picture();
  const image::OutputOptions options = output_options(picture, output);
  require_writable(output);
  MergedRows rows(parts, stop);
  if (layer_choice(picture.layers).any)
    write_with_layers(parts, rows, output, options);
  else
    image::write({picture.width, picture.height, [&](int y) { return rows.row(y); }}, output, options);
  return {static_cast<int>(parts.count()), picture.width, picture.height};
}

}  // namespace verisim::cli
