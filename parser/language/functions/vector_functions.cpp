// Vector functions and named vectors (spec 01 sections 8.5 and 11), and what SDL asks the tracer.
#include <cmath>
#include <numbers>

#include "parser/language/impl.h"
#include "tracer/image/image.h"
#include "tracer/noise/noise.h"

namespace verisim::parser {
namespace {

Numeric vector(const Vec3& v) { return {{v.x, v.y, v.z}, 3}; }

}  // namespace

Vec3 Parser::Impl::vector_argument() {
  if (Vec3 v; literal_vector(3, &v.x) || vector_fast(v)) return v;
  const Token* const start = position;
  Numeric n;
  additive(3, n);
  fit(n, 3, start);
  return {n.v[0], n.v[1], n.v[2]};
}

scene::ObjectPtr Parser::Impl::object_argument() {
  const Value* value = peek_value();
  if (!value || !std::holds_alternative<scene::ObjectPtr>(*value)) expected("object identifier");
  return std::get<scene::ObjectPtr>(resolve().value());
}

const query::Target& Parser::Impl::query_target(const scene::ObjectPtr& object) {
  QueryTarget& entry = query_targets[object.get()];
  if (!entry.target) {
    entry.object = object;  // keeps the address from being used again
    entry.target = std::make_unique<query::Target>(object);
  }
  return *entry.target;
}

namespace {

// trace(Object, From, Direction [, Normal variable])
Vec3 trace(Parser::Impl& p) {
  p.open_arguments();
  const Live live(p);
  const auto comma = [&p] {
    if (p.peek().punctuation == ',') p.skip_token();
  };
  const scene::ObjectPtr object = p.object_argument();
  comma();
  const Vec3 from = p.vector_argument();
  comma();
  const Vec3 direction = p.vector_argument();
  comma();
  std::optional<query::TraceHit> hit;
  if (direction != Vec3(0, 0, 0))
    p.within_budget("trace()", [&] { hit = p.query_target(object).trace(from, direction); });
  if (p.peek().punctuation != ')') {
    const Value* value = p.peek_value();
    const Numeric* old = value ? std::get_if<Numeric>(value) : nullptr;
    if (!old || old->terms != 3) p.expected("vector identifier");
    p.resolve().value() = vector(hit ? hit->normal : Vec3(0, 0, 0));
  }
  p.close_arguments();
  return hit ? hit->point : Vec3(0, 0, 0);
}

// Bounds are single precision; an image's size is the extent of a pigment (spec 01 section 11).
Vec3 extent(Parser::Impl& p, bool maximum) {
  p.open_arguments();
  const Live live(p);
  Vec3 result(0, 0, 0);
  if (p.peek().punctuation == ')') {  // of nothing: accepted, and <0,0,0>
    p.skip_token();
    return result;
  }
  const Value* value = p.peek_value();
  if (value && std::holds_alternative<scene::PigmentPtr>(*value)) {
    const scene::PigmentPtr pigment = std::get<scene::PigmentPtr>(p.resolve().value());
    const auto* image = std::get_if<scene::ImageParams>(&*pigment->pattern.params);
    if (!maximum || !image || !image->image || pigment->pattern.kind != scene::PatternKind::image_map)
      p.error(Code::misplaced_keyword, "max_extent() of a pigment needs an image_map.");
    result = {static_cast<double>(image->image->width), static_cast<double>(image->image->height), 0};
  } else {
    const scene::Bounds bounds = p.object_argument()->bounds;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      result[i] = maximum ? static_cast<double>(bounds.low[k] + bounds.size[k]) : static_cast<double>(bounds.low[k]);
    }
  }
  p.close_arguments();
  return result;
}

Vec3 normalized(Parser::Impl& p, const Vec3& a) {
  if (a != Vec3(0, 0, 0)) return normalize(a);
  if (p.language_version >= 350)
    p.message(Severity::possible_error, Code::domain_error, "Normalizing a zero-length vector.");
  return a;
}

// Functions of vectors and numbers. False: the word, which is behind the cursor, is none.
bool function_of_vectors(Parser::Impl& p, Word word, Vec3& out) {
  if (word != Word::vcross && word != Word::vnormalize && word != Word::vrotate && word != Word::vaxis_rotate &&
      word != Word::vturbulence)
    return false;
  p.open_arguments();
  const Live live(p);
  const auto comma = [&p] {
    if (p.peek().punctuation == ',') p.skip_token();
  };
  const auto next_vector = [&] {
    comma();
    return p.vector_argument();
  };
  if (word == Word::vturbulence) {
    const double lambda = p.scalar();
    comma();
    const double omega = p.scalar();
    comma();
    const int octaves = std::clamp(to_int(p.scalar()), 1, 10);
    out = textures::vector_turbulence(next_vector(), octaves, lambda, omega);
  } else {
    const Vec3 a = p.vector_argument();
    if (word == Word::vcross) {
      out = cross(a, next_vector());
    } else if (word == Word::vrotate) {
      out = Transform::rotation(next_vector()).point(a);
    } else if (word == Word::vaxis_rotate) {
      const Vec3 axis = next_vector();
      comma();
      out = Transform::axis_rotation(axis, p.scalar() * (std::numbers::pi / 180)).point(a);
    } else {
      p.close_arguments();
      out = normalized(p, a);
      return true;
    }
  }
  p.close_arguments();
  return true;
}

}  // namespace

// The word is at the cursor; false: it is no vector function.
bool Parser::Impl::vector_function(Word word, Numeric& out) {
  if (word_class(word) != WordClass::vector_function) return false;
  const Nesting nesting(*this);
  skip_token();
  if (Vec3 result; function_of_vectors(*this, word, result)) {
    out = vector(result);
    return true;
  }
  switch (word) {
    case Word::x:
      out = vector({1, 0, 0});
      break;
    case Word::y:
      out = vector({0, 1, 0});
      break;
    case Word::z:
      out = vector({0, 0, 1});
      break;
    case Word::u:
      out = {{1, 0}, 2};
      break;
    case Word::v:
      out = {{0, 1}, 2};
      break;
    case Word::t:
      out = {{0, 0, 0, 1}, 4};
      break;
    case Word::trace:
      out = vector(trace(*this));
      break;
    case Word::min_extent:
      out = vector(extent(*this, false));
      break;
    case Word::max_extent:
      out = vector(extent(*this, true));
      break;
    default:
      return false;
  }
  return true;
}

}  // namespace verisim::parser
