// Large blocks of memory and a large heap in huge pages: a mesh of millions of triangles fills hundreds of MiB once,
// and a third of the time until its first pixel went into page faults of 4 KiB each; thousands of small objects need a
// tenth of their time for them. Part of the program, not of the libraries: whoever embeds those chooses an allocator.
// Large blocks are also where --max-memory is kept before memory is taken.
#include "tracer/base/sanitizers.h"

#if defined(__linux__) && !defined(VERISIM_SANITIZED)
#ifdef __x86_64__
#include <cpuid.h>
#endif
#include <malloc.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <limits>
#include <new>

#include "cli/console/exit_status.h"
#include "tracer/base/huge_pages.h"
#include "tracer/base/resident_memory.h"

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;
constexpr std::size_t kLarge = 2 * kHugePage;
constexpr int kNoMemory = verisim::cli::kInputOutput;

std::atomic<bool> refused{false};  // a block, at some time
[[noreturn]] void refuse() {
  refused = true;
  throw std::bad_alloc();
}

// Where the heap's small pages begin that nobody has touched yet, and where it ends (0: pages come one by one, as they
// are touched). What threads allocate for themselves lies elsewhere.
std::atomic<std::uintptr_t> untouched{~std::uintptr_t{0}};
std::atomic<std::uintptr_t> heap_end{0};

// Takes small pages by the dozen as the heap grows into them, which costs three quarters of a page fault for each. One
// thread does it; the others touch theirs meanwhile.
void touch_ahead(std::uintptr_t end) {
#ifdef MADV_POPULATE_WRITE
  constexpr std::uintptr_t kStep = 256 << 10;
  std::uintptr_t from = untouched.load(std::memory_order_relaxed);
  const std::uintptr_t last = heap_end.load(std::memory_order_relaxed);
  if (end <= from || end > last) return;
  const std::uintptr_t to = std::min((end + kStep) / kStep * kStep, last);
  if (!untouched.compare_exchange_strong(from, to, std::memory_order_relaxed)) return;
  if (::madvise(reinterpret_cast<void*>(from), to - from, MADV_POPULATE_WRITE) != 0) heap_end = 0;
#else
  static_cast<void>(end);
#endif
}

// Blocks of any alignment: what free() takes, so that delete need not know which they are.
void* allocate(std::size_t size, std::size_t alignment) {
  for (;;) {
    void* block;
    if (size >= kLarge) {
      const std::size_t limit = verisim::memory_limit.load(std::memory_order_relaxed);
      if (limit && (size > limit || size > limit - std::min(limit, verisim::resident_memory()))) refuse();
    }
    if (alignment > __STDCPP_DEFAULT_NEW_ALIGNMENT__) {
      if (size > ~std::size_t{0} - alignment) refuse();
      block = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    } else {
      block = std::malloc(size == 0 ? 1 : size);
    }
    if (block) {
      // Not aligned to them, which would leave gaps of up to a page before and behind each block.
      if (size >= kLarge)
        verisim::fill_by_huge_pages(block, size);
      else
        touch_ahead(reinterpret_cast<std::uintptr_t>(block) + size);
      return block;
    }
    const std::new_handler handler = std::get_new_handler();
    if (!handler) refuse();
    handler();
  }
}

[[noreturn]] void end_without_memory() {
  static const char text[] = "verisim: error: there is not enough memory, or --max-memory does not allow it\n";
  if (::write(STDERR_FILENO, text, sizeof text - 1) < 0) ::_exit(kNoMemory);
  ::_exit(kNoMemory);
}

// Where nobody can catch it, before main and in destructors of libraries, a lack of memory still ends in words. What
// else comes here is a mistake of ours, and a core.
void on_terminate() {
  if (!refused) std::abort();
  end_without_memory();
}

// So it does where a library follows a pointer to what it did not get: nlohmann's JSON, whose destructor visits a value
// that became an object and found no memory for one.
void on_bad_address(int number, siginfo_t* info, void*) {
  constexpr std::uintptr_t kNull = 4096;
  if (refused && reinterpret_cast<std::uintptr_t>(info->si_addr) < kNull) end_without_memory();
  ::signal(number, SIG_DFL);                // the instruction is tried again, and ends the program as ever
  if (info->si_code <= 0) ::raise(number);  // there is none: somebody sent the signal
}

void watch_bad_addresses() {
  struct sigaction action {};
  action.sa_sigaction = on_bad_address;
  action.sa_flags = SA_SIGINFO;
  ::sigaction(SIGSEGV, &action, nullptr);
}

#ifdef __GLIBC__
char* end_of_heap() { return static_cast<char*>(::sbrk(0)); }

// The host of a virtual machine takes back free memory in blocks as large as huge pages, and has to clear them again: a
// huge page that was not in use lately costs 2 to 5 ms there, one that was 0.2 ms, 512 small ones, which the kernel
// keeps at hand, 0.7 ms.
bool in_virtual_machine() {
#ifdef __x86_64__
  constexpr unsigned kHypervisor = 1u << 31;
  unsigned a = 0, b = 0, c = 0, d = 0;
  return __get_cpuid(1, &a, &b, &c, &d) && (c & kHypervisor);
#else
  return false;
#endif
}

// Sets addresses aside for the heap, which untouched pages need no memory for, and asks for huge pages for all but its
// first megabytes: small scenes shall not take more than they need. Not for all that follows in a virtual machine.
void set_heap_aside() {
  constexpr int kAside = 1 << 30, kStep = 64 << 20;
  constexpr std::uintptr_t kSmall = 3 << 20;
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);  // what the library's own adaptation, which this ends, would arrive at
  ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  ::mallopt(M_TOP_PAD, kAside);
  char* const start = end_of_heap();
  void* volatile growth = std::malloc(256 << 10);  // volatile: so that it is not left out
  std::free(growth);
  char* const end = end_of_heap();
  const bool grown = end - start > kAside / 2;  // else a limit forbids that
  ::mallopt(M_TOP_PAD, grown ? kStep : 128 << 10);
  if (!grown) return;
  const std::uintptr_t from =
      (reinterpret_cast<std::uintptr_t>(start) + kSmall + kHugePage - 1) / kHugePage * kHugePage;
  constexpr std::uintptr_t kAtHand = 48 << 20;
  auto to = reinterpret_cast<std::uintptr_t>(end);
  if (in_virtual_machine()) {
    to = std::min(to, from + kAtHand);
    untouched = to;
    heap_end = reinterpret_cast<std::uintptr_t>(end);
  }
  ::madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);
}
#else
void set_heap_aside() {}
#endif

[[gnu::constructor(101)]] void before_all_others() {
  std::set_terminate(on_terminate);
  watch_bad_addresses();
  set_heap_aside();
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }
#endif
