#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "tracer/shapes/heights/height_packet.h"
#include "tracer/shapes/heights/height_walk.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/heights/height_packet_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

HWY_INLINE double least(const Packet& v) {
  double result = v[0];
  for (int i = 1; i < kLanes; ++i) result = v[i] < result ? v[i] : result;
  return result;
}
HWY_INLINE double most(const Packet& v) { return -least(-v); }

unsigned enter(const HeightGrid& grid, const Transform& matrix, const RayPacket& rays, HeightPacket& p) {
  const int first = rays.first;
  const Packet x = load(rays.rays.origin.x + first), y = load(rays.rays.origin.y + first),
               z = load(rays.rays.origin.z + first);
  const Packet dx = load(rays.rays.direction.x + first), dy = load(rays.rays.direction.y + first),
               dz = load(rays.rays.direction.z + first);
  const Affine& m = matrix.inv;
  Packet o[3], d[3];
  for (int i = 0; i < 3; ++i)
    o[i] = x * m[0][i] + y * m[1][i] + z * m[2][i] + m[3][i], d[i] = dx * m[0][i] + dy * m[1][i] + dz * m[2][i];
  const double cells[3] = {grid.width() - 1.0, 65536, grid.depth() - 1.0};
  const double low[3] = {0, grid.bottom(), 0}, high[3] = {cells[0], grid.top(), cells[2]};
  Packet enter = kHeightFieldNearest, leave = 1e300;
  Mask met = Mask::of_bits(rays.active);
  for (int i = 0; i < 3; ++i) {
    const Mask level = d[i] == 0;
    const Packet a = (low[i] - o[i]) / d[i], b = (high[i] - o[i]) / d[i];
    enter = select(level, enter, max(enter, min(a, b)));
    leave = select(level, leave, min(leave, max(a, b)));
    met &= ~level | ((o[i] >= low[i]) & (o[i] <= high[i]));
  }
  met &= enter <= leave;
  store(p.ox, o[0]), store(p.oy, o[1]), store(p.oz, o[2]), store(p.dx, d[0]), store(p.dy, d[1]), store(p.dz, d[2]),
      store(p.enter, enter), store(p.leave, leave);
  return bits(met);
}

// A straight line above or below what the rays do, in single precision.
struct Bound {
  float start, slope;
};

// What the rays themselves do, at u = 0 and from cell to cell.
struct Lines {
  Packet w, w_slope, y, y_slope;
};

// All rays of a packet: u is the axis that they mostly follow, counted along them from where the first of them enters;
// w is the other one.
struct ThickRay {
  Bound w_low, w_high, y_low, y_high;
  float end, side_margin, height_margin;
  double first;  // u where the count begins
  bool along_z, backward;
  unsigned flip;
  alignas(64) float u_steps[16], w_steps[16];
};

HWY_INLINE unsigned meet_thick(const ThickRay& ray, const HeightGrid::Block& block, float u0, float w0, float size,
                               float near[16]) {
  using Floats = BasicPacket<float, 16>;  // one for each child
  const float m = ray.side_margin, beyond = size + 2 * m;
  const Floats from = u0 - m + Floats::load(ray.u_steps) * size, left = w0 - m + Floats::load(ray.w_steps) * size;
  const Floats a = max(Floats(0.0f), from), b = min(Floats(ray.end), from + beyond), right = left + beyond;
  const auto below = [&](const Bound& line)
                         VERISIM_INLINE_LAMBDA { return line.start + min(b * line.slope, a * line.slope); };
  const auto above = [&](const Bound& line)
                         VERISIM_INLINE_LAMBDA { return line.start + max(b * line.slope, a * line.slope); };
  const Floats low = Floats::load(block.low), high = Floats::load(block.high),
               margin = ray.height_margin + (high - low) * (ray.side_margin * 4);
  store(near, a);
  return bits((a <= b) & (low <= high) & (below(ray.w_low) <= right) & (left <= above(ray.w_high)) &
              (below(ray.y_low) <= high + margin) & (low - margin <= above(ray.y_high)));
}

// Where the rays are while they are in one of the columns of cells across u.
struct Column {
  Packet w_low, w_high, y_low, y_high;
};
HWY_INLINE Column column_of(const Lines& lines, double u, double margin) {
  const Packet wa = lines.w + (u - margin) * lines.w_slope, wb = lines.w + (u + 1 + margin) * lines.w_slope;
  const Packet ya = lines.y + (u - margin) * lines.y_slope, yb = lines.y + (u + 1 + margin) * lines.y_slope;
  return {min(wa, wb), max(wa, wb), min(ya, yb), max(ya, yb)};
}

