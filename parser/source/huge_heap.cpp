#include "parser/source/huge_heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace verisim::parser {
namespace {

constexpr std::ptrdiff_t kWorthIt = 8 << 20;
constexpr int kAhead = 64 << 20;  // address space only: untouched pages take no memory
constexpr std::uintptr_t kHugePage = 2 << 20;

char* end_of_heap() { return static_cast<char*>(::sbrk(0)); }

}  // namespace

HugeHeap::HugeHeap(bool tune) : tune_(tune), start_(end_of_heap()) {}

void HugeHeap::look() {
  if (!tune_) return;
  char* const end = end_of_heap();
  if (end - start_ < kWorthIt) return;
  if (!advised_) {
    ::mallopt(M_TOP_PAD, kAhead);
    ::mallopt(M_MMAP_THRESHOLD,
              32 << 20);  // what the library's own adaptation, which the line above ends, would arrive at
    advised_ = start_;
  }
  const std::uintptr_t from = (reinterpret_cast<std::uintptr_t>(advised_) + kHugePage - 1) / kHugePage * kHugePage;
  const auto to = reinterpret_cast<std::uintptr_t>(end);
  if (to < from + kHugePage) return;
  ::madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);  // a hint: failure means ordinary pages
  advised_ = end;
}

}  // namespace verisim::parser
