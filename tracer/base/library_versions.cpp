#include "tracer/base/library_versions.h"

#include <cstdio>

#include <ImathConfig.h>
#include <boost/version.hpp>
#include <fmt/format.h>
#include <gif_lib.h>
#include <jpeglib.h>
#include <png.h>
#include <tbb/version.h>
#include <zlib.h>

namespace verisim {

std::vector<std::pair<std::string, std::string>> library_versions() {
  const auto dotted = [](int major, int minor, int patch) { return fmt::format("{}.{}.{}", major, minor, patch); };
  return {
      {"Boost", dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"GIFLIB", dotted(GIFLIB_MAJOR, GIFLIB_MINOR, GIFLIB_RELEASE)},
      {"Imath", IMATH_VERSION_STRING},
      {"fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"libjpeg-turbo", dotted(LIBJPEG_TURBO_VERSION_NUMBER / 1000000, LIBJPEG_TURBO_VERSION_NUMBER / 1000 % 1000,
                               LIBJPEG_TURBO_VERSION_NUMBER % 1000)},
      {"libpng", PNG_LIBPNG_VER_STRING},
      {"oneTBB", TBB_runtime_version()},
      {"zlib", zlibVersion()},
  };
}

}  // namespace verisim
