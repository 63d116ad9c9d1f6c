// Asks for huge pages where a scene of many objects grows: page faults are a good part of the time such a scene takes
// to read.
#pragma once

#include <cstddef>

namespace verisim::parser {

class HugeHeap {
 public:
  // `tune`: the allocator of the whole process may be told to grow in large steps.
  explicit HugeHeap(bool tune);
  // Called now and then; once the heap has grown by some megabytes, what grows further lies in huge pages where the
  // system has them.
  void look();

 private:
  bool tune_;
  char* start_ = nullptr;
  char* advised_ = nullptr;
};

}  // namespace verisim::parser
