// What a thread keeps for itself (thread_local) is destroyed when it ends. The C library takes memory to note down each
// such object and ends the program by abort() where there is none; this needs none for as many as we have. Part of the
// program, not of the libraries, as large_blocks.cpp is.
#include <pthread.h>

#include <cstddef>
#include <cstdlib>
#include <iterator>

#include "tracer/base/sanitizers.h"

#if defined(__GLIBC__) && !defined(VERISIM_SANITIZED)

extern "C" int __cxa_thread_atexit_impl(void (*destroy)(void*), void* object, void* library) noexcept;

namespace {

struct Kept {
  void (*destroy)(void*);
  void* object;
};
constinit thread_local Kept kept[64] = {};
constinit thread_local std::size_t count = 0;

// Of the last kept first; one may keep others while it is destroyed.
void destroy_kept(void*) {
  while (count > 0) {
    const Kept last = kept[--count];
    last.destroy(last.object);
  }
}

// A value of this key lets the thread call destroy_kept when it ends. The first 32 keys of a process take no memory.
pthread_key_t key_of_end() {
  static const pthread_key_t made = [] {
    pthread_key_t key{};
    if (pthread_key_create(&key, destroy_kept) != 0) std::abort();
    return key;
  }();
  return made;
}

}  // namespace

// What the compiler calls where a thread_local object has been made. Hidden: objects of shared libraries, which may be
// unloaded before a thread ends, are left to the C library.
extern "C" [[gnu::visibility("hidden")]] int __cxa_thread_atexit(void (*destroy)(void*), void* object,
                                                                 void* library) noexcept {
  if (count == std::size(kept)) return __cxa_thread_atexit_impl(destroy, object, library);
  if (count == 0) pthread_setspecific(key_of_end(), kept);
  kept[count++] = {destroy, object};
  return 0;
}
#endif
