// GIF: the first picture, as palette and indices (spec 05 section 12.1). giflib decodes it.
#include <gif_lib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

int read_source(GifFileType* gif, GifByteType* out, int count) {
  auto& in = *static_cast<ByteReader*>(gif->UserData);
  const std::size_t n = std::min(static_cast<std::size_t>(count), in.left());
  try {
    in.read(out, n);
  } catch (...) {
    return 0;  // no exception may pass the library
  }
  return static_cast<int>(n);
}

struct Close {
  void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};

[[noreturn]] void fail(int code) {
  const char* reason = GifErrorString(code);
  throw std::runtime_error(reason ? reason : "unexpected end of the picture");
}

void check(const std::unique_ptr<GifFileType, Close>& gif, int status) {
  if (status == GIF_ERROR) fail(gif->Error);
}

// Skips what stands before the first picture; the index that it declares transparent, or -1.
int find_picture(const std::unique_ptr<GifFileType, Close>& gif) {
  int transparent = -1;
  for (;;) {
    GifRecordType kind = UNDEFINED_RECORD_TYPE;
    check(gif, DGifGetRecordType(gif.get(), &kind));
    if (kind == IMAGE_DESC_RECORD_TYPE) break;
    if (kind != EXTENSION_RECORD_TYPE) throw std::runtime_error("no picture in the GIF file");
    int label = 0;
    GifByteType* data = nullptr;
    for (check(gif, DGifGetExtension(gif.get(), &label, &data)); data;
         check(gif, DGifGetExtensionNext(gif.get(), &data))) {
      GraphicsControlBlock control;
      if (label == GRAPHICS_EXT_FUNC_CODE && DGifExtensionToGCB(data[0], data + 1, &control) == GIF_OK &&
          control.TransparentColor >= 0)
        transparent = control.TransparentColor;
    }
  }
  check(gif, DGifGetImageDesc(gif.get()));
  return transparent;
}

}  // namespace

RawImage decode_gif(ByteReader& in) {
  int error = 0;
  const std::unique_ptr<GifFileType, Close> gif(DGifOpen(&in, read_source, &error));
  if (!gif) {
    if (error == D_GIF_ERR_NOT_GIF_FILE) throw std::runtime_error("this is not a GIF file");
    fail(error);
  }
  if (!gif->SColorMap) throw std::runtime_error("a GIF without global palette is not supported");
  const int transparent = find_picture(gif);
  RawImage raw;
  raw.channels = 3;
  raw.set_size(gif->Image.Width, gif->Image.Height);
  if (raw.pixels() > in.size() * 4096)
    throw std::runtime_error("unexpected end of the picture");  // a code is at least 2 bits and at most 4096 pixels
  const ColorMapObject& map = gif->Image.ColorMap ? *gif->Image.ColorMap : *gif->SColorMap;
  for (int i = 0; i < map.ColorCount; ++i) {
    const GifColorType& c = map.Colors[i];
    for (const GifByteType value : {c.Red, c.Green, c.Blue}) raw.palette.push_back(static_cast<float>(value) / 255.0f);
    raw.palette.push_back(1);
  }
  std::uint8_t* indices = raw.allocate_indices();
  // Rows stay as the file has them: POV-Ray does not put those of interlaced pictures in order (measured).
  for (int y = 0; y < raw.height; ++y)
    check(gif, DGifGetLine(gif.get(), indices + static_cast<std::size_t>(y) * raw.width, raw.width));
  if (transparent >= 0 && 4 * static_cast<std::size_t>(transparent) < raw.palette.size()) {
    raw.channels = 4;
    raw.palette[4 * static_cast<std::size_t>(transparent) + 3] = 0;
  }
  return raw;
}

}  // namespace verisim::image
