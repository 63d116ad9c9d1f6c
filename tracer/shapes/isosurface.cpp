// isosurface (spec 04 section 6). The search bisects dyadically and prunes by max_gradient exactly as POV-Ray's: where max_gradient is too small, which is
// common, the picture depends on every step.
#include <atomic>
#include <cmath>

#include "tracer/functions/function.h"
#include "tracer/shapes/container.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

namespace {

constexpr double kFarthest = 2e10;
constexpr int kMaxDepth = 62;  // halvings after which floating point has no finer steps

class Isosurface final : public Primitive<Isosurface> {
 public:
  Isosurface(const scene::Object& description, const scene::Isosurface& s)
      : Primitive(description, {container_box(s.container), true}), surface_(s), max_gradient_(s.max_gradient) {
    max_trace_ = s.max_trace <= 0 || s.max_trace > 10 ? 10 : s.max_trace;
  }

  template <class Sink>
  void crossings(const Ray& ray, Sink& sink) const {
    Search search{*this, ray.origin, ray.direction, 0, 1, max_gradient_};
    if (has_matrix()) search.origin = matrix().inverse_point(ray.origin), search.direction = matrix().inverse_direction(ray.direction);
    search.speed = length(search.direction);
    if (surface_.evaluate) search.gradient = adapted_gradient_.load(std::memory_order_relaxed);
    trace(ray, search, sink);
    if (surface_.evaluate) raise_gradient(search.gradient);
  }

  bool contains(const Vec3& p) const {
    const Vec3 q = local(p);
    return in_container(surface_.container, q) && !(value(q) - surface_.threshold > 0);
  }

  Vec3 raw_normal(const Hit& hit) const {
    const Vec3 p = local(hit.point);
    if (hit.part > 0) return world_normal(container_normal(surface_.container, hit.part, p));
    const auto& container = surface_.container;
    if (container.sphere && std::fabs(length(p - container.center) - container.radius) < kEpsilon) {
      return world_normal(container_normal(container, 7, p));
    }
    const double a = surface_.accuracy;
    const double f = value(p);
    const Vec3 gradient(value({p.x + a, p.y, p.z}) - f, value({p.x, p.y + a, p.z}) - f, value({p.x, p.y, p.z + a}) - f);
    if (gradient.x == 0 && gradient.y == 0 && gradient.z == 0) return world_normal({1, 0, 0});
    return world_normal(normalize(gradient));
  }

 private:
  // One ray in object space; the direction is not normalised.
  struct Search {
    const Isosurface& shape;
    Vec3 origin, direction;
    double speed;     // length of the direction
    double sign;      // of the crossing that is looked for
    double gradient;  // the max_gradient in force

    double known_t[2] = {-1, -1}, known[2] = {0, 0};  // the last values given by end_field
    int oldest = 0;

    // f - threshold at distance t.
    double field(double t) const { return shape.value(origin + t * direction) - shape.surface_.threshold; }
    // The same at the ends of a search, which are asked for again and again.
    double end_field(double t) {
      for (int k = 0; k < 2; ++k)
        if (known_t[k] == t) return known[k];
      const int at = oldest;
      oldest ^= 1;
      known_t[at] = t;
      return known[at] = field(t);
    }
    bool find(double begin, double end, double& t);
    double adapted(double slope, double value0, double value1, double width);
  };

  double value(const Vec3& p) const {
    const double arguments[3] = {p.x, p.y, p.z};
    double result;
    surface_.function->evaluate(arguments, &result);
    return result;
  }

  template <class Sink>
  void trace(const Ray& ray, Search& search, Sink& sink) const;

  void raise_gradient(double g) const {
    double known = adapted_gradient_.load(std::memory_order_relaxed);
    while (g > known && !adapted_gradient_.compare_exchange_weak(known, g, std::memory_order_relaxed)) {
    }
  }

