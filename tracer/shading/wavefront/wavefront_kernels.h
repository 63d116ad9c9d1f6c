// The arithmetic of camera rays that are shaded together (wavefront.h), compiled for several instruction sets. Every
// lane does the operations of the scalar code in the same order, so all give its bits.
#pragma once

#include <cstdint>

#include "tracer/math/color.h"
#include "tracer/math/perspective.h"
#include "tracer/math/ray_batch.h"

namespace verisim::shading {

// A part of a row of the picture, as arrays. Kernels work on the first `count` lanes, rounded up to whole
// registers: what stands behind is any number.
struct alignas(64) WavefrontPacket {
  static constexpr int kMax = RayBatch::kMax, kStep = RayBatch::kStep;
  using Doubles = double[kMax];
  using Floats = float[kMax];
  using Vectors = RayBatch::Vectors;
  struct Colors {
    Floats r, g, b;
  };

  RayBatch rays;  // directions are unit vectors

  // The surfaces that are lit: a denser numbering than that of the rays.
  Vectors normal, view;
  Colors pigment, own, direct;  // the surface's own light; its sum with what lights add
  Doubles front, behind;  // opacity * diffuse coefficient on the side that is turned to the light, and on the other
  std::int32_t lit_behind[kMax], two_sided[kMax],
      dull[kMax];                     // flags: diffuse_back counts; both sides are front sides; nothing reflects light
  Doubles exponent, amount, dark_to;  // the highlight (highlights.h); amount 0: none
  Doubles phong;                      // 1: the highlight is Phong's, 0: Blinn's

  // One light on these surfaces.
  RayBatch to_light;  // from the point on the surface
  Doubles distance, cosine;
  Doubles attenuation;           // of the light on its way
  std::int32_t active[kMax];     // 1: the light counts where nothing is in its way
  Colors intensity, tint, film;  // what arrives; how metals tint the highlight, and iridescence all of it
  Doubles diffuse;               // opacity * coefficient; 0: none
  Floats lit;                    // 1 or 0
  Doubles shines;                // 1 or 0: with highlights
  Doubles scattered;             // diffuse factor
  Doubles strength, second;      // highlight; Blinn's where there is Phong's, too
  std::int32_t uncertain[kMax];  // not 0: the last bit of what `strength` makes of the intensity is not known
};

struct WavefrontKernels {
  // Unit directions of the rays through places of the picture, for whose number as of rays there is room.
  void (*directions)(const PerspectiveView& view, const Vec2* places, int count, WavefrontPacket& packet);
  // Sets cosine from normals and directions.
  void (*face)(int count, WavefrontPacket& packet);
  // What arrives if nothing is in the way: sets active, intensity, diffuse and shines. False: nowhere anything.
  bool (*receive)(const Rgb& light, bool highlights, int count, WavefrontPacket& packet);
  // Sets lit where what was asked for is not dark. False: nowhere.
  bool (*illuminate)(int count, WavefrontPacket& packet);
  // Sets scattered, strength and uncertain from intensity and tint. False: nothing is uncertain. `phong`, `blinn`: some
  // lane has such a highlight.
  bool (*evaluate_lobes)(bool phong, bool blinn, int count, WavefrontPacket& packet);
  // Adds the light of lit lanes to direct. `second`: some lane has a second highlight.
  void (*add)(bool second, int count, WavefrontPacket& packet);
};

// Those of the best instruction set of this machine.
const WavefrontKernels& wavefront_kernels();
// The same function for any set that this machine can run, for tests; null: none.
const WavefrontKernels* wavefront_kernels(int instruction_set);

}  // namespace verisim::shading
