// A picture as Python has it: bytes of a file of 8 bits, and what the render made before they were rounded.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "parser/source/diagnostic.h"
#include "tracer/film/framebuffer.h"
#include "tracer/film/layers.h"
#include "tracer/film/statistics.h"
#include "tracer/image/output.h"

namespace verisim::python {

// Immutable for Python once it is made: views of its memory are shared.
struct Picture {
  int width = 0, height = 0, channels = 3;
  std::vector<std::uint8_t> bytes;  // row 0 at the top
  render::Framebuffer frame;        // no pixels: the picture was made from bytes
  render::Layers layers;
  image::OutputOptions output;
  render::Statistics statistics;
  std::vector<parser::Diagnostic> warnings;
  std::string debug;  // text of #debug, #render and #statistics
  int frame_number = 0;
  double clock = 0;
};
using PicturePtr = std::shared_ptr<Picture>;

// Of samples 0..1, as image files hold them.
PicturePtr picture_of(const image::Picture& samples);
// Rounds the frame to the bytes that a file would hold.
void quantise(Picture& picture);
// What image::read_picture would give for its file.
image::Picture samples_of(const Picture& picture);

// A file in memory that has a name, for functions that write to files.
class NamedMemory {
 public:
  NamedMemory();  // throws std::system_error
  ~NamedMemory();
  NamedMemory(const NamedMemory&) = delete;
  NamedMemory& operator=(const NamedMemory&) = delete;
  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void bind_picture(pybind11::module_& module);

}  // namespace verisim::python
