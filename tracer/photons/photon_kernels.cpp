#include "tracer/photons/photon_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tracer/photons/photon_search.h"
#include "tracer/photons/photon_tree.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/photons/photon_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/photons/photon_loads-inl.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::global {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

constexpr std::size_t kAtOnce = kPhotonsAtOnce, kEight = kLanes;
// Times the wanted number of photons is when the nearest are picked out, and the search narrowed.
constexpr std::size_t kCrowd = 3;

alignas(64) constexpr std::uint32_t kNumbers[kLanes] = {0, 1, 2, 3, 4, 5, 6, 7};

// compress(), for AVX2 by a table of whole orders: Highway 1.0.3 computes them from bits, and optics.pov of
// povray-examples took 8.1 s instead of 1.5.
#if HWY_TARGET == HWY_AVX2
struct Orders {
  std::array<std::array<std::uint8_t, kEight>, 256> from{};
  constexpr Orders() {
    for (unsigned bits = 0; bits < 256; ++bits) {
      std::size_t n = 0;
      for (unsigned i = 0; i < kEight; ++i) {
        if (bits >> i & 1) from[bits][n++] = static_cast<std::uint8_t>(i);
      }
    }
  }
};
alignas(64) constexpr Orders kOrders;
HWY_INLINE __m256i order_of(unsigned which) {
  return _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kOrders.from[which].data())));
}
HWY_INLINE void pack(unsigned which, const FloatPacket& a, float* to) {
  _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(a.v[0].raw, order_of(which)));
}
HWY_INLINE void pack(unsigned which, const Words& a, std::uint32_t* to) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(a.v[0].raw, order_of(which)));
}
#else
template <class P, class T>
HWY_INLINE void pack(unsigned which, const P& a, T* to) {
  compress(which, a, to);
}
#endif

// 1 where the mask is set, elsewhere 0.
HWY_INLINE Words ones(const FloatPacket::Mask& mask) { return select(mask, Words(1u), Words(0u)); }

// Bit i: box i of eight is nearer to the point than the square root of `squared`, or as near.
HWY_INLINE unsigned near_boxes(const PhotonBoxes& boxes, std::size_t first, const std::array<float, 3>& point,
                               float squared) {
  FloatPacket sum;
  _Pragma("GCC unroll 3") for (std::size_t a = 0; a < 3; ++a) {
    const FloatPacket at(point[a]);
    const FloatPacket below = FloatPacket::load(boxes.low[a].data() + first) - at,
                      above = at - FloatPacket::load(boxes.high[a].data() + first);
    const FloatPacket gap = max(FloatPacket(0.0f), max(above, below));
    sum = a == 0 ? gap * gap : sum + gap * gap;
  }
  return bits(sum <= squared);
}
unsigned boxes(const PhotonBoxes& boxes, const std::array<float, 3>& point, float squared) {
  return near_boxes(boxes, 0, point, squared) | near_boxes(boxes, kEight, point, squared) << kEight;
}

// A center in floats, and what they may say of the squared distance of a photon, or a box, that is below a limit.
struct FloatCenter {
  std::array<float, 3> at, normal{};
  double error, steep = 0.0;
  // Distances are flattened as long as floats can hold them.
  FloatCenter(const PhotonCenter& c, double limit)
      : at{static_cast<float>(c.point.x), static_cast<float>(c.point.y), static_cast<float>(c.point.z)},
        error(4e-7 * (std::fabs(c.point.x) + std::fabs(c.point.y) + std::fabs(c.point.z))) {
    steep = 16.0 * length(c.normal);
    if (!(flattened(limit) < 1e37)) steep = 0.0;
    if (steep > 0.0)
      normal = {static_cast<float>(16.0 * c.normal.x), static_cast<float>(16.0 * c.normal.y),
                static_cast<float>(16.0 * c.normal.z)};
  }
  float plain(double squared) const {
    const double r = std::sqrt(squared) + error;
    return static_cast<float>(std::min(r * r * (1.0 + 1e-5), 1e38));
  }
  // The factor is at most 1 + steep * r; each coordinate and the normal are wrong by their rounding.
  float flattened(double squared) const {
    const double r = std::sqrt(squared), wider = r + error * std::sqrt(1.0 + steep * r);
    return static_cast<float>(std::min(wider * wider * (1.0 + 1e-5) * (1.0 + steep * (2.0 * error + 1e-6 * r)), 1e38));
  }
};

