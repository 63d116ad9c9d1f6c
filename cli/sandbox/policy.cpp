#include "cli/sandbox/policy.h"

#include <link.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tracer/base/output_file.h"
#include "tracer/image/module/module.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// The folders of the shared libraries of this process: what is loaded later lies beside them.
int add_folder(dl_phdr_info* library, std::size_t, void* data) {
  auto& paths = *static_cast<std::vector<fs::path>*>(data);
  const fs::path path = library->dlpi_name ? library->dlpi_name : "";
  if (path.is_absolute() && std::find(paths.begin(), paths.end(), path.parent_path()) == paths.end())
    paths.push_back(path.parent_path());
  return 0;
}

}  // namespace

std::vector<fs::path> system_files() {
  std::vector<fs::path> paths{"/lib",
                              "/lib64",
                              "/usr/lib",
                              "/usr/lib64",
                              "/usr/local/lib",
                              "/etc/ld.so.cache",
                              "/etc/localtime",
                              "/sys/devices/system/cpu/online",
                              "/sys/devices/system/cpu/possible"};
  if (const char* folders = std::getenv("LD_LIBRARY_PATH"))
    for (std::string_view rest = folders; !rest.empty();) {
      const std::string_view folder = rest.substr(0, rest.find(':'));
      if (folder.starts_with('/')) paths.emplace_back(folder);
      rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    }
  ::dl_iterate_phdr(add_folder, &paths);
  for (const fs::path& file : image::image_module_files()) paths.push_back(file);
  return paths;
}

void grant_output(Policy& policy, const fs::path& file) {
  const fs::path target = behind_links(file);
  std::error_code ignored;
  if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored)) {
    policy.write_files.push_back(target);
    return;
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  if (std::find(policy.write.begin(), policy.write.end(), folder) == policy.write.end()) policy.write.push_back(folder);
}

}  // namespace verisim::cli
