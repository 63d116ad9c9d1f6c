#include "parser/source/origins.h"

namespace verisim::parser {

scene::SourceLocation Origins::with(const scene::SourceLocation& place, Origin origin) {
  if (!place.file) return place;
  Name& name = names_[{*place.file, origin}];
  if (!name) {
    name = std::make_shared<const std::string>(*place.file);
    origins_[name.get()] = std::move(origin);
  }
  return {name, place.line, place.column};
}

Origins::Origin Origins::of(const scene::SourceLocation& place) const {
  const auto found = origins_.find(place.file.get());
  return found == origins_.end() ? Origin() : found->second;
}

}  // namespace verisim::parser
