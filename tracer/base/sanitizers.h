// VERISIM_SANITIZED: a sanitizer that has its own allocator watches this build. GCC says so by macros, Clang by
// features.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define VERISIM_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define VERISIM_SANITIZED 1
#endif
#endif
