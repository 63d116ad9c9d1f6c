// `verisim help`: what the program and its commands say of themselves.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/text.h"
#include "parser/keywords/keywords.h"
#include "parser/lexer/words.h"

namespace verisim::cli {
namespace {

constexpr Command kCommands[] = {
    {"render", command_render},   {"merge", command_merge},     {"farm", command_farm},   {"check", command_check},
    {"compare", command_compare}, {"explain", command_explain}, {"diff", command_diff},   {"view", command_view},
    {"review", command_review},   {"lsp", command_lsp},         {"bench", command_bench},
};

CommandHelp help_of(const Command& command) {
  try {
    command.run({"--help"});
  } catch (HelpWanted& wanted) {
    return std::move(wanted.help);
  }
  throw std::logic_error("a command without help");
}

std::vector<CommandHelp> all_commands() {
  std::vector<CommandHelp> all;
  for (const Command& command : kCommands) all.push_back(help_of(command));
  return all;
}

std::string man_page(const CommandHelp& command) {
  std::vector<std::string> others{""};
  for (const Command& other : kCommands) others.emplace_back(other.name);
  return help_man(command, others);
}

// Every man page and the completion of bash, under the names they are installed with.
void write_pages(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const auto page = [&](const std::string& name, const std::string& text) {
    std::ofstream file(folder / name);
    if (!(file << text << std::flush)) throw std::runtime_error("cannot write " + (folder / name).string());
  };
  page("verisim.1", man_page(program_help()));
  for (const CommandHelp& command : all_commands()) page("verisim-" + command.name + ".1", man_page(command));
  page("verisim.bash", help_bash(all_commands()));
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

CommandHelp program_help() {
  CommandHelp help;
  help.synopsis = "COMMAND ... | SWITCHES";
  help.summary = "a native ray tracer for POV-Ray 3.7 scenes that proves itself against POV-Ray";
  help.description =
      "Renders scenes of POV-Ray 3.7 as POV-Ray does, and shows pixel by pixel that it does. Without a command, or "
      "through a link named povray, it is called exactly as povray is called. `verisim COMMAND --help` tells more.";
  help.examples = {{"verisim render scene.pov +W640 +H480 +A0.3", "a picture beside the scene"},
                   {"verisim +Iscene.pov +Oout.png +W320 +H240 +A0.3", "called as povray is called"}};
  HelpSection list{"Commands", {}};
  for (const CommandHelp& command : all_commands()) list.entries.push_back({{command.name}, command.summary});
  list.entries.push_back({{"help [COMMAND|WORD]"}, "this, what a command takes, or what a word of scenes means"});
  help.sections = {
      std::move(list),
      {"Options", {{{"--help", "-h"}, "this"}, {{"--version"}, "the version; with --json also the libraries it uses"}}},
      {"Environment",
       {{{"VERISIM_INCLUDE_PATH"}, "folders of include files, separated by colons; +L comes first"},
        {{"VERISIM_MODULE_PATH"}, "the folder of the plug-ins for image formats"},
        {{"VERISIM_INSTRUCTION_SET"},
         "baseline, sse4, avx2 or avx512: no wider instructions than these; pictures are the same with all"},
        {{"POVINI"}, "an INI file that is read before the others"},
        {{"POVINC"}, "a folder of include files"}}},
      exit_status_help()};
  help.sections.back().entries.push_back(
      {{"povray"}, "called in POV-Ray's style: 0, 1 after an error, 2 after an interrupt"});
  return help;
}

namespace {

// A word of the language, as people may write it: "#macro", "sphere".
std::string word_help(const std::string& word) {
  return parser::keyword_text(word.starts_with('#') ? word.substr(1) : word);
}

[[noreturn]] void no_such_word(const std::string& word) {
  std::vector<std::string_view> names;
  for (const Command& command : kCommands) names.push_back(command.name);
  for (const parser::WordEntry& entry : parser::all_words()) names.push_back(entry.text);
  const std::string advice = nearest(word, names);
  throw OptionError(fmt::format("there is no command and no word of scenes '{}'{}", word,
                                advice.empty() ? "" : "; did you mean " + advice + "?"));
}

void print(const std::string& text) { std::fputs(text.c_str(), stdout); }

}  // namespace

int command_help(const std::vector<std::string>& arguments) {
  std::string format = "text", pages;
  OwnOptions own("help", "Tells what the program or one of its commands takes, or what a word of scenes means.");
  own.synopsis("[COMMAND|WORD]").summary("what a command takes, what a word of scenes means").section("Options");
  own.value("--format NAME", format,
            "text, markdown (docs/cli.md), man (one page) or bash (the completion); of the words of scenes: language "
            "(docs/language), grammar (colours for editors, as a TextMate grammar)");
  own.value("--pages FOLDER", pages, "write all man pages and the completion of bash into this folder");
  const std::vector<std::string> words = own.parse(arguments);
  if (!pages.empty()) return write_pages(pages), kOk;
  if (words.size() > 1) throw OptionError("help for one thing at a time: verisim help COMMAND, verisim help WORD");
  if (format == "language" || format == "grammar") {
    print(format == "language" ? parser::language_page() : parser::text_mate_grammar());
    return kOk;
  }
  if (format != "text" && format != "markdown" && format != "man" && format != "bash")
    throw OptionError(fmt::format("--format is text, markdown, man, bash, language or grammar, not '{}'", format));
  CommandHelp help = program_help();
  std::string word;
  if (!words.empty()) {
    word = word_help(words[0]);
    const auto found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                    [&](const Command& command) { return command.name == words[0]; });
    if (found == std::end(kCommands)) {
      if (word.empty()) no_such_word(words[0]);
      print(word);
      return kOk;
    }
    help = help_of(*found);
  }
  print(format == "markdown" ? help_markdown(help, words.empty() ? all_commands() : std::vector<CommandHelp>{})
        : format == "man" ? man_page(help)
        : format == "bash"   ? help_bash(all_commands())
                             : help_text(help));
  if (format == "text" && !word.empty()) print("\nIn scenes:\n\n" + word);
  return kOk;
}

}  // namespace verisim::cli
