#include "cli/view/review.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "cli/commands/review.h"
#include "cli/console/exit_status.h"
#include "cli/console/interrupt.h"
#include "cli/sandbox/sandbox.h"
#include "cli/view/browser.h"
#include "cli/view/server.h"
#include "compare/json_text.h"
#include "compare/regression/review.h"
#include "compare/report/html.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// Pictures may come from anywhere: who reads them can touch the run, the stored pictures and nothing else.
void restrict_to(const fs::path& folder, const fs::path& baseline) {
  if (!wants_sandbox()) return;
  Policy policy;
  policy.read = system_files();
  policy.read.push_back(folder), policy.write.push_back(folder);
  if (!baseline.empty() && fs::is_directory(baseline))
    policy.read.push_back(baseline), policy.write.push_back(baseline);
  policy.server = true;
  enter_sandbox(policy);
}

// Requests are answered by several threads, decisions one after the other.
class Answers {
 public:
  explicit Answers(compare::Review& review) : review_(review), report_(review.run()) {}

  void serve(Server& server) {
    server.on("", [this](const PageRequest&) {
      const std::lock_guard lock(mutex_);
      return PageReply{"text/html; charset=utf-8", report_.served(review_.state())};
    });
    server.on("report.css", [](const PageRequest&) {
      return PageReply{"text/css; charset=utf-8", compare::HtmlReport::style()};
    });
    server.on("report.js", [](const PageRequest&) {
      return PageReply{"text/javascript; charset=utf-8", compare::HtmlReport::script()};
    });
    server.on("picture", [this](const PageRequest& request) {
      const auto id = request.parameters.find("id");
      return PageReply{"image/png", report_.picture(id == request.parameters.end() ? "" : id->second)};
    });
    server.on("decide", [this](const PageRequest& request) {
      const nlohmann::json asked = compare::parse_json(request.body);
      const std::lock_guard lock(mutex_);
      review_.decide(asked.at("scene"), asked.at("decision"), asked.at("note"));
      return state();
    });
    server.on("store", [this](const PageRequest&) {
      const std::lock_guard lock(mutex_);
      for (const std::string& line : review_.store()) std::fprintf(stderr, "%s\n", line.c_str());
      return state();
    });
  }

 private:
  PageReply state() const { return {"application/json", compare::json_text(review_.state())}; }

  compare::Review& review_;
  const compare::HtmlReport report_;
  std::mutex mutex_;
};

}  // namespace

int review(const std::vector<std::string>& arguments) {
  const ReviewSettings settings = review_settings(arguments);
  const fs::path folder = fs::absolute(settings.folder).lexically_normal();
  compare::Review review(folder, settings.baseline.empty() ? fs::path() : fs::absolute(settings.baseline));
  Server server;
  const std::string address = server.listen(settings.port, settings.token);
  if (settings.open) open_browser(address);
  restrict_to(folder, review.baseline());
  Interrupt interrupt;
  Answers answers(review);
  answers.serve(server);
  server.start();
  std::printf("%s\n", address.c_str());
  std::fflush(stdout);
  std::fprintf(stderr, "verisim review: open this address in a browser; Ctrl-C ends.\n");
  while (!interrupt.flag()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  server.stop();
  const compare::Review::Left left = review.left();
  std::fprintf(stderr, "%d to decide, %d refused, %d accepted and not stored yet\n", left.undecided, left.refused,
               left.not_stored);
  return left.any() ? kDifferent : kOk;
}

}  // namespace verisim::cli
