// Packets: N numbers as one value, over as many of Highway's vectors as a target needs for them, so that a formula is
// written once for any target and, as a template, for one or eight numbers. Included once for each target by kernels
// (each_target.h). Every lane gets the bits of the plain operation: nothing is fused or reassociated.
#if defined(VERISIM_SIMD_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_SIMD_PACKET_INL_H
#undef VERISIM_SIMD_PACKET_INL_H
#else
#define VERISIM_SIMD_PACKET_INL_H
#endif

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hwy/highway.h"

// Of a lambda within kernels.
#undef VERISIM_INLINE_LAMBDA
#define VERISIM_INLINE_LAMBDA HWY_ATTR __attribute__((always_inline))

#undef VERISIM_X86_TARGET
#define VERISIM_X86_TARGET (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)

#define VERISIM_EACH_VECTOR HWY_UNROLL(8) for (int i = 0; i < kVectors; ++i)

HWY_BEFORE_NAMESPACE();
namespace verisim::simd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <int kBytes>
struct NumberOfBytes;
template <>
struct NumberOfBytes<4> {
  using type = float;
};
template <>
struct NumberOfBytes<8> {
  using type = double;
};

// Which lanes of packets of numbers of kBytes bytes are meant.
template <int kBytes, int N>
struct BasicMask {
  using T = typename NumberOfBytes<kBytes>::type;
  using D = hn::CappedTag<T, N>;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(D())), kVectors = N / kLanes;
  hn::Mask<D> v[kVectors];

#if HWY_ARCH_ARM  // the vectors have constructors there that set nothing: neither would BasicMask{}
  HWY_INLINE BasicMask() { VERISIM_EACH_VECTOR v[i] = hn::MaskFromVec(hn::Zero(D())); }
#endif
  static HWY_INLINE BasicMask all() {
    BasicMask r;
    VERISIM_EACH_VECTOR r.v[i] = hn::FirstN(D(), kLanes);
    return r;
  }
  // Lane k: bit k.
  static HWY_INLINE BasicMask of_bits(unsigned bits) {
    BasicMask r;
    VERISIM_EACH_VECTOR {
      const unsigned here = bits >> (i * kLanes);
      const std::uint8_t part[8] = {static_cast<std::uint8_t>(here), static_cast<std::uint8_t>(here >> 8)};
      r.v[i] = hn::LoadMaskBits(D(), part);
    }
    return r;
  }
  friend HWY_INLINE unsigned bits(const BasicMask& a) {
    unsigned result = 0;
    VERISIM_EACH_VECTOR {
      std::uint8_t part[8] = {};
      hn::StoreMaskBits(D(), a.v[i], part);
      result |= (part[0] | (kLanes > 8 ? static_cast<unsigned>(part[1]) << 8 : 0u)) << (i * kLanes);
    }
    return result;
  }

  friend HWY_INLINE BasicMask operator&(const BasicMask& a, const BasicMask& b) {
    BasicMask r;
    VERISIM_EACH_VECTOR r.v[i] = hn::And(a.v[i], b.v[i]);
    return r;
  }
  friend HWY_INLINE BasicMask operator|(const BasicMask& a, const BasicMask& b) {
    BasicMask r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Or(a.v[i], b.v[i]);
    return r;
  }
  friend HWY_INLINE BasicMask operator^(const BasicMask& a, const BasicMask& b) {
    BasicMask r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Xor(a.v[i], b.v[i]);
    return r;
  }
  friend HWY_INLINE BasicMask operator~(const BasicMask& a) {
    BasicMask r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Not(a.v[i]);
    return r;
  }
  friend HWY_INLINE BasicMask operator!(const BasicMask& a) { return ~a; }  // as of bool
  friend HWY_INLINE BasicMask& operator&=(BasicMask& a, const BasicMask& b) { return a = a & b; }
  friend HWY_INLINE BasicMask& operator|=(BasicMask& a, const BasicMask& b) { return a = a | b; }
  friend HWY_INLINE BasicMask select(const BasicMask& where, const BasicMask& a, const BasicMask& b) {
    return (where & a) | (~where & b);
  }
};

