#include "python/src/picture.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cli/settings/options.h"
#include "python/src/errors.h"
#include "python/src/json.h"
#include "python/src/plane.h"
#include "tracer/image/formats/layers_file.h"
#include "tracer/image/formats/png.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

using Sizes = std::vector<py::ssize_t>;

// The memory of pixels that lie row by row, each `stride` bytes; one channel: without a third dimension.
Plane plane_of(const PicturePtr& picture, const void* data, char kind, std::size_t item, int channels,
               std::size_t stride) {
  const auto size = [](auto n) { return static_cast<py::ssize_t>(n); };
  Plane plane{picture,
              data,
              kind,
              size(item),
              {picture->height, picture->width},
              {size(stride) * picture->width, size(stride)}};
  if (channels > 1) plane.shape.push_back(channels), plane.strides.push_back(size(item));
  return plane;
}

Plane bytes_of(const PicturePtr& picture) {
  return plane_of(picture, picture->bytes.data(), 'u', 1, picture->channels,
                  static_cast<std::size_t>(picture->channels));
}

const render::Framebuffer& frame_of(const PicturePtr& picture) {
  if (picture->frame.pixels.empty())
    throw py::value_error("this picture was made of bytes: it has no radiance; np.asarray(picture) gives its bytes");
  return picture->frame;
}

py::object radiance(const PicturePtr& picture) {
  return array_of(plane_of(picture, &frame_of(picture).pixels[0].r, 'f', sizeof(float), 3, sizeof(render::PixelColor)));
}
py::object transmit(const PicturePtr& picture) {
  return array_of(plane_of(picture, &frame_of(picture).pixels[0].t, 'f', sizeof(float), 1, sizeof(render::PixelColor)));
}

template <class T>
py::object layer(const PicturePtr& picture, const char* name, const std::vector<T>& values, char kind,
                 std::size_t item) {
  if (values.empty())
    throw py::value_error(
        fmt::format("the picture has no layer '{0}': ask for it with render(..., layers=['{0}'])", name));
  return array_of(plane_of(picture, values.data(), kind, item, static_cast<int>(sizeof(T) / item), sizeof(T)));
}

// A row of bytes widened to what writers of files take.
void widen(const Picture& picture, int y, std::uint16_t* row) {
  const std::size_t n = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
  std::copy_n(picture.bytes.data() + n * static_cast<std::size_t>(y), n, row);
}

py::bytes png(const Picture& picture) {
  char* memory = nullptr;
  std::size_t size = 0;
  {
    const py::gil_scoped_release writing;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(open_memstream(&memory, &size), std::fclose);
    if (!file) throw std::bad_alloc();
    image::write_png(file.get(), {picture.width, picture.height, picture.channels, 8, {}}, picture.output,
                     [&](int y, std::uint16_t* row) { widen(picture, y, row); });
  }
  const std::unique_ptr<char, void (*)(void*)> owner(memory, std::free);
  return {memory, size};
}

image::OutputOptions file_options(const Picture& picture, const std::filesystem::path& path, int bits, int quality) {
  image::OutputOptions options = picture.output;
  const std::optional<image::Format> format = cli::format_of_extension(path.extension().string());
  if (!format)
    throw py::value_error(
        fmt::format("'{}': the ending says what a picture is written as: .png, .jpg, .exr, .hdr, .tif, .tga, "
                    ".bmp or .ppm",
                    path.string()));
  options.format = *format;
  options.bits = bits;
  options.compression = quality;
  return options;
}

void save(const Picture& picture, const std::filesystem::path& path, int bits, int quality) {
  const image::OutputOptions options = file_options(picture, path, bits, quality);
  if (picture.frame.pixels.empty() && options.format != image::Format::png)
    throw py::value_error("this picture was made of bytes: it is written as .png only");
  if (bits < 5 || bits > 16) throw py::value_error("bits must be between 5 and 16");
  std::string failure;
  {
    const py::gil_scoped_release writing;
    try {
      const bool layers = picture.layers.depth || picture.layers.normal || picture.layers.albedo || picture.layers.id;
      if (picture.frame.pixels.empty())
        image::write_picture(samples_of(picture), path);
      else if (layers && options.format == image::Format::exr)
        image::write_layers(picture.frame, picture.layers, true, path, options);
      else
        image::write(picture.frame, path, options);
    } catch (const std::runtime_error& error) {
      failure = error.what();
    }
  }
  if (failure.empty()) return;
  PyErr_SetString(PyExc_OSError, failure.c_str());
  throw py::error_already_set();
}

