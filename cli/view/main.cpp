// The program behind `verisim view`, a page on the loopback interface that shows a scene's picture while it is edited,
// and behind `verisim review` (review.h), which it is when it is called verisim-review.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "cli/commands/view.h"
#include "cli/help/help.h"
#include "cli/sandbox/private_folder.h"
#include "cli/sandbox/sandbox.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/output_name.h"
#include "cli/view/lecture.h"
#include "cli/view/live_picture.h"
#include "cli/page/page.h"
#include "cli/view/browser.h"
#include "cli/view/reference.h"
#include "cli/view/review.h"
#include "cli/view/server.h"
#include "compare/json_text.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// A number of a request's parameter, within bounds; the default when there is none.
double number(const PageRequest& request, const char* name, double low, double high, double otherwise) {
  const auto found = request.parameters.find(name);
  if (found == request.parameters.end()) return otherwise;
  char* end = nullptr;
  const double value = std::strtod(found->second.c_str(), &end);
  if (found->second.empty() || *end || !(value >= low && value <= high))
    throw std::runtime_error(fmt::format("{} must be a number from {} to {}", name, low, high));
  return value;
}

Wish wish_of(const std::string& body, const Options& options, Wish wish) {
  const nlohmann::json asked = compare::parse_json(body);
  const auto take = [&](const char* name, double otherwise, double low, double high) {
    const double value = asked.value(name, otherwise);
    if (!(value >= low && value <= high)) throw std::runtime_error(fmt::format("{} is out of its range", name));
    return value;
  };
  constexpr double kMaxZoom = 4096;
  wish.zoom = take("zoom", wish.zoom, 1, kMaxZoom);
  wish.left = static_cast<int>(take("left", wish.left, 0, std::max(0.0, options.width * (wish.zoom - 1))));
  wish.top = static_cast<int>(take("top", wish.top, 0, std::max(0.0, options.height * (wish.zoom - 1))));
  wish.focus_x = static_cast<int>(take("focus_x", -1, -1, options.width));
  wish.focus_y = static_cast<int>(take("focus_y", -1, -1, options.height));
  wish.clock = take("clock", wish.clock, -1e9, 1e9);
  wish.quick = asked.value("quick", false);
  if (asked.contains("values"))
    for (const auto& [name, value] : asked["values"].items()) wish.values[name] = value.get<double>();
  return wish;
}

DrawnFrom drawn_from(const PageRequest& request) {
  constexpr double kLargest = 2000;
  return {number(request, "azimuth", -3600, 3600, 0), number(request, "elevation", -90, 90, 0),
          static_cast<int>(number(request, "width", 1, kLargest, 480)),
          static_cast<int>(number(request, "height", 1, kLargest, 360))};
}

void comparison_answers(Server& server, LivePicture& picture, Reference& reference) {
  const auto bytes = [](std::string body) { return PageReply{"application/octet-stream", std::move(body)}; };
  server.on("povray", [&, bytes](const PageRequest&) {
    return bytes(reference.povray(picture.files_read(), picture.wish().clock));
  });
  server.on("stored", [&, bytes](const PageRequest&) { return bytes(reference.stored()); });
  server.on("flip", [&, bytes](const PageRequest&) { return bytes(reference.flip(picture.stored_picture())); });
  server.on("others", [&](const PageRequest&) {
    return PageReply{"application/json", reference.has_stored() ? R"({"stored": true})" : R"({"stored": false})"};
  });
}

void answers(Server& server, LivePicture& picture, const Options& options) {
  const auto text = [](const char* content, const char* type) {
    return [content, type](const PageRequest&) { return PageReply{type, content}; };
  };
  server.on("", text(kViewHtml, "text/html; charset=utf-8"));
  server.on("view.css", text(kViewCss, "text/css; charset=utf-8"));
  server.on("story.js", text(kStoryJs, "text/javascript; charset=utf-8"));
  server.on("view.js", text(kViewJs, "text/javascript; charset=utf-8"));
  server.on("update", [&picture](const PageRequest& request) {
    constexpr double kLarge = 9e15, kLongest = 10;
    return PageReply{"application/octet-stream",
                     picture.update(static_cast<std::uint64_t>(number(request, "generation", 0, kLarge, 0)),
                                    static_cast<std::size_t>(number(request, "pieces", 0, kLarge, 0)),
                                    static_cast<std::uint64_t>(number(request, "state", 0, kLarge, 0)),
                                    number(request, "wait", 0, kLongest, 5))};
  });
  server.on("layers", [&picture](const PageRequest& request) {
    return PageReply{"application/octet-stream",
                     picture.layers(static_cast<std::uint64_t>(number(request, "generation", 0, 9e15, 0)))};
  });
  server.on("explain", [&picture, &options](const PageRequest& request) {
    return PageReply{"application/json",
                     compare::json_text(picture.explain(number(request, "x", -0.5, options.width, 0),
                                                        number(request, "y", -0.5, options.height, 0)))};
  });
  server.on("drawing", [&picture](const PageRequest& request) {
    const DrawnFrom from = drawn_from(request);
    const std::string behind =
        fmt::format("behind?azimuth={}&amp;elevation={}&amp;width={}&amp;height={}&amp;of={}", from.azimuth,
                    from.elevation, from.width, from.height, number(request, "of", 0, 9e15, 0));
    return PageReply{"image/svg+xml", picture.drawing(from, behind)};
  });
  server.on("overlay", [&picture](const PageRequest&) { return PageReply{"image/svg+xml", picture.overlay()}; });
  server.on("behind", [&picture](const PageRequest& request) {
    return PageReply{"image/png", picture.behind(drawn_from(request))};
  });
  server.on("wish", [&picture, &options](const PageRequest& request) {
    picture.ask(wish_of(request.body, options, picture.wish()));
    return PageReply{"application/json", "{}"};
  });
}

