// PNG with the chunks POV-Ray writes (spec 02 section 4.7): libpng, and zlib to compress what is written.
#pragma once

#include <cstdio>
#include <functional>
#include <memory>

#include "tracer/image/output.h"

namespace verisim::image {

// Writes `picture` (8 or 16 bits) to an open stream; throws std::runtime_error.
void write_png(std::FILE* file, const Quantised& picture, const OutputOptions& options);
// The same from rows that are asked for one by one: `shape` has no samples.
void write_png(std::FILE* file, const Quantised& shape, const OutputOptions& options,
               const std::function<void(int y, std::uint16_t* row)>& rows);
// Reads any PNG as 8- or 16-bit samples with 1..4 channels; palettes are expanded. Throws std::runtime_error on
// anything corrupt or huge.
Quantised read_png(std::FILE* file);

// Reads a PNG row by row. Throws std::runtime_error on anything corrupt.
class PngRows {
 public:
  explicit PngRows(std::FILE* file);
  ~PngRows();
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;
  int width = 0, height = 0, channels = 0, bits = 0;
  bool interlaced = false;        // such a file cannot be read by rows
  void next(std::uint16_t* row);  // not more often than there are rows

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace verisim::image
