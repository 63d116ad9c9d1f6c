// The pieces of pages that the program serves or writes, as text.
#pragma once

namespace verisim::cli {

extern const char* const kViewHtml;  // the live picture
extern const char* const kViewCss;   // of all pages
extern const char* const kViewJs;
extern const char* const kStoryJs;   // how a pixel's colour comes about: used by the live picture and by files
extern const char* const kRaysHtml;  // a file of one pixel's rays, with places to fill in: @TITLE@ ...

}  // namespace verisim::cli
