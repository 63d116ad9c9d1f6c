// JPEG, TIFF and EXR through the OpenImageIO plug-in.
#include <cstring>
#include <memory>
#include <stdexcept>

#include "tracer/image/module/module.h"
#include "tracer/image/raw_image.h"

namespace verisim::image {

RawImage decode_with_module(const std::filesystem::path& path) {
  const Module& module = image_module();
  VerisimImage read{};
  char error[512];
  if (module.read(path.c_str(), kMaxPixels, &read, error, sizeof error) != 0) throw std::runtime_error(error);
  const auto release = [&module](VerisimImage* image) { module.free(image); };
  const std::unique_ptr<VerisimImage, decltype(release)> owner(&read, release);
  RawImage raw;
  raw.set_size(read.width, read.height);
  raw.channels = read.channels;
  raw.premultiplied = read.premultiplied != 0;
  const std::size_t count = static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height) *
                            static_cast<std::size_t>(read.channels);
  raw.samples.resize(count);
  switch (read.sample) {
    case kVerisimUint8:
      raw.bits = 8;
      for (std::size_t i = 0; i < count; ++i)
        raw.samples[i] = static_cast<float>(static_cast<const std::uint8_t*>(read.pixels)[i]) / 255.0f;
      break;
    case kVerisimUint16:
      raw.bits = 16;
      for (std::size_t i = 0; i < count; ++i)
        raw.samples[i] = static_cast<float>(static_cast<const std::uint16_t*>(read.pixels)[i]) / 65535.0f;
      break;
    default:
      raw.bits = 32;
      std::memcpy(raw.samples.data(), read.pixels, count * sizeof(float));
      break;
  }
  return raw;
}

}  // namespace verisim::image
