// Picture files read and written row by row: of a PNG of any size no more than a row is in memory.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "tracer/image/output.h"

namespace verisim::image {

class PictureRows {
 public:
  virtual ~PictureRows() = default;
  int width = 0, height = 0, channels = 3, bits = 8;
  bool is_float = false;
  // The next row from the top, width * channels values as in Picture. Throws std::runtime_error when the file is
  // damaged or ends too early.
  virtual void next(float* row) = 0;
  // All of it, when it had to be read as a whole (before the first call of next); else nothing.
  virtual const Picture* whole() const { return nullptr; }
};

// Throws std::runtime_error naming the file and the reason. Interlaced PNG and other formats are read as a whole.
std::unique_ptr<PictureRows> open_rows(const std::filesystem::path& path);

// A PNG of 8 or 16 bits whose rows (values 0..1) are asked for from the top.
void write_rows(int width, int height, int channels, const std::function<void(int y, float* row)>& rows,
                const std::filesystem::path& path, int bits = 8);

}  // namespace verisim::image