// N numbers of type T: double, float or std::int64_t.
template <class T, int N>
struct BasicPacket {
  using D = hn::CappedTag<T, N>;
  using Mask = BasicMask<sizeof(T), N>;
  static constexpr int kCount = N;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(D())), kVectors = N / kLanes;
  hn::Vec<D> v[kVectors];

#if HWY_ARCH_ARM  // as BasicMask's
  HWY_INLINE BasicPacket() : BasicPacket(T{}) {}
#else
  BasicPacket() = default;
#endif
  HWY_INLINE BasicPacket(T all) { VERISIM_EACH_VECTOR v[i] = hn::Set(D(), all); }
  // From and to N numbers in memory, aligned or not.
  static HWY_INLINE BasicPacket load(const T* p) {
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::LoadU(D(), p + i * kLanes);
    return r;
  }
  static HWY_INLINE BasicPacket load(const std::uint16_t* p) requires std::is_same_v<T, float> {
    const hn::Rebind<std::uint16_t, D> narrow;
    const hn::Rebind<std::int32_t, D> wide;
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::ConvertTo(D(), hn::PromoteTo(wide, hn::LoadU(narrow, p + i * kLanes)));
    return r;
  }
  friend HWY_INLINE void store(T* p, const BasicPacket& a) {
    VERISIM_EACH_VECTOR hn::StoreU(a.v[i], D(), p + i * kLanes);
  }
  HWY_INLINE T operator[](int k) const {
#if HWY_TARGET == HWY_SCALAR
    return v[k].raw;
#else
    if constexpr (std::is_floating_point_v<T>) return v[k / kLanes].raw[k % kLanes];  // in a register, of constants
    return hn::ExtractLane(v[k / kLanes], static_cast<std::size_t>(k % kLanes));
#endif
  }

#define VERISIM_OPERATOR(op, function)                                                    \
  friend HWY_INLINE BasicPacket operator op(const BasicPacket& a, const BasicPacket& b) { \
    BasicPacket r;                                                                        \
    VERISIM_EACH_VECTOR r.v[i] = hn::function(a.v[i], b.v[i]);                            \
    return r;                                                                             \
  }
  VERISIM_OPERATOR(+, Add)
  VERISIM_OPERATOR(-, Sub)
  VERISIM_OPERATOR(*, Mul)
  VERISIM_OPERATOR(/, Div)
  VERISIM_OPERATOR(&, And)
  VERISIM_OPERATOR(|, Or)
  VERISIM_OPERATOR(^, Xor)
#undef VERISIM_OPERATOR
#define VERISIM_OPERATOR(op, function)                                                             \
  friend HWY_INLINE Mask operator op(const BasicPacket& a, const BasicPacket& b) {                 \
    Mask r;                                                                                        \
    VERISIM_EACH_VECTOR r.v[i] = hn::RebindMask(typename Mask::D(), hn::function(a.v[i], b.v[i])); \
    return r;                                                                                      \
  }
  VERISIM_OPERATOR(<, Lt)
  VERISIM_OPERATOR(<=, Le)
  VERISIM_OPERATOR(>, Gt)
  VERISIM_OPERATOR(>=, Ge)
  VERISIM_OPERATOR(==, Eq)
