#include "tests/fuzz/targets.h"

#include <chrono>
#include <cstdio>

#include "cli/frame/state_file.h"
#include "tests/fuzz/named_bytes.h"
#include "tests/fuzz/promise.h"

namespace verisim::fuzz {

void state(std::string_view bytes) {
  constexpr std::uint64_t kKey = 4711;
  // With the head that belongs to this key, or as it is.
  for (const bool own_head : {false, true}) {
    NamedBytes file("");
    render::Framebuffer frame;
    frame.width = frame.height = 64;
    frame.pixels.resize(64 * 64);
    frame.done.resize(64 * 64);
    if (own_head) {
      cli::StateFile made(file.path(), kKey, std::chrono::milliseconds(0));
      made.finished({0, 0, 1, 1}, frame);
      made.flush(frame);
    }
    if (std::FILE* more = std::fopen(file.path().c_str(), "ab")) {
      std::fwrite(bytes.data(), 1, bytes.size(), more);
      std::fclose(more);
    }
    may_throw([&] {
      cli::StateFile read(file.path(), kKey);
      (void)read.resume(frame);
    });
  }
}

}  // namespace verisim::fuzz
