// `verisim merge`: parts of a picture put together.
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/console/exit_status.h"
#include "cli/console/interrupt.h"
#include "cli/parts/merge.h"
#include "cli/settings/reading/own_options.h"

namespace verisim::cli {

namespace {

namespace fs = std::filesystem;

// A folder stands for the parts in it.
std::vector<fs::path> files_of(const std::vector<std::string>& words) {
  std::vector<fs::path> files;
  for (const std::string& word : words) {
    std::error_code error;
    if (!fs::is_directory(word, error)) {
      files.emplace_back(word);
      continue;
    }
    const std::size_t before = files.size();
    for (fs::directory_iterator i(word, error), end; !error && i != end; i.increment(error))
      if (i->path().extension() == ".vsp") files.push_back(i->path());
    if (error) throw std::runtime_error(fmt::format("cannot read the folder '{}': {}", word, error.message()));
    if (files.size() == before)
      throw std::runtime_error(fmt::format("there are no parts (*.vsp) in the folder '{}'", word));
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
  }
  return files;
}

}  // namespace

int command_merge(const std::vector<std::string>& arguments) {
  std::string output;
  bool quiet = false;
  OwnOptions own(
      "merge",
      "Puts the parts of a picture together that `verisim render --part` has made. The file is the same as "
      "that of one render of the whole picture, to the byte; parts that do not belong together, are missing, "
      "doubled or damaged are refused by name. A folder stands for the files *.vsp in it.");
  own.synopsis("PARTS...|FOLDER --output FILE")
      .summary("put the parts of a picture together")
      .example("verisim merge parts/*.vsp --output picture.png",
               "after verisim render scene.pov --part 1/8 --output "
               "parts/1.vsp, and so on to 8/8");
  own.value("--output FILE", output,
            "the picture's file, named as it is; the type by its extension unless +F said otherwise");
  own.flag("--quiet", quiet, "say nothing when all goes well");
  const std::vector<std::string> words = own.parse(arguments);
  if (words.empty()) throw OptionError("name the files of the parts: verisim merge PARTS... --output picture.png");
  if (output.empty()) throw OptionError("name the picture's file: --output picture.png");
  Interrupt interrupt;
  Merged merged;
  try {
    merged = merge_parts(files_of(words), output, interrupt.flag());
  } catch (const std::runtime_error&) {
    if (!interrupt.flag()) throw;
    std::fputs("verisim: interrupted; no picture was written\n", stderr);
    return kInterrupted;
  }
  if (!quiet)
    std::fputs(fmt::format("{} by {}: merged {} part{} to {}\n", merged.width, merged.height, merged.parts,
                           merged.parts == 1 ? "" : "s", output)
                   .c_str(),
               stderr);
  return kOk;
}

}  // namespace verisim::cli