#undef VERISIM_OPERATOR
  friend HWY_INLINE Mask operator!=(const BasicPacket& a, const BasicPacket& b) { return ~(a == b); }  // NaN differs
  friend HWY_INLINE BasicPacket operator-(const BasicPacket& a) {
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Neg(a.v[i]);
    return r;
  }
  friend HWY_INLINE BasicPacket& operator+=(BasicPacket& a, const BasicPacket& b) { return a = a + b; }
  friend HWY_INLINE BasicPacket& operator-=(BasicPacket& a, const BasicPacket& b) { return a = a - b; }
  friend HWY_INLINE BasicPacket& operator*=(BasicPacket& a, const BasicPacket& b) { return a = a * b; }
  friend HWY_INLINE BasicPacket& operator&=(BasicPacket& a, const BasicPacket& b) { return a = a & b; }

  // Lane by lane: where the mask is set a, elsewhere b.
  friend HWY_INLINE BasicPacket select(const Mask& where, const BasicPacket& a, const BasicPacket& b) {
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::IfThenElse(hn::RebindMask(D(), where.v[i]), a.v[i], b.v[i]);
    return r;
  }
  // As std::min and std::max, with NaN and with zeros of both signs, too: the first operand unless the other one is
  // less (greater).
  friend HWY_INLINE BasicPacket min(const BasicPacket& a, const BasicPacket& b) {
#if VERISIM_X86_TARGET
    BasicPacket r;  // the instruction gives its second operand where the comparison is false
    VERISIM_EACH_VECTOR r.v[i] = hn::Min(b.v[i], a.v[i]);
    return r;
#else
    return select(b < a, b, a);
#endif
  }
  friend HWY_INLINE BasicPacket max(const BasicPacket& a, const BasicPacket& b) {
#if VERISIM_X86_TARGET
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Max(b.v[i], a.v[i]);
    return r;
#else
    return select(a < b, b, a);
#endif
  }
  friend HWY_INLINE BasicPacket abs(const BasicPacket& a) {
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Abs(a.v[i]);
    return r;
  }
  // Towards zero.
  friend HWY_INLINE BasicPacket trunc(const BasicPacket& a) {
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Trunc(a.v[i]);
    return r;
  }
  friend HWY_INLINE BasicPacket sqrt(const BasicPacket& a) {
    BasicPacket r;
    VERISIM_EACH_VECTOR r.v[i] = hn::Sqrt(a.v[i]);
    return r;
  }
};

// One number: formulas that are templates over the width use it for a single ray.
template <int kBytes>
struct BasicMask<kBytes, 1> {
  bool v;
  static HWY_INLINE BasicMask all() { return {true}; }
  static HWY_INLINE BasicMask of_bits(unsigned bits) { return {(bits & 1) != 0}; }
  friend HWY_INLINE unsigned bits(const BasicMask& a) { return a.v; }
  friend HWY_INLINE BasicMask operator&(const BasicMask& a, const BasicMask& b) { return {a.v && b.v}; }
  friend HWY_INLINE BasicMask operator|(const BasicMask& a, const BasicMask& b) { return {a.v || b.v}; }
  friend HWY_INLINE BasicMask operator~(const BasicMask& a) { return {!a.v}; }
  friend HWY_INLINE BasicMask operator!(const BasicMask& a) { return {!a.v}; }
  friend HWY_INLINE BasicMask select(const BasicMask& where, const BasicMask& a, const BasicMask& b) {
    return where.v ? a : b;
  }
};
template <class T>
struct BasicPacket<T, 1> {
  using Mask = BasicMask<sizeof(T), 1>;
  static constexpr int kCount = 1;
  T v;

  BasicPacket() = default;
  HWY_INLINE BasicPacket(T number) : v(number) {}
  static HWY_INLINE BasicPacket load(const T* p) { return *p; }
  friend HWY_INLINE void store(T* p, const BasicPacket& a) { *p = a.v; }
  HWY_INLINE T operator[](int) const { return v; }