// The current folder is about to be another one.
void make_absolute(Options& options) {
  for (std::string& path : options.library_paths) path = fs::absolute(path).string();
  for (fs::path& path : options.allow_write) path = fs::absolute(path);
  for (fs::path& path : options.allow_read) path = fs::absolute(path);
  if (!options.include_header.empty() && fs::exists(options.include_header))
    options.include_header = fs::absolute(options.include_header).string();
  options.display = false;
}

// What is served: the pages of the lecture, or a scene, held against a picture.
struct Shown {
  fs::path scene, against, pages;  // absolute; empty: none

  explicit Shown(const ViewSettings& settings) {
    if (settings.lecture) {
      pages = lecture_folder();
      return;
    }
    scene = find_scene(settings.options);
    if (scene.empty()) throw std::runtime_error(fmt::format("cannot find the scene '{}'", settings.options.input_file));
    scene = fs::absolute(scene);
    if (!settings.against.empty()) against = fs::absolute(settings.against);
  }
};

void restrict_to(const Shown& shown, Options& options) {
  if (!wants_sandbox()) return;
  Policy policy =
      policy_of(options, {{shown.scene.empty() ? lecture_scenes(shown.pages) / "any.pov" : shown.scene, std::nullopt}});
  if (!shown.against.empty()) policy.read.push_back(shown.against);
  if (!shown.pages.empty()) policy.read.push_back(shown.pages), policy.read.push_back(lecture_scenes(shown.pages));
  confine_scene(options, policy);
  policy.server = true;
  enter_sandbox(policy);
}

int view(const std::vector<std::string>& arguments) {
  const ViewSettings settings = view_settings(arguments);
  Options options = settings.options;
  const Shown shown(settings);
  make_absolute(options);

  const fs::path called_from = fs::current_path();
  // Scenes may write into the current folder (#fopen): nothing is written beside them.
  const PrivateFolder folder("verisim-view-");
  fs::current_path(folder.path());
  if (wants_sandbox() || !options.allow_read.empty()) options.allow_read.push_back(folder.path());
  if (wants_sandbox()) options.allow_write.push_back(folder.path());
  Server server;
  const std::string address = server.listen(settings.port, settings.token);
  if (settings.open) open_browser(address);
  restrict_to(shown, options);
  // Files are looked for where the program was called; whether they may be read is another question.
  options.library_paths.insert(options.library_paths.begin(), called_from.string());

  Interrupt interrupt(Watch{.seconds = options.max_seconds, .memory = options.limits.max_memory_bytes});
  std::optional<LivePicture> picture;
  std::optional<Reference> reference;
  if (settings.lecture) {
    serve_lecture(server, shown.pages, options, interrupt);
  } else {
    picture.emplace(options, shown.scene, interrupt);
    reference.emplace(shown.scene, options, settings.words, shown.against);
    answers(server, *picture, options);
    comparison_answers(server, *picture, *reference);
  }
  server.start();
  std::printf("%s\n", address.c_str());
  std::fflush(stdout);
  std::fprintf(stderr, "verisim view: open this address in a browser; Ctrl-C ends.\n");
  while (!interrupt.flag()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  interrupt.orderly_end(15);  // pages that wait for answers hold the server up for some five
  server.stop();
  return kOk;
}

}  // namespace
}  // namespace verisim::cli

int main(int count, char** words) {
  using namespace verisim::cli;
  const std::string name = count > 0 ? std::filesystem::path(words[0]).filename().string() : "";
  const bool reviews = name == "verisim-review";
  const char* const command = reviews ? "review" : "view";
  try {
    return reviews ? review({words + 1, words + count}) : view({words + 1, words + count});
  } catch (const HelpWanted& help) {
    std::fputs(help_text(help.help).c_str(), stdout);
    return kOk;
  } catch (const OptionError& error) {
    std::fprintf(stderr, "verisim %s: %s\n", command, error.what());
    return kUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "verisim %s: %s\n", command, error.what());
    return kInputOutput;
  }
}
