// A library for LD_PRELOAD that lets the n-th call of one kind fail (tests/faults/run.py).
//
//   FAULT=write FAULT_AT=3 LD_PRELOAD=libverisim_faults.so verisim ...    the third write fails
//   FAULT=write FAULT_COUNT=counts.txt ...                                none does; how many there were
//   FAULT=order FAULT_LOG=log.txt ...                                     none does; what is written, synced and named,
//   in order
//
// Kinds: write, read, open, mmap, rename (and linkat), fsync, malloc, thread. System calls are caught by a filter of
// the kernel's (seccomp), in the insides of the C library and of the loader, too: the filter sends SIGSYS where one
// comes from their code, and the handler makes the call itself, from here, or fails it. A program that is started
// inherits the filter, but has these libraries at other addresses, so that its calls are none of those.
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {

// A call that is not caught.
long verisim_faults_call(long number, long a, long b, long c, long d, long e, long f);

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

asm(R"(
.text
.globl verisim_faults_call
verisim_faults_call:
  mov %rdi, %rax
  mov %rsi, %rdi
  mov %rdx, %rsi
  mov %rcx, %rdx
  mov %r8, %r10
  mov %r9, %r8
  mov 8(%rsp), %r9
  syscall
  ret
)");

namespace {

struct Kind {
  const char* name;
  int error;
  long calls[6];  // -1: the end; none: functions of the library
};
constexpr Kind kKinds[] = {{"write", ENOSPC, {SYS_write, SYS_writev, SYS_pwrite64, SYS_sendfile, -1}},
                           {"read", EIO, {SYS_read, SYS_readv, SYS_pread64, -1}},
                           {"open", EMFILE, {SYS_open, SYS_openat, -1}},
                           {"mmap", ENOMEM, {SYS_mmap, SYS_mremap, SYS_brk, -1}},
                           {"rename", EIO, {SYS_rename, SYS_renameat, SYS_renameat2, SYS_linkat, -1}},
                           {"fsync", EIO, {SYS_fsync, SYS_fdatasync, -1}},
                           {"order", 0, {SYS_write, SYS_fdatasync, SYS_rename, SYS_linkat, -1}},
                           {"malloc", ENOMEM, {-1}},
                           {"thread", EAGAIN, {-1}}};

const Kind* kind = nullptr;
std::atomic<long> count{0};
long fails_at = 0;
bool armed = false;

bool fails() { return armed && count.fetch_add(1) + 1 == fails_at; }
bool is(const char* name) { return kind && std::strcmp(kind->name, name) == 0; }

long call(long number, long a = 0, long b = 0, long c = 0, long d = 0) {
  return verisim_faults_call(number, a, b, c, d, 0, 0);
}
long address(const char* text) { return reinterpret_cast<long>(text); }

int log_file = -1;

// A line of the log: the word and the path behind an open file, or behind a link in /proc that stands for one.
void log(const char* word, const char* link, const char* name = "") {
  char path[1024], line[2200];
  const long length = call(SYS_readlink, address(link), address(path), sizeof path - 1);
  path[length > 0 ? length : 0] = 0;
  const int size = std::snprintf(line, sizeof line, "%s\t%s\t%s\n", word, length > 0 ? path : link, name);
  call(SYS_write, log_file, address(line), size);
}
void log(const char* word, long file) {
  char link[64];
  std::snprintf(link, sizeof link, "/proc/self/fd/%ld", file);
  log(word, link);
}
void log(long number, const greg_t* registers) {
  const auto text = [&](int place) { return reinterpret_cast<const char*>(registers[place]); };
  if (number == SYS_write) log("write", registers[REG_RDI]);
  if (number == SYS_fdatasync) log("sync", registers[REG_RDI]);
  if (number == SYS_rename) log("name", text(REG_RDI), text(REG_RSI));
  if (number == SYS_linkat) log("name", text(REG_RSI), text(REG_R10));
}

void on_call(int, siginfo_t* info, void* context) {
  const int saved = errno;
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  if (log_file >= 0) log(info->si_syscall, registers);
  // A failing brk gives the old end of the heap, not an error.
  const long refused = info->si_syscall == SYS_brk ? verisim_faults_call(SYS_brk, 0, 0, 0, 0, 0, 0) : -kind->error;
  registers[REG_RAX] =
      fails() ? refused
              : verisim_faults_call(info->si_syscall, registers[REG_RDI], registers[REG_RSI], registers[REG_RDX],
                                    registers[REG_R10], registers[REG_R8], registers[REG_R9]);
  errno = saved;
}

// Where the code of the C library and of the loader is: [begin, end), none across a multiple of 4 GiB.
struct Code {
  struct Range {
    std::uint64_t begin, end;
  } ranges[4];
  int count = 0;

  void add(std::uint64_t begin, std::uint64_t end) {
    const std::uint64_t border = (begin | 0xffffffff) + 1;
    if (end > border) add(border, end), end = border;
    if (count < 4) ranges[count++] = {begin, end};
  }
};
Code code_that_calls() {
  Code code;
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* data) {
        if (!std::strstr(library->dlpi_name, "/libc.so") && !std::strstr(library->dlpi_name, "/ld-linux")) return 0;
        for (int i = 0; i < library->dlpi_phnum; ++i)
          if (const auto& part = library->dlpi_phdr[i]; part.p_type == PT_LOAD && (part.p_flags & PF_X))
            static_cast<Code*>(data)->add(library->dlpi_addr + part.p_vaddr,
                                          library->dlpi_addr + part.p_vaddr + part.p_memsz);
        return 0;
      },
      &code);
  return code;
}

