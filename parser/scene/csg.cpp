// union, merge, intersection, difference (spec 03 section 5).
#include "parser/scene/common/nesting.h"
#include "parser/scene/objects.h"
#include "tracer/scene/solid_parts.h"

namespace verisim::parser {

namespace {

void read_children(Parser& parser, scene::Object& object, Word word) {
  scene::Csg csg;
  csg.kind = word == Word::merge                                      ? scene::CsgKind::merge
             : word == Word::intersection || word == Word::difference ? scene::CsgKind::intersection
                                                                      : scene::CsgKind::union_;
  csg.difference = word == Word::difference;
  while (ObjectRef child = parse_object(parser)) {
    if (csg.kind == scene::CsgKind::intersection && !scene::has_only_solid_parts(*child))
      parser.warning(Code::incompatible, "Patch objects not allowed in intersection.");
    if (csg.difference && !csg.children.declared().empty()) scene::invert(*child);
    child->solid_steps = {};  // nobody writes to its texture any more
    csg.children.push_back(child);
  }
  if (csg.children.declared().size() < 2 && parser.version() > 150)
    parser.warning(Code::too_few, "Should have at least 2 objects in csg.");
  object.shape = std::move(csg);
  check_nesting(parser, object);
}

}  // namespace

ObjectRef parse_csg(Parser& parser) {
  const Word word = word_at(parser);
  if (word == Word::composite && parser.version() > 150)
    parser.warning(Code::discontinued, "Use union instead of composite.");
  return shape_block(parser, [&](scene::Object& object) { read_children(parser, object, word); });
}

}  // namespace verisim::parser
