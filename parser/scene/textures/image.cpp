// Images in image_map, image_pattern, bump_map, material_map and height_field: files and function fields (spec 05
// section 12, 04 section 5, 02 section 5).
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "parser/scene/common/common.h"
#include "parser/scene/textures/pattern.h"
#include "tracer/functions/evaluation_budget.h"
#include "tracer/image/image.h"
#include "tracer/textures/evaluation/evaluation_faults.h"

namespace verisim::parser {

namespace {

struct FileType {
  Word word;
  ImageType type;
  const char* extensions;  // tried for a name without one
};

constexpr FileType kFileTypes[] = {
    {Word::gif, ImageType::gif, ".gif .GIF"},
    {Word::tga, ImageType::tga, ".tga .TGA"},
    {Word::png, ImageType::png, ".png .PNG"},
    {Word::jpeg, ImageType::jpeg, ".jpg .JPG .jpeg .JPEG"},
    {Word::tiff, ImageType::tiff, ".tiff .TIFF .tif .TIF"},
    {Word::bmp, ImageType::bmp, ".bmp .BMP"},
    {Word::ppm, ImageType::ppm, ".ppm .PPM"},
    {Word::pgm, ImageType::pgm, ".pgm .PGM"},
    {Word::exr, ImageType::exr, ".exr .EXR"},
    {Word::hdr, ImageType::hdr, ".hdr .HDR"},
    {Word::iff, ImageType::iff, ".iff .IFF"},
    {Word::pot, ImageType::pot, ".pot .POT"},
    {Word::sys, ImageType::sys, ".bmp .BMP"},
};

const FileType* file_type_at(Parser& parser) {
  const Word word = word_at(parser);
  for (const FileType& type : kFileTypes) {
    if (type.word == word) return &type;
  }
  return nullptr;
}

// The working space as it is known at this point of the file (spec 02 section 5).
ImageDecoding decoding(Parser& parser, ImageUse use) {
  const scene::Settings& settings = parser.scene().settings;
  ImageDecoding result;
  result.data = use != ImageUse::image_map;
  result.version = parser.effective_version();
  result.working_is_srgb = settings.gamma_given && settings.gamma == scene::Gamma::srgb;
  result.working_none = !settings.gamma_given && parser.effective_version() < 370;
  result.working_gamma = settings.gamma_given ? settings.assumed_gamma : 1;
  return result;
}

void parse_file_options(Parser& parser, ImageDecoding& decoding) {
  for (;;) {
    if (parser.accept(Word::gamma)) {
      if (parser.accept(Word::srgb)) {
        decoding.gamma = ImageGamma::srgb;
        continue;
      }
      decoding.gamma = ImageGamma::power;
      decoding.gamma_value = parser.parse_float();
      if (!(decoding.gamma_value > 0)) parser.error(Code::bad_value, "gamma value must be positive.");
      if (decoding.gamma_value < 1) parser.warning(Code::adjusted_value, "Suspicious gamma value: below 1.");
    } else if (parser.accept(Word::premultiplied)) {
      decoding.premultiplied = parser.parse_flag() ? 1 : 0;
    } else {
      return;
    }
  }
}

ImagePtr load_file(Parser& parser, ImageUse use) {
  const FileType* file_type = file_type_at(parser);
  if (file_type) {
    const bool refused = (file_type->type == ImageType::iff && use == ImageUse::height_field) ||
                         (file_type->type == ImageType::pot && use != ImageUse::height_field);
    if (refused) parser.error(Code::bad_file, "File type not supported here.");
    parser.next();
  }
  if (!parser.at_string()) parser.error_expected("image file");
  const std::string name = parser.parse_path();
  if (const auto memory = parser.memory_file(name); memory && memory->pixels()) {
    ImageDecoding how = decoding(parser, use);
    parse_file_options(parser, how);
    try {
      return image::make_image(*memory->pixels(), how);
    } catch (const std::runtime_error& failure) {
      parser.error(Code::bad_file, "'" + name + "': " + failure.what());
    }
  }
  ImageType type = file_type ? file_type->type : image_type_from_extension(name);
  const std::filesystem::path path = parser.find_file(name, file_type ? file_type->extensions : ".png .PNG");
  if (type == ImageType::unknown) type = image_type_from_extension(path.string());
  ImageDecoding how = decoding(parser, use);
  parse_file_options(parser, how);
  try {
    return load_image(path, type, how);
  } catch (const std::runtime_error& failure) {
    parser.error(Code::bad_file, failure.what());
  }
}

// One for all images of functions: a scene may have hundreds.
const Image::CodeTable& fractions_of_words() {
  static const Image::CodeTable table = [] {
    auto fractions = std::make_shared<std::vector<float>>(65536);
    for (std::size_t i = 0; i < fractions->size(); ++i) (*fractions)[i] = static_cast<float>(i) / 65535.0f;
    return fractions;
  }();
  return table;
}

// What the evaluation of pixels noted: it throws nothing.
void check_pixels(Parser& parser) {
  if (functions::EvaluationBudget::take_overrun())
    parser.error(Code::size_limit, "The function of an image needs too many passes of loops and calls for one pixel.");
  if (textures::MissingSurface::take())
    parser.error(Code::incompatible, "The function of an image asks for uv_mapping, but there is no surface.");
}

// `function W, H { ... }`: a float function gives 16-bit grey that wraps around, a pigment function colours.
ImagePtr function_image(Parser& parser) {
  parser.next();
  const double w = std::floor(parser.parse_float() + 0.5);
  parser.optional_comma();
  const double h = std::floor(parser.parse_float() + 0.5);
  if (!(w >= 1) || !(h >= 1) || !(w < 1e6) || !(h < 1e6))
    parser.error(Code::bad_value, "Illegal size of a function image.");
  const std::size_t count = checked_count(parser, w * h, "pixels of a function image", 4 * sizeof(std::uint16_t));
  const FunctionPtr function = parser.parse_function_body();
  if (function->parameters() != 3)
    parser.error(Code::missing_item, "The function of an image needs the parameters x, y, z.");
  auto image = std::make_shared<Image>();
  image->width = static_cast<int>(w);
  image->height = static_cast<int>(h);
  image->sixteen_bit = true;
  const bool colors = function->components() >= 5;
  image->grey = !colors;
  image->has_alpha = colors;
  image->channels = colors ? 4 : 1;
  image->samples = image::Samples(image::SampleType::word, count * static_cast<std::size_t>(image->channels));
  image->values = fractions_of_words();
  if (colors) image->transmits = image->values;
  const double sx = w > 1 ? 1 / (w - 1) : 0, sy = h > 1 ? 1 / (h - 1) : 0;
  const auto sixteen = [](double value) {
    const double scaled = std::trunc(static_cast<float>(value) * 65535.0f);
    if (!(std::fabs(scaled) < 9e15)) return std::uint16_t{0};
    return static_cast<std::uint16_t>(static_cast<std::int64_t>(scaled));
  };
  functions::EvaluationBudget::take_overrun(), textures::MissingSurface::take();  // of what was parsed before
  auto* sample = image->samples.as<std::uint16_t>();
  constexpr std::size_t kTogether = 256;
  double points[3 * kTogether] = {}, values[kMaxFunctionComponents * kTogether];
  const auto width = static_cast<std::size_t>(image->width);
  for (int row = 0; row < image->height; ++row) {
    if (parser.options().cancelled && parser.options().cancelled()) parser.error(Code::time_limit, "Cancelled.");
    std::fill_n(points + kTogether, kTogether, row * sy);
    for (std::size_t begin = 0; begin < width; begin += kTogether) {
      const std::size_t n = std::min(kTogether, width - begin);
      for (std::size_t k = 0; k < n; ++k) points[k] = static_cast<double>(begin + k) * sx;
      function->evaluate_batch(points, kTogether, n, values);
      for (std::size_t k = 0; k < n; ++k) {
        *sample++ = sixteen(values[k]);
        if (!colors) continue;
        for (const std::size_t component : {1, 2, 4}) *sample++ = sixteen(values[component * kTogether + k]);
      }
    }
    check_pixels(parser);
  }
  return image;
}

// filter and transmit of image_map: for all pixels or one palette entry (spec 05 12.4).
void parse_transparency(Parser& parser, scene::ImageParams& params, bool filter) {
  parser.next();
  params.filters = true;
  const bool all = parser.accept(Word::all);
  const int entry = all ? 0 : parser.parse_int();
  parser.optional_comma();
  const float amount = to_float(parser.parse_float());
  if (!params.image->indexed()) {
    if (!all)
      parser.error(Code::misplaced_keyword, std::string("Keyword '") + (filter ? "filter" : "transmit") +
                                                "' cannot be used with non color-mapped image.");
    (filter ? params.filter_all : params.transmit_all) = amount;
    return;
  }
  auto image = std::make_shared<Image>(*params.image);
  const auto size = static_cast<int>(image->palette.size());
  if (!all && (entry < 0 || entry >= size))
    parser.error(Code::bad_value, std::string(filter ? "FILTER" : "TRANSMIT") + " color register value out of range.");
  for (int i = all ? 0 : entry; i < (all ? size : entry + 1); ++i) {
    Color& color = image->palette[static_cast<std::size_t>(i)];
    (filter ? color.f : color.t) = amount;
  }
  params.image = image;
}

}  // namespace

scene::ImageParams parse_image(Parser& parser, ImageUse use, float* bump_size) {
  scene::ImageParams params;
  // In DKBTrace and POV-Ray 1 the kind of projection and the plane of the image.
  while (use != ImageUse::height_field && parser.at_number_start() && !at_color(parser)) {
    parser.parse_vec3();
    parser.warning(Code::no_effect, "A number or vector before the image file is ignored.");
  }
  params.image = parser.at(Word::function) ? function_image(parser) : load_file(parser, use);
  if (use == ImageUse::height_field) return params;
  for (;;) {
    switch (word_at(parser)) {
      case Word::once:
        parser.next();
        params.once = true;
        break;
      case Word::map_type:
        parser.next();
        params.map_type = parser.parse_int();
        if (use == ImageUse::image_map && params.map_type != 0 && params.map_type != 1 && params.map_type != 2 &&
            params.map_type != 5)
          parser.error(Code::bad_value, "Invalid map_type value: it is 0, 1, 2 or 5.");
        break;
      case Word::interpolate:
        parser.next();
        params.interpolate = parser.parse_int();
        if (use == ImageUse::image_map && (params.interpolate < 2 || params.interpolate > 4)) {
          parser.error(Code::bad_value, "Invalid interpolate value.");
        }
        break;
      case Word::repeat:
        parser.next();
        params.repeat = parser.parse_vec2();
        if (!(params.repeat.x > 0) || !(params.repeat.y > 0))
          parser.error(Code::bad_value, "The repeat vector of an image must be positive.");
        break;
      case Word::offset:
        parser.next();
        params.offset = parser.parse_vec2();
        break;
      case Word::use_color:
        parser.next();
        params.use_index = params.use_alpha = false;
        break;
      case Word::use_index:
        parser.next();
        params.use_index = true;
        break;
      case Word::use_alpha:
        if (use != ImageUse::image_pattern) return params;
        parser.next();
        params.use_alpha = true;
        break;
      case Word::filter:
      case Word::transmit:
        if (use != ImageUse::image_map) return params;
        parse_transparency(parser, params, word_at(parser) != Word::transmit);
        break;
      case Word::bump_size:
        if (!bump_size) return params;
        parser.next();
        *bump_size = to_float(parser.parse_float());
        break;
      default:
        return params;
    }
  }
}

}  // namespace verisim::parser