void catch_calls() {
  struct sigaction action {};
  action.sa_sigaction = on_call;
  action.sa_flags = SA_SIGINFO | SA_NODEFER | SA_RESTART;
  sigaction(SIGSYS, &action, nullptr);
  sock_filter program[64] = {};
  unsigned short length = 0;
  const Code code = code_that_calls();
  for (int i = 0; i < code.count; ++i) {
    const auto [begin, end] = code.ranges[i];
    program[length++] = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, instruction_pointer) + 4);
    program[length++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(begin >> 32), 0, 4);
    program[length++] = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, instruction_pointer));
    program[length++] = BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, static_cast<std::uint32_t>(begin), 0, 2);
    program[length++] = BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, static_cast<std::uint32_t>(end - 1), 1, 0);
    program[length++] = BPF_STMT(BPF_JMP | BPF_JA, static_cast<std::uint32_t>(6 * (code.count - 1 - i) + 1));
  }
  program[length++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  program[length++] = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
  for (const long* call = kind->calls; *call >= 0; ++call) {
    program[length++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(*call), 0, 1);
    program[length++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP);
  }
  program[length++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  const sock_fprog filter{length, program};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) {
    static const char text[] = "faults: this kernel has no filters of system calls\n";
    if (::write(2, text, sizeof text - 1) >= 0) _exit(77);
    _exit(77);
  }
}

void report() {
  armed = false;
  const char* name = std::getenv("FAULT_COUNT");
  if (!name) return;
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%ld\n", count.load());
  const auto file = static_cast<int>(verisim_faults_call(SYS_openat, AT_FDCWD, reinterpret_cast<long>(name),
                                                         O_WRONLY | O_CREAT | O_TRUNC, 0600, 0, 0));
  verisim_faults_call(SYS_write, file, reinterpret_cast<long>(text), length, 0, 0, 0);
}

__attribute__((constructor)) void start() {
  const char* name = std::getenv("FAULT");
  const char* at = std::getenv("FAULT_AT");
  // Of a chain of programs (compare and its renders) the one is meant whose second argument this is.
  const char* command = std::getenv("FAULT_COMMAND");
  if (command) {
    char line[4096] = {};
    const int file = ::open("/proc/self/cmdline", O_RDONLY | O_CLOEXEC);
    const long size = file >= 0 ? ::read(file, line, sizeof line - 1) : 0;
    if (file >= 0) ::close(file);
    const char* second = size > 0 ? line + std::strlen(line) + 1 : line;
    if (std::strcmp(second, command) != 0) return;
  }
  if (!name) return;
  for (const Kind& k : kKinds)
    if (std::strcmp(k.name, name) == 0) kind = &k;
  if (!kind) return;
  fails_at = at ? std::atol(at) : 0;
  if (const char* log = std::getenv("FAULT_LOG"); log && is("order"))
    log_file = ::open(log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  std::atexit(report);
  if (kind->calls[0] >= 0) catch_calls();
  armed = true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  if (is("malloc") && fails()) return errno = ENOMEM, nullptr;
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
  if (is("malloc") && fails()) return errno = ENOMEM, nullptr;
  return __libc_calloc(n, size);
}
void* realloc(void* old, std::size_t size) {
  if (is("malloc") && fails()) return errno = ENOMEM, nullptr;
  return __libc_realloc(old, size);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  if (is("malloc") && fails()) return ENOMEM;
  *result = __libc_memalign(alignment, size);
  return *result ? 0 : ENOMEM;
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  if (is("malloc") && fails()) return errno = ENOMEM, nullptr;
  return __libc_memalign(alignment, size);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  if (is("thread") && fails()) return EAGAIN;
  return create(thread, attributes, run, argument);
}
}
