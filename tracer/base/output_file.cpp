#include "tracer/base/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace verisim {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& action, const std::string& reason) {
  throw std::runtime_error("cannot " + action + " '" + path.string() + "': " + reason);
}

std::string last_error() { return std::strerror(errno); }

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : "."; }

// The number of the open file of this process that a link in /proc stands for; negative: it is another link. Such a
// link names nothing that could be opened by that name, or a file that is being written already.
int own_open_file(const fs::path& link) {
  std::error_code failed;
  if (fs::canonical(folder_of(link), failed) != fs::path("/proc") / std::to_string(::getpid()) / "fd") return -1;
  return std::atoi(link.filename().c_str());
}

struct Target {
  fs::path path;                              // behind all links
  bool in_place = false;                      // there is something that is not a regular file
  int open_file = -1;                         // of this process; it is in place, too
  std::optional<mode_t> mode = std::nullopt;  // permissions of the regular file that is there
};

Target target_of(const fs::path& name) {
  Target target{name};
  constexpr int kMaxLinks = 40;  // as many as Linux follows
  std::error_code failed;
  for (int links = 0; !target.in_place && fs::is_symlink(target.path, failed); ++links) {
    if (links == kMaxLinks) fail(name, "create", std::strerror(ELOOP));
    target.open_file = own_open_file(target.path);
    target.in_place = target.open_file >= 0;
    if (!target.in_place) target.path = target.path.parent_path() / fs::read_symlink(target.path);
  }
  struct stat about {};
  if (target.in_place || ::stat(target.path.c_str(), &about) != 0) return target;
  if (S_ISDIR(about.st_mode)) fail(name, "write", "it is a folder");
  target.in_place = !S_ISREG(about.st_mode);
  if (!target.in_place) target.mode = about.st_mode & 0777;
  return target;
}

// Names of files that are not whole yet, of this process and its threads.
fs::path temporary_name(fs::path path, std::string_view extension = "") {
  static std::atomic<unsigned> count{0};
  path += "." + std::to_string(::getpid()) + "." + std::to_string(count++) + ".tmp";
  path += extension;
  return path;
}

// What a name is given to must be on the disk before the name: after a power cut there is the old file or the new one.
// Some file systems have nothing to wait for, and say so.
bool on_disk(int fd) { return ::fdatasync(fd) == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP; }

// The same for a file that is closed, which gets its permissions, too.
bool on_disk(const fs::path& path, const std::optional<mode_t>& mode) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool safe = on_disk(fd);
  const int failed = errno;
  if (mode && ::fchmod(fd, *mode) != 0) errno = 0;  // some file systems have no permissions
  ::close(fd);
  errno = failed;
  return safe;
}

}  // namespace

fs::path behind_links(const fs::path& path) { return target_of(path).path; }

OutputFile::OutputFile(const fs::path& path) : name_(path) {
  const Target target = target_of(path);
  path_ = target.path, in_place_ = target.in_place, temporary_ = temporary_name(path_);
  if (!in_place_) open_new(target.mode);
  const bool sealed_folder = !file_ && target.mode && (errno == EACCES || errno == EROFS || errno == EPERM);
  if (in_place_ || sealed_folder) {
    in_place_ = true;
    std::fflush(stdout);  // which may be the same file
    const int fd = target.open_file >= 0 ? ::dup(target.open_file)
                                         : ::open(path_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC | O_TRUNC);
    if (fd >= 0) file_.reset(::fdopen(fd, "wb"));
  }
  if (!file_) fail(name_, "create", last_error());
}

OutputFile::~OutputFile() {
  if (named_) ::unlink(temporary_.c_str());
}

// Without a name, where the file system can do that (O_TMPFILE), not even a kill leaves anything behind.
void OutputFile::open_new(const std::optional<unsigned>& mode) {
  int fd = ::access("/proc/self/fd", X_OK) == 0
               ? ::open(folder_of(path_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666)
               : -1;
  if (fd < 0) {
    fd = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    named_ = fd >= 0;
  }
  if (fd < 0) return;
  if (mode && ::fchmod(fd, *mode) != 0) errno = 0;  // some file systems have no permissions
  file_.reset(::fdopen(fd, "wb"));
}

void OutputFile::publish() {
  if (std::fflush(file_.get()) != 0 || std::ferror(file_.get())) fail(name_, "write", last_error());
  if (in_place_) return;
  if (!on_disk(::fileno(file_.get()))) fail(name_, "write", last_error());
  if (!named_) {
    const std::string self = "/proc/self/fd/" + std::to_string(::fileno(file_.get()));
    if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path_.c_str(), AT_SYMLINK_FOLLOW) == 0) return;
    if (errno != EEXIST || ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0)
      fail(name_, "write", last_error());
    named_ = true;
  }
  file_.reset();
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(name_, "write", last_error());
  named_ = false;
}

void require_writable(const fs::path& path) {
  const Target target = target_of(path);
  if (target.in_place) {
    if (::access(target.path.c_str(), W_OK) != 0) fail(path, "write", last_error());
    return;
  }
  const fs::path folder = folder_of(target.path);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) fail(path, "write", "there is no folder '" + folder.string() + "'");
  if (target.mode && ::access(target.path.c_str(), W_OK) == 0) return;
  // What access() says is not all: the disk may be full of files.
  if (const int nameless = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600); nameless >= 0) {
    ::close(nameless);
    return;
  }
  std::string probe = (folder / ".verisim-XXXXXX").string();
  const int file = ::mkstemp(probe.data());
  if (file < 0) fail(path, "write", last_error());
  ::close(file);
  ::unlink(probe.c_str());
}

void write_text_file(const fs::path& path, std::string_view text) {
  OutputFile file(path);
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) fail(path, "write", last_error());
  file.publish();
}

void copy_into(const fs::path& from, std::FILE* to) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(from.c_str(), "rbe"), std::fclose);
  if (!file) fail(from, "read", last_error());
  char buffer[65536];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;)
    if (std::fwrite(buffer, 1, n, to) != n) throw std::runtime_error(last_error());
  if (std::ferror(file.get())) fail(from, "read", last_error());
}

void write_by_name(const fs::path& name, std::string_view extension,
                   const std::function<void(const fs::path& temporary)>& body) {
  const fs::path path = name == "-" ? "/proc/self/fd/1" : name;
  const Target target = target_of(path);
  const fs::path temporary =
      temporary_name(target.in_place ? fs::temp_directory_path() / "verisim" : target.path, extension);
  try {
    body(temporary);
    if (target.in_place) {
      OutputFile file(path);
      copy_into(temporary, file.get());
      file.publish();
      ::unlink(temporary.c_str());
      return;
    }
    if (!on_disk(temporary, target.mode)) throw std::runtime_error(last_error());
    if (::rename(temporary.c_str(), target.path.c_str()) != 0) throw std::runtime_error(last_error());
  } catch (const std::exception& error) {
    ::unlink(temporary.c_str());
    fail(path, "write", error.what());
  }
}

}  // namespace verisim
