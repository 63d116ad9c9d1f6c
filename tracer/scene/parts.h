// How large a description is once the copies in it are written out, and walks that need not write them out.
//
// A copy shares the list of what is below it with its original (children.h), so a few statements describe any number
// of objects: `#declare U = union { object { U } object { U } }` doubles them. Whoever walks over copies one by one
// never comes to an end of sixty such lines.
#pragma once

#include <unordered_set>

#include "tracer/scene/object.h"

namespace verisim::scene {

// Takes time in the size of what was never counted before, not of what is written out: nested statements count once.
// Its recursion is as deep as `levels`.
Parts parts_of(const Object& object);
double objects_of(const std::vector<ObjectPtr>& objects);  // in all of them together

// Memory that an object of a tree takes at least.
inline constexpr double kBytesPerObject = sizeof(Object) + 3 * sizeof(void*);

// The lists of declared children (declared_children) that a walk came by.
class SharedLists {
 public:
  // True when the walk is to go on below `parent`: copies of one object share its list, and what was found below one
  // of them holds for all. `variant`: of walks whose answer hangs on a flag, too.
  bool first(const Object& parent, bool variant = false);

 private:
  std::unordered_set<const void*> seen_[2];
};

}  // namespace verisim::scene
