#include "compare/oracle/folder_watch.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace verisim::compare {
namespace fs = std::filesystem;

FolderWatch::FolderWatch(const fs::path& folder, bool subfolders) : fd_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  watch(folder, {}, subfolders);
}

FolderWatch::~FolderWatch() {
  if (fd_ >= 0) close(fd_);
}
FolderWatch::FolderWatch(FolderWatch&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)), folders_(std::move(other.folders_)) {}
FolderWatch& FolderWatch::operator=(FolderWatch&& other) noexcept {
  std::swap(fd_, other.fd_), std::swap(folders_, other.folders_);
  return *this;
}

void FolderWatch::watch(const fs::path& folder, const fs::path& below, bool subfolders) {
  constexpr std::uint32_t kWhat = IN_MODIFY | IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO |
                                  IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR | IN_DONT_FOLLOW;
  if (fd_ < 0) return;
  const int descriptor = inotify_add_watch(fd_, folder.c_str(), kWhat);
  if (descriptor < 0) {
    close(std::exchange(fd_, -1));
    return;
  }
  folders_[descriptor] = below;
  if (!subfolders) return;
  std::error_code failed;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, failed)) {
    const fs::path name = entry.path().filename();
    if (entry.is_directory(failed) && !entry.is_symlink(failed) && !name.string().starts_with("."))
      watch(entry.path(), below / name, true);
  }
}

std::optional<std::set<fs::path>> FolderWatch::changes() {
  std::set<fs::path> out;
  alignas(inotify_event) char buffer[16384];
  while (fd_ >= 0) {
    const ssize_t size = read(fd_, buffer, sizeof buffer);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && errno == EAGAIN) return out;
    bool known = size > 0;
    for (ssize_t at = 0; known && at < size;) {
      inotify_event event;
      std::memcpy(&event, buffer + at, sizeof event);
      const char* name = buffer + at + sizeof event;
      const auto folder = folders_.find(event.wd);
      known = folder != folders_.end() &&
              !(event.mask & (IN_Q_OVERFLOW | IN_IGNORED | IN_ISDIR | IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT));
      if (known && event.len) out.insert(folder->second / name);
      at += static_cast<ssize_t>(sizeof event + event.len);
    }
    if (!known) close(std::exchange(fd_, -1));
  }
  return std::nullopt;
}

}  // namespace verisim::compare