  friend HWY_INLINE BasicPacket operator+(const BasicPacket& a, const BasicPacket& b) { return a.v + b.v; }
  friend HWY_INLINE BasicPacket operator-(const BasicPacket& a, const BasicPacket& b) { return a.v - b.v; }
  friend HWY_INLINE BasicPacket operator*(const BasicPacket& a, const BasicPacket& b) { return a.v * b.v; }
  friend HWY_INLINE BasicPacket operator/(const BasicPacket& a, const BasicPacket& b) { return a.v / b.v; }
  friend HWY_INLINE BasicPacket operator-(const BasicPacket& a) { return -a.v; }
  friend HWY_INLINE Mask operator<(const BasicPacket& a, const BasicPacket& b) { return {a.v < b.v}; }
  friend HWY_INLINE Mask operator<=(const BasicPacket& a, const BasicPacket& b) { return {a.v <= b.v}; }
  friend HWY_INLINE Mask operator>(const BasicPacket& a, const BasicPacket& b) { return {a.v > b.v}; }
  friend HWY_INLINE Mask operator>=(const BasicPacket& a, const BasicPacket& b) { return {a.v >= b.v}; }
  friend HWY_INLINE Mask operator!=(const BasicPacket& a, const BasicPacket& b) { return {a.v != b.v}; }
  friend HWY_INLINE BasicPacket select(const Mask& where, const BasicPacket& a, const BasicPacket& b) {
    return where.v ? a : b;
  }
  friend HWY_INLINE BasicPacket min(const BasicPacket& a, const BasicPacket& b) { return b.v < a.v ? b : a; }
  friend HWY_INLINE BasicPacket max(const BasicPacket& a, const BasicPacket& b) { return a.v < b.v ? b : a; }
  friend HWY_INLINE BasicPacket abs(const BasicPacket& a) { return std::fabs(a.v); }
  friend HWY_INLINE BasicPacket sqrt(const BasicPacket& a) { return std::sqrt(a.v); }
};

template <int kBytes, int N>
HWY_INLINE bool any(const BasicMask<kBytes, N>& a) {
  return bits(a) != 0;
}

// Of N or, mostly, of eight doubles; integers have as many lanes, and masks serve both.
template <int N>
using PacketOf = BasicPacket<double, N>;
template <int N>
using IntPacketOf = BasicPacket<std::int64_t, N>;
template <int N>
using MaskOf = BasicMask<8, N>;
// Integers for the lanes of a packet of doubles.
template <class P>
using IntsFor = IntPacketOf<P::kCount>;
constexpr int kLanes = 8;
using Packet = PacketOf<kLanes>;
using IntPacket = IntPacketOf<kLanes>;
using Mask = MaskOf<kLanes>;

using FloatPacket = BasicPacket<float, kLanes>;

HWY_INLINE Packet load(const double* p) { return Packet::load(p); }
HWY_INLINE IntPacket load(const std::int64_t* p) { return IntPacket::load(p); }

template <int k, class T, int N>
HWY_INLINE BasicPacket<T, N> shift_left(const BasicPacket<T, N>& a) {
  constexpr int kVectors = BasicPacket<T, N>::kVectors;
  BasicPacket<T, N> r;
  VERISIM_EACH_VECTOR r.v[i] = hn::ShiftLeft<k>(a.v[i]);
  return r;
}
// The sign moves in.
template <int k, class T, int N>
HWY_INLINE BasicPacket<T, N> shift_right(const BasicPacket<T, N>& a) {
  constexpr int kVectors = BasicPacket<T, N>::kVectors;
  BasicPacket<T, N> r;
  VERISIM_EACH_VECTOR r.v[i] = hn::ShiftRight<k>(a.v[i]);
  return r;
}

// Writes the lanes whose bits are set side by side, in their order; numbers behind them, N in all, are written over.
template <class T, int N>
HWY_INLINE void compress(unsigned which, const BasicPacket<T, N>& a, T* to) {
  using P = BasicPacket<T, N>;
  constexpr int kVectors = P::kVectors;
  VERISIM_EACH_VECTOR {
    const std::uint8_t here[8] = {static_cast<std::uint8_t>(which >> (i * P::kLanes) & ((1u << P::kLanes) - 1))};
    hn::StoreU(hn::CompressBits(a.v[i], here), typename P::D(), to);
    to += std::popcount(here[0]);
  }
}

// from[index[k]] in lane k; the index is below 2^31.
template <class T, class I, int N>
HWY_INLINE BasicPacket<T, N> gather(const T* from, const BasicPacket<I, N>& index) {
  using P = BasicPacket<T, N>;
  constexpr int kVectors = P::kVectors;
  const hn::RebindToSigned<typename P::D> places;
  P r;
  VERISIM_EACH_VECTOR r.v[i] = hn::GatherIndex(typename P::D(), from, hn::BitCast(places, index.v[i]));
  return r;
}

