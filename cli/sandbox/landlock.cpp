#include "cli/sandbox/landlock.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "tracer/base/descriptor.h"

namespace verisim::cli {
namespace {

// Rights and fields that are younger than the headers of Debian 12 (linux/landlock.h of Linux 6.2 to 6.12).
constexpr std::uint64_t kRefer = 1u << 13, kTruncate = 1u << 14, kDeviceControl = 1u << 15;
constexpr std::uint64_t kNetwork = 3;  // bind and connect
constexpr std::uint64_t kScopes = 3;   // abstract sockets, signals
struct Ruleset {
  std::uint64_t files, network, scopes;
};

constexpr std::uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kWriteFile = LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;
constexpr std::uint64_t kMakeFiles = kWriteFile | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REMOVE_FILE;
constexpr std::uint64_t kOfFiles = LANDLOCK_ACCESS_FS_READ_FILE | kWriteFile;  // rights that make sense for one file

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(fmt::format("the sandbox cannot {}: {}", what, std::strerror(errno)));
}

// All rights of this version of the interface: each is refused unless a rule grants it.
Ruleset handled(int version) {
  Ruleset all{kRefer - 1, 0, 0};
  if (version >= 2) all.files |= kRefer;
  if (version >= 3) all.files |= kTruncate;
  if (version >= 4) all.network = kNetwork;
  if (version >= 5) all.files |= kDeviceControl;
  if (version >= 6) all.scopes = kScopes;
  return all;
}

void grant(const Descriptor& ruleset, const std::filesystem::path& path, std::uint64_t rights) {
  const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat about {};
  if (place.get() < 0 || ::fstat(place.get(), &about) != 0) return;
  landlock_path_beneath_attr rule{};
  rule.parent_fd = place.get();
  rule.allowed_access = S_ISDIR(about.st_mode) ? rights : rights & kOfFiles;
  if (rule.allowed_access == 0) return;
  if (::syscall(SYS_landlock_add_rule, ruleset.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
    throw std::runtime_error(fmt::format("the sandbox cannot let '{}' in: {}", path.string(), std::strerror(errno)));
}

}  // namespace

int landlock_version() {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return version > 0 ? static_cast<int>(version) : 0;
}

void restrict_files(const Policy& policy) {
  const int version = landlock_version();
  const Ruleset all = handled(version);
  const std::size_t size = version >= 6 ? sizeof all : version >= 4 ? 16 : 8;
  const Descriptor ruleset(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, size, 0)));
  if (ruleset.get() < 0) fail("make its rules");
  for (const auto& path : policy.read) grant(ruleset, path, kRead & all.files);
  for (const auto& path : policy.write) grant(ruleset, path, kMakeFiles & all.files);
  for (const auto& path : policy.write_files) grant(ruleset, path, kWriteFile & all.files);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail("give up new privileges");
  if (::syscall(SYS_landlock_restrict_self, ruleset.get(), 0) != 0) fail("restrict files");
}

}  // namespace verisim::cli
