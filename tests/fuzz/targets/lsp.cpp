#include "tests/fuzz/targets.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "cli/lsp/server.h"
#include "tests/fuzz/promise.h"

namespace verisim::fuzz {

void lsp(std::string_view bytes) {
  std::string wire;
  const auto message = [&wire](std::string_view body) {
    wire.append("Content-Length: " + std::to_string(body.size()) + "\r\n\r\n").append(body);
  };
  if (bytes.starts_with('\0')) {
    wire = bytes.substr(1);
  } else {
    message(R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{}})");
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
      message(bytes.substr(at, end - at));
      at = end + 1;
    }
  }
  cli::lsp::ServerSettings settings;
  settings.program = "/nonexistent";
  settings.options.limits.max_steps = 20000;
  settings.delay_ms = 0, settings.seconds = 1;
  settings.in = ::memfd_create("wire", MFD_CLOEXEC), settings.out = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (::write(settings.in, wire.data(), wire.size()) < 0 || ::lseek(settings.in, 0, SEEK_SET) != 0) std::abort();
  may_throw([&] { cli::lsp::serve(settings); });
  ::close(settings.in), ::close(settings.out);
}

}  // namespace verisim::fuzz
