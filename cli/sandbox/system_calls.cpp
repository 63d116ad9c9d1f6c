#include "cli/sandbox/system_calls.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>  // the numbers of calls by their names, on any machine
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

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

constexpr std::uint32_t kControls[] = {TCGETS, TIOCGWINSZ, FIONREAD, FIONBIO};
#ifndef PR_SET_VMA
#define PR_SET_VMA 0x53564d41  // names of memory, which newer C libraries give
#endif
constexpr int kProcessControls[] = {PR_SET_NAME, PR_GET_NAME, PR_SET_VMA};

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
constexpr std::uint32_t kFirstOfOtherTable = 0x40000000;  // calls of x32
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
constexpr std::uint32_t kFirstOfOtherTable = 0xffffffff;
#else
constexpr std::uint32_t kArchitecture = 0;  // not known here: nothing would be left
constexpr std::uint32_t kFirstOfOtherTable = 0;
#endif

// The program that the kernel runs for each call. Written here and not by libseccomp, whose 2.5 frees twice, hangs or
// leaves rules out, and calls that a success, where an allocation fails.
class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    skip_unless(BPF_JEQ, kArchitecture, 1);
    add(BPF_JUMP(BPF_JMP | BPF_JA, 1, 0, 0));
    end(SECCOMP_RET_ERRNO | EPERM);
    load(offsetof(seccomp_data, nr));
    skip_unless(BPF_JGE, kFirstOfOtherTable, 1);
    end(SECCOMP_RET_ERRNO | EPERM);
  }
  void allow(int call) { answer(call, SECCOMP_RET_ALLOW); }
  // As a kernel that does not have it.
  void missing(int call) { answer(call, SECCOMP_RET_ERRNO | ENOSYS); }
  // Where argument `index`, under the mask, is `value`.
  void allow(int call, unsigned index, std::uint32_t mask, std::uint32_t value) {
    if (call < 0) return;
    skip_unless(BPF_JEQ, static_cast<std::uint32_t>(call), 5);
    load(static_cast<unsigned>(offsetof(seccomp_data, args) + index * sizeof(std::uint64_t)));  // its low half
    add(BPF_STMT(BPF_ALU | BPF_AND | BPF_K, mask));
    skip_unless(BPF_JEQ, value, 1);
    end(SECCOMP_RET_ALLOW);
    load(offsetof(seccomp_data, nr));
  }
  // For all threads. The filter is no just-in-time code of strangers: without SPEC_ALLOW older kernels would slow every
  // thread down for nothing.
  void enter() {
    end(SECCOMP_RET_ERRNO | EPERM);
    const sock_fprog filter{static_cast<unsigned short>(code_.size()), code_.data()};
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail(errno);
    const long result = ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER,
                                  SECCOMP_FILTER_FLAG_TSYNC | SECCOMP_FILTER_FLAG_SPEC_ALLOW, &filter);
    if (result != 0) fail(result < 0 ? errno : EBUSY);
  }

 private:
  [[noreturn]] static void fail(int error) {
    throw std::runtime_error(fmt::format("the sandbox cannot restrict system calls: {}", std::strerror(error)));
  }
  void add(sock_filter instruction) { code_.push_back(instruction); }
  void load(unsigned offset) { add(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offset)); }
  void end(std::uint32_t action) { add(BPF_STMT(BPF_RET | BPF_K, action)); }
  void skip_unless(unsigned short test, std::uint32_t value, unsigned char instructions) {
    add(BPF_JUMP(static_cast<unsigned short>(BPF_JMP | BPF_K | test), value, 0, instructions));
  }
  // A negative number: there is no such call on this machine.
  void answer(int call, std::uint32_t action) {
    if (call < 0) return;
    skip_unless(BPF_JEQ, static_cast<std::uint32_t>(call), 1);
    end(action);
  }

  std::vector<sock_filter> code_;
};

}  // namespace

bool has_system_call_filters() {
  const std::uint32_t action = SECCOMP_RET_ERRNO;
  return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

void restrict_system_calls(bool server) {
  constexpr std::uint32_t kInt = 0xffffffffu;
  Filter filter;
  for (const int call : kAllowed) filter.allow(call);
  if (server)
    for (const int call : kServer) filter.allow(call);
  for (const std::uint32_t control : kControls) filter.allow(SCMP_SYS(ioctl), 1, kInt, control);
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
  filter.enter();
}

}  // namespace verisim::cli
