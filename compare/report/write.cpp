#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "compare/compare.h"

namespace verisim::compare {

void write_report(const std::string& text, const std::filesystem::path& path) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(fmt::format("{}: cannot {}: {}", path.string(), what, std::strerror(errno)));
  };
  const auto put = [&](std::FILE* file) { return std::fwrite(text.data(), 1, text.size(), file) == text.size(); };
  if (path == "-") {
    if (!put(stdout) || std::fflush(stdout) != 0) fail("write");
    return;
  }
  std::string temporary = path.string() + ".XXXXXX";
  const int fd = mkstemp(temporary.data());
  if (fd < 0) fail("write");
  std::FILE* file = fdopen(fd, "wb");
  const bool written = file && fchmod(fd, 0644) == 0 && put(file) && std::fflush(file) == 0;
  const int error = errno;
  if (file)
    std::fclose(file);
  else
    ::close(fd);
  if (!written || std::rename(temporary.c_str(), path.c_str()) != 0) {
    const int cause = written ? errno : error;
    std::remove(temporary.c_str());
    errno = cause;
    fail("write");
  }
}

}  // namespace verisim::compare
