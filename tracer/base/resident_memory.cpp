#include "tracer/base/resident_memory.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

namespace verisim {

std::size_t resident_memory() {
  static const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  char text[128];
  const ssize_t length = file >= 0 ? ::pread(file, text, sizeof text - 1, 0) : -1;
  if (length <= 0) return 0;
  text[length] = 0;
  char* second = nullptr;
  std::strtoull(text, &second, 10);  // all that is mapped; the next number is resident
  return std::strtoull(second, nullptr, 10) * page;
}

}  // namespace verisim
