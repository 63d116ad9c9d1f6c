// The four quarters of a block of a height field tested at once against a ray: SSE2 where there is such, plain loops elsewhere. It only narrows: single
// precision with margins for its rounding.
#pragma once

#include <algorithm>
#include <cmath>

#include "tracer/shapes/height_grid.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace verisim::shapes {

class QuarterTest {
 public:
  // A ray in grid units. Triangles are accepted slightly beyond their edges, and their planes reach beyond the heights at the corners by as much.
  QuarterTest(const HeightGrid& grid, const Vec3& o, const Vec3& d) : origin_(o) {
    const auto reciprocal = [](double v) { return static_cast<float>(std::clamp(1 / (v == 0 ? 1e-30 : v), -1e30, 1e30)); };
    inverse_x_ = reciprocal(d.x), inverse_z_ = reciprocal(d.z);
    flip_ = (d.x < 0 ? 1u : 0u) | (d.z < 0 ? 2u : 0u);
    height_ = static_cast<float>(o.y), slope_ = static_cast<float>(d.y);
    side_margin_ = static_cast<float>(1e-3 + 1e-6 * (std::fabs(o.x) + std::fabs(o.z) + grid.width() + grid.depth()));
    height_margin_ = static_cast<float>(1 + 1e-6 * (65536 + 2 * std::fabs(o.y)));
  }

  // Quarter c, c ^ flip() = 0 the nearest along the ray.
  unsigned flip() const { return flip_; }

  // Bit c: the ray may meet quarter c of the block between enter and leave; near[c] (aligned to 16 bytes): from where on. `half`: cells to a quarter's side.
  [[gnu::always_inline]] unsigned test(const HeightGrid::Quarters& q, double i, double k, float half, float enter, float leave, float near[4]) const {
    const float x0 = static_cast<float>(i - origin_.x), z0 = static_cast<float>(k - origin_.z);
#if defined(__SSE2__)
    const auto lines = [&](float first, float inverse, bool backward, bool far, __m128 steps) {
      const float margin = far != backward ? side_margin_ : -side_margin_;
      const __m128 at = _mm_add_ps(_mm_set1_ps(first + (far != backward ? half : 0) + margin), _mm_mul_ps(steps, _mm_set1_ps(half)));
      return _mm_mul_ps(at, _mm_set1_ps(inverse));
    };
    const __m128 sx = _mm_setr_ps(0, 1, 0, 1), sz = _mm_setr_ps(0, 0, 1, 1);
    const bool bx = flip_ & 1, bz = flip_ & 2;
    const __m128 a = _mm_max_ps(_mm_max_ps(lines(x0, inverse_x_, bx, false, sx), lines(z0, inverse_z_, bz, false, sz)), _mm_set1_ps(enter));
    const __m128 b = _mm_min_ps(_mm_min_ps(lines(x0, inverse_x_, bx, true, sx), lines(z0, inverse_z_, bz, true, sz)), _mm_set1_ps(leave));
    const __m128 y = _mm_set1_ps(height_), dy = _mm_set1_ps(slope_);
    const __m128 ya = _mm_add_ps(y, _mm_mul_ps(a, dy)), yb = _mm_add_ps(y, _mm_mul_ps(b, dy));
    const __m128i packed = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&q)), zero = _mm_setzero_si128();
    const __m128 low = _mm_cvtepi32_ps(_mm_unpacklo_epi16(packed, zero)), high = _mm_cvtepi32_ps(_mm_unpackhi_epi16(packed, zero));
    const __m128 margin = _mm_add_ps(_mm_set1_ps(height_margin_), _mm_mul_ps(_mm_sub_ps(high, low), _mm_set1_ps(side_margin_ * 4)));
    __m128 meets = _mm_and_ps(_mm_cmple_ps(a, b), _mm_cmple_ps(low, high));
    meets = _mm_and_ps(meets, _mm_cmple_ps(_mm_min_ps(ya, yb), _mm_add_ps(high, margin)));
    meets = _mm_and_ps(meets, _mm_cmpge_ps(_mm_max_ps(ya, yb), _mm_sub_ps(low, margin)));
    _mm_store_ps(near, a);
    return static_cast<unsigned>(_mm_movemask_ps(meets));
#else
    unsigned hits = 0;
    for (unsigned c = 0; c < 4; ++c) {
      float a = enter, b = leave;
      const auto narrow = [&](float first, float inverse) {
        const float s = (first - side_margin_) * inverse, t = (first + half + side_margin_) * inverse;
        a = std::max(a, std::min(s, t)), b = std::min(b, std::max(s, t));
      };
      narrow(x0 + (c & 1 ? half : 0), inverse_x_);
      narrow(z0 + (c & 2 ? half : 0), inverse_z_);
      const float ya = height_ + a * slope_, yb = height_ + b * slope_, low = q.low[c], high = q.high[c];
      const float margin = height_margin_ + (high - low) * side_margin_ * 4;
      near[c] = a;
      hits |= static_cast<unsigned>(a <= b && low <= high && std::min(ya, yb) <= high + margin && std::max(ya, yb) >= low - margin) << c;
    }
    return hits;
#endif
  }

 private:
  Vec3 origin_;
  float inverse_x_, inverse_z_, height_, slope_, side_margin_, height_margin_;
  unsigned flip_;
};

}  // namespace verisim::shapes
