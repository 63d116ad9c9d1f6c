#include "cli/view/browser.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace verisim::cli {

void open_browser(const std::string& address) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
  if (fork() == 0) {
    if (std::freopen("/dev/null", "w", stdout) && std::freopen("/dev/null", "w", stderr))
      execlp("xdg-open", "xdg-open", address.c_str(), static_cast<char*>(nullptr));
    _exit(1);
  }
}

}  // namespace verisim::cli
