// What the parser does to an object while it reads it: boxes, transformations with POV-Ray's absorption rules,
// inversion, copies (spec 03 1, 5.1, 6).
#include "tracer/scene/object.h"

#include <algorithm>

#include "tracer/scene/bounds.h"
#include "tracer/scene/complement.h"
#include "tracer/scene/copy_on_write.h"
#include "tracer/scene/transform_steps.h"
#include "tracer/scene/extents.h"

namespace verisim::scene {
namespace {

template <class T>
constexpr bool names_fields() {
  if constexpr (HasFields<T>)
    return names_all_fields<T>();
  else
    return true;
}
#define VERISIM_SHAPE(held, name) static_assert(names_fields<held>(), "fields() leaves out a number of this shape");
VERISIM_SHAPES(VERISIM_SHAPE)
#undef VERISIM_SHAPE
static_assert(names_fields<Quadric>());

using Step = TransformStep::Step;

// a, then a translation: the digits of the product of the matrices, without its many terms that are zero.
Transform then_translated(const Transform& a, const Vec3& v) {
  Transform result = a;
  for (int k = 0; k < 3; ++k) {
    result.m[3][k] += v[k];
    result.inv[3][k] = -v.x * a.inv[0][k] + -v.y * a.inv[1][k] + -v.z * a.inv[2][k] + a.inv[3][k];
  }
  return result;
}

bool absorb(Sphere& s, const TransformStep& move) {
  if (move.step == Step::translate)
    s.center += move.v;
  else if (move.step == Step::rotate)
    s.center = move.t.point(s.center);
  else if (move.uniform_scale())
    s.center *= move.v.x, s.radius *= std::fabs(move.v.x);
  else
    return false;
  return true;
}

bool absorb(Box& b, const TransformStep& move) {
  if (move.step == Step::translate) {
    b.low += move.v, b.high += move.v;
  } else if (move.step == Step::scale) {
    b.low = b.low * move.v, b.high = b.high * move.v;
    for (int i = 0; i < 3; ++i)
      if (b.low[i] > b.high[i]) std::swap(b.low[i], b.high[i]);
  } else {
    return false;
  }
  return true;
}

bool absorb(Plane& p, const TransformStep& move) {
  if (move.step == Step::translate) {
    p.distance += dot(p.normal, move.v);
  } else if (move.step == Step::rotate) {
    p.normal = move.t.direction(p.normal);
  } else if (move.step == Step::scale) {
    p.normal = p.normal / move.v;
    const double len = length(p.normal);
    p.normal = p.normal * (1.0 / len);
    p.distance /= len;
  } else {
    return false;
  }
  return true;
}

// The order in which a triangle is kept: its first two corners are exchanged when it runs clockwise in the projection
// of its containment test (spec 03 4.7). The plane's normal is computed anew from that order at every transformation.
template <class Corner>
void exchange_if_clockwise(std::array<Vec3, 3>& p, const Corner& exchange) {
  const Vec3 n = cross(p[0] - p[1], p[2] - p[1]);
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  int i = 0, j = 1;  // the two axes other than the dominant one
  if (x > y && x > z)
    i = 1, j = 2;
  else if (!(x > y) && y > z)
    i = 0, j = 2;
  if ((p[1][i] - p[2][i]) * (p[1][j] - p[0][j]) < (p[1][j] - p[2][j]) * (p[1][i] - p[0][i])) {
    std::swap(p[0], p[1]);
    exchange();
  }
}

bool absorb(Triangle& triangle, const TransformStep& move) {
  exchange_if_clockwise(triangle.p, [] {});
  for (Vec3& p : triangle.p) p = move.t.point(p);
  return true;
}

bool absorb(Boxed<SmoothTriangle>& smooth, const TransformStep& move) {
  SmoothTriangle& triangle = *smooth;
  exchange_if_clockwise(triangle.p, [&] { std::swap(triangle.n[0], triangle.n[1]); });
  for (Vec3& p : triangle.p) p = move.t.point(p);
  if (move.step == Step::translate) return true;
  for (Vec3& n : triangle.n) {
    n = move.step == Step::scale ? n / move.v : move.t.normal(n);
    if (move.step == Step::scale) n = normalize(n);
  }
  return true;
}

// p Q p' = 0 with p = p' M^-1 becomes M^-1 Q M^-T. Q has the mixed and linear terms above the diagonal, as POV-Ray's
// has: halves on both sides give other last bits.
bool absorb(Boxed<Quadric>& quadric, const TransformStep& move) {
  Quadric& q = *quadric;
  Mat4 a;
  a[0][0] = q.square.x, a[1][1] = q.square.y, a[2][2] = q.square.z, a[3][3] = q.constant;
  a[0][1] = q.mixed.x, a[0][2] = q.mixed.y, a[1][2] = q.mixed.z;
  for (int i = 0; i < 3; ++i) a[i][3] = q.linear[i];
  const Mat4 inverse = move.t.inv.whole(), b = inverse * a * inverse.transposed();
  q.square = {b[0][0], b[1][1], b[2][2]};
  q.mixed = {b[0][1] + b[1][0], b[0][2] + b[2][0], b[1][2] + b[2][1]};
  q.linear = {b[0][3] + b[3][0], b[1][3] + b[3][1], b[2][3] + b[3][2]};
  q.constant = b[3][3];
  return true;
}

bool absorb(std::shared_ptr<const SphereSweep>& sweep, const TransformStep& move) {
  if (move.step == Step::matrix || (move.step == Step::scale && !move.uniform_scale())) return false;
  auto moved = std::make_shared<SphereSweep>(*sweep);
  for (Vec3& c : moved->centers) c = move.t.point(c);
  if (move.step == Step::scale)
    for (double& r : moved->radii) r *= move.v.x;  // a negative scale makes the object vanish, as in POV-Ray
  sweep = std::move(moved);
  return true;
}

bool absorb(std::shared_ptr<const BicubicPatch>& patch, const TransformStep& move) {
  auto moved = std::make_shared<BicubicPatch>(*patch);
  for (Vec3& p : moved->points) p = move.t.point(p);
  patch = std::move(moved);
  return true;
}

template <class T>
bool absorb(T&, const TransformStep&) {
  return false;
}

void move_light(LightSource& light, const TransformSteps& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Transform& t = steps[i].t;
    light.position = t.point(light.position);
    light.point_at = t.point(light.point_at);
    if (light.direction != Vec3(0)) light.direction = normalize(t.direction(light.direction));
    light.axis1 = t.direction(light.axis1);
    light.axis2 = t.direction(light.axis2);
  }
  if (light.looks_like) apply(writable(light.looks_like), steps);
  if (light.projected_through) apply(writable(light.projected_through), steps);
}

DensityPtr transformed(const DensityPtr& density, Transforms steps) {
  auto moved = std::make_shared<Density>(*density);
  moved->pattern.prepend(steps);
  return moved;
}

InteriorPtr transformed(const InteriorPtr& interior, Transforms steps) {
  const auto has_density = [](const Media& m) { return !m.densities.empty(); };
  if (!interior || std::none_of(interior->media.begin(), interior->media.end(), has_density)) return interior;
  auto moved = std::make_shared<Interior>(*interior);
  for (Media& media : moved->media)
    for (DensityPtr& density : media.densities) density = transformed(density, steps);
  return moved;
}

// The present box of shapes whose box POV-Ray transforms step by step; all others get it anew from their numbers and
// the total matrix (spec 03 2.2).
bool box_steps(const Object& object) {
  return object.as<Csg>() || object.as<LightGroup>() || object.as<Quadric>() ||
         object.as<std::shared_ptr<const Blob>>() || object.as<Mesh>() || object.as<std::shared_ptr<const Text>>();
}

Bounds polygon_padded(const Bounds& b) {
  Vec3 low = low_corner(b), high = high_corner(b);
  for (int i = 0; i < 3; ++i)
    if (b.size[i] < 0.001f) low[i] -= 0.001, high[i] += 0.001;
  return make_bounds(low, high);
}

// Of the moved points, not of a moved box.
Bounds polygon_bounds(const Polygon& polygon, const Object& object) {
  Box3 box;
  const Transform frame = shapes::polygon_frame(polygon);
  for (const Vec3& p : polygon.points)
    box.extendBy(object.transform ? object.transform->point(frame.inverse_point(p)) : p);
  return polygon_padded(make_bounds(box.min, box.max));
}

Bounds bounds_from_numbers(const Object& object) {
  if (const Polygon* polygon = object.as<Polygon>()) return polygon_bounds(*polygon, object);
  const Bounds local = local_bounds(object);
  // The box of a text is that of its frame already.
  const bool fixed = object.as<Plane>() || object.as<Poly>() || object.as<std::shared_ptr<const Text>>();
  return object.transform && !fixed ? transformed(local, *object.transform) : local;
}

// Clips that were added since the box of a quadric was last computed count before the next transformation.
void refit_clipped_quadric(Object& object) {
  if (!object.as<Quadric>() || object.clips_in_bounds == object.clipped_by.size()) return;
  object.clips_in_bounds = static_cast<std::uint32_t>(object.clipped_by.size());
  fit_quadric(object, {});
}

void move_guards(Object& object, const TransformSteps& steps) {
  if (object.clip_is_bound) {
    List<ObjectPtr>& source = object.clipped_by.empty() ? object.bounded_by : object.clipped_by;
    List<ObjectPtr>& link = object.clipped_by.empty() ? object.clipped_by : object.bounded_by;
    link.clear();
    for (ObjectPtr& o : source) apply(writable(o), steps);
    link = source;
    return;
  }
  for (ObjectPtr& o : object.bounded_by) apply(writable(o), steps);
  for (ObjectPtr& o : object.clipped_by) apply(writable(o), steps);
}

void move_shape(Object& object, const TransformSteps& steps) {
  if (auto* csg = std::get_if<Csg>(&object.shape)) {
    if (csg->children.shared() || csg->children.postponed()) return csg->children.postpone(steps);
    for (ObjectPtr& child : own_children(object)) apply(writable(child), steps);
  } else if (object.as<LightGroup>()) {
    for (ObjectPtr& child : own_children(object)) apply(writable(child), steps);
  } else if (auto* light = object.as<LightSource>()) {
    move_light(*light, steps);
  } else {
    std::size_t i = 0;
    if (!object.transform)
      while (i < steps.size() && std::visit([&](auto& shape) { return absorb(shape, steps[i]); }, object.shape)) ++i;
    if (i < steps.size()) steps.add_to(object.transform, i);
    // A disc's normal goes through the steps by itself: its frame need not turn z to the last bit of it.
    if (Disc* disc = object.as<Disc>())
      for (std::size_t k = 0; k < steps.size(); ++k) disc->normal = normalize(steps[k].t.normal(disc->normal));
    if (object.as<std::shared_ptr<const JuliaFractal>>()) object.inverted = false;  // spec 04 section 8
  }
  if (object.as<Sphere>()) steps.add_to(object.uv_transform, 0);
}

void move_bounds(Object& object, const TransformSteps& steps) {
  if (box_steps(object)) {
    for (std::size_t i = 0; i < steps.size(); ++i) object.bounds = transformed(object.bounds, steps[i].t);
  } else if (!object.as<LightSource>()) {
    // What has no box of its own takes that of its first clip when it is moved, whatever the others are and even where
    // that clip is inverted (spec 03 2.2).
    const bool endless = object.as<Plane>() || object.as<Poly>();
    object.bounds = endless && !object.clipped_by.empty() ? object.clipped_by[0]->bounds : bounds_from_numbers(object);
  }
}

void move_textures(Object& object, const TransformSteps& steps) {
  object.texture = steps.moved(object.texture);
  object.interior_texture = steps.moved(object.interior_texture);
  if (const auto* blob = object.as<std::shared_ptr<const Blob>>()) {
    std::shared_ptr<Blob> moved;  // textures that do not move leave the blob shared with its copies
    for (std::size_t i = 0; i < (*blob)->components.size(); ++i) {
      const TexturePtr& texture = (*blob)->components[i].texture;
      if (TexturePtr there = steps.moved(texture); there != texture) {
        if (!moved) moved = std::make_shared<Blob>(**blob);
        moved->components[i].texture = std::move(there);
      }
    }
    if (moved) object.shape = std::shared_ptr<const Blob>(std::move(moved));
  }
  if (const Mesh* mesh = object.as<Mesh>(); mesh && mesh->data && !mesh->data->textures.empty()) {
    std::vector<TexturePtr> textures = mesh->textures.empty() ? mesh->data->textures : mesh->textures;
    for (TexturePtr& texture : textures) texture = steps.moved(texture);
    std::get<Mesh>(object.shape).textures = std::move(textures);
  }
}

// The box of bounded_by or clipped_by replaces the object's when it is smaller (spec 03 2.2).
void shrink_to(Object& object, const List<ObjectPtr>& limits) {
  if (limits.empty()) return;
  BoxRange box;
  for (const ObjectPtr& limit : limits)
    if (!is_complement(*limit)) box.clip(limit->bounds);
  const Bounds narrowed = make_bounds(box.low, box.high);
  if (volume(narrowed) < volume(object.bounds)) object.bounds = narrowed;
}

}  // namespace

