#include "cli/sandbox/private_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace verisim::cli {

PrivateFolder::PrivateFolder(const std::string& name) {
  std::string path = (fs::temp_directory_path() / (name + "XXXXXX")).string();
  if (!::mkdtemp(path.data()))
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", path, std::strerror(errno)));
  path_ = path;
  if (::pipe2(alive_, O_CLOEXEC) != 0 || (keeper_ = ::fork()) < 0)
    throw std::runtime_error(fmt::format("cannot watch over the folder {}: {}", path, std::strerror(errno)));
  if (keeper_ == 0) remove_at_end();
  ::close(alive_[0]);
}

PrivateFolder::~PrivateFolder() {
  ::close(alive_[1]);
  ::waitpid(keeper_, nullptr, 0);
}

void PrivateFolder::remove_at_end() const {
  ::setsid();  // Ctrl-C is not for it
  for (const int asked : {SIGTERM, SIGHUP}) ::signal(asked, SIG_IGN);
  ::close(alive_[1]);
  for (const int inherited : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(inherited);
  char byte = 0;
  while (::read(alive_[0], &byte, 1) < 0 && errno == EINTR) continue;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  ::_exit(0);
}

}  // namespace verisim::cli