// Eight rays against the two triangles of a cell, as HeightField::cell does it for one; the lanes that are hit.
HWY_INLINE unsigned test_cell(const HeightGrid& grid, int i, int k, unsigned lanes, double t_min, const Packet& t_max,
                              HeightPacket& p) {
  const double h00 = grid.at(i, k), h10 = grid.at(i + 1, k), h01 = grid.at(i, k + 1), h11 = grid.at(i + 1, k + 1);
  const Packet ox = load(p.ox), oy = load(p.oy), oz = load(p.oz), dx = load(p.dx), dy = load(p.dy), dz = load(p.dz),
               enter = load(p.enter), leave = load(p.leave);
  Packet best = load(p.t);
  IntPacket hit = load(p.triangle);
  const IntPacket none(-1);
  const Mask active = Mask::of_bits(lanes);
  unsigned any = 0;
  for (int triangle = 0; triangle < 2; ++triangle) {
    const double nx = triangle == 0 ? h00 - h10 : h01 - h11, nz = triangle == 0 ? h00 - h01 : h10 - h11;
    const Packet nd = nx * dx + dy + nz * dz;
    const Packet x = static_cast<double>(i + triangle) - ox, y = (triangle == 0 ? h00 : h11) - oy,
                 z = static_cast<double>(k + triangle) - oz;
    const Packet t = (nx * x + y + nz * z) / nd;
    const Packet a = ox + t * dx - static_cast<double>(i), b = oz + t * dz - static_cast<double>(k);
    constexpr double e = kHeightFieldEdge;
    const Mask in =
        triangle == 0 ? (a >= -e) & (b >= -e) & (a + b <= 1 + e) : (a <= 1 + e) & (b <= 1 + e) & (a + b >= 1 - e);
    const Mask wanted = (t >= t_min) & select(hit == none, t < t_max, t <= best);
    const Mask taken = active & in & ((nd > kEpsilon) | (nd < -kEpsilon)) & (t >= enter) & (t <= leave) & wanted;
    const unsigned now = bits(taken);
    if (now == 0) continue;
    any |= now;
    best = select(taken, t, best);
    hit = select(taken, IntPacket(triangle), hit);
    store(p.t, best);
    store(p.triangle, hit);
    for (unsigned rest = now; rest != 0; rest &= rest - 1)
      p.i[std::countr_zero(rest)] = i, p.k[std::countr_zero(rest)] = k;
  }
  return any;
}

// The smallest block that holds all cells between two corners; false: there is nothing to hold.
HWY_INLINE HeightWalk::Block block_around(const HeightGrid& grid, double x0, double x1, double z0, double z1) {
  const auto cell = [](double at, int cells) {
    return static_cast<unsigned>(at > 0 ? (at < cells - 1.0 ? at : cells - 1.0) : 0);
  };
  const unsigned i0 = cell(x0, grid.width() - 1), i1 = cell(x1, grid.width() - 1), k0 = cell(z0, grid.depth() - 1),
                 k1 = cell(z1, grid.depth() - 1);
  const int wide_bits = static_cast<int>(std::bit_width((i0 ^ i1) | (k0 ^ k1)) + 1) / 2,
            level = wide_bits < 1 ? 1 : wide_bits;
  return {level, static_cast<int>(i0 >> 2 * level), static_cast<int>(k0 >> 2 * level), -HUGE_VALF};
}

constexpr double kThickest = 2;  // cells a ray: those that are further apart find their own ways sooner