py::dict statistics(const Picture& picture) {
  const render::Statistics& s = picture.statistics;
  return py::dict(py::arg("camera_rays") = s.camera_rays, py::arg("reflected_rays") = s.reflected_rays,
                  py::arg("refracted_rays") = s.refracted_rays, py::arg("transmitted_rays") = s.transmitted_rays,
                  py::arg("shadow_rays") = s.shadow_rays, py::arg("seconds_compile") = s.seconds_compile,
                  py::arg("seconds_render") = s.seconds_render);
}

PicturePtr from_array(const py::buffer& array) {
  const py::buffer_info info = array.request();
  const bool flat = info.ndim == 2;
  if (info.format != py::format_descriptor<std::uint8_t>::format() || (!flat && info.ndim != 3))
    throw py::value_error(
        "a picture is made of an array of uint8 with the shape (height, width) or (height, width, channels)");
  auto picture = std::make_shared<Picture>();
  picture->height = static_cast<int>(info.shape[0]), picture->width = static_cast<int>(info.shape[1]);
  picture->channels = flat ? 1 : static_cast<int>(info.shape[2]);
  if (picture->channels != 1 && picture->channels != 3 && picture->channels != 4)
    throw py::value_error("a picture has 1, 3 or 4 channels");
  if (info.size == 0) throw py::value_error("a picture has at least one pixel");
  picture->bytes.resize(static_cast<std::size_t>(info.size));
  auto out = picture->bytes.begin();
  for (py::ssize_t y = 0; y < info.shape[0]; ++y)
    for (py::ssize_t x = 0; x < info.shape[1]; ++x)
      for (py::ssize_t c = 0; c < picture->channels; ++c)
        *out++ = static_cast<const std::uint8_t*>(
            info.ptr)[y * info.strides[0] + x * info.strides[1] + (flat ? 0 : c * info.strides[2])];
  return picture;
}

std::string text_of(const Picture& picture) {
  return fmt::format("<verisim.Picture {} by {}, {} channels>", picture.width, picture.height, picture.channels);
}

}  // namespace

void quantise(Picture& picture) {
  image::OutputOptions options = picture.output;
  options.bits = 8;
  image::Quantiser quantiser(image::rows_of(picture.frame), options);
  const image::Quantised shape = quantiser.shape();
  picture.width = shape.width, picture.height = shape.height, picture.channels = shape.channels;
  const std::size_t n = static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels);
  picture.bytes.resize(n * static_cast<std::size_t>(shape.height));
  std::vector<std::uint16_t> row(n);
  for (int y = 0; y < shape.height; ++y) {
    quantiser.row(y, row.data());
    std::transform(row.begin(), row.end(), picture.bytes.begin() + static_cast<std::ptrdiff_t>(n) * y,
                   [](std::uint16_t v) { return static_cast<std::uint8_t>(v); });
  }
}

PicturePtr picture_of(const image::Picture& samples) {
  auto picture = std::make_shared<Picture>();
  picture->width = samples.width, picture->height = samples.height, picture->channels = samples.channels;
  picture->bytes.resize(samples.samples.size());
  std::transform(samples.samples.begin(), samples.samples.end(), picture->bytes.begin(),
                 [](float v) { return static_cast<std::uint8_t>(v > 0 ? std::min(v, 1.0f) * 255 + 0.5f : 0.0f); });
  return picture;
}

