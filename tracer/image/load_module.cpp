// Finds and loads the OpenImageIO plug-in (module/module.h).
#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "tracer/image/module/module.h"

namespace verisim::image {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLibrary = "libverisim_image_module.so";

// The folder of the file this code was linked into: the program or a shared library.
fs::path own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_folder), &info) == 0 || !info.dli_fname) return {};
  std::error_code error;
  fs::path file = fs::canonical(info.dli_fname, error);
  if (error) file = fs::read_symlink("/proc/self/exe", error);  // dli_fname is argv[0] for a program found through PATH
  return error ? fs::path() : file.parent_path();
}

std::vector<fs::path> candidates() {
  std::vector<fs::path> result;
  if (const char* path = std::getenv("VERISIM_MODULE_PATH"); path && *path) {
    result.emplace_back(path);
    result.emplace_back(fs::path(path) / kLibrary);
  }
  if (const fs::path folder = own_folder(); !folder.empty()) {
    result.push_back(folder / kLibrary);
    for (const char* lib : {"lib", "lib64", "lib/x86_64-linux-gnu", "lib/aarch64-linux-gnu"}) {
      result.push_back(folder.parent_path() / lib / kLibrary);
      result.push_back(folder.parent_path() / lib / "verisim" / kLibrary);
    }
    result.push_back(folder / "verisim" / kLibrary);  // beside a shared library in the library folder
  }
  return result;
}

template <class F>
F symbol(void* library, const char* name) {
  void* address = dlsym(library, name);
  if (!address) throw std::runtime_error(std::string("the image module lacks ") + name);
  return reinterpret_cast<F>(address);
}

Module load() {
  std::string problem;
  for (const fs::path& path : candidates()) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) continue;
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
      problem = dlerror();
      continue;
    }
    if (symbol<int (*)()>(library, "verisim_module_version")() != kModuleVersion) {
      problem = path.string() + " belongs to another version of verisim";
      dlclose(library);
      continue;
    }
    return {symbol<VerisimReadImage>(library, "verisim_read_image"),
            symbol<VerisimWriteImage>(library, "verisim_write_image"),
            symbol<VerisimFreeImage>(library, "verisim_free_image")};
  }
  if (problem.empty())
    problem = std::string(kLibrary) +
              " was not found beside the program, in ../lib or ../lib/verisim, nor in $VERISIM_MODULE_PATH";
  throw std::runtime_error("this image format needs verisim's image module: " + problem);
}

}  // namespace

const Module& image_module() {
  static const Module module = load();
  return module;
}

}  // namespace verisim::image
