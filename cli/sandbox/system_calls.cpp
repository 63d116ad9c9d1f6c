#include "cli/sandbox/system_calls.h"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

// What is left of the file system is decided by Landlock; these take whatever can be opened.
constexpr int kAllowed[] = {
    // Open files.
    SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(preadv), SCMP_SYS(write), SCMP_SYS(writev),
    SCMP_SYS(pwrite64), SCMP_SYS(pwritev), SCMP_SYS(lseek), SCMP_SYS(close), SCMP_SYS(close_range), SCMP_SYS(dup),
    SCMP_SYS(dup2), SCMP_SYS(dup3), SCMP_SYS(fcntl), SCMP_SYS(flock), SCMP_SYS(fstat), SCMP_SYS(fstatfs),
    SCMP_SYS(ftruncate), SCMP_SYS(fallocate), SCMP_SYS(fadvise64), SCMP_SYS(fsync), SCMP_SYS(fdatasync),
    SCMP_SYS(fchmod), SCMP_SYS(sendfile), SCMP_SYS(copy_file_range), SCMP_SYS(getdents), SCMP_SYS(getdents64),
    SCMP_SYS(poll), SCMP_SYS(ppoll), SCMP_SYS(select), SCMP_SYS(pselect6), SCMP_SYS(pipe2), SCMP_SYS(eventfd2),
    SCMP_SYS(memfd_create),
    // Names.
    SCMP_SYS(stat), SCMP_SYS(lstat), SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(statfs), SCMP_SYS(access),
    SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd),
    SCMP_SYS(chdir), SCMP_SYS(rename), SCMP_SYS(renameat), SCMP_SYS(renameat2), SCMP_SYS(linkat), SCMP_SYS(unlink),
    SCMP_SYS(unlinkat), SCMP_SYS(umask),
    // Memory.
    SCMP_SYS(mmap), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(mprotect), SCMP_SYS(madvise), SCMP_SYS(msync),
    SCMP_SYS(mincore), SCMP_SYS(brk), SCMP_SYS(membarrier),
    // Threads.
    SCMP_SYS(futex), SCMP_SYS(futex_waitv), SCMP_SYS(set_robust_list), SCMP_SYS(get_robust_list), SCMP_SYS(rseq),
    SCMP_SYS(set_tid_address), SCMP_SYS(gettid), SCMP_SYS(getpid), SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity),
    SCMP_SYS(sched_getparam), SCMP_SYS(sched_getscheduler), SCMP_SYS(sched_get_priority_max),
    SCMP_SYS(sched_get_priority_min), SCMP_SYS(getcpu), SCMP_SYS(wait4), SCMP_SYS(waitid), SCMP_SYS(exit),
    SCMP_SYS(exit_group), SCMP_SYS(arch_prctl),
    // Signals that come, and time.
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
    SCMP_SYS(restart_syscall), SCMP_SYS(pause), SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres),
    SCMP_SYS(clock_nanosleep), SCMP_SYS(nanosleep), SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(times),
    // What the process and the machine are.
    SCMP_SYS(getuid), SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(getppid), SCMP_SYS(getrlimit),
    SCMP_SYS(getrusage), SCMP_SYS(sysinfo), SCMP_SYS(uname), SCMP_SYS(getrandom)};

constexpr int kServer[] = {
    SCMP_SYS(accept),       SCMP_SYS(accept4),           SCMP_SYS(recvfrom),        SCMP_SYS(recvmsg),
    SCMP_SYS(sendto),       SCMP_SYS(sendmsg),           SCMP_SYS(shutdown),        SCMP_SYS(getsockname),
    SCMP_SYS(getpeername),  SCMP_SYS(getsockopt),        SCMP_SYS(setsockopt),      SCMP_SYS(inotify_init1),
    SCMP_SYS(inotify_init), SCMP_SYS(inotify_add_watch), SCMP_SYS(inotify_rm_watch)};

constexpr unsigned long kControls[] = {TCGETS, TIOCGWINSZ, FIONREAD, FIONBIO};
#ifndef PR_SET_VMA
#define PR_SET_VMA 0x53564d41  // names of memory, which newer C libraries give
#endif
constexpr int kProcessControls[] = {PR_SET_NAME, PR_GET_NAME, PR_SET_VMA};

void require(int result) {
  if (result < 0)
    throw std::runtime_error(fmt::format("the sandbox cannot restrict system calls: {}", std::strerror(-result)));
}

class Filter {
 public:
  Filter() : context_(::seccomp_init(SCMP_ACT_ERRNO(EPERM)), ::seccomp_release) {
    if (!context_) require(-ENOMEM);
    require(::seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_ERRNO(EPERM)));
    require(::seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_TSYNC, 1));
    // The filter is no just-in-time code of strangers: older kernels would slow every thread down for nothing.
    require(::seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_SSB, 1));
    require(::seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2));
  }
  void allow(int call) { require(::seccomp_rule_add(context_.get(), SCMP_ACT_ALLOW, call, 0)); }
  // Where argument `index`, under the mask, is `value`.
  void allow(int call, unsigned index, std::uint64_t mask, std::uint64_t value) {
    const scmp_arg_cmp argument{index, SCMP_CMP_MASKED_EQ, mask, value};
    require(::seccomp_rule_add_array(context_.get(), SCMP_ACT_ALLOW, call, 1, &argument));
  }
  // As a kernel that does not have it.
  void missing(int call) { require(::seccomp_rule_add(context_.get(), SCMP_ACT_ERRNO(ENOSYS), call, 0)); }
  void load() { require(::seccomp_load(context_.get())); }

 private:
  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
};

}  // namespace

bool has_system_call_filters() {
  const std::uint32_t action = SECCOMP_RET_ERRNO;
  return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

void restrict_system_calls(bool server) {
  constexpr std::uint64_t kInt = 0xffffffffu;
  Filter filter;
  for (const int call : kAllowed) filter.allow(call);
  if (server)
    for (const int call : kServer) filter.allow(call);
  for (const unsigned long control : kControls) filter.allow(SCMP_SYS(ioctl), 1, kInt, control);
  for (const int control : kProcessControls) filter.allow(SCMP_SYS(prctl), 0, kInt, static_cast<unsigned>(control));
  // Kernels before 6.2 let O_TRUNC empty what may only be read: files are emptied by who opens them for writing.
  for (const auto& [call, flags] : {std::pair{SCMP_SYS(open), 1u}, std::pair{SCMP_SYS(openat), 2u}}) {
    filter.allow(call, flags, O_TRUNC, 0);
    filter.allow(call, flags, O_TRUNC | O_ACCMODE, O_TRUNC | O_WRONLY);
    filter.allow(call, flags, O_TRUNC | O_ACCMODE, O_TRUNC | O_RDWR);
  }
  // Threads, but no processes; by the call whose flags a filter can see.
  filter.allow(SCMP_SYS(clone), 0, CLONE_THREAD, CLONE_THREAD);
  filter.missing(SCMP_SYS(clone3));
  filter.missing(SCMP_SYS(openat2));
  // Its own limits, its own signals (abort).
  filter.allow(SCMP_SYS(prlimit64), 0, kInt, 0);
  filter.allow(SCMP_SYS(tgkill), 0, kInt, static_cast<unsigned>(::getpid()));
  filter.load();
}

}  // namespace verisim::cli
