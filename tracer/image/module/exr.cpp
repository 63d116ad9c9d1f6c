// The plug-in for OpenEXR files: one part of grey or RGB, with or without alpha, in halves or single precision.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfPartType.h>
#include <ImfTestFile.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tracer/image/module/seam.h"

namespace verisim::image {
namespace {

// Names of the channels that are read, in the order of the picture; none: the file is left to OpenImageIO's plug-in.
// `half`: no channel is more precise.
std::vector<std::string> channels_of(const Imf::Header& header, bool& half) {
  const Imf::ChannelList& list = header.channels();
  std::size_t count = 0;
  half = true;
  for (auto channel = list.begin(); channel != list.end(); ++channel, ++count) {
    const Imf::Channel& c = channel.channel();
    if (c.xSampling != 1 || c.ySampling != 1 || c.type == Imf::UINT) return {};
    half &= c.type == Imf::HALF;
  }
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"R", "G", "B"}, {"R", "G", "B", "A"}, {"Y"}, {"Y", "A"}}) {
    if (names.size() == count &&
        std::all_of(names.begin(), names.end(), [&](const std::string& name) { return list.findChannel(name); }))
      return names;
  }
  return {};
}

int read_image(const char* path, std::uint64_t max_pixels, VerisimImage* image, char* error, std::size_t error_size) {
  bool tiled = false, deep = false, parts = false;
  if (!Imf::isOpenExrFile(path, tiled, deep, parts)) return fail(error, error_size, "this is not an OpenEXR file");
  if (deep || parts) return kVerisimLeft;
  Imf::InputFile file(path, 0);
  const Imath::Box2i window = file.header().dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1,
                     height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width <= 0 || height <= 0) return fail(error, error_size, "the image has no pixels");
  if (width > 0x7fffffff || height > 0x7fffffff ||
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > max_pixels)
    return fail(error, error_size, "the image is too large");
  bool half = false;
  const std::vector<std::string> names = channels_of(file.header(), half);
  if (names.empty()) return kVerisimLeft;
  image->width = static_cast<std::int32_t>(width);
  image->height = static_cast<std::int32_t>(height);
  image->channels = static_cast<std::int32_t>(names.size());
  image->sample = half ? kVerisimHalf : kVerisimFloat;
  image->premultiplied = names.back() == "A";
  const std::size_t sample = half ? 2 : 4, pixel = sample * names.size(), row = pixel * static_cast<std::size_t>(width);
  allocate_pixels(*image, sample);
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < names.size(); ++i)
    frame.insert(names[i], Imf::Slice::Make(half ? Imf::HALF : Imf::FLOAT,
                                            static_cast<char*>(image->pixels) + i * sample, window, pixel, row));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return kVerisimDone;
}

}  // namespace
}  // namespace verisim::image

VERISIM_EXPORT_READER(verisim::image::read_image)