void compute_bounds(Object& object) {
  if (!object.transform) {
    if (const Cone* cone = object.as<Cone>()) object.transform = shapes::cone_frame(*cone);
    if (Disc* disc = object.as<Disc>()) {
      disc->normal = normalize(disc->normal);
      object.transform = shapes::disc_frame(*disc);
    }
    if (const Polygon* polygon = object.as<Polygon>()) object.transform = shapes::polygon_frame(*polygon);
    if (object.as<std::shared_ptr<const Text>>()) object.transform = shapes::text_frame();
    if (const auto* field = object.as<std::shared_ptr<const HeightField>>())
      object.transform = shapes::height_field_frame(**field);
  }
  if (object.as<Csg>() || object.as<LightGroup>()) {
    if (auto* csg = object.as<Csg>()) {
      const auto postponable = [](const ObjectPtr& child) {
        const auto* inner = child->as<Csg>();
        return child->bounded_by.empty() && !child->as<LightGroup>() && (!inner || inner->postponable);
      };
      csg->postponable = std::all_of(csg->children.declared().begin(), csg->children.declared().end(), postponable);
    }
    object.bounds = csg_bounds(object);
    return;
  }
  object.bounds = bounds_from_numbers(object);
  if (object.as<Quadric>()) {
    object.clips_in_bounds = static_cast<std::uint32_t>(object.clipped_by.size());
    fit_quadric(object, {});
  }
}

