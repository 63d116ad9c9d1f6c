#include "cli/frame/state_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "tracer/base/output_file.h"

namespace verisim::cli {
namespace {

constexpr std::array<char, 16> kMagic{'v', 'e', 'r', 'i', 's', 'i', 'm', '-', 's', 't', 'a', 't', 'e', '-', '1', '\n'};
constexpr std::size_t kHeaderBytes = kMagic.size() + 16;   // key, checksum
constexpr std::size_t kBytesPerPixel = 4 * sizeof(float);  // r g b transmit
constexpr std::size_t kRecordHead = 4 * sizeof(std::int32_t);

std::uint64_t mixed(std::uint64_t h) {  // the finaliser of SplitMix64
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
  return h ^ (h >> 31);
}

std::uint64_t checksum(const char* bytes, std::size_t count, std::uint64_t seed) {
  std::uint64_t hash = mixed(seed + count);
  for (; count >= 8; bytes += 8, count -= 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes, 8);
    hash = mixed(hash ^ word) + 0x9e3779b97f4a7c15ull;
  }
  std::uint64_t rest = 0;
  std::memcpy(&rest, bytes, count);
  return mixed(hash ^ rest);
}

template <class T>
void put(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string header(std::uint64_t key) {
  std::string bytes(kMagic.data(), kMagic.size());
  put(bytes, key);
  put(bytes, checksum(bytes.data(), bytes.size(), 1));
  return bytes;
}

bool write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

bool regular_or_absent(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto type = std::filesystem::status(path, ignored).type();
  return type == std::filesystem::file_type::regular || type == std::filesystem::file_type::not_found;
}

}  // namespace

void Fingerprint::add(std::string_view bytes) { hash_ = checksum(bytes.data(), bytes.size(), hash_); }
void Fingerprint::add(double value) { hash_ = mixed(hash_ ^ std::bit_cast<std::uint64_t>(value)); }
void Fingerprint::add_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string buffer(1 << 16, '\0');
  add(path.filename().string());
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    add(std::string_view(buffer.data(), static_cast<std::size_t>(stream.gcount())));
  }
}

StateFile::StateFile(const std::filesystem::path& path, std::uint64_t key, std::chrono::milliseconds delay)
    : path_(behind_links(path)), key_(key), start_(std::chrono::steady_clock::now()), delay_(delay) {}

StateFile::~StateFile() {
  if (file_ >= 0) ::close(file_);
}

StateFile::Found StateFile::resume(render::Framebuffer& framebuffer) {
  if (!regular_or_absent(path_)) return Found::nothing;
  std::ifstream stream(path_, std::ios::binary);
  std::array<char, kHeaderBytes> head{};
  if (!stream.read(head.data(), head.size())) return Found::nothing;
  const std::string wanted = header(key_);
  if (std::memcmp(head.data(), wanted.data(), wanted.size()) != 0) return Found::other_render;
  std::size_t good = kHeaderBytes;
  std::string record;
  while (true) {
    std::array<std::int32_t, 4> at{};
    if (!stream.read(reinterpret_cast<char*>(at.data()), kRecordHead)) break;
    const auto [x, y, w, h] = at;
    if (x < 0 || y < 0 || w <= 0 || h <= 0 || x > framebuffer.width - w || y > framebuffer.height - h) break;
    const std::size_t pixels = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
    record.assign(reinterpret_cast<const char*>(at.data()), kRecordHead);
    record.resize(kRecordHead + pixels * kBytesPerPixel);
    std::uint64_t sum = 0;
    if (!stream.read(record.data() + kRecordHead, static_cast<std::streamsize>(pixels * kBytesPerPixel))) break;
    if (!stream.read(reinterpret_cast<char*>(&sum), sizeof sum) || sum != checksum(record.data(), record.size(), key_))
      break;
    const char* source = record.data() + kRecordHead;
    for (int row = y; row < y + h; ++row)
      for (int column = x; column < x + w; ++column, source += kBytesPerPixel) {
        std::array<float, 4> values{};
        std::memcpy(values.data(), source, kBytesPerPixel);
        framebuffer.at(column, row) = Color(values[0], values[1], values[2], 0, values[3]);
        if (!framebuffer.done.empty())
          framebuffer.done[static_cast<std::size_t>(row) * static_cast<std::size_t>(framebuffer.width) +
                           static_cast<std::size_t>(column)] = 1;
      }
    known_.insert({x, y, w, h});
    good += record.size() + sizeof sum;
  }
  stream.close();
  if (open(true) && ::ftruncate(file_, static_cast<off_t>(good)) != 0) fail("cannot shorten");
  return Found::blocks;
}

bool StateFile::open(bool append) {
  // What is kept in a device or a pipe cannot be read again, and a pipe that nobody reads would stop the render.
  if (errno = ESPIPE; !regular_or_absent(path_)) return fail("cannot use"), false;
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | (append ? 0 : O_TRUNC), 0666);
  if (file_ < 0) return fail("cannot open"), false;
  if (!append && !write_all(file_, header(key_))) return fail("cannot write"), false;
  return true;
}

void StateFile::append(const Block& block, const render::Framebuffer& framebuffer) {
  std::string bytes;
  bytes.reserve(kRecordHead +
                static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height) * kBytesPerPixel + 8);
  for (const std::int32_t value : {block.x, block.y, block.width, block.height}) put(bytes, value);
  for (int y = block.y; y < block.y + block.height; ++y)
    for (int x = block.x; x < block.x + block.width; ++x) {
      const Color& c = framebuffer.at(x, y);
      for (const float value : {c.r, c.g, c.b, c.t}) put(bytes, value);
    }
  put(bytes, checksum(bytes.data(), bytes.size(), key_));
  if (!write_all(file_, bytes)) fail("cannot write");
}

void StateFile::finished(const Block& block, const render::Framebuffer& framebuffer) {
  const std::lock_guard lock(mutex_);
  if (failed_) return;
  waiting_.push_back(block);
  if (file_ < 0 && (std::chrono::steady_clock::now() - start_ < delay_ || !open(false))) return;
  for (const Block& ready : waiting_)
    if (!failed_) append(ready, framebuffer);
  waiting_.clear();
}

void StateFile::flush(const render::Framebuffer& framebuffer) {
  const std::lock_guard lock(mutex_);
  if (failed_ || waiting_.empty() || (file_ < 0 && !open(false))) return;
  for (const Block& ready : waiting_)
    if (!failed_) append(ready, framebuffer);
  waiting_.clear();
}

void StateFile::remove() {
  const std::lock_guard lock(mutex_);
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  failed_ = true;  // nothing more is written
  if (is_state_file(path_)) ::unlink(path_.c_str());
}

void StateFile::fail(const std::string& what) {
  failure_ = fmt::format("{} the state file '{}': {}; the render cannot be continued if it is broken off", what,
                         path_.string(), std::strerror(errno));
  failed_ = true;
  // On a full disk the picture may need the room.
  std::error_code ignored;
  if (file_ >= 0 && std::filesystem::is_regular_file(path_, ignored)) ::unlink(path_.c_str());
}

std::string StateFile::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

bool is_state_file(const std::filesystem::path& path) {
  if (!regular_or_absent(path)) return false;
  std::ifstream stream(path, std::ios::binary);
  std::array<char, kMagic.size()> head{};
  return stream.read(head.data(), head.size()) && head == kMagic;
}

}  // namespace verisim::cli