// The same for the lanes of a mask, elsewhere zero. There is a from[0].
template <class T, class I, int N>
HWY_INLINE BasicPacket<T, N> gather(const T* from, const BasicPacket<I, N>& index,
                                    const BasicMask<sizeof(T), N>& where) {
  return select(where, gather(from, select(where, index, BasicPacket<I, N>(I{0}))), BasicPacket<T, N>(T{0}));
}
template <class T, class I, int N>
HWY_INLINE void scatter(T* to, const BasicPacket<I, N>& index, const BasicPacket<T, N>& a) {
  using P = BasicPacket<T, N>;
  constexpr int kVectors = P::kVectors;
  const hn::RebindToSigned<typename P::D> places;
  VERISIM_EACH_VECTOR hn::ScatterIndex(a.v[i], typename P::D(), to, hn::BitCast(places, index.v[i]));
}

// Rounded to single precision, and without loss back.
HWY_INLINE FloatPacket to_floats(const Packet& a) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128  // their DemoteTo makes the largest float of larger numbers
  double doubles[kLanes];
  float floats[kLanes];
  store(doubles, a);
  for (int k = 0; k < kLanes; ++k) floats[k] = static_cast<float>(doubles[k]);
  return FloatPacket::load(floats);
#else
  constexpr int kVectors = FloatPacket::kVectors;
  const hn::Rebind<float, Packet::D> part;  // as many as doubles are in a vector
  FloatPacket r;
#if HWY_TARGET == HWY_AVX3
  VERISIM_EACH_VECTOR r.v[i] = hn::DemoteTo(part, a.v[i]);
#else  // put together in a register: halves that are written to memory and read whole are waited for
  VERISIM_EACH_VECTOR r.v[i] =
      hn::Combine(FloatPacket::D(), hn::DemoteTo(part, a.v[2 * i + 1]), hn::DemoteTo(part, a.v[2 * i]));
#endif
  return r;
#endif
}
HWY_INLINE Packet to_doubles(const float* p) {
  constexpr int kVectors = Packet::kVectors;
  const hn::Rebind<float, Packet::D> part;
  Packet r;
  VERISIM_EACH_VECTOR r.v[i] = hn::PromoteTo(Packet::D(), hn::LoadU(part, p + i * Packet::kLanes));
  return r;
}

// Masks in memory: all bits of a lane or none.
HWY_INLINE Mask load_mask(const std::int64_t* p) {
  constexpr int kVectors = Mask::kVectors;
  Mask r;
  VERISIM_EACH_VECTOR r.v[i] =
      hn::RebindMask(Mask::D(), hn::MaskFromVec(hn::LoadU(IntPacket::D(), p + i * Mask::kLanes)));
  return r;
}
HWY_INLINE void store_mask(std::int64_t* p, const Mask& a) {
  constexpr int kVectors = Mask::kVectors;
  VERISIM_EACH_VECTOR hn::StoreU(hn::VecFromMask(IntPacket::D(), hn::RebindMask(IntPacket::D(), a.v[i])),
                                 IntPacket::D(), p + i * Mask::kLanes);
}

// The bits of doubles as integers, and back.
template <int N>
HWY_INLINE IntPacketOf<N> bits_of(const PacketOf<N>& a) {
  constexpr int kVectors = PacketOf<N>::kVectors;
  IntPacketOf<N> r;
  VERISIM_EACH_VECTOR r.v[i] = hn::BitCast(typename IntPacketOf<N>::D(), a.v[i]);
  return r;
}
template <int N>
HWY_INLINE PacketOf<N> number_of(const IntPacketOf<N>& a) {
  constexpr int kVectors = PacketOf<N>::kVectors;
  PacketOf<N> r;
  VERISIM_EACH_VECTOR r.v[i] = hn::BitCast(typename PacketOf<N>::D(), a.v[i]);
  return r;
}

}  // namespace HWY_NAMESPACE
}  // namespace verisim::simd
HWY_AFTER_NAMESPACE();

#endif
