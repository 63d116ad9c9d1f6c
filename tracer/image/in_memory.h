// Pictures of programs, without files: samples in the place of an image file's, and what a picture file would hold.
#pragma once

#include <memory>

#include "tracer/image/image.h"
#include "tracer/image/output.h"

namespace verisim::image {

// Row 0 at the top, tightly packed: 1 grey, 2 grey + alpha, 3 rgb, 4 rgb + alpha samples a pixel. Bytes and words mean
// what they mean in a PNG file without colour information (sRGB in image_map, plain fractions of white elsewhere);
// reals are linear light, as in an HDR file. Alpha does not multiply colours. Half floats are not taken.
struct PixelArray {
  int width = 0, height = 0, channels = 3;
  Samples samples;  // width * height * channels
};

// Throws std::runtime_error when size, channels and samples do not fit together. Bytes and words are shared, not
// copied.
std::shared_ptr<const Image> make_image(const PixelArray& pixels, const ImageDecoding& decoding);

// The options of a PNG file with 8 bits a channel for pictures of this scene: its gamma, POV-Ray's defaults for the
// rest.
OutputOptions output_options(const scene::Scene& scene);

// The samples that an integer file made with these options would hold, as read_picture gives them: for
// compare::measure, and for whoever wants values 0..1. Rows from the top.
Picture to_picture(const render::Framebuffer& framebuffer, const OutputOptions& options);

}  // namespace verisim::image
