// bicubic_patch (spec 04 section 4).
#include <optional>

#include "parser/scene/objects.h"

namespace verisim::parser {

namespace {

// The form without keywords: type [flatness] u_steps v_steps, without commas.
void parse_old_form(Parser& parser, scene::BicubicPatch& patch, std::optional<int>& type) {
  parser.warning(Code::discontinued, "Should use keywords for bicubic parameters.");
  type = parser.parse_int();
  patch.flatness = *type == 2 || *type == 3 ? parser.parse_float() : 0.1;
  patch.u_steps = parser.parse_int();
  patch.v_steps = parser.parse_int();
}

bool at_float(Parser& parser) {
  const Token& token = parser.peek();
  if (token.kind == TokenKind::number || token.punctuation == '(') return true;
  if (token.kind == TokenKind::word) return word_class(token.word) == WordClass::float_function;
  const Value* value = parser.peek_value();
  const auto* numeric = value ? std::get_if<Numeric>(value) : nullptr;
  return numeric && numeric->terms == 1;
}

// Numbers without a keyword are the old form, whatever stood before.
void parse_keywords(Parser& parser, scene::BicubicPatch& patch, std::optional<int>& type) {
  for (;;) {
    switch (word_at(parser)) {
      case Word::type:
        parser.next();
        type = parser.parse_int();
        break;
      case Word::flatness:
        parser.next();
        patch.flatness = parser.parse_float();
        break;
      case Word::u_steps:
        parser.next();
        patch.u_steps = parser.parse_int();
        break;
      case Word::v_steps:
        parser.next();
        patch.v_steps = parser.parse_int();
        break;
      case Word::accuracy:  // has no effect
        parser.next();
        parser.parse_float();
        break;
      default:
        if (at_float(parser)) parse_old_form(parser, patch, type);
        return;
    }
  }
}

}  // namespace

ObjectRef parse_bicubic_patch(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto patch = std::make_shared<scene::BicubicPatch>();
    std::optional<int> type;
    parse_keywords(parser, *patch, type);
    parser.optional_comma();
    if (parser.accept(Word::uv_vectors)) {
      patch->uv.emplace();
      for (Vec2& uv : *patch->uv) {
        uv = parser.parse_vec2();
        parser.optional_comma();
      }
    }
    if (!type || *type < 0) parser.error(Code::bad_value, "Undefined bicubic patch type.");
    if (*type > 1) {
      parser.warning(Code::discontinued, "Patch type no longer supported. Using type 1.");
      type = 1;
    }
    patch->type = *type;
    for (Vec3& point : patch->points) {
      point = parser.parse_vec3();
      parser.optional_comma();
    }
    object.shape = std::shared_ptr<const scene::BicubicPatch>(patch);
  });
}

}  // namespace verisim::parser
