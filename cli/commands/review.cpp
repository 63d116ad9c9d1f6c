// `verisim review`: what changed against stored pictures is accepted or refused. Served by the program verisim-view;
// the rest is done here.
#include "cli/commands/review.h"

#include <cstdio>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/commands/view.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/process_limits.h"
#include "cli/sandbox/sandbox.h"
#include "compare/regression/review.h"
#include "compare/report/html.h"

namespace verisim::cli {

ReviewSettings review_settings(const std::vector<std::string>& arguments) {
  ReviewSettings settings;
  bool no_open = false;
  std::string baseline;
  process_limits.sandbox = "best-effort";
  OwnOptions own(
      "review",
      "Shows the run that `verisim compare ... --baseline FOLDER --work DIR` left in DIR, as a page that only "
      "this machine sees: each picture that changed is accepted (key A) or refused (R), with a note, and what "
      "was accepted is stored as the new baseline. Exit status 0 when nothing is left: all that changed is "
      "accepted and stored; 1 when something is refused or open.");
  own.synopsis("DIR [options]")
      .summary("accept or refuse what changed against stored pictures")
      .example("verisim review run", "look, and decide with keys")
      .example("verisim review run --update", "store what was accepted, and nothing else")
      .example("verisim review run --markdown review.md", "a summary with pictures for a pull request")
      .section("Without a page");
  own.flag("--status", settings.status, "say what is left to do");
  own.flag("--update", settings.update, "store the pictures that were accepted");
  own.value("--markdown FILE", settings.markdown,
            "write a summary as Markdown, with pictures in a folder beside it (FILE without extension, _pictures)");
  own.value("--html FILE", settings.html, "write the report with all decisions as one file, to read");
  own.section("Options");
  own.value("--baseline FOLDER", baseline, "the stored pictures, if they are not where the run found them");
  own.flag("--no-open", no_open, "print the address, but do not open a browser");
  own.value("--port N", settings.port, "the port on 127.0.0.1; 0: any free one");
  own.value("--token TEXT", settings.token, "the secret in the address, 16 letters and digits or more");
  own.value("--sandbox[=strict]", process_limits.sandbox,
            "what the program may touch while it serves: DIR and the baseline (best-effort), strict or off");
  const std::vector<std::string> words = own.parse(arguments);
  if (words.size() != 1) throw OptionError("one folder is needed: verisim review DIR");
  settings.folder = words[0], settings.baseline = baseline, settings.open = !no_open;
  check_address(settings.port, settings.token);
  wants_sandbox();  // throws
  return settings;
}

int command_review(const std::vector<std::string>& arguments) {
  const ReviewSettings settings = review_settings(arguments);
  if (settings.serves()) run_view_program("verisim-review", arguments);
  compare::Review review(settings.folder, settings.baseline);
  if (settings.update)
    for (const std::string& line : review.store()) std::printf("%s\n", line.c_str());
  if (!settings.markdown.empty()) review.write_markdown(settings.markdown);
  if (!settings.html.empty())
    compare::write_report(compare::HtmlReport(review.run(), review.state()).file(), settings.html);
  const compare::Review::Left left = review.left();
  std::printf("%d to decide, %d refused, %d accepted and not stored yet\n", left.undecided, left.refused,
              left.not_stored);
  return left.any() ? kDifferent : kOk;
}

}  // namespace verisim::cli
