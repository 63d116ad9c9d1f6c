// The report's page: report.html with marks where the policy, the style sheet, the data, the script and the pictures
// go.
#pragma once

namespace verisim::compare {
extern const char* const kReportHtml;
extern const char* const kReportCss;
extern const char* const kReportJs;
// A file that asks for nothing from elsewhere.
extern const char* const kPagePolicy;
// The page for corners in photographs (corner_page.h), with the same marks but the last.
extern const char* const kCornersHtml;
extern const char* const kCornersJs;
}  // namespace verisim::compare
