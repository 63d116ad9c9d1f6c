#include "cli/frame/state_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "cli/parts/fingerprint.h"
#include "tracer/base/bytes.h"
#include "tracer/base/output_file.h"

namespace verisim::cli {
namespace {

constexpr std::array<char, 16> kStateMagic{'v', 'e', 'r', 'i', 's', 'i', 'm', '-',
                                           's', 't', 'a', 't', 'e', '-', '1', '\n'};
constexpr std::size_t kHeaderBytes = kStateMagic.size() + 16;  // key, checksum

std::string header(std::uint64_t key) {
  std::string bytes(kStateMagic.data(), kStateMagic.size());
  put_bytes(bytes, key);
  put_bytes(bytes, checksum(bytes, 1));
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

StateFile::StateFile(const std::filesystem::path& path, std::uint64_t key, std::chrono::milliseconds delay)
    : path_(behind_links(path)), key_(key), start_(std::chrono::steady_clock::now()), delay_(delay) {}

StateFile::~StateFile() {
  if (file_ >= 0) ::close(file_);
}

Block StateFile::place(const Block& block) const {
  const auto found = places_.find(block);
  return found == places_.end() ? block : found->second;
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
    record.resize(kRecordHead);
    if (!stream.read(record.data(), kRecordHead)) break;
    const bool whole = places_.empty();
    const std::optional<Block> block =
        block_of_head(record, whole ? framebuffer.width : width_, whole ? framebuffer.height : height_);
    if (!block || (!whole && !places_.contains(*block))) break;
    record.resize(record_bytes(*block, kColorBytes));
    if (!stream.read(record.data() + kRecordHead, static_cast<std::streamsize>(record.size() - kRecordHead)) ||
        !record_is_whole(record, key_))
      break;
    const Block at = place(*block);
    read_colors(record, *block, &framebuffer.at(at.x, at.y), static_cast<std::size_t>(framebuffer.width));
    if (!framebuffer.done.empty())
      for (int row = at.y; row < at.y + at.height; ++row)
        std::fill_n(framebuffer.done.begin() + static_cast<std::ptrdiff_t>(row) * framebuffer.width + at.x, at.width,
                    std::uint8_t{1});
    known_.insert(*block);
    good += record.size();
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
  if (!write_all(file_, color_record(block, place(block), framebuffer, key_))) fail("cannot write");
  framebuffer.pixels.done_with(block.pixels());
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
  std::array<char, kStateMagic.size()> head{};
  return stream.read(head.data(), head.size()) && head == kStateMagic;
}

}  // namespace verisim::cli
