// The page of `verisim view`, made from view.html, view.css and view.js by CMake.
#pragma once

namespace verisim::cli {
extern const char* const kViewHtml;
extern const char* const kViewCss;
extern const char* const kViewJs;
}  // namespace verisim::cli
