// What the plug-ins share on their side of module.h.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "tracer/base/huge_pages.h"
#include "tracer/image/module/module.h"

#define VERISIM_EXPORT extern "C" __attribute__((visibility("default")))

namespace verisim::image {

inline int fail(char* error, std::size_t size, const std::string& message) {
  if (error && size > 0) {
    const std::size_t n = std::min(size - 1, message.size());
    std::memcpy(error, message.data(), n);
    error[n] = '\0';
  }
  return kVerisimFailed;
}

inline void free_pixels(VerisimImage& image) {
  std::free(image.pixels);
  image = {};
}

// Memory for width * height * channels samples, not cleared. Throws std::bad_alloc.
inline void allocate_pixels(VerisimImage& image, std::size_t sample_bytes) {
  const std::size_t bytes = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                            static_cast<std::size_t>(image.channels) * sample_bytes;
  image.pixels = std::malloc(bytes);
  if (!image.pixels) throw std::bad_alloc();
  fill_by_huge_pages(image.pixels, bytes);
}

// No exception may cross the seam.
template <class F>
int guarded(char* error, std::size_t error_size, F f) {
  try {
    return f();
  } catch (const std::bad_alloc&) {
    return fail(error, error_size, "not enough memory for the image");
  } catch (const std::exception& e) {
    return fail(error, error_size, e.what());
  } catch (...) {
    return fail(error, error_size, "unknown error");
  }
}

}  // namespace verisim::image

// What every plug-in exports: its version, reading by `read_image`, which may throw, and the release of what was read.
#define VERISIM_EXPORT_READER(read_image)                                                                             \
  VERISIM_EXPORT int verisim_module_version() { return verisim::image::kModuleVersion; }                              \
  VERISIM_EXPORT int verisim_read_image(const char* path, std::uint64_t max_pixels, VerisimImage* image, char* error, \
                                        std::size_t error_size) {                                                     \
    return verisim::image::guarded(error, error_size,                                                                 \
                                   [&] { return read_image(path, max_pixels, image, error, error_size); });           \
  }                                                                                                                   \
  VERISIM_EXPORT void verisim_free_image(VerisimImage* image) { verisim::image::free_pixels(*image); }
