// `verisim view`: a live picture, by the program verisim-view.
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/commands/own_program.h"
#include "cli/commands/view.h"
#include "cli/sandbox/sandbox.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/process_limits.h"
#include "cli/settings/reading/scene_words.h"

namespace verisim::cli {

void check_address(int port, const std::string& token) {
  if (port < 0 || port > 65535) throw OptionError("--port must be from 0 to 65535");
  constexpr std::size_t kShortest = 16;
  const bool plain = std::all_of(token.begin(), token.end(), [](unsigned char c) { return std::isalnum(c); });
  if (!token.empty() && (token.size() < kShortest || !plain))
    throw OptionError("--token needs 16 letters and digits or more");
}

ViewSettings view_settings(const std::vector<std::string>& arguments) {
  ViewSettings settings;
  Options& options = settings.options;
  options.width = 640, options.height = 480;
  process_limits.sandbox = "strict";
  bool no_open = false;
  OwnOptions own("view",
                 "Shows the picture of a scene in the browser, and again whenever the scene or a file it reads is "
                 "saved. Only this machine is served, and only who has the address that is printed. What the scene "
                 "writes goes to a folder that is removed at the end. It runs in the sandbox (--sandbox) unless "
                 "--sandbox=off is given.");
  own.synopsis("SCENE|--lecture [options] [switches]")
      .summary("a live picture in the browser that follows every saved file")
      .example("verisim view scene.pov +W640 +H480 +A0.3", "edit the scene and look")
      .example("verisim view --lecture", "ray tracing explained, with scenes that can be changed")
      .section("Options");
  own.flag("--lecture", settings.lecture, "show the pages that explain ray tracing instead of a scene");
  own.value("--against FILE", settings.against, "a stored picture of the same size to hold the live one against");
  own.flag("--no-open", no_open, "print the address, but do not open a browser");
  own.value("--port N", settings.port, "the port on 127.0.0.1; 0: any free one");
  own.value("--token TEXT", settings.token,
            "the secret in the address, 16 letters and digits or more, so that a page stays valid when the program is "
            "started again with the same --port; without it a random one");
  add_render_options(own, options);
  own.switches({Topic::scene, Topic::size, Topic::speed, Topic::animation, Topic::messages});
  settings.words = own.parse(arguments);
  const std::vector<std::string> files = apply_words(options, settings.words);
  settings.open = !no_open;
  if (files.size() > 1) throw OptionError(fmt::format("one scene at a time: '{}' and '{}'", files[0], files[1]));
  if (!files.empty()) options.input_file = files[0];
  if (settings.lecture && !options.input_file.empty())
    throw OptionError("--lecture has scenes of its own: give either a scene or --lecture");
  if (options.input_file.empty() && !settings.lecture) throw OptionError("no scene: verisim view SCENE [switches]");
  if (options.input_file == "-") throw OptionError("a live picture needs a file that can change, not a stream");
  if (options.replay) throw OptionError("--replay needs the whole picture in order; `verisim render` does that");
  check_address(settings.port, settings.token);
  validate(options);
  wants_sandbox();  // throws
  return settings;
}

int command_view(const std::vector<std::string>& arguments) {
  view_settings(arguments);  // bad ones are told here
  run_view_program("verisim-view", arguments);
}

void run_view_program(const std::string& name, const std::vector<std::string>& arguments) {
  const std::filesystem::path program = own_program().parent_path() / "verisim-view";
  std::vector<std::string> words{name};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());  // returns only if it failed
  throw std::runtime_error(fmt::format("cannot run {}: {}", program.string(), std::system_category().message(errno)));
}

}  // namespace verisim::cli
