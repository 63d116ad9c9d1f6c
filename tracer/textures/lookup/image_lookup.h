// Where a point falls in an image and what is there (spec 05 sections 12.2 to 12.7).
#pragma once

#include "tracer/image/image.h"
#include "tracer/scene/pattern.h"

namespace verisim::textures {

// An image with its projection, ready for use.
struct ImageLookup {
  ImagePtr image;
  int map_type = 0, interpolate = 0;
  bool once = false, use_alpha = false, use_index = false;
  double width = 1, height = 1;            // in pixels, repeated
  double offset_u = 0, offset_v = 0;       // in pixels
  float filter_all = 0, transmit_all = 0;  // of an image that is not indexed
  bool transparent = false;                // some pixel may let light through
  bool transmits = false;                  // some pixel does, by itself or by its entry in the palette
};

ImageLookup compile_image(const scene::ImageParams& params);

// Pixel coordinates (row 0 at the top) of a point; false: outside.
bool locate(const ImageLookup& lookup, const Vec3& p, double& u, double& v);
// The colour of an image_map at pixel coordinates: straight alpha, filter/transmit options added.
Color map_color(const ImageLookup& lookup, double u, double v);
// image_pattern: grey value or transmit, clamped to [0, 1]; 0 outside.
double image_pattern(const ImageLookup& lookup, const Vec3& p);
// Height under a bump_map at pixel coordinates, without its amount.
double bump_height(const ImageLookup& lookup, double u, double v);
// material_map: the number of the material at p.
int material_number(const ImageLookup& lookup, const Vec3& p);

}  // namespace verisim::textures