  scene::Isosurface surface_;
  double max_gradient_;
  int max_trace_;
  // `evaluate`: the largest slope any ray needed so far (spec 04 6.4).
  mutable std::atomic<double> adapted_gradient_{surface_.max_gradient};
};

template <class Sink>
void Isosurface::trace(const Ray& ray, Search& search, Sink& sink) const {
  ContainerSpan span;
  if (!intersect_container(surface_.container, search.origin, search.direction, span)) return;
  const double a = surface_.accuracy, gap = 5 * a, near_zero = 4 * search.gradient * a;
  double begin = std::max(span.enter, 0.0), end = span.leave;
  const auto report = [&](double t, int face) { return sink.add(t, [&] { return ray.at(t); }, face); };
  const auto start_behind_surface = [&] {
    begin = gap;
    if (search.end_field(gap) < 0) search.sign = -1;
  };

  int remaining = max_trace_;
  double wall = -1;  // a hit on the container
  int wall_face = 0;
  if (!surface_.open) {
    if (begin > a) {
      // Cut away, it is as if the wall had not been met: it uses up none of the hits either.
      if (search.end_field(begin) < 0 && !sink.clipped(ray.at(begin))) {
        --remaining;
        wall = begin, wall_face = span.enter_face, search.sign = -1;
      }
    } else {
      if (search.end_field(begin) < near_zero) start_behind_surface();
      if (search.end_field(end) < 0) wall = end, wall_face = span.leave_face;
    }
  }
  end = std::min(end, kFarthest);
  if (!(end - begin >= a)) return;
  if (wall >= 0 && report(wall, wall_face) && Sink::kNearest && wall == begin) return;
  if (begin < a && search.sign > 0 && std::fabs(search.end_field(begin)) < near_zero) start_behind_surface();

  while (remaining-- > 0) {
    double t;
    if (!search.find(begin, end, t)) return;
    if (report(t, 0) && Sink::kNearest) return;
    begin = t + gap;
    if (end - begin < a || (Sink::kNearest && begin > sink.upper())) return;
    search.sign = -search.sign;
  }
}

// The slope bound for a node, raised by `evaluate` where the function proves steeper.
double Isosurface::Search::adapted(double slope, double value0, double value1, double width) {
  if (!shape.surface_.evaluate) return slope;
  const double factor = shape.surface_.evaluate->y;
  const double estimate = std::fabs(value1 - value0) / (speed * width);
  if (gradient < estimate * factor) gradient = slope = estimate * factor * factor;
  return slope;
}

// The first leaf of the dyadic bisection of [begin, end] whose far end is negative (spec 04 6.2).
bool Isosurface::Search::find(double begin, double end, double& t) {
  if (const auto& evaluate = shape.surface_.evaluate; evaluate && gradient > evaluate->x) gradient *= evaluate->z;
  double h0 = sign * end_field(begin);
  if (shape.surface_.open && h0 < 0) sign = -sign, h0 = -h0;
  const double h1 = sign * end_field(end), accuracy = shape.surface_.accuracy;

  struct Node {
    double begin, width, value0, value1, slope;
    int depth;
  };
  Node waiting[kMaxDepth + 1];  // right halves
  int count = 0;
  Node node{begin, end - begin, h0, h1, gradient, 0};
  for (;;) {
    bool split = false;
    const double slope = adapted(node.slope, node.value0, node.value1, node.width);
    if (node.width < accuracy || node.depth == kMaxDepth) {
      if (node.value1 < 0) {
        t = node.begin + node.width;
        return true;
      }
    } else if (node.value0 + node.value1 < slope * speed * node.width) {
      split = true;
    }
    if (split) {
      const double half = node.width / 2, middle = node.begin + half, value = sign * field(middle);
      waiting[count++] = {middle, half, value, node.value1, slope, node.depth + 1};
      node = {node.begin, half, node.value0, value, slope, node.depth + 1};
    } else {
      if (count == 0) return false;
      node = waiting[--count];
    }
  }
}

}  // namespace

std::unique_ptr<Shape> compile_isosurface(const scene::Object& object) {
  return std::make_unique<Isosurface>(object, **object.as<std::shared_ptr<const scene::Isosurface>>());
}
Box3 isosurface_box(const scene::Isosurface& isosurface) { return container_box(isosurface.container); }

}  // namespace verisim::shapes