Transform TransformSteps::product(const Transform& before, std::size_t first) const {
  Transform result = before;
  for (std::size_t i = first; i < size_; ++i)
    result = steps_[i]->step == Step::translate ? then_translated(result, steps_[i]->v) : result.then(steps_[i]->t);
  return result;
}

void TransformSteps::add_to(Rare<Transform>& total, std::size_t first) const {
  if (!total) {
    if (!alone_[first]) alone_[first] = product(steps_[first]->t, first + 1);
    total = alone_[first];
  } else if (before_ && after_first_ == first && &*total == &*before_) {
    total = after_;
  } else {
    before_ = total;
    after_ = product(*total, first);
    after_first_ = first;
    total = after_;
  }
}

TexturePtr TransformSteps::moved(const TexturePtr& texture) const {
  if (!texture) return texture;
  for (const Moved& known : few_textures_)
    if (known.before == texture) return known.after;
  constexpr std::size_t kMany = 256;
  const std::size_t place = (reinterpret_cast<std::uintptr_t>(texture.get()) >> 4) * 0x9e3779b97f4a7c15u >> 56;
  static_assert(std::size_t{1} << 8 == kMany);
  if (!many_textures_.empty() && many_textures_[place].before == texture) return many_textures_[place].after;
  TexturePtr after = transformed(texture, transforms().span());
  if (after == texture) return after;
  if (next_texture_ < few_textures_.size()) {
    few_textures_[next_texture_++] = {texture, after};
  } else {
    many_textures_.resize(kMany);
    many_textures_[place] = {texture, after};
  }
  return after;
}

