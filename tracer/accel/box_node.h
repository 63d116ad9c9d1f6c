// Four boxes tested at once: the one place of BoxTree that uses vector instructions (SSE, in every x86-64), with a plain version for other machines.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "tracer/math/vec.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace verisim::accel {

struct alignas(64) BoxNode {
  static constexpr std::uint32_t kLeaf = 0x80000000u;
  // Bounds of the children by axis; the boxes of missing children are empty.
  float planes[6][4];  // low x, y, z; high x, y, z
  std::uint32_t child[4];  // a node, or kLeaf + index of a box
};

inline float round_down(double v) {
  const float f = static_cast<float>(v);
  return f <= v ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
// An upper limit for comparisons with binary32 distances: generous by a few roundings, cheap.
inline float round_up(double v) {
  const float f = static_cast<float>(v);
  return f + std::fabs(f) * 3e-7f;
}

// A ray in the single precision of the nodes.
class NodeRay {
 public:
  // `inverse`: 1 / direction; infinities are replaced, because 0 * infinity would turn into NaN.
  NodeRay(const Vec3& origin, const Vec3& inverse) {
    for (int i = 0; i < 3; ++i) {
      float r = static_cast<float>(inverse[i]);
      if (!(std::fabs(r) < 1e30f)) r = std::copysign(1e30f, r);
      const bool backward = r < 0;
      front_[i] = backward ? 12 + 4 * i : 4 * i;
      back_[i] = backward ? 4 * i : 12 + 4 * i;
#if defined(__SSE__)
      origin_[i] = _mm_set1_ps(static_cast<float>(origin[i]));
      inverse_[i] = _mm_set1_ps(r);
#else
      origin_[i] = static_cast<float>(origin[i]);
      inverse_[i] = r;
#endif
    }
  }

  // Bit k: child k is met between 0 and `far`; near[k]: where it is entered. `near` is aligned to 16 bytes.
  unsigned test(const BoxNode& node, float far, float near[4]) const {
    const float* planes = node.planes[0];
#if defined(__SSE__)
    const auto plane = [&](int offset, int i) { return _mm_mul_ps(_mm_sub_ps(_mm_load_ps(planes + offset), origin_[i]), inverse_[i]); };
    const __m128 enter = _mm_max_ps(_mm_max_ps(plane(front_[0], 0), plane(front_[1], 1)), _mm_max_ps(plane(front_[2], 2), _mm_setzero_ps()));
    const __m128 leave = _mm_min_ps(_mm_min_ps(plane(back_[0], 0), plane(back_[1], 1)), _mm_min_ps(plane(back_[2], 2), _mm_set1_ps(far)));
    _mm_store_ps(near, enter);
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(enter, leave)));
#else
    unsigned hits = 0;
    for (int k = 0; k < 4; ++k) {
      float enter = 0, leave = far;
      for (int i = 0; i < 3; ++i) {
        enter = std::fmax(enter, (planes[front_[i] + k] - origin_[i]) * inverse_[i]);
        leave = std::fmin(leave, (planes[back_[i] + k] - origin_[i]) * inverse_[i]);
      }
      near[k] = enter;
      hits |= static_cast<unsigned>(enter <= leave) << k;
    }
    return hits;
#endif
  }

 private:
#if defined(__SSE__)
  __m128 origin_[3], inverse_[3];
#else
  float origin_[3], inverse_[3];
#endif
  int front_[3], back_[3];  // where the planes a ray meets first and last stand in a node, in floats
};

// Bit k: child k contains the point.
inline unsigned boxes_around(const BoxNode& node, float x, float y, float z) {
#if defined(__SSE__)
  const float p[3] = {x, y, z};
  __m128 inside = _mm_cmpeq_ps(_mm_setzero_ps(), _mm_setzero_ps());
  for (int i = 0; i < 3; ++i) {
    const __m128 v = _mm_set1_ps(p[i]);
    inside = _mm_and_ps(inside, _mm_and_ps(_mm_cmple_ps(_mm_load_ps(node.planes[i]), v), _mm_cmple_ps(v, _mm_load_ps(node.planes[3 + i]))));
  }
  return static_cast<unsigned>(_mm_movemask_ps(inside));
#else
  unsigned hits = 0;
  for (int k = 0; k < 4; ++k)
    hits |= static_cast<unsigned>(x >= node.planes[0][k] && x <= node.planes[3][k] && y >= node.planes[1][k] && y <= node.planes[4][k] &&
                                  z >= node.planes[2][k] && z <= node.planes[5][k])
            << k;
  return hits;
#endif
}

}  // namespace verisim::accel
