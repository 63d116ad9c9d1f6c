// The plug-in for OpenEXR files. As pictures: one part of grey or RGB, with or without alpha, in halves or single
// precision; channel by channel: all that is not deep or subsampled.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
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

// Why a data window is no size for a picture; null: it is one.
const char* refusal(const Imath::Box2i& window, std::uint64_t max_pixels) {
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1,
                     height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width <= 0 || height <= 0) return "the image has no pixels";
  if (width > 0x7fffffff || height > 0x7fffffff ||
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > max_pixels)
    return "the image is too large";
  return nullptr;
}

int read_image(const char* path, std::uint64_t max_pixels, VerisimImage* image, char* error, std::size_t error_size) {
  bool tiled = false, deep = false, parts = false;
  if (!Imf::isOpenExrFile(path, tiled, deep, parts)) return fail(error, error_size, "this is not an OpenEXR file");
  if (deep || parts) return kVerisimLeft;
  Imf::InputFile file(path, 0);
  const Imath::Box2i window = file.header().dataWindow();
  if (const char* reason = refusal(window, max_pixels)) return fail(error, error_size, reason);
  const std::int64_t width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
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

template <std::size_t N>
void put(const std::string& text, char (&out)[N]) {
  const std::size_t n = std::min(text.size(), N - 1);
  std::copy_n(text.data(), n, out);
  out[n] = '\0';
}

int list_channels(const char* path, std::uint64_t max_pixels, VerisimChannel* channels, std::int32_t capacity,
                  std::int32_t* count, char* error, std::size_t error_size) {
  *count = 0;
  Imf::MultiPartInputFile file(path, 0);
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::Header& header = file.header(part);
    if (header.hasType() && Imf::isDeepData(header.type()))
      return fail(error, error_size, "deep images are not compared");
    const Imath::Box2i window = header.dataWindow();
    if (const char* reason = refusal(window, max_pixels)) return fail(error, error_size, reason);
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c, ++*count) {
      if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
        return fail(error, error_size, std::string("channel ") + c.name() + " has not a value for every pixel");
      if (*count >= capacity) continue;
      VerisimChannel& out = channels[*count];
      out.part = part, out.width = window.max.x - window.min.x + 1, out.height = window.max.y - window.min.y + 1;
      out.integer = c.channel().type == Imf::UINT;
      put(header.hasName() ? header.name() : std::string(), out.part_name);
      put(c.name(), out.name);
    }
  }
  return kVerisimDone;
}

int read_channels(const char* path, std::int32_t part, const char* const* names, void* const* values,
                  std::int32_t count, char* error, std::size_t error_size) {
  Imf::MultiPartInputFile file(path, 0);
  if (part < 0 || part >= file.parts()) return fail(error, error_size, "there is no such part");
  Imf::InputPart input(file, part);
  const Imath::Box2i window = input.header().dataWindow();
  const std::size_t row = 4 * static_cast<std::size_t>(window.max.x - window.min.x + 1);
  Imf::FrameBuffer frame;
  for (std::int32_t i = 0; i < count; ++i) {
    const Imf::Channel* channel = input.header().channels().findChannel(names[i]);
    if (!channel) return fail(error, error_size, std::string("there is no channel ") + names[i]);
    const Imf::PixelType type = channel->type == Imf::UINT ? Imf::UINT : Imf::FLOAT;
    frame.insert(names[i], Imf::Slice::Make(type, values[i], window, 4, row));
  }
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
  return kVerisimDone;
}

}  // namespace
}  // namespace verisim::image

VERISIM_EXPORT_READER(verisim::image::read_image)

VERISIM_EXPORT int verisim_list_channels(const char* path, std::uint64_t max_pixels, VerisimChannel* channels,
                                         std::int32_t capacity, std::int32_t* count, char* error,
                                         std::size_t error_size) {
  return verisim::image::guarded(error, error_size, [&] {
    return verisim::image::list_channels(path, max_pixels, channels, capacity, count, error, error_size);
  });
}

VERISIM_EXPORT int verisim_read_channels(const char* path, std::int32_t part, const char* const* names,
                                         void* const* values, std::int32_t count, char* error, std::size_t error_size) {
  return verisim::image::guarded(error, error_size, [&] {
    return verisim::image::read_channels(path, part, names, values, count, error, error_size);
  });
}
