// TIFF and OpenEXR through their plug-ins, and what those leave through OpenImageIO's.
#include <memory>
#include <stdexcept>

#include "tracer/image/module/module.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

// False: the plug-in leaves this kind of file to another. Throws std::runtime_error when it is damaged.
bool read_with(const Module& module, const std::filesystem::path& path, VerisimImage& image) {
  char error[512];
  switch (module.read(path.c_str(), kMaxPixels, &image, error, sizeof error)) {
    case kVerisimDone:
      return true;
    case kVerisimLeft:
      return false;
    default:
      module.free(&image);
      throw std::runtime_error(error);
  }
}

RawImage adopted(const Module& module, const VerisimImage& read) {
  std::shared_ptr<void> memory(read.pixels, [&module](void* pixels) {
    VerisimImage image{};
    image.pixels = pixels;
    module.free(&image);
  });
  RawImage raw;
  raw.set_size(read.width, read.height);
  raw.channels = read.channels;
  raw.premultiplied = read.premultiplied != 0;
  const auto type = read.sample == kVerisimUint8    ? SampleType::byte
                    : read.sample == kVerisimUint16 ? SampleType::word
                    : read.sample == kVerisimHalf   ? SampleType::half
                                                    : SampleType::real;
  raw.bits = type == SampleType::byte ? 8 : type == SampleType::word ? 16 : 32;
  raw.white = type == SampleType::byte ? 255 : 65535;
  raw.samples = Samples(type, raw.pixels() * static_cast<std::size_t>(read.channels), std::move(memory));
  return raw;
}

}  // namespace

RawImage decode_with_module(const std::filesystem::path& path, ModuleKind kind) {
  VerisimImage read{};
  const Module* module = &image_module(kind);
  if (!read_with(*module, path, read)) {
    module = &image_module(ModuleKind::general);
    if (!read_with(*module, path, read)) throw std::runtime_error("this kind of file is not supported");
  }
  return adopted(*module, read);
}

}  // namespace verisim::image
