#include "compare/oracle/working_copy.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <system_error>

#include "compare/oracle/folder_watch.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kCopyBytes = std::uintmax_t{256} << 20;
constexpr int kMaxEntries = 20000, kMaxNeighbours = 2000;
constexpr std::size_t kMaxWaiting =
    16;  // copies kept for the next scene; each takes two of the few hundred watches that a user has

bool is_hidden(const fs::path& name) { return name.string().starts_with("."); }

void empty_folder(const fs::path& folder) {
  fs::create_directories(folder);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) fs::remove_all(entry.path());
}

// Hidden: not copied with a scene that lies beside it.
constexpr std::string_view kTemporaryName = ".verisim-run-";

int locked(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

// Folders of ours that nobody holds. Between making and locking one a moment passes, so young ones are left alone.
void remove_abandoned() {
  constexpr auto kYoung = std::chrono::seconds(20);
  std::error_code failed;
  for (auto it = fs::directory_iterator(fs::temp_directory_path(), failed); !failed && it != fs::directory_iterator();
       it.increment(failed)) {
    struct stat about {};
    const fs::path folder = it->path();
    if (!folder.filename().string().starts_with(kTemporaryName) || ::lstat(folder.c_str(), &about) != 0 ||
        !S_ISDIR(about.st_mode) || about.st_uid != ::geteuid())
      continue;
    if (std::chrono::system_clock::from_time_t(about.st_mtime) + kYoung > std::chrono::system_clock::now()) continue;
    const int lock = locked(folder);
    if (lock < 0) continue;
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    ::close(lock);
  }
}

}  // namespace

FilesBelow files_below(const fs::path& folder) {
  FilesBelow out;
  std::error_code failed;
  int count = 0;
  for (auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, failed);
       !failed && it != fs::recursive_directory_iterator(); it.increment(failed)) {
    if (++count > kMaxEntries) return out.all = false, out;
    std::error_code gone;
    if (it->is_directory(gone) && is_hidden(it->path().filename())) it.disable_recursion_pending();
    if (it->is_regular_file(gone)) out.files.push_back(it->path());
  }
  return out;
}