void apply(Object& object, const TransformSteps& steps) {
  refit_clipped_quadric(object);
  move_shape(object, steps);
  move_guards(object, steps);
  move_bounds(object, steps);
  if (!object.uv_mapping) move_textures(object, steps);
  object.interior = transformed(object.interior, steps.transforms().span());
}

void translate(Object& object, const Vec3& v) {
  TransformSteps steps;
  steps.translate(v);
  apply(object, steps);
}
void scale(Object& object, const Vec3& s) {
  TransformSteps steps;
  steps.scale(s);
  apply(object, steps);
}
void rotate(Object& object, const Vec3& degrees) {
  TransformSteps steps;
  steps.rotate(degrees);
  apply(object, steps);
}
void transform(Object& object, const Transform& t) {
  TransformSteps steps;
  steps.transform(t);
  apply(object, steps);
}

void invert(Object& object) {
  if (auto* csg = std::get_if<Csg>(&object.shape)) {
    csg->kind = csg->kind == CsgKind::intersection ? CsgKind::merge : CsgKind::intersection;
    for (ObjectPtr& child : own_children(object)) invert(writable(child));
    object.inverted = !object.inverted, object.was_inverted = object.texture_forgotten = true;
    return;
  }
  if (auto* plane = std::get_if<Plane>(&object.shape)) {
    plane->normal = -plane->normal;
    plane->distance = -plane->distance;
    return;
  }
  if (auto* light = object.as<LightSource>(); light && light->looks_like) invert(writable(light->looks_like));
  // A mesh turns over even where it has no inside (spec 04 1.6).
  const bool stays = object.as<LightSource>() || object.as<Polygon>();
  if (stays || (is_patch(object) && !object.as<Mesh>())) return;
  if (object.as<LightGroup>()) {  // a union; finish_statement makes it an intersection of what is inverted below it
    for (ObjectPtr& child : own_children(object)) invert(writable(child));
  }
  if (auto* quadric = object.as<Quadric>()) {
    quadric->square = -quadric->square, quadric->mixed = -quadric->mixed, quadric->linear = -quadric->linear;
    quadric->constant = -quadric->constant;
  }
  object.inverted = !object.inverted, object.was_inverted = object.texture_forgotten = true;
}

