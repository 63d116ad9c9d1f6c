#include "cli/view/file_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;

namespace verisim::cli {

FileWatch::FileWatch(std::function<void()> changed) : changed_(std::move(changed)) {
  notify_ = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (notify_ < 0 || pipe(wake_) != 0)
    throw std::runtime_error("cannot watch files: " + std::system_category().message(errno));
  thread_ = std::thread([this] { run(); });
}

FileWatch::~FileWatch() {
  ::close(wake_[1]);  // ends poll
  thread_.join();
  ::close(wake_[0]);
  ::close(notify_);
}

// Folders are watched, not files: most editors put a new file in the place of the old one.
void FileWatch::watch(const std::vector<fs::path>& files) {
  const std::lock_guard lock(mutex_);
  std::set<std::pair<int, std::string>> names;
  std::set<int> folders;
  for (const fs::path& file : files) {
    const fs::path absolute = fs::absolute(file);
    const int folder = inotify_add_watch(notify_, absolute.parent_path().c_str(),
                                         IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM);
    if (folder < 0) continue;  // gone: the scene will say so
    folders.insert(folder);
    names.emplace(folder, absolute.filename().string());
  }
  for (const int old : folders_)
    if (!folders.contains(old)) inotify_rm_watch(notify_, old);
  names_ = std::move(names), folders_ = std::move(folders);
}

void FileWatch::run() {
  alignas(inotify_event) char buffer[16384];
  pollfd wait[2] = {{notify_, POLLIN, 0}, {wake_[0], POLLIN, 0}};
  while (true) {
    if (poll(wait, 2, -1) < 0) continue;
    if (wait[1].revents) return;
    bool ours = false;
    for (ssize_t size; (size = read(notify_, buffer, sizeof buffer)) > 0;) {
      const std::lock_guard lock(mutex_);
      for (const char* at = buffer; at < buffer + size;) {
        const auto* event = reinterpret_cast<const inotify_event*>(at);
        if (event->len > 0 && names_.contains({event->wd, event->name})) ours = true;
        at += sizeof(inotify_event) + event->len;
      }
    }
    if (ours) changed_();
  }
}

}  // namespace verisim::cli
