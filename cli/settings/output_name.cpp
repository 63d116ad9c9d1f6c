#include "cli/settings/output_name.h"

#include <array>

#include <fmt/format.h>

#include "cli/settings/text.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// The last extension is what follows the last dot of the name itself.
std::string base_of(const fs::path& scene) {
  const std::string name = scene.filename().string();
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? name : name.substr(0, dot);
}

}  // namespace

fs::path find_scene(const Options& options) {
  const std::string& name = options.input_file;
  if (name.empty()) return {};
  std::vector<std::string> variants{name + ".pov", name + ".POV", name};
  if (name.ends_with(".pov") || name.ends_with(".POV")) variants = {name};
  std::vector<fs::path> folders{fs::path()};
  if (fs::path(name).is_relative())
    folders.insert(folders.end(), options.library_paths.begin(), options.library_paths.end());
  for (const std::string& variant : variants)
    for (const fs::path& folder : folders) {
      std::error_code ignored;
      const fs::path path = folder / variant;
      if (fs::exists(path, ignored) && !fs::is_directory(path, ignored)) return path;
    }
  return {};
}

OutputName output_name(const Options& options, const fs::path& scene, const Animation& animation, const Frame& frame) {
  OutputName result;
  const std::string number = animation.on ? fmt::format("{:0{}}", frame.number, animation.digits) : "";
  if (!options.exact_output.empty() && options.exact_output != "-") {
    const fs::path name(options.exact_output);
    result.path = name.parent_path() / (name.stem().string() + number + name.extension().string());
    result.state_path = name.parent_path() / (name.stem().string() + number + ".pov-state");
    return result;
  }
  if (options.exact_output == "-" || options.output_file == "-" || options.output_file == "stdout") {
    result.standard_output = true;
    return result;
  }
  if (options.output_file == "stderr") {
    result.standard_error = true;
    return result;
  }
  const std::string ext = image::extension_of(options.format);
  std::string name = options.output_file;
  std::string folder = scene.parent_path().string();  // without a name the picture lies beside the scene
  if (folder == "/dev" || folder.starts_with("/dev/") || folder.starts_with("/proc/")) folder.clear();  // of streams
  if (!folder.empty()) folder += '/';
  if (const std::size_t slash = name.rfind('/'); slash != std::string::npos) {
    folder = name.substr(0, slash + 1);
    name.erase(0, slash + 1);
  } else if (!name.empty()) {
    folder.clear();
  }
  if (name.ends_with(ext))
    name.resize(name.size() - ext.size());
  else if (name.ends_with('.'))
    name.pop_back();
  if (name.empty()) name = base_of(scene);
  result.path = folder + name + number + ext;
  result.state_path = folder + name + number + ".pov-state";
  return result;
}

}  // namespace verisim::cli
