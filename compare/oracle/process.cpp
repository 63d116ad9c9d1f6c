#include "compare/oracle/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "tracer/base/descriptor.h"

namespace verisim::compare {
namespace {

using Clock = std::chrono::steady_clock;

// What a stream says, its end only when it says too much.
class Tail {
 public:
  // Reads what is there; false at the end of the stream.
  bool read_from(int fd) {
    char buffer[16384];
    for (;;) {
      const ssize_t n = ::read(fd, buffer, sizeof buffer);
      if (n > 0) text_.append(buffer, static_cast<std::size_t>(n));
      if (text_.size() > 2 * kKeep) text_.erase(0, text_.size() - kKeep);
      if (n == 0) return false;
      if (n < 0) return errno == EAGAIN || errno == EINTR;
    }
  }
  std::string take() {
    if (text_.size() > kKeep) text_.erase(0, text_.size() - kKeep);
    return std::move(text_);
  }

 private:
  static constexpr std::size_t kKeep = 256 * 1024;
  std::string text_;
};

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

// VmHWM of a living process; 0 if unknown.
std::uint64_t resident_peak(pid_t pid) {
  std::ifstream status(fmt::format("/proc/{}/status", pid));
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::strtoull(line.c_str() + 6, nullptr, 10) * 1024;
  return 0;
}

struct Child {
  const char* folder;  // null: ours
  int in, out, err;
  pid_t parent;
  char* const* argv;
  char* const* envp;
};

// In the new process, which shares our memory until it has become the other program: nothing but system calls. It dies
// with the thread that waits for it, so that a kill of this program leaves nothing running (posix_spawn cannot ask for
// that). Returns only with the error of what failed.
int become(const Child& child) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != child.parent) _exit(127);
  setpgid(0, 0);
  if (dup2(child.in, 0) < 0 || dup2(child.out, 1) < 0 || dup2(child.err, 2) < 0 ||
      (child.folder && chdir(child.folder) != 0))
    return errno;
  if (child.in == 0) fcntl(0, F_SETFD, 0);  // it got that number, and would close
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  for (int signal = 1; signal < NSIG; ++signal) sigaction(signal, &usual, nullptr);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execve(child.argv[0], child.argv, child.envp);
  return errno;
}

// Signals wait meanwhile: our handlers must not run in the child. `error` is written by the child.
[[gnu::noinline]] pid_t start(const Child& child, volatile int& error) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t pid = vfork();
  if (pid == 0) {
    error = become(child);
    _exit(127);
  }
  if (pid < 0) error = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return pid;
}

int spawn(const ProcessRequest& request, int out, int err, pid_t& pid) {
  std::vector<std::string> environment;
  for (const auto& [key, value] : request.environment) environment.push_back(key + "=" + value);
  std::vector<char*> argv, envp;
  for (const std::string& s : request.arguments) argv.push_back(const_cast<char*>(s.c_str()));
  for (const std::string& s : environment) envp.push_back(const_cast<char*>(s.c_str()));
  argv.push_back(nullptr), envp.push_back(nullptr);
  const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  if (!nothing) return errno;
  volatile int error = 0;
  pid = start({request.folder.empty() ? nullptr : request.folder.c_str(), nothing.get(), out, err, getpid(),
               argv.data(), envp.data()},
              error);
  if (error && pid > 0) waitpid(pid, nullptr, 0);
  return error;
}

bool make_pipe(Descriptor& read_end, Descriptor& write_end) {
  int fds[2];
  if (pipe2(fds, O_CLOEXEC) != 0) return false;
  read_end = Descriptor(fds[0]), write_end = Descriptor(fds[1]);
  return fcntl(fds[0], F_SETFL, O_NONBLOCK) == 0;
}

}  // namespace

ProcessResult run_process(const ProcessRequest& request) {
  ProcessResult result;
  Descriptor out_read, out_write, err_read, err_write;
  if (request.arguments.empty() || !make_pipe(out_read, out_write) || !make_pipe(err_read, err_write)) {
    result.start_error = std::strerror(errno);
    return result;
  }
  const auto start = Clock::now();
  pid_t pid = -1;
  if (const int error = spawn(request, out_write.get(), err_write.get(), pid)) {
    result.start_error = fmt::format("{}: {}", request.arguments[0], std::strerror(error));
    return result;
  }
  result.started = true;
  out_write.close(), err_write.close();
  const Descriptor process(
      static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));  // readable at the end; kernels without it are polled

  Tail out, err;
  bool out_open = true, err_open = true;
  rusage usage{};
  int status = 0;
  std::uint64_t sampled_peak = 0;
  for (;;) {
    pollfd fds[3] = {{out_open ? out_read.get() : -1, POLLIN, 0},
                     {err_open ? err_read.get() : -1, POLLIN, 0},
                     {process.get(), POLLIN, 0}};
    poll(fds, 3, 10);
    if (fds[0].revents) out_open = out.read_from(out_read.get());
    if (fds[1].revents) err_open = err.read_from(err_read.get());
    const pid_t ended = wait4(pid, &status, WNOHANG, &usage);
    if (ended == pid || (ended < 0 && errno != EINTR)) break;
    sampled_peak = std::max(sampled_peak, resident_peak(pid));
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    if (!result.timed_out && request.time_limit > 0 && elapsed > request.time_limit)
      result.timed_out = true, kill(-pid, SIGKILL);
    if (!result.cancelled && request.cancel && *request.cancel) result.cancelled = true, kill(-pid, SIGKILL);
  }
  result.wall = std::chrono::duration<double>(Clock::now() - start).count();
  kill(-pid, SIGKILL);  // children it left behind
  if (out_open) out.read_from(out_read.get());
  if (err_open) err.read_from(err_read.get());
  result.out = out.take(), result.err = err.take();
  result.cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  // Linux counts the parent's pages between vfork and exec to the child: ru_maxrss says nothing unless it is larger
  // than ours.
  rusage own{};
  getrusage(RUSAGE_SELF, &own);
  result.peak_bytes = usage.ru_maxrss > own.ru_maxrss || sampled_peak == 0
                          ? static_cast<std::uint64_t>(usage.ru_maxrss) * 1024
                          : sampled_peak;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

std::string ProcessResult::how_it_ended(double time_limit) const {
  if (!started) return "could not be started: " + start_error;
  if (timed_out) return fmt::format("no end after {:g} s", time_limit);
  if (cancelled) return "cancelled";
  if (signal) return fmt::format("killed by signal {} ({})", signal, strsignal(signal));
  return fmt::format("exit status {}", exit_code);
}

std::filesystem::path find_program(const std::string& name) {
  const auto executable = [](const std::filesystem::path& p) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(p, ignored) && access(p.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos)
    return executable(name) ? std::filesystem::absolute(name) : std::filesystem::path();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const auto candidate = std::filesystem::path(folder.empty() ? "." : folder) / name; executable(candidate))
      return std::filesystem::absolute(candidate);
  return {};
}

std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace verisim::compare