TemporaryFolder::TemporaryFolder() {
  static std::once_flag cleaned;
  std::call_once(cleaned, remove_abandoned);
  std::string name = (fs::temp_directory_path() / (std::string(kTemporaryName) + "XXXXXX")).string();
  if (!mkdtemp(name.data()))
    throw fs::filesystem_error("cannot make a temporary folder", name, std::error_code(errno, std::generic_category()));
  path_ = name;
  lock_ = locked(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

class FolderCopy {
 public:
  explicit FolderCopy(const fs::path& original) : original_(original) {
    const fs::path base = root_.path() / "scenes";
    folder_ = base / (original.has_filename() ? original.filename() : fs::path("root"));
    fs::create_directories(folder_);
    link_neighbours(base);
  }

  // Makes the copy equal to the original; what earlier scenes wrote goes. Only what changed on either side is looked
  // at, where that is known: a folder of thousands of scenes is not gone through for each of them.
  void synchronise() {
    empty_folder(home()), empty_folder(out());
    if (!refresh()) start_anew();
    watch_copy_.changes();  // our own
  }
  fs::path home() const { return root_.path() / "home"; }
  fs::path out() const { return root_.path() / "out"; }
  const fs::path& folder() const { return folder_; }
  const fs::path& original() const { return original_; }

 private:
  // A file as it was copied. The copy gets the original's time, so that anything a scene writes to it shows.
  struct Stamp {
    std::uintmax_t size = 0;
    fs::file_time_type time;
    bool operator==(const Stamp&) const = default;
  };
  // Of a file that is gone, one that equals no file's.
  static Stamp stamp(const fs::path& path) {
    std::error_code gone;
    return {fs::file_size(path, gone), fs::last_write_time(path, gone)};
  }

  // Everything. The original is watched before it is read, so that nothing is missed.
  void start_anew() {
    fs::create_directories(folder_);
    const bool deep = files_below(original_).all;
    watch_original_ = FolderWatch(original_, deep);
    copied_bytes_ = 0, links_ = false;
    std::map<fs::path, Stamp> kept;
    std::swap(kept, made_);
    copy_folder(original_, folder_, deep, kept);
    watch_copy_ = FolderWatch(folder_, deep);
  }

  // False when it is not known what changed, or when it is not a plain file.
  bool refresh() {
    const auto theirs = watch_original_.changes(), ours = watch_copy_.changes();
    if (!theirs || !ours || links_) return false;
    const std::uintmax_t copied_bytes = copied_bytes_;
    for (const auto* side : {&*theirs, &*ours})
      for (const fs::path& name : *side) {
        const fs::file_status status = fs::symlink_status(original_ / name),
                              copied = fs::symlink_status(folder_ / name);
        if (fs::is_directory(copied) || (fs::exists(status) && !fs::is_regular_file(status))) return false;
        made_.erase(folder_ / name);
        std::error_code failed;
        if (fs::is_regular_file(status))
          copy_file(fs::directory_entry(original_ / name), folder_ / name, {});
        else
          fs::remove(folder_ / name, failed);
      }
    copied_bytes_ = copied_bytes;  // what is copied again was counted before
    return true;
  }

  void copy_folder(const fs::path& from, const fs::path& to, bool deep, const std::map<fs::path, Stamp>& kept) {
    std::set<fs::path> wanted;
    std::error_code unread;
    const fs::directory_iterator entries(from, fs::directory_options::skip_permission_denied, unread);
    if (unread && unread != std::errc::no_such_file_or_directory)  // else it went away meanwhile
      throw fs::filesystem_error("cannot list", from, unread);
    for (const fs::directory_entry& entry : entries) {
      const fs::path name = entry.path().filename(), target = to / name;
      std::error_code failed;
      if (entry.is_directory(failed)) {
        if (entry.is_symlink(failed)) {  // it may lead back up: it stays a link
          link(fs::canonical(entry.path(), failed), target);
        } else if (deep && !is_hidden(name)) {
          if (!fs::is_directory(fs::symlink_status(target))) fs::remove_all(target), fs::create_directory(target);
          copy_folder(entry.path(), target, deep, kept);
        } else {
          continue;
        }
      } else if (entry.is_regular_file(failed)) {
        links_ = links_ || entry.is_symlink(failed);
        copy_file(entry, target, kept);
      } else {
        continue;
      }
      wanted.insert(name);
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(to))
      if (!wanted.contains(entry.path().filename())) fs::remove_all(entry.path());
  }

  static void link(const fs::path& to, const fs::path& name) {
    std::error_code failed;
    if (fs::is_symlink(fs::symlink_status(name)) && fs::read_symlink(name, failed) == to) return;
    fs::remove_all(name, failed);
    fs::create_symlink(to, name, failed);
  }

  void copy_file(const fs::directory_entry& entry, const fs::path& target, const std::map<fs::path, Stamp>& kept) {
    std::error_code failed;
    const std::uintmax_t size = entry.file_size(failed);
    if (failed) return;
    if (copied_bytes_ + size > kCopyBytes) return link(fs::absolute(entry.path()), target);
    copied_bytes_ += size;
    const Stamp now = stamp(entry.path());
    // A file written just now may be written once more without a change of its time.
    const bool settled = fs::file_time_type::clock::now() - now.time > std::chrono::milliseconds(100);
    const auto it = kept.find(target);
    if (settled && it != kept.end() && it->second == now && fs::is_regular_file(fs::symlink_status(target)) &&
        stamp(target) == now) {
      made_[target] = now;
      return;
    }
    fs::remove_all(target, failed);
    if (!fs::copy_file(entry.path(), target, failed)) {
      // An unreadable neighbour is not the scene's problem unless the scene asks for it; a cut copy would show another
      // picture.
      if (::access(entry.path().c_str(), R_OK) == 0) throw fs::filesystem_error("cannot copy", target, failed);
      return;
    }
    fs::permissions(target, fs::perms::owner_write, fs::perm_options::add, failed);
    fs::last_write_time(target, now.time, failed);
    if (settled && !failed) made_[target] = now;
  }

  void link_neighbours(const fs::path& base) const {
    const fs::path parent = original_.parent_path();
    if (parent == original_ || parent == parent.root_path()) return;
    int count = 0;
    std::error_code failed;
    for (auto it = fs::directory_iterator(parent, failed);
         !failed && it != fs::directory_iterator() && ++count <= kMaxNeighbours; it.increment(failed)) {
      std::error_code ignored;
      if (it->path() != original_) fs::create_symlink(it->path(), base / it->path().filename(), ignored);
    }
  }

  TemporaryFolder root_;
  fs::path original_, folder_;
  FolderWatch watch_original_, watch_copy_;  // nothing is known before they are made
  std::map<fs::path, Stamp> made_;
  std::uintmax_t copied_bytes_ = 0;
  bool links_ = false;  // files elsewhere, which nobody watches
};

namespace {

class Waiting {
 public:
  std::unique_ptr<FolderCopy> take(const fs::path& original) {
    const std::lock_guard lock(mutex_);
    for (auto it = copies_.begin(); it != copies_.end(); ++it)
      if ((*it)->original() == original) {
        std::unique_ptr<FolderCopy> out = std::move(*it);
        copies_.erase(it);
        return out;
      }
    return nullptr;
  }
  void give(std::unique_ptr<FolderCopy> copy) {
    std::unique_ptr<FolderCopy> oldest;  // removed from the disk without the lock
    const std::lock_guard lock(mutex_);
    copies_.push_back(std::move(copy));
    if (copies_.size() > kMaxWaiting) oldest = std::move(copies_.front()), copies_.pop_front();
  }

 private:
  std::mutex mutex_;
  std::deque<std::unique_ptr<FolderCopy>> copies_;
};

Waiting& waiting() {
  static Waiting instance;
  return instance;
}

}  // namespace

WorkingCopy::WorkingCopy(const fs::path& scene) : name_(scene.filename()) {
  const fs::path original = fs::canonical(scene).parent_path();
  copy_ = waiting().take(original);
  if (!copy_) copy_ = std::make_unique<FolderCopy>(original);
  copy_->synchronise();
  if (!fs::exists(copy_->folder() / name_))
    fs::copy_file(scene, copy_->folder() / name_);  // the scene itself was reached through a link
}

WorkingCopy::~WorkingCopy() {
  try {
    waiting().give(std::move(copy_));
  } catch (const std::exception&) {
    // Not kept.
  }
}

fs::path WorkingCopy::home() const { return copy_->home(); }
fs::path WorkingCopy::out() const { return copy_->out(); }
const fs::path& WorkingCopy::folder() const { return copy_->folder(); }

}  // namespace verisim::compare
