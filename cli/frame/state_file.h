// Continue-trace (+C): finished blocks of a render are kept in a file beside the picture, so that a render that was
// broken off at any time, even by `kill -9`, goes on where it stood and ends in the identical picture.
//
// The file is a header with a key (everything the pixels depend on), then one record a finished block, each with a
// checksum. Records are appended by a single write; what follows the first damaged or incomplete record is dropped when
// the file is read.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/parts/block_record.h"
#include "tracer/film/framebuffer.h"

namespace verisim::cli {

class StateFile {
 public:
  // Nothing is written before `delay` has passed: a picture that is done sooner needs no state.
  StateFile(const std::filesystem::path& path, std::uint64_t key,
            std::chrono::milliseconds delay = std::chrono::milliseconds(1000));
  ~StateFile();
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  // Of a part of a picture of this size: its blocks, and where they lie in its framebuffer.
  void set_part(std::map<Block, Block> places, int width, int height) {
    places_ = std::move(places), width_ = width, height_ = height;
  }

  enum class Found { nothing, other_render, blocks };
  // Reads the finished blocks of an earlier run into the framebuffer (which has its size) and goes on with its file.
  Found resume(render::Framebuffer& framebuffer);
  bool known(const Block& block) const { return known_.contains(block); }
  std::size_t known_count() const { return known_.size(); }

  // Keeps a finished block; safe from several threads. Never throws: without room for it the render goes on, see
  // `failure`.
  void finished(const Block& block, const render::Framebuffer& framebuffer);
  // Writes what is still held back: before a render is left unfinished.
  void flush(const render::Framebuffer& framebuffer);
  // The render is complete: the file goes.
  void remove();
  std::string failure() const;

 private:
  bool open(bool append);
  void append(const Block& block, const render::Framebuffer& framebuffer);
  void fail(const std::string& what);

  Block place(const Block& block) const;

  std::filesystem::path path_;
  std::uint64_t key_;
  std::map<Block, Block> places_;  // empty: blocks lie where they are in the picture
  int width_ = 0, height_ = 0;     // then of the picture
  std::chrono::steady_clock::time_point start_;
  std::chrono::milliseconds delay_;
  std::set<Block> known_;
  std::vector<Block> waiting_;
  int file_ = -1;
  bool failed_ = false;
  std::string failure_;
  mutable std::mutex mutex_;
};

// True if `path` holds the beginning of a state file.
bool is_state_file(const std::filesystem::path& path);

}  // namespace verisim::cli