image::Picture samples_of(const Picture& picture) {
  image::Picture out{picture.width, picture.height, picture.channels, false, 8, {}};
  out.samples.resize(picture.bytes.size());
  std::transform(picture.bytes.begin(), picture.bytes.end(), out.samples.begin(),
                 [](std::uint8_t v) { return static_cast<float>(v) * (1.0f / 255); });
  return out;
}

NamedMemory::NamedMemory() : descriptor_(::memfd_create("verisim", MFD_CLOEXEC)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "cannot make a file in memory");
}
NamedMemory::~NamedMemory() { ::close(descriptor_); }

void bind_picture(py::module_& module) {
  py::class_<Picture, PicturePtr>(
      module, "Picture", py::buffer_protocol(),
      "A rendered picture. As a buffer and for numpy.asarray(): the samples of a PNG file of 8 bits, "
      "uint8 of the shape (height, width, channels), row 0 at the top, without a copy.")
      .def(py::init(&from_array), py::arg("array"),
           "A picture of uint8 samples, (height, width) or (height, width, channels).")
      .def_buffer([](Picture& picture) { return buffer_of(bytes_of(PicturePtr(PicturePtr(), &picture))); })
      .def_property_readonly("__array_interface__", [](const PicturePtr& p) { return array_interface_of(bytes_of(p)); })
      .def_readonly("width", &Picture::width)
      .def_readonly("height", &Picture::height)
      .def_readonly("channels", &Picture::channels)
      .def_property_readonly(
          "pixels", [](const PicturePtr& p) { return array_of(bytes_of(p)); },
          "uint8 (height, width, channels): what a PNG file holds. Of one channel: (height, width).")
      .def_property_readonly("radiance", &radiance,
                             "float32 (height, width, 3): colours before gamma and rounding, as the scene computes "
                             "them; linear light with "
                             "assumed_gamma 1. Multiplied by alpha.")
      .def_property_readonly("transmit", &transmit, "float32 (height, width): what shows through, 1 - alpha.")
      .def_property_readonly(
          "depth", [](const PicturePtr& p) { return layer(p, "depth", p->layers.depths, 'f', sizeof(float)); },
          "float32 (height, width): distance from the camera to the centre of the pixel; 1e10 where there is nothing.")
      .def_property_readonly(
          "normal", [](const PicturePtr& p) { return layer(p, "normal", p->layers.normals, 'f', sizeof(double)); },
          "float64 (height, width, 3): in world space, perturbed, towards the viewer; 0 where there is nothing.")
      .def_property_readonly(
          "albedo", [](const PicturePtr& p) { return layer(p, "albedo", p->layers.albedos, 'f', sizeof(float)); },
          "float32 (height, width, 3): colour of the pigments, without light.")
      .def_property_readonly(
          "id", [](const PicturePtr& p) { return layer(p, "id", p->layers.ids, 'u', sizeof(std::uint32_t)); },
          "uint32 (height, width): number of the object in the order of the scene, from 1; 0 where there is nothing.")
      .def_readonly("frame", &Picture::frame_number, "Number of the frame of an animation; 0 without one.")
      .def_readonly("clock", &Picture::clock)
      .def_property_readonly(
          "debug", [](const Picture& p) { return to_text(p.debug); },
          "What the scene said with #debug, #render and #statistics.")
      .def_property_readonly(
          "warnings", [](const Picture& p) { return diagnostics(p.warnings); }, "A list of Diagnostic.")
      .def_property_readonly("statistics", &statistics, "Numbers of rays, and seconds.")
      .def("png", &png, "The bytes of a PNG file: those that `verisim render` writes.")
      .def("_repr_png_", &png)
      .def(
          "save", &save, py::arg("path"), py::kw_only(), py::arg("bits") = 8, py::arg("quality") = 0,
          "Writes a file, whole or not at all; its ending says what: .png, .jpg, .exr (with the layers), .hdr, .tif, "
          ".tga, "
          ".bmp or .ppm. `bits` a channel, where the format has a choice; `quality` of JPEG, 2 to 100. Raises OSError.")
      .def("__repr__", &text_of);
}

}  // namespace verisim::python
