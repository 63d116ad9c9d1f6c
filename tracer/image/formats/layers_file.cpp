#include "tracer/image/formats/layers_file.h"

#include <stdexcept>

#include "tracer/image/gamma.h"
#include "tracer/image/module/module.h"
#include "tracer/image/formats/module_files.h"
#include "tracer/base/output_file.h"

namespace verisim::image {
namespace {

// Channels beside each other in memory, pixel by pixel.
class Channels {
 public:
  explicit Channels(std::size_t pixels) : pixels_(pixels) {}
  void declare(const char* name, VerisimSample sample) { names_.push_back(name), samples_.push_back(sample); }
  std::size_t count() const { return names_.size(); }
  void allocate() { values_.resize(pixels_ * count()); }
  float& at(std::size_t pixel, std::size_t channel) { return values_[pixel * count() + channel]; }

  void write(const std::filesystem::path& path, int width, int height, const OutputOptions& options) {
    std::map<std::string, std::string> described = options.metadata;
    described["DateTime"] = date_text(options);
    std::vector<const char*> metadata;
    for (const auto& [key, value] : described) metadata.push_back(key.c_str()), metadata.push_back(value.c_str());
    const VerisimImage image{width, height, static_cast<std::int32_t>(count()), kVerisimFloat, values_.data(), 1};
    const VerisimWriteOptions how{
        &image,        "zip",          0, 0, static_cast<std::int32_t>(described.size()), metadata.data(),
        names_.data(), samples_.data()};
    char error[512] = {};
    if (image_module().write(path.c_str(), &how, error, sizeof error) != 0) throw std::runtime_error(error);
  }

 private:
  std::size_t pixels_;
  std::vector<const char*> names_;
  std::vector<std::int32_t> samples_;
  std::vector<float> values_;
};

}  // namespace

void write_layers(const render::Framebuffer& frame, const render::Layers& layers, bool beauty,
                  const std::filesystem::path& path, const OutputOptions& options) {
  const OutputCurve to_linear(options.working, options.working_gamma, Curve::identity());
  const std::size_t pixels = frame.pixels.size();
  Channels out(pixels);
  if (beauty)
    for (const char* name : {"R", "G", "B"}) out.declare(name, kVerisimHalf);
  if (beauty && options.alpha) out.declare("A", kVerisimHalf);
  if (layers.depth) out.declare("Z", kVerisimFloat);
  if (layers.normal)
    for (const char* name : {"N.X", "N.Y", "N.Z"}) out.declare(name, kVerisimFloat);
  if (layers.albedo)
    for (const char* name : {"albedo.R", "albedo.G", "albedo.B"}) out.declare(name, kVerisimHalf);
  if (layers.id) out.declare("id", kVerisimFloat);
  out.allocate();
  for (std::size_t i = 0; i < pixels; ++i) {
    std::size_t c = 0;
    if (beauty) {
      const render::PixelColor& pixel = frame.pixels[i];
      for (const float v : {pixel.r, pixel.g, pixel.b}) out.at(i, c++) = to_linear.encode(v);
      if (options.alpha) out.at(i, c++) = 1.0f - pixel.t;
    }
    if (layers.depth) out.at(i, c++) = layers.depths[i];
    if (layers.normal)
      for (int k = 0; k < 3; ++k) out.at(i, c++) = static_cast<float>(layers.normals[i][k]);
    if (layers.albedo)
      for (const float v : {layers.albedos[i].r, layers.albedos[i].g, layers.albedos[i].b})
        out.at(i, c++) = to_linear.encode(v);
    if (layers.id) out.at(i, c++) = static_cast<float>(layers.ids[i]);
  }
  write_by_name(path, ".exr", [&](const std::filesystem::path& temporary) {
    out.write(temporary, frame.width, frame.height, options);
  });
}

}  // namespace verisim::image
