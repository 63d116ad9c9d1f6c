#include "parser/source/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace verisim::parser {

MemoryFile::~MemoryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::filesystem::path MemoryFile::path() const {
  const std::string* content = bytes();
  if (!content) throw std::runtime_error("it holds samples, not the bytes of a file");
  const std::lock_guard lock(mutex_);
  if (descriptor_ < 0) {
    // Caches tell files apart by name, size and time: the name is another one for every file of this process.
    static std::atomic<unsigned> count{0};
    const int made = ::memfd_create(("verisim-" + std::to_string(++count)).c_str(), MFD_CLOEXEC);
    if (made < 0) throw std::runtime_error(std::string("no file in memory can be made: ") + std::strerror(errno));
    for (std::size_t done = 0; done < content->size();) {
      const ssize_t written = ::write(made, content->data() + done, content->size() - done);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) {
        const std::string reason = std::strerror(errno);
        ::close(made);
        throw std::runtime_error("a file in memory cannot be filled: " + reason);
      }
      done += static_cast<std::size_t>(written);
    }
    descriptor_ = made;
  }
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

}  // namespace verisim::parser
