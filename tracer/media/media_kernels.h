// The arithmetic of places in media that are asked for the light that is scattered there (spec 07 section 4.4), a batch
// at a time. Compiled for several instruction sets; every lane does the operations of the scalar code in the same
// order, so all give its bits.
#pragma once

#include "tracer/math/ray_batch.h"
#include "tracer/scene/texture.h"

namespace verisim::global {

// Places side by side. Behind the last one stands any number.
struct alignas(64) MediaPacket {
  static constexpr int kMax = RayBatch::kMax, kStep = RayBatch::kStep, kSize = RayBatch::kSize;
  struct Colors {
    float r[kSize], g[kSize], b[kSize];
    Rgb at(int i) const { return {r[i], g[i], b[i]}; }
    void set(int i, const Rgb& c) { r[i] = c.r, g[i] = c.g, b[i] = c.b; }
  };
  RayBatch to_light;       // from the places; unit vectors
  double distance[kSize];  // of the light
  RayBatch::Vectors view;  // unit vectors: directions of the view rays
  double phase[kSize];     // the sum over all media
  Colors scattering, arriving, scattered;
};

struct MediaKernels {
  // Adds the phase function of a medium for light from these directions.
  void (*add_phase)(const scene::Media& media, int count, MediaPacket& packet);
  // Sets what is scattered along the view rays of what arrives, by that many media.
  void (*scatter)(int media, int count, MediaPacket& packet);
};

const MediaKernels& media_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const MediaKernels* media_kernels(int instruction_set);

}  // namespace verisim::global