// Calls visit(numbers) for leaves that are nearer to the point than the square root of `near_enough`, many at a time
// and in the order of the map, while it returns true; it may lower `near_enough`. What is near is listed before it is
// looked at: where a walk does both at once, its branches are hard to foretell.
template <class Visit>
class LeafWalk {
 public:
  HWY_INLINE LeafWalk(const PhotonTree& tree, const FloatCenter& point, const float& near_enough, Visit& visit)
      : nodes_(tree.nodes().data()), point_(point), near_enough_(near_enough), visit_(visit) {
    if (tree.nodes().empty()) return;
    if (tree.height() == 0) {
      lowest_[waiting_++] = 0;
    } else if (!look_at(nodes_[0], tree.height())) {
      return;
    }
    look_at_lowest();
  }

 private:
  static constexpr std::size_t kMaxNodes = 32, kMaxLeaves = 96;

  // Appends the parts of a node that are near.
  HWY_INLINE std::size_t add_near(const PhotonTree::Node& node, std::uint32_t* to) const {
    std::size_t n = 0;
    _Pragma("GCC unroll 2") for (std::size_t i = 0; i < kAtOnce; i += kEight) {
      const unsigned which = near_boxes(node.boxes, i, point_.at, near_enough_);
      pack(which, Words::load(node.child.data() + i), to + n);
      n += static_cast<std::size_t>(std::popcount(which));
    }
    return n;
  }
  bool look_at(const PhotonTree::Node& node, int height) {
    if (height == 1) {
      waiting_ += add_near(node, lowest_.data() + waiting_);
      return waiting_ <= kMaxNodes || look_at_lowest();
    }
    std::array<std::uint32_t, 2 * kAtOnce> parts;
    const std::size_t n = add_near(node, parts.data());
    for (std::size_t i = 0; i < n; ++i) {
      if (!look_at(nodes_[parts[i]], height - 1)) return false;
    }
    return true;
  }
  bool look_at_lowest() {
    std::array<std::uint32_t, kMaxLeaves + 2 * kAtOnce> leaves;
    std::size_t n = 0;
    const std::size_t waiting = waiting_;
    waiting_ = 0;
    for (std::size_t k = 0; k < waiting; ++k) {
      n += add_near(nodes_[lowest_[k]], leaves.data() + n);
      if (n < kMaxLeaves && k + 1 < waiting) continue;
      if (!visit_(std::span<const std::uint32_t>(leaves.data(), n))) return false;
      n = 0;
    }
    return true;
  }

  const PhotonTree::Node* const nodes_;
  const FloatCenter& point_;
  const float& near_enough_;
  Visit& visit_;
  std::array<std::uint32_t, kMaxNodes + 2 * kAtOnce> lowest_;  // nodes that are looked at together
  std::size_t waiting_ = 0;
};

// Writes infinities behind the last, for loops that take eight at a time.
HWY_INLINE void fill_up(PhotonDistances& list) {
  list.make_room(list.size());
  for (std::size_t i = 0; i < kAtOnce; i += kEight)
    store(list.squared_data() + list.size() + i, FloatPacket(kInfiniteFloat));
}

// Those among a list that are as far as its limit when rounded: how many, and the place of one of them.
struct EqualOnes {
  std::size_t count = 0, place = 0;
};
// Copies those that are at most `limit` when rounded; `from` is filled up.
HWY_INLINE EqualOnes keep_rounded(const PhotonDistances& from, float limit, PhotonDistances& to) {
  constexpr std::size_t kChunk = 1024;  // room is made for so many: mostly, few of many are kept
  const std::size_t n = from.size();
  const float* const squared = from.squared().data();
  const std::uint32_t* const index = from.index().data();
  const FloatPacket limits(limit);
  std::size_t kept = 0;
  EqualOnes equals;
  for (std::size_t first = 0; first < n; first += kChunk) {
    to.make_room(kept + std::min(kChunk, n - first));
    float* const to_squared = to.squared_data();
    std::uint32_t* const to_index = to.index_data();
    for (std::size_t i = first; i < std::min(first + kChunk, n); i += kEight) {
      const FloatPacket eight = FloatPacket::load(squared + i);
      const unsigned which = bits(eight <= limits);
      if (const unsigned same = bits(eight == limits); same != 0) {
        equals.count += static_cast<std::size_t>(std::popcount(same)),
            equals.place = kept + static_cast<std::size_t>(std::popcount(which & (same - 1)));
      }
      pack(which, eight, to_squared + kept), pack(which, Words::load(index + i), to_index + kept);
      kept += static_cast<std::size_t>(std::popcount(which));
    }
  }
  to.set_size(kept);
  return equals;
}

