// The seam between the tracer and large libraries of image formats: a C interface implemented by plug-ins.
//
// OpenImageIO and what it needs are some 260 shared libraries, 0.2 s of start-up, libtiff and OpenEXR a dozen each, so
// the program does not link them: `image_module()` loads a plug-in when the first image wants it. TIFF and OpenEXR
// files of the usual layouts are read by a plug-in each; the rest, and what we do not write ourselves, is
// OpenImageIO's. Only plain data cross the seam; errors are returned as text, never thrown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

extern "C" {

enum VerisimSample : std::int32_t { kVerisimUint8 = 0, kVerisimUint16 = 1, kVerisimHalf = 2, kVerisimFloat = 3 };

struct VerisimImage {
  std::int32_t width, height, channels;  // 1: grey, 2: grey + alpha, 3: rgb, 4: rgb + alpha
  std::int32_t sample;                   // VerisimSample; half: the bits of a binary16 where reading gives it
  void* pixels;                          // row 0 at the top, tightly packed, native byte order
  std::int32_t premultiplied;            // reading: colours are multiplied by alpha already
};

struct VerisimWriteOptions {
  const VerisimImage*
      image;  // sample is the type stored in the file; pixels are uint8, uint16 or, for half and float, float
  const char* compression;  // OpenImageIO's name ("rle", "zip", "none" ...) or null
  std::int32_t quality;     // JPEG quality 1..100, 0: the default
  std::int32_t bits;        // significant bits per channel, 0: all
  std::int32_t metadata_count;
  const char* const* metadata;  // key, value, key, value ...
  const char* const*
      channel_names;  // one a channel, or null: the usual ones; only then may there be more than four channels
  const std::int32_t* channel_samples;  // VerisimSample each channel is stored as (OpenEXR), or null: image->sample
};

// Results. A message of a failure is put into `error` (at most error_size bytes with the terminating zero).
enum VerisimResult : std::int32_t {
  kVerisimDone = 0,
  kVerisimFailed = 1,
  kVerisimLeft = 2  // reading: a kind of file that this plug-in leaves to OpenImageIO's
};

using VerisimReadImage = int (*)(const char* path, std::uint64_t max_pixels, VerisimImage* image, char* error,
                                 std::size_t error_size);
using VerisimWriteImage = int (*)(const char* path, const VerisimWriteOptions* options, char* error,
                                  std::size_t error_size);
using VerisimFreeImage = void (*)(VerisimImage* image);

// One channel of one part of an OpenEXR file; texts are cut to fit.
struct VerisimChannel {
  std::int32_t part, width, height;
  std::int32_t integer;  // unsigned whole numbers; else floats
  char part_name[128], name[256];
};
// Puts at most `capacity` channels into `channels`, all parts in order, channels by name; `count` is how many there
// are.
using VerisimListChannels = int (*)(const char* path, std::uint64_t max_pixels, VerisimChannel* channels,
                                    std::int32_t capacity, std::int32_t* count, char* error, std::size_t error_size);
// Channels of one part by name, each into width * height floats, or std::uint32_t where it is of integers.
using VerisimReadChannels = int (*)(const char* path, std::int32_t part, const char* const* names, void* const* values,
                                    std::int32_t count, char* error, std::size_t error_size);

}  // extern "C"

namespace verisim::image {

// Must change with anything above: an old plug-in beside a new program is refused.
inline constexpr int kModuleVersion = 4;

enum class ModuleKind : std::uint8_t { general, tiff, exr };  // general: OpenImageIO

// A loaded plug-in.
struct Module {
  VerisimReadImage
      read;  // the file's values, untouched: no gamma conversion, alpha as stored (see VerisimImage::premultiplied)
  VerisimWriteImage write;  // the format follows from the extension of the path; null where a plug-in only reads
  VerisimFreeImage free;
  VerisimListChannels list_channels;  // these two: OpenEXR's plug-in alone
  VerisimReadChannels read_channels;
};

// Loads the plug-in on first use (thread-safe). It is looked for in $VERISIM_MODULE_PATH (a folder, or a plug-in in
// it), beside the program, and in ../lib and ../lib/verisim (the build's and the installed layout). Throws
// std::runtime_error when it cannot be found or loaded.
const Module& image_module(ModuleKind kind = ModuleKind::general);
// The files of plug-ins that are there, in any of these places.
std::vector<std::filesystem::path> image_module_files();

}  // namespace verisim::image