// Rays of a packet on their way over the field, as one thick ray.
class PacketWalk {
 public:
  HWY_INLINE PacketWalk(const HeightGrid& grid, unsigned lanes, double t_min, const double* limits, HeightPacket& p)
      : grid_(grid), lanes_(lanes), here_(Mask::of_bits(lanes)), t_min_(t_min), t_max_(load(limits)), p_(p) {
    const int one = std::countr_zero(lanes);
    backward_x_ = p.dx[one] < 0, backward_z_ = p.dz[one] < 0;
    ray_.along_z = std::fabs(p.dz[one]) > std::fabs(p.dx[one]);
    ray_.backward = ray_.along_z ? backward_z_ : backward_x_;
    ray_.flip = (backward_x_ ? 5u : 0u) | (backward_z_ ? 10u : 0u);
    sign_ = ray_.backward ? -1 : 1;
    ou_ = load(ray_.along_z ? p.oz : p.ox), du_ = load(ray_.along_z ? p.dz : p.dx);
    leave_ = min(load(p.leave), t_max_);
    ray_.first = least(select(here_, sign_ * (ou_ + load(p.enter) * du_), Packet(HUGE_VAL)));
    last_ = farthest(here_, leave_);
  }
  bool stands_still() const { return bits((du_ == 0) & here_) != 0; }  // one of them, along u
  bool is_number() const { return ray_.first == ray_.first && last_ == last_; }
  bool misses() const { return !(ray_.first <= last_); }

  // False: the rays are too far apart.
  HWY_INLINE bool make_thick() {
    const Packet ow = load(ray_.along_z ? p_.ox : p_.oz), dw = load(ray_.along_z ? p_.dx : p_.dz);
    const Range w = fit(ow, dw, lines_.w, lines_.w_slope, ray_.w_low, ray_.w_high);
    if (!(w.apart <= kThickest * std::popcount(lanes_))) return false;
    const Range y = fit(load(p_.oy), load(p_.dy), lines_.y, lines_.y_slope, ray_.y_low, ray_.y_high);
    // Lines that leave the field far behind would need more digits, and so would those of rays that go almost straight
    // down.
    const double reach = 2.0 * (grid_.width() + grid_.depth());
    constexpr double kMaxDigits = 1e10;
    const Packet largest =
        max(max(abs(lines_.w), abs(lines_.y)), reach * max(abs(lines_.w_slope), abs(lines_.y_slope)));
    if (bits((largest < kMaxDigits) & here_) != lanes_) return false;
    if (!(w.least > -reach && w.most < reach && y.least > -4 * 65536 && y.most < 4 * 65536)) return false;
    ray_.side_margin = static_cast<float>(1e-3 + 4e-6 * reach);
    ray_.height_margin = 2;
    ray_.end = static_cast<float>(last_ - ray_.first) + ray_.side_margin;
    for (int c = 0; c < 16; ++c) {
      const int u_step = ray_.along_z ? HeightGrid::row(c) : HeightGrid::column(c),
                w_step = ray_.along_z ? HeightGrid::column(c) : HeightGrid::row(c);
      ray_.u_steps[c] = static_cast<float>(ray_.backward ? -u_step : u_step);
      ray_.w_steps[c] = static_cast<float>(w_step);
    }
    const double m = ray_.side_margin, u_low = (ray_.backward ? -last_ : ray_.first) - m,
                 u_high = (ray_.backward ? -ray_.first : last_) + m;
    around_ = ray_.along_z ? block_around(grid_, w.least - m, w.most + m, u_low, u_high)
                           : block_around(grid_, u_low, u_high, w.least - m, w.most + m);
    return true;
  }

  HWY_INLINE void run(bool any) {
    HeightWalk::Block blocks[HeightGrid::kMaxLevels * HeightGrid::kChildren];
    blocks[0] = around_;
    int waiting = 1;
    alignas(64) float near[16];
    unsigned open = lanes_;
    while (waiting > 0) {
      const HeightWalk::Block at = blocks[--waiting];
      if (at.near > ray_.end) continue;
      const int below = at.level - 1, i = at.i * 4, k = at.k * 4;
      const double size = static_cast<double>(std::int64_t{1} << 2 * below);
      const double u = (ray_.along_z ? k : i) * size, w = (ray_.along_z ? i : k) * size;
      const auto u0 = static_cast<float>((ray_.backward ? -u - size : u) - ray_.first);
      const HeightGrid::Block& block = grid_.block(at.level, at.i, at.k);
      unsigned met = in_order(meet_thick(ray_, block, u0, static_cast<float>(w), static_cast<float>(size), near),
                              backward_x_, backward_z_);
      if (below > 0) {
        int place = waiting += std::popcount(met);
        for (; met != 0; met &= met - 1) {  // near ones last on the stack
          const int c = child(met);
          blocks[--place] = {below, i + HeightGrid::column(c), k + HeightGrid::row(c), near[c]};
        }
      } else if (met != 0 && !look_at_cells(block, i, k, met, near, any, open)) {
        return;
      }
    }
  }

 private:
  // Of what the rays do in one direction across u; `apart`: at the ends.
  struct Range {
    double least, most, apart;
  };