void keep_within(PhotonDistances& from, const PhotonMeasure& measure, double limit, PhotonDistances& to) {
  fill_up(from);
  if (keep_rounded(from, PhotonDistances::rounded(limit), to).count != 0) drop_farther(to, measure, limit);
}

// How many of the numbers, filled up, are smaller than `limit`.
HWY_INLINE std::size_t count_below(const float* numbers, std::size_t size, float limit) {
  const FloatPacket limits(limit);
  Words count(0u);
  _Pragma("GCC unroll 4") for (std::size_t i = 0; i < size; i += kEight) count +=
      ones(FloatPacket::load(numbers + i) < limits);
  alignas(64) std::uint32_t each[kEight];
  store(each, count);
  std::uint32_t sum = 0;
  for (const std::uint32_t n : each) sum += n;
  return static_cast<std::size_t>(sum);
}

// Copies the numbers, filled up, that are at least `low` and smaller than `high`, and fills them up, too; `to` may be
// `numbers`. Returns how many.
HWY_INLINE std::size_t copy_between(const float* numbers, std::size_t n, float low, float high, float* to) {
  std::size_t count = 0;
  const FloatPacket lows(low), highs(high);
  for (std::size_t i = 0; i < n; i += kEight) {
    const FloatPacket eight = FloatPacket::load(numbers + i);
    const unsigned which = bits(eight < highs) & ~bits(eight < lows);
    pack(which, eight, to + count);
    count += static_cast<std::size_t>(std::popcount(which));
  }
  for (std::size_t i = 0; i < kAtOnce; i += kEight) store(to + count + i, FloatPacket(kInfiniteFloat));
  return count;
}

// The one of sixteen numbers that `before` are before when they are sorted: the largest with at most as many smaller
// ones.
HWY_INLINE float in_order(const float* numbers, std::size_t before) {
  const FloatPacket halves[2] = {FloatPacket::load(numbers), FloatPacket::load(numbers + kEight)};
  Words smaller[2] = {0u, 0u};
  _Pragma("GCC unroll 16") for (std::size_t i = 0; i < kAtOnce; ++i) {
    const FloatPacket at(numbers[i]);
    for (int h = 0; h < 2; ++h) smaller[h] += ones(at < halves[h]);
  }
  FloatPacket best(0.0f);  // none is negative
  for (int h = 0; h < 2; ++h)
    best = max(best, select(smaller[h] > Words(static_cast<std::uint32_t>(before)), FloatPacket(0.0f), halves[h]));
  alignas(64) float each[kEight];
  store(each, best);
  float result = each[0];
  for (const float v : each) result = std::max(result, v);
  return result;
}

// The one of the numbers, filled up and none larger than `most`, that `wanted` are before or equal to when they are
// sorted.
HWY_INLINE float find_last(const float* numbers, std::size_t n, std::size_t wanted, float most) {
  // Squared distances are spread about evenly over a disc: guesses a little beyond and before the last one wanted, in
  // turn, leave few between them. Once they are much fewer than all, they are looked for apart.
  constexpr int kMaxGuesses = 12, kPatience = 2;
  constexpr std::size_t kMuchFewer = 3;
  thread_local std::vector<float> apart;
  apart.resize(n + 2 * kAtOnce);
  std::size_t before = 0;  // how many are smaller than all of the numbers that are left
  float low = 0.0f, high = std::nextafter(most, kInfiniteFloat);
  std::size_t below_low = 0, below_high = n;
  // Where they are spread so unevenly that guesses on one side leave most of them, the next ones go farther the same
  // way.
  bool too_high = false;
  float pull = 1.0f;
  const auto set_apart = [&] {
    n = copy_between(numbers, n, low, high, apart.data());
    numbers = apart.data(), before = below_low;
  };
  for (int i = 0; i < kMaxGuesses && below_high - below_low > kAtOnce; ++i) {
    const auto between = static_cast<float>(below_high - below_low), margin = std::min(4.0f, 0.2f * between);
    const float share = (static_cast<float>(wanted - below_low) + (i % 2 == 0 ? margin : -margin)) / between;
    const float guess = low + (too_high ? share * pull : 1.0f - (1.0f - share) * pull) * (high - low);
    if (!(guess > low && guess < high)) continue;
    const std::size_t below = before + count_below(numbers, n, guess);
    const bool again = too_high == (below >= wanted);
    too_high = below >= wanted;
    if (too_high) {
      high = guess, below_high = below;
    } else {
      low = guess, below_low = below;
    }
    pull = i >= kPatience && again && 2.0f * static_cast<float>(below_high - below_low) > between ? 0.25f * pull : 1.0f;
    if ((below_high - below_low) * kMuchFewer < n) set_apart();
  }
  set_apart();
  if (n <= kAtOnce) return in_order(apart.data(), wanted - before - 1);
  const auto last = apart.begin() + static_cast<std::ptrdiff_t>(wanted - before - 1);
  std::nth_element(apart.begin(), last, apart.begin() + static_cast<std::ptrdiff_t>(n));
  return *last;
}

