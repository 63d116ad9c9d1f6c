// Finds and loads the plug-ins for image files (module/module.h).
#include <dlfcn.h>
#include <sys/auxv.h>

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

constexpr const char* kLibraries[] = {"libverisim_image_module.so", "libverisim_tiff_module.so",
                                      "libverisim_exr_module.so"};  // by ModuleKind

// The folder of the file this code was linked into: the program or a shared library.
fs::path own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_folder), &info) == 0 || !info.dli_fname) return {};
  std::error_code error;
  fs::path file = info.dli_fname;
  if (file.has_parent_path()) {
    file = fs::canonical(file, error);
  } else {  // argv[0] of a program found through PATH: what the current folder holds under that name is not it
    file = fs::read_symlink("/proc/self/exe", error);
    if (error) file = fs::canonical(reinterpret_cast<const char*>(getauxval(AT_EXECFN)), error);
  }
  return error ? fs::path() : file.parent_path();
}

std::vector<fs::path> candidates(const fs::path& library) {
  std::vector<fs::path> result;
  if (const char* path = std::getenv("VERISIM_MODULE_PATH"); path && *path) {
    std::error_code error;
    result.push_back((fs::is_directory(path, error) ? fs::path(path) : fs::path(path).parent_path()) / library);
  }
  if (const fs::path folder = own_folder(); !folder.empty()) {
    result.push_back(folder / library);
    for (const char* lib : {"lib", "lib64", "lib/x86_64-linux-gnu", "lib/aarch64-linux-gnu"}) {
      result.push_back(folder.parent_path() / lib / library);
      result.push_back(folder.parent_path() / lib / "verisim" / library);
    }
    result.push_back(folder / "verisim" / library);  // beside a shared library in the library folder
  }
  result.push_back(fs::path(VERISIM_MODULE_DIR) / library);
  return result;
}

template <class F>
F symbol(void* library, const char* name) {
  void* address = dlsym(library, name);
  if (!address) throw std::runtime_error(std::string("the image module lacks ") + name);
  return reinterpret_cast<F>(address);
}

Module functions(void* library, ModuleKind kind) {
  return {symbol<VerisimReadImage>(library, "verisim_read_image"),
          kind == ModuleKind::general ? symbol<VerisimWriteImage>(library, "verisim_write_image") : nullptr,
          symbol<VerisimFreeImage>(library, "verisim_free_image"),
          kind == ModuleKind::exr ? symbol<VerisimListChannels>(library, "verisim_list_channels") : nullptr,
          kind == ModuleKind::exr ? symbol<VerisimReadChannels>(library, "verisim_read_channels") : nullptr};
}

Module load(ModuleKind kind) {
  const std::string name = kLibraries[static_cast<int>(kind)];
  std::string problem;
  for (const fs::path& path : candidates(name)) {
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
    return functions(library, kind);
  }
  // Along the run path of the program that this library is linked into.
  if (void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL); library) {
    if (symbol<int (*)()>(library, "verisim_module_version")() == kModuleVersion) return functions(library, kind);
    problem = name + " belongs to another version of verisim";
    dlclose(library);
  }
  if (problem.empty())
    problem = name + " was not found beside the program, in ../lib or ../lib/verisim, in " VERISIM_MODULE_DIR
                     ", nor in $VERISIM_MODULE_PATH; it is in the package verisim-images";
  throw std::runtime_error("this image format needs verisim's image module: " + problem);
}

}  // namespace

const Module& image_module(ModuleKind kind) {
  switch (kind) {
    case ModuleKind::tiff: {
      static const Module tiff = load(kind);
      return tiff;
    }
    case ModuleKind::exr: {
      static const Module exr = load(kind);
      return exr;
    }
    default: {
      static const Module general = load(kind);
      return general;
    }
  }
}

std::vector<fs::path> image_module_files() {
  std::vector<fs::path> files;
  for (const char* library : kLibraries)
    for (const fs::path& path : candidates(library)) {
      std::error_code error;
      if (fs::is_regular_file(path, error)) files.push_back(path);
    }
  return files;
}

}  // namespace verisim::image
