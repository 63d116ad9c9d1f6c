#include "tracer/film/pixels.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "tracer/base/huge_pages.h"

namespace verisim::render {
namespace {

constexpr std::size_t kKept = std::size_t{2} << 20;  // pixels: 32 MB

bool may_be_written(std::size_t bytes) {
  rlimit limit{};
  return ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && (limit.rlim_cur == RLIM_INFINITY || bytes <= limit.rlim_cur);
}

}  // namespace

void Pixels::Unmap::operator()(PixelColor* colors) const { ::munmap(colors, count * sizeof(PixelColor)); }

void Pixels::assign(std::size_t count, const PixelColor& color) {
  file_.reset();
  memory_.reserve(count);
  fill_by_huge_pages(memory_.data(), count * sizeof(PixelColor));
  memory_.assign(count, color);
}

bool Pixels::assign_in_file(std::size_t count, const std::filesystem::path& folder) {
  const std::size_t bytes = count * sizeof(PixelColor);
  if (count == 0 || !may_be_written(bytes)) return false;
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0) return false;
  // All of the room now: a disk that is full while a mapped page is written ends the process.
  void* const place = ::fallocate(file, 0, 0, static_cast<off_t>(bytes)) == 0
                          ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0)
                          : MAP_FAILED;
  ::close(file);
  if (place == MAP_FAILED) return false;
  memory_ = {};
  file_ = std::unique_ptr<PixelColor[], Unmap>(static_cast<PixelColor*>(place), Unmap{count});
  return true;
}

void Pixels::done_with(std::size_t count) const {
  if (!file_ || kept_.fetch_add(count) + count < kKept) return;
  kept_ = 0;
  // The pages of a shared mapping stay in the file; they are only no longer this process's.
  ::madvise(file_.get(), size() * sizeof(PixelColor), MADV_DONTNEED);
}

}  // namespace verisim::render