void keep_nearest(PhotonDistances& from, const PhotonMeasure& measure, std::size_t maximum, double& limit,
                  PhotonDistances& to) {
  fill_up(from);
  const float last = find_last(from.squared().data(), from.size(), maximum, PhotonDistances::rounded(limit));
  const EqualOnes equals = keep_rounded(from, last, to);
  to.set_split(from.split());
  limit = equals.count == 1 ? measure.squared(to.index()[equals.place]) : drop_farthest(to, last, measure, maximum);
}

// Collects photons around a point: leaves are looked at in single precision, candidates among their photons are
// measured together in double.
template <bool flat>
class Collector {
 public:
  HWY_INLINE Collector(const PhotonTree& tree, const PhotonQuery& query, double& limit, PhotonDistances& found)
      : tree_(tree),
        query_(query),
        center_(query.measure.center),
        point_(center_, limit),
        most_(query.maximum < kAnyNumber ? kCrowd * query.maximum + 20 : kAnyNumber),
        crowd_(std::min(most_, query.too_many)),
        limit_(limit),
        found_(found),
        near_enough_(point_.plain(limit)),
        wait_(std::min(crowd_, kMaxCandidates)) {
    found.clear();
  }

  HWY_INLINE Collected collect() {
    LeafWalk(tree_, point_, near_enough_, *this);
    measure();
    return found_.size() >= query_.too_many ? Collected::too_many : result_;
  }

  // Of the walk: false ends it.
  bool operator()(std::span<const std::uint32_t> leaves) {
    const FloatPacket x(point_.at[0]), y(point_.at[1]), z(point_.at[2]);
    const FloatPacket tilt_x(point_.normal[0]), tilt_y(point_.normal[1]), tilt_z(point_.normal[2]);  // times 16
    const Words numbers = Words::load(kNumbers);
    // Not asked for again after each store.
    const PhotonPosition* const positions = query_.measure.positions;
    const std::uint32_t* const firsts = tree_.firsts().data();
    std::uint32_t* const to_index = index_;
    FloatPacket near(reach());
    std::size_t n = count_, enough = wait_;
    for (const std::uint32_t number : leaves) {
      const std::uint32_t first = firsts[number];
      const unsigned here = (1u << (firsts[number + 1] - first)) - 1;  // behind them are those of the next leaf
      _Pragma("GCC unroll 2") for (std::size_t i = 0; i < kAtOnce; i += kEight) {
        FloatPacket px, py, pz;
        load_positions(positions + first + i, px, py, pz);
        const FloatPacket dx = px - x, dy = py - y, dz = pz - z;
        FloatPacket squared = dx * dx + dy * dy + dz * dz;
        if (flat) squared = squared * (FloatPacket(1.0f) + abs(tilt_x * dx + tilt_y * dy + tilt_z * dz));
        const unsigned which = bits(squared <= near) & here >> i;
        pack(which, numbers + Words(first + static_cast<std::uint32_t>(i)), to_index + n);
        n += static_cast<std::size_t>(std::popcount(which));
      }
      if (n < enough) continue;
      count_ = n;
      measure();
      if (found_.size() >= query_.too_many) return false;
      if (found_.size() >= most_) drop_far_ones();
      near = FloatPacket(reach()), n = 0, enough = wait_ = std::min(crowd_ - found_.size(), kMaxCandidates);
    }
    count_ = n;
    return true;
  }

 private:
  static constexpr std::size_t kMaxCandidates = 512;

  float reach() const { return flat ? point_.flattened(limit_) : near_enough_; }