  // The largest u of some lanes.
  HWY_INLINE double farthest(const Mask& lanes, const Packet& t) const {
    return most(select(lanes, sign_ * (ou_ + t * du_), Packet(-HUGE_VAL)));
  }

  // Every ray is a straight line over u: the least of them lies above the chord of its ends, the largest below.
  HWY_INLINE Range fit(const Packet& origin, const Packet& direction, Packet& at_zero, Packet& slope, Bound& low,
                       Bound& high) const {
    slope = direction / du_, at_zero = origin - ou_ * slope;
    const Packet from = at_zero + sign_ * ray_.first * slope, to = at_zero + sign_ * last_ * slope;
    const double low0 = least(select(here_, from, Packet(HUGE_VAL))), low1 = least(select(here_, to, Packet(HUGE_VAL))),
                 high0 = most(select(here_, from, Packet(-HUGE_VAL))),
                 high1 = most(select(here_, to, Packet(-HUGE_VAL)));
    const Range range{low0 < low1 ? low0 : low1, high0 < high1 ? high1 : high0, std::max(high0 - low0, high1 - low1)};
    const double length = last_ - ray_.first;
    if (length > 1e-3) {
      low = {static_cast<float>(low0), static_cast<float>((low1 - low0) / length)};
      high = {static_cast<float>(high0), static_cast<float>((high1 - high0) / length)};
    } else {
      low = {static_cast<float>(range.least), 0}, high = {static_cast<float>(range.most), 0};
    }
    return range;
  }

  int child(unsigned met) const { return static_cast<int>(static_cast<unsigned>(std::countr_zero(met)) ^ ray_.flip); }

  // Those of a block of cells from (i, k) on that the thick ray meets. False: nothing is left to look for.
  HWY_INLINE bool look_at_cells(const HeightGrid::Block& block, int i, int k, unsigned met, const float* near, bool any,
                                unsigned& open) {
    const double m = ray_.side_margin;
    Column columns[4];
    for (int j = 0; j < 4; ++j) columns[j] = column_of(lines_, (ray_.along_z ? k : i) + j, m);
    for (; met != 0; met &= met - 1) {
      const int c = child(met);
      if (near[c] > ray_.end) continue;
      const int ci = i + HeightGrid::column(c), ck = k + HeightGrid::row(c);
      const double margin = ray_.height_margin + 4 * m * (block.high[c] - block.low[c]), low = block.low[c] - margin,
                   high = block.high[c] + margin;
      const Column& column = columns[ray_.along_z ? ck - k : ci - i];
      const double left = (ray_.along_z ? ci : ck) - m, right = left + 1 + 2 * m;
      const unsigned active = open & bits((column.w_low <= right) & (column.w_high >= left) & (column.y_low <= high) &
                                          (column.y_high >= low));
      const unsigned hit = active == 0 ? 0 : test_cell(grid_, ci, ck, active, t_min_, t_max_, p_);
      if (hit == 0) continue;
      if (any && (open &= ~hit) == 0) return false;
      // No ray is interesting behind its hit.
      const Packet until = select(load(p_.triangle) == IntPacket(-1), leave_, min(leave_, load(p_.t)));
      ray_.end = static_cast<float>(farthest(Mask::of_bits(open), until) - ray_.first) + ray_.side_margin;
    }
    return true;
  }

  const HeightGrid& grid_;
  const unsigned lanes_;
  const Mask here_;
  const double t_min_;
  const Packet t_max_;
  HeightPacket& p_;
  ThickRay ray_;
  Lines lines_;
  HeightWalk::Block around_;  // all cells that the rays may meet
  bool backward_x_, backward_z_;
  double sign_, last_;
  Packet ou_, du_, leave_;
};

bool walk(const HeightGrid& grid, unsigned lanes, double t_min, const double* limits, bool any, HeightPacket& p) {
  PacketWalk rays(grid, lanes, t_min, limits, p);
  if (rays.stands_still()) return false;
  for (int k = 0; k < kLanes; ++k)
    if (lanes >> k & 1) p.triangle[k] = -1;
  if (rays.misses()) return rays.is_number();
  if (!rays.make_thick()) return false;
  rays.run(any);
  return true;
}

constexpr HeightPacketKernels kKernels = {enter, walk};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(HeightPacketKernels, height_packet_kernels)
}  // namespace verisim::shapes
#endif
