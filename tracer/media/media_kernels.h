// The arithmetic of places in media that are asked for the light that is scattered there (spec 07 section 4.4), a row
// at a time. Compiled for several instruction sets; every lane does the operations of the scalar code in the same
// order, so all give its bits.
#pragma once

#include "tracer/math/ray_row.h"
#include "tracer/scene/texture.h"

namespace verisim::global {

// Places side by side. Behind the last one stands any number.
struct alignas(64) MediaLanes {
  static constexpr int kMost = RayRow::kMost, kStep = RayRow::kStep, kSize = RayRow::kSize;
  struct Colors {
    float r[kSize], g[kSize], b[kSize];
    Rgb at(int i) const { return {r[i], g[i], b[i]}; }
    void set(int i, const Rgb& c) { r[i] = c.r, g[i] = c.g, b[i] = c.b; }
  };
  RayRow to_light;         // from the places; unit vectors
  double distance[kSize];  // of the light
  RayRow::Vectors view;    // unit vectors: directions of the view rays
  double phase[kSize];     // the sum over all media
  Colors scattering, arriving, scattered;
};

struct MediaKernels {
  // Adds the phase function of a medium for light from these directions.
  void (*add_phase)(const scene::Media& media, int count, MediaLanes& lanes);
  // Sets what is scattered along the view rays of what arrives, by that many media.
  void (*scatter)(int media, int count, MediaLanes& lanes);
};

const MediaKernels& media_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const MediaKernels* media_kernels(int instruction_set);

}  // namespace verisim::global