void finish_modifiers(Object& object) {
  refit_clipped_quadric(object);
  shrink_to(object, object.bounded_by);
  shrink_to(object, object.clipped_by);
}

bool is_patch(const Object& object) {
  if (const Mesh* mesh = object.as<Mesh>()) return !mesh->data || !mesh->data->inside_vector;
  return object.as<Triangle>() || object.as<SmoothTriangle>() || object.as<std::shared_ptr<const BicubicPatch>>() ||
         object.as<std::shared_ptr<const Parametric>>();
}

bool is_infinite(const Object& object) { return volume(object.bounds) > kInfiniteVolume; }

std::shared_ptr<Object> copy(const Object& object) {
  if (const auto* csg = object.as<Csg>(); csg && csg->children.postponed())
    children_of(object);  // copies of copies must not grow chains of moves
  auto result = std::make_shared<Object>(object);
  result->copied = true;
  const auto own = [](auto& objects) {
    for (ObjectPtr& o : objects) o = copy(*o);
  };
  if (auto* light = result->as<LightSource>()) {
    if (light->looks_like) light->looks_like = copy(*light->looks_like);
    if (light->projected_through) light->projected_through = copy(*light->projected_through);
  }
  own(result->bounded_by);
  own(result->clipped_by);
  if (object.clip_is_bound) {
    if (result->clipped_by.empty())
      result->clipped_by = result->bounded_by;
    else
      result->bounded_by = result->clipped_by;
  }
  return result;
}

}  // namespace verisim::scene
