// The fuzzers' main function where there is no libFuzzer (GCC): the same targets, with inputs of the corpora changed at
// random, blind to what they reach:
//   TARGET_fuzz [-max_total_time=SECONDS] [-seed=N] [-artifact_prefix=PREFIX] [-timeout=SECONDS] FOLDER...
// An input that ends the process is in PREFIXinput afterwards.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" {
int LLVMFuzzerInitialize(int* argc, char*** argv);
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
__attribute__((weak)) std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t a_size,
                                                            const std::uint8_t* b, std::size_t b_size,
                                                            std::uint8_t* out, std::size_t max_size, unsigned int seed);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
}

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kMaxSize = std::size_t{1} << 20;
std::mt19937 random_numbers;

std::size_t below(std::size_t n) { return n ? random_numbers() % n : 0; }

std::vector<Bytes> files_below(const std::string& folder) {
  std::vector<Bytes> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.file_size() > kMaxSize) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return all;
}

// One change: a bit, a byte, a number of up to eight bytes, or a run of bytes lost, doubled or overwritten by another.
void change(Bytes& bytes, std::size_t max_size) {
  constexpr std::uint64_t kOdd[] = {0,      1,      0x7f,       0x80,       0xff,       0x7fff,
                                    0x8000, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff, ~0ull};
  const std::size_t at = below(bytes.size()), run = 1 + below(std::size_t{1} << below(9));
  const std::size_t length = std::min(run, bytes.size() - at);
  const auto place = [&](std::size_t n) { return bytes.begin() + static_cast<std::ptrdiff_t>(n); };
  switch (bytes.empty() ? 3 : below(7)) {
    case 0:
      bytes[at] ^= static_cast<std::uint8_t>(1u << below(8));
      break;
    case 1:
      bytes[at] = static_cast<std::uint8_t>(random_numbers());
      break;
    case 2: {
      const std::uint64_t value = kOdd[below(std::size(kOdd))];
      const bool big = below(2);
      for (std::size_t k = 0, n = std::size_t{1} << below(4); k < n && at + k < bytes.size(); ++k)
        bytes[at + k] = static_cast<std::uint8_t>(value >> 8 * (big ? n - 1 - k : k));
      break;
    }
    case 3:
      bytes.insert(place(at), std::min(run, max_size - std::min(max_size, bytes.size())),
                   static_cast<std::uint8_t>(random_numbers()));
      break;
    case 4:
      bytes.erase(place(at), place(at + length));
      break;
    case 5: {
      const Bytes copy(place(at), place(at + length));
      if (bytes.size() + length <= max_size) bytes.insert(place(below(bytes.size())), copy.begin(), copy.end());
      break;
    }
    default:
      std::memmove(bytes.data() + below(bytes.size() - length + 1), bytes.data() + at, length);
  }
}

Bytes next_input(const std::vector<Bytes>& corpus) {
  const Bytes &a = corpus[below(corpus.size())], &b = corpus[below(corpus.size())];
  if (LLVMFuzzerCustomCrossOver && below(4)) {
    Bytes out(std::size_t{1} << 14);
    out.resize(LLVMFuzzerCustomCrossOver(a.data(), a.size(), b.data(), b.size(), out.data(), out.size(),
                                         static_cast<unsigned>(random_numbers())));
    return out;
  }
  Bytes out = a;
  for (std::size_t n = 1 + below(std::size_t{1} << below(5)); n > 0; --n) change(out, kMaxSize);
  return out;
}

// What the process that tries inputs leaves to the one that started it.
struct Shared {
  std::uint64_t runs;
  std::size_t size;
  std::uint8_t input[kMaxSize];  // under way
};
Shared* shared = nullptr;

void run(const Bytes& input, unsigned timeout) {
  if (!input.empty()) std::memcpy(shared->input, input.data(), input.size());
  shared->size = input.size();
  ::alarm(timeout);
  LLVMFuzzerTestOneInput(input.data(), input.size());
  ++shared->runs;
}

void run_for(double seconds, const std::vector<Bytes>& corpus, unsigned timeout) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (const Bytes& input : corpus) run(input, timeout);
  while (Clock::now() < end) run(next_input(corpus), timeout);
}

// Says how the process ended, and keeps what ended it.
int outcome(int status, const std::string& prefix) {
  std::fprintf(stderr, "stat::number_of_executed_units: %llu\n", static_cast<unsigned long long>(shared->runs));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return 0;
  std::ofstream(prefix + "input", std::ios::binary)
      .write(reinterpret_cast<const char*>(shared->input), static_cast<std::streamsize>(shared->size));
  std::fprintf(stderr, "found: %sinput\n", prefix.c_str());
  return 1;
}

}  // namespace

// A trace of each allocation, large blocks that were freed and copies of stacks would take most of the time.
extern "C" const char* __asan_default_options() {
  return "malloc_context_size=2:quarantine_size_mb=16:detect_stack_use_after_return=0:intercept_tls_get_addr=0";
}

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
  Bytes bytes(data, data + size);
  change(bytes, max_size);
  bytes.resize(std::min(bytes.size(), max_size));
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

int main(int argc, char** argv) {
  double seconds = 60;
  unsigned timeout = 25;
  std::string prefix = fs::current_path().string() + "/";
  std::vector<Bytes> corpus;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::string value = argument.substr(argument.find('=') + 1);
    if (argument.starts_with("-max_total_time="))
      seconds = std::stod(value);
    else if (argument.starts_with("-seed="))
      random_numbers.seed(static_cast<unsigned>(std::stoul(value)));
    else if (argument.starts_with("-timeout="))
      timeout = static_cast<unsigned>(std::stoul(value));
    else if (argument.starts_with("-artifact_prefix="))
      prefix = value;
    else if (argument[0] != '-')
      for (Bytes& bytes : files_below(argument)) corpus.push_back(std::move(bytes));
  }
  if (corpus.empty()) return std::fputs("no inputs\n", stderr), 2;
  LLVMFuzzerInitialize(&argc, &argv);
  void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return std::perror("mmap"), 2;
  shared = static_cast<Shared*>(memory);
  const pid_t child = ::fork();
  if (child < 0) return std::perror("fork"), 2;
  if (child == 0) return run_for(seconds, corpus, timeout), 0;
  int status = 0;
  ::waitpid(child, &status, 0);
  return outcome(status, prefix);
}
