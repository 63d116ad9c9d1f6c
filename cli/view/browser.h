// The user's browser.
#pragma once

#include <string>

namespace verisim::cli {

// Where there is a display; who has none copies the address.
void open_browser(const std::string& address);

}  // namespace verisim::cli
