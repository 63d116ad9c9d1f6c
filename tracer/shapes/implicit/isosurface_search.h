// The search of one ray for the intersections of an isosurface. It bisects dyadically and prunes by max_gradient
// exactly as POV-Ray's: where max_gradient is too small, which is common, the picture depends on every step. But steps
// need not know values better than they ask for them.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>

#include "tracer/functions/narrowing.h"
#include "tracer/scene/object.h"
#include "tracer/shapes/implicit/last_miss.h"

namespace verisim::shapes {

struct IsosurfaceField {
  const scene::Isosurface& surface;
  std::unique_ptr<const functions::Narrowing> narrowing;  // null: values are computed as they are

  double value(const Vec3& p) const {
    const double arguments[3] = {p.x, p.y, p.z};
    double result;
    surface.function->evaluate(arguments, &result);
    return result;
  }
};

// What a search knows of a value of the field: the value.
struct ExactValue {
  struct Workspace {
    explicit Workspace(const IsosurfaceField&) {}
  };
  double v;

  ExactValue() = default;
  template <class Search>
  ExactValue(const Search& search, double t, double sign = 1) : v(sign * search.exact(t)) {}
  ExactValue times(double sign) const { return ExactValue(sign * v); }
  static double least_slope(double /*steepest_known*/) { return 0; }

  template <class Search>
  bool below(const Search&, double limit) const {
    return v < limit;
  }
  template <class Search>
  bool near_zero(const Search&, double limit) const {
    return std::fabs(v) < limit;
  }
  template <class Search>
  static bool sum_below(const Search&, const ExactValue& a, const ExactValue& b, double limit) {
    return a.v + b.v < limit;
  }
  template <class Search>
  static void find_rise(const Search&, const ExactValue& a, const ExactValue& b, double width, double& largest) {
    if (const double rise = std::fabs(b.v - a.v); rise > largest * width) largest = rise / width;
  }

 private:
  explicit ExactValue(double value) : v(value) {}
};
// Or bounds of it, which come closer until they tell what is asked.
struct BoundedValue {
  struct Workspace {
    explicit Workspace(const IsosurfaceField& field) : values(*field.narrowing) {}
    functions::Narrowing::Workspace values;
  };
  double low, high, sign;
  functions::Narrowing::Value value;

  BoundedValue() = default;
  template <class Search>
  BoundedValue(const Search& search, double t, double of_sign = 1) : sign(of_sign) {
    search.field.narrowing->begin(search.at(t), value, search.workspace.values);
    set(search);
  }
  BoundedValue times(double by) const {
    BoundedValue other = *this;
    other.sign *= by;
    if (by < 0) other.low = -high, other.high = -low;
    return other;
  }
  // What is less steep does not matter; what is told from bounds may be a little steeper than it is.
  static double least_slope(double steepest_known) { return steepest_known * (1 - 1e-12); }

  template <class Search>
  bool below(const Search& search, double limit) {
    while (!(high < limit)) {
      if (low >= limit || !narrow(search)) return false;
    }
    return true;
  }
  template <class Search>
  bool near_zero(const Search& search, double limit) {
    return below(search, limit) && times(-1).below(search, limit);
  }
  template <class Search>
  static bool sum_below(const Search& search, BoundedValue& a, BoundedValue& b, double limit) {
    while (!(a.high + b.high < limit)) {
      if (a.low + b.low >= limit || !narrow(search, a, b)) return false;
    }
    return true;
  }
  template <class Search>
  static void find_rise(const Search& search, BoundedValue& a, BoundedValue& b, double width, double& largest) {
    const auto most = [&] { return std::max(std::fabs(b.high - a.low), std::fabs(b.low - a.high)); };
    while (most() > largest * width) {
      if (narrow(search, a, b)) continue;
      largest = most() / width;
      return;
    }
  }

 private:
  template <class Search>
  void set(const Search& search) {
    const double threshold = search.field.surface.threshold, a = value.bounds.low - threshold,
                 b = value.bounds.high - threshold;
    low = sign < 0 ? -b : a, high = sign < 0 ? -a : b;
  }
  template <class Search>
  bool narrow(const Search& search) {
    if (!search.field.narrowing->narrow(value, search.workspace.values)) return false;
    set(search);
    return true;
  }
  // The one that is known less well.
  template <class Search>
  static bool narrow(const Search& search, BoundedValue& a, BoundedValue& b) {
    return a.high - a.low >= b.high - b.low ? a.narrow(search) || b.narrow(search)
                                            : b.narrow(search) || a.narrow(search);
  }
};

// One ray in object space; the direction is not normalised. Value: ExactValue or BoundedValue.
template <class Value>
struct IsosurfaceSearch {
  const IsosurfaceField& field;
  Vec3 origin, direction;
  double speed;           // length of the direction
  double sign;            // of the intersection that is looked for
  double gradient;        // the max_gradient in force
  double steepest_known;  // of any ray
  std::uint64_t number;   // of the isosurface
  LastMiss* memory;       // null: the order of searches does not count
  double steepest = 0;    // slope between the ends of any node