  // Candidates become photons that are found, if they are within the limit and not hidden.
  void measure() {
    store(index_ + count_, Words(0u));
    std::size_t n = found_.size();
    found_.make_room(n + count_);
    float* const squared = found_.squared_data();
    std::uint32_t* const index = found_.index_data();
    const Vec3 &c = center_.point, &normal = center_.normal;
    const Packet cx(c.x), cy(c.y), cz(c.z), nx(normal.x), ny(normal.y), nz(normal.z), limits(limit_);
    const float* const coordinates = query_.measure.positions->data();
    for (std::size_t i = 0; i < count_; i += kEight) {
      const Words here = Words::load(index_ + i), at = here + shift_left<1>(here);
      alignas(64) float position[3][kEight];
      for (std::size_t a = 0; a < 3; ++a) store(position[a], gather(coordinates + a, at));
      const Packet dx = to_doubles(position[0]) - cx, dy = to_doubles(position[1]) - cy,
                   dz = to_doubles(position[2]) - cz;
      Packet s = dx * dx + dy * dy + dz * dz;
      if (flat) s *= Packet(1.0) + Packet(16.0) * abs(nx * dx + ny * dy + nz * dz);  // else the factor is 1
      const unsigned which = bits(s < limits) & ((1u << std::min(count_ - i, kEight)) - 1);
      if (flat) s = min(s, Packet(3e38));  // rounded; without a normal none is so far, or it would be no candidate
      pack(which, to_floats(s), squared + n), pack(which, here, index + n);
      n += static_cast<std::size_t>(std::popcount(which));
    }
    found_.set_size(n), count_ = 0;
    if (query_.hiding) query_.hiding->planes.drop_hidden(query_.hiding->photons, c, query_.radius, looked_at_, found_);
    looked_at_ = found_.size();
  }

  void drop_far_ones() {
    keep_nearest(found_, query_.measure, query_.maximum, limit_, found_);
    near_enough_ = point_.plain(limit_), result_ = Collected::nearest;
    looked_at_ = found_.size();
  }

  const PhotonTree& tree_;
  const PhotonQuery& query_;
  const PhotonCenter center_;
  const FloatCenter point_;
  const std::size_t most_, crowd_;
  double& limit_;
  PhotonDistances& found_;
  float near_enough_;
  Collected result_ = Collected::all;
  std::size_t count_ = 0, wait_;
  std::size_t looked_at_ = 0;                          // those from here on may be hidden
  std::uint32_t index_[kMaxCandidates + 2 * kAtOnce];  // candidates
};

Collected collect(const PhotonTree& tree, const PhotonQuery& query, double& limit, PhotonDistances& found) {
  return query.measure.center.normal == Vec3(0.0) ? Collector<false>(tree, query, limit, found).collect()
                                                  : Collector<true>(tree, query, limit, found).collect();
}

std::size_t reaching(PhotonDistances& list, const PhotonOverhangs& overhangs, double radius, std::uint32_t* places) {
  constexpr double kRounding = 1e-6;
  const FloatPacket radii(static_cast<float>(radius * (1.0 - kRounding)));
  std::size_t found = 0;
  const std::size_t n = list.size();
  const float* const squared = list.squared().data();
  const std::uint32_t* const index = list.index().data();
  const Words numbers = Words::load(kNumbers);
  const FloatPacket least = radii - overhangs.largest();
  const FloatPacket least_squared = least * abs(least);
  for (std::size_t i = 0; i < n; i += kEight) {
    const auto left = static_cast<unsigned>(std::min(n - i, kEight));
    const FloatPacket distances = FloatPacket::load(squared + i);
    if (((bits(least_squared <= distances)) & ((1u << left) - 1)) == 0) continue;  // most of them
    const Words here = Words::load(index + i);  // behind the last one stands anything
    const FloatPacket over = overhang_of(overhangs, select(numbers < Words(left), here, Words(0u)));
    const FloatPacket rest = radii - over;
    const unsigned which = bits(rest * abs(rest) <= distances) & ((1u << left) - 1);
    pack(which, numbers + Words(static_cast<std::uint32_t>(i)), places + found);
    found += static_cast<std::size_t>(std::popcount(which));
  }
  return found;
}

constexpr PhotonKernels kKernels = {boxes, collect, keep_nearest, keep_within, reaching};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::global
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::global {
VERISIM_EXPORT_KERNELS(PhotonKernels, photon_kernels)
}  // namespace verisim::global
#endif
