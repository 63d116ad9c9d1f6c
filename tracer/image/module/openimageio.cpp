// The plug-in: reads and writes image files with OpenImageIO behind the C interface of module.h.
#include "tracer/image/module/seam.h"

#include <OpenImageIO/imageio.h>

#include <string>

namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;
using verisim::image::allocate_pixels;
using verisim::image::fail;
using verisim::image::free_pixels;
using verisim::image::guarded;

void configure_once() {
  static const bool done = [] {
    OIIO::attribute("threads", 1);  // one file at a time; a thread pool would cost more than it gives
    return true;
  }();
  (void)done;
}

bool integer_file(const ImageSpec& spec) { return !spec.format.is_floating_point(); }

// Those of a picture: of an OpenEXR file the fourth may be depth, and is no alpha then.
int picture_channels(const ImageSpec& spec) {
  if (spec.nchannels > 4) return spec.alpha_channel == 3 ? 4 : 3;
  const bool even = spec.nchannels % 2 == 0, alpha = integer_file(spec) || spec.alpha_channel == spec.nchannels - 1;
  return even && !alpha ? spec.nchannels - 1 : spec.nchannels;
}

int read_image(const char* path, std::uint64_t max_pixels, VerisimImage* image, char* error, std::size_t error_size) {
  configure_once();
  *image = {};
  ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;  // leave straight alpha straight
  config["tiff:UnassociatedAlpha"] = 1;
  auto input = ImageInput::open(path, &config);
  if (!input) return fail(error, error_size, OIIO::geterror());
  const ImageSpec& spec = input->spec();
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0)
    return fail(error, error_size, "the image has no pixels");
  const std::uint64_t pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
  if (pixels > max_pixels || spec.depth > 1) return fail(error, error_size, "the image is too large");
  const int channels = picture_channels(spec);
  TypeDesc type = TypeDesc::FLOAT;
  image->sample = kVerisimFloat;
  if (integer_file(spec)) {
    const bool wide = spec.format.size() > 1;
    type = wide ? TypeDesc::UINT16 : TypeDesc::UINT8;
    image->sample = wide ? kVerisimUint16 : kVerisimUint8;
  }
  image->width = spec.width;
  image->height = spec.height;
  image->channels = channels;
  allocate_pixels(*image, type.size());
  std::memset(image->pixels, 0, static_cast<std::size_t>(pixels) * static_cast<std::size_t>(channels) * type.size());
  if (!input->read_image(0, 0, 0, channels, type, image->pixels)) {
    const std::string message = input->geterror();
    free_pixels(*image);
    return fail(error, error_size, message.empty() ? "the image is damaged" : message);
  }
  image->premultiplied = spec.alpha_channel >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
  return 0;
}

int write_image(const char* path, const VerisimWriteOptions* options, char* error, std::size_t error_size) {
  configure_once();
  const VerisimImage& image = *options->image;
  if (image.width <= 0 || image.height <= 0 || image.channels < 1 ||
      image.channels > (options->channel_names ? 64 : 4) || !image.pixels)
    return fail(error, error_size, "nothing to write");
  auto output = ImageOutput::create(path);
  if (!output) return fail(error, error_size, OIIO::geterror());
  TypeDesc file = TypeDesc::UINT8, memory = TypeDesc::UINT8;
  switch (image.sample) {
    case kVerisimUint16:
      file = memory = TypeDesc::UINT16;
      break;
    case kVerisimHalf:
      file = TypeDesc::HALF, memory = TypeDesc::FLOAT;
      break;
    case kVerisimFloat:
      file = memory = TypeDesc::FLOAT;
      break;
    default:
      break;
  }
  ImageSpec spec(image.width, image.height, image.channels, file);
  if (options->channel_names) {
    spec.alpha_channel = -1;
    for (int c = 0; c < image.channels; ++c) {
      spec.channelnames[static_cast<std::size_t>(c)] = options->channel_names[c];
      if (spec.channelnames[static_cast<std::size_t>(c)] == "A") spec.alpha_channel = c;
      if (options->channel_samples)
        spec.channelformats.push_back(options->channel_samples[c] == kVerisimHalf ? TypeDesc::HALF : TypeDesc::FLOAT);
    }
  } else if (image.channels == 2 || image.channels == 4) {
    spec.alpha_channel = image.channels - 1;
    if (!image.premultiplied) spec.attribute("oiio:UnassociatedAlpha", 1);
  }
  if (options->compression) spec.attribute("compression", options->compression);
  if (options->quality > 0) {
    spec.attribute("CompressionQuality", options->quality);
    spec.attribute("jpeg:subsampling", "4:4:4");  // as POV-Ray writes them (spec 02 section 4.7)
  }
  if (options->bits > 0) spec.attribute("oiio:BitsPerSample", options->bits);
  for (std::int32_t i = 0; i < options->metadata_count; ++i)
    spec.attribute(options->metadata[2 * i], options->metadata[2 * i + 1]);
  if (!output->open(path, spec)) return fail(error, error_size, output->geterror());
  if (!output->write_image(memory, image.pixels) || !output->close())
    return fail(error, error_size, output->geterror());
  return 0;
}

}  // namespace

VERISIM_EXPORT_READER(read_image)

VERISIM_EXPORT int verisim_write_image(const char* path, const VerisimWriteOptions* options, char* error,
                                       std::size_t error_size) {
  return guarded(error, error_size, [&] { return write_image(path, options, error, error_size); });
}
