#include "cli/settings/reading/scene_words.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "cli/settings/reading/configuration.h"
#include "cli/settings/reading/ini.h"

namespace verisim::cli {

bool is_setting_word(const std::string& word) {
  if (word.empty()) return false;
  if (word.front() == '+' || (word.front() == '-' && word.size() > 1) || word.back() == '/') return true;
  if (word.ends_with(".ini") || word.ends_with(".INI") || (word.back() == ']' && word.find('[') != std::string::npos))
    return true;
  const std::size_t equals = word.find('=');
  return equals != std::string::npos && equals > 0 &&
         std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(equals),
                     [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

std::vector<std::string> with_folders(std::vector<std::string> words) {
  for (std::string& word : words)
    while (word.size() > 1 && word.back() == '/' && word.front() != '+' && word.front() != '-' &&
           word.find('=') == std::string::npos)
      word.pop_back();
  return words;
}

std::vector<std::string> apply_words(Options& options, const std::vector<std::string>& words) {
  apply_configuration(options);
  std::vector<std::string> files;
  for (const std::string& word : words) {
    if (is_setting_word(word))
      apply_argument(options, word);
    else
      files.push_back(word);
  }
  return files;
}

bool format_chosen(const Options& options) {
  return std::any_of(options.given.begin(), options.given.end(),
                     [](const auto& setting) { return setting.first == "Output_File_Type"; });
}

void choose_format(Options& options) {
  if (!options.part.empty()) return;  // the name is a part's; merging them decides
  const bool chosen = format_chosen(options);
  if (options.exact_output == "-") return;  // PNG, or what +F says
  if (!options.exact_output.empty()) {
    const std::string ext = std::filesystem::path(options.exact_output).extension().string();
    const auto format = format_of_extension(ext);
    if (format && !(chosen && *format != options.format))
      options.format = *format;
    else if (!chosen)
      throw OptionError(
          fmt::format("--output {}: '{}' is no picture type; known are .png .exr .hdr .ppm .tga .bmp .jpg .tif",
                      options.exact_output, ext));
  } else if (!chosen) {
    if (const auto format = format_of_extension(std::filesystem::path(options.output_file).extension().string())) {
      options.format = *format;
      // Both spellings of JPEG and TIFF are fine, and the name stays as it is.
      if (!options.output_file.ends_with(image::extension_of(*format))) options.exact_output = options.output_file;
    }
  }
}

}  // namespace verisim::cli