  double known_t[2] = {-1, -1};  // the last values given by end_field
  Value known[2] = {};
  int oldest = 0;
  mutable typename Value::Workspace workspace{field};

  Vec3 at(double t) const { return origin + t * direction; }
  // f - threshold at distance t.
  double exact(double t) const { return field.value(at(t)) - field.surface.threshold; }
  // The same at the ends of a search, which are asked for again and again.
  Value& end_field(double t) {
    for (int k = 0; k < 2; ++k)
      if (known_t[k] == t) return known[k];
    const int to = oldest;
    oldest ^= 1;
    known_t[to] = t;
    return known[to] = Value(*this, t);
  }
  bool below(double t, double limit) { return end_field(t).below(*this, limit); }
  bool find(double begin, double end, double& t);
  double adapted(double slope, const Value& value0, const Value& value1, double width);
};

// The slope bound for a node, raised by `evaluate` where the function proves steeper.
template <class Value>
double IsosurfaceSearch<Value>::adapted(double slope, [[maybe_unused]] const Value& value0,
                                        [[maybe_unused]] const Value& value1, [[maybe_unused]] double width) {
  if constexpr (std::is_same_v<Value, ExactValue>) {
    if (!field.surface.evaluate) return slope;
    const double factor = field.surface.evaluate->y;
    const double estimate = std::fabs(value1.v - value0.v) / (speed * width);
    if (gradient < estimate * factor) gradient = slope = estimate * factor * factor;
  }
  return slope;
}

// The first leaf of the dyadic bisection of [begin, end] whose far end is negative (spec 04 6.2).
template <class Value>
bool IsosurfaceSearch<Value>::find(double begin, double end, double& t) {
  if (memory && memory->spares(number, at(begin), at(end), gradient)) return false;
  if (memory) memory->forget();
  if (const auto& evaluate = field.surface.evaluate; evaluate && gradient > evaluate->x) gradient *= evaluate->z;
  Value value0 = end_field(begin).times(sign);
  const Value first = value0;
  if (field.surface.open && value0.below(*this, 0)) sign = -sign, value0 = value0.times(-1);
  const double accuracy = field.surface.accuracy;

  constexpr int kMaxDepth = 62;  // halvings after which floating point has no finer steps
  struct Node {
    double begin, end, width, slope;  // the end is that of a node above, not begin + width
    int depth;
  };
  double largest = Value::least_slope(steepest_known) * speed;  // change of the function over a node, for its width
  double least = 0;                                             // of all values
  const auto seen = [&]([[maybe_unused]] const Value& value) {
    if constexpr (std::is_same_v<Value, ExactValue>) least = std::min(least, value.v);
  };
  const auto ended = [&](bool found) {
    if (largest > steepest * speed) steepest = largest / speed;
    // What a hit or a shadow ray leaves does not count for its own rays, but takes the place of what others left.
    if (memory) memory->keep(found || memory->shadow_ray ? 0 : number, at(begin), at(end), least);
    return found;
  };
  // Right halves; the value where the node ends that is above count of them.
  Node waiting[kMaxDepth + 1];
  Value ends[kMaxDepth + 2];
  int count = 0;
  ends[0] = end_field(end).times(sign);
  if constexpr (std::is_same_v<Value, ExactValue>) least = std::min(first.v, ends[0].v);
  Node node{begin, end, end - begin, gradient, 0};
  for (;;) {
    bool split = false;
    Value& value1 = ends[count];
    Value::find_rise(*this, value0, value1, node.width, largest);
    const double slope = adapted(node.slope, value0, value1, node.width);
    if (node.width < accuracy || node.depth == kMaxDepth) {
      if (value1.below(*this, 0)) {
        t = node.end;
        return ended(true);
      }
    } else if (Value::sum_below(*this, value0, value1, slope * speed * node.width)) {
      split = true;
    }
    if (split) {
      const double half = node.width / 2, middle = node.begin + half;
      waiting[count] = {middle, node.end, half, slope, node.depth + 1};
      ends[++count] = Value(*this, middle, sign);
      seen(ends[count]);
      node = {node.begin, middle, half, slope, node.depth + 1};
    } else {
      if (count == 0) return ended(false);
      value0 = ends[count];
      node = waiting[--count];
    }
  }
}

}  // namespace verisim::shapes
