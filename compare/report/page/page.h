// The report's page: report.html with marks where the policy, the style sheet, the data, the script and the pictures
// go.
#pragma once

namespace verisim::compare {
extern const char* const kReportHtml;
extern const char* const kReportCss;
extern const char* const kReportJs;
}  // namespace verisim::compare
