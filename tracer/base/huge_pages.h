// Memory in large pages.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace verisim {

// Asks for huge pages for memory that is about to be filled: thousands of page faults less. A hint; failure means
// ordinary pages.
inline void fill_by_huge_pages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t kPage = 4096;
  const std::uintptr_t from = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) / kPage * kPage,
                       to = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / kPage * kPage;
  if (to > from + (std::size_t{4} << 20)) ::madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);
}

}  // namespace verisim
