// `verisim lsp`: the language server for scenes.
#include "cli/lsp/server.h"

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/commands/own_program.h"
#include "cli/lints/lints.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/reading/scene_words.h"

namespace verisim::cli {

int command_lsp(const std::vector<std::string>& arguments) {
  lsp::ServerSettings settings;
  Options& options = settings.options;
  options.limits.max_memory_bytes = std::size_t{4} << 30;
  OwnOptions own("lsp",
                 "Serves editors over standard input and output (Language Server Protocol 3.17): what is wrong while "
                 "you type, what words and names mean, completion, definitions, renaming, colours, formatting. "
                 "docs/editor.md has the settings of editors. Scenes are read as `verisim check` reads them; what they "
                 "write goes to a folder that is removed at the end.");
  own.synopsis("[options] [switches]")
      .summary("the language server for editors")
      .example("verisim lsp +L/home/me/include", "as an editor starts it, with a folder of include files")
      .section("Options");
  bool stdio = false;
  own.flag("--stdio", stdio, "taken because some editors give it; standard input and output are the only way");
  own.value("--read-seconds S", settings.seconds, "a scene is read for S seconds at most, then what is known is shown");
  own.value("--delay MS", settings.delay_ms, "milliseconds without a change after which a scene is read");
  std::vector<std::string> lints;
  own.values("--lint NAME", lints,
             "which lints are shown as hints, as for `verisim check`: names, all (without this option) or none");
  add_scene_options(own, options);
  own.switches({Topic::scene, Topic::size});
  const std::vector<std::string> files = apply_words(options, own.parse(arguments));
  if (!files.empty() || !options.input_file.empty())
    throw OptionError("the editor names the scenes: verisim lsp [options] [switches]");
  if (!(settings.seconds > 0 && settings.seconds <= 3600))
    throw OptionError("--read-seconds must be above 0, up to 3600");
  if (settings.delay_ms < 0 || settings.delay_ms > 10000) throw OptionError("--delay must be from 0 to 10000");
  settings.lints = wanted_lints(lints.empty() ? std::vector<std::string>{"all"} : lints);
  validate(options);
  settings.program = own_program();
  return lsp::serve(settings);
}

}  // namespace verisim::cli
