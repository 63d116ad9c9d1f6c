#include "compare/oracle/working_copy.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kCopyBytes = std::uintmax_t{256} << 20;
constexpr int kMaxFiles = 20000, kMaxNeighbours = 2000;

class Copier {
 public:
  void copy_tree(const fs::path& from, const fs::path& to, bool deep) {
    fs::create_directories(to);
    for (const fs::directory_entry& entry : fs::directory_iterator(from, fs::directory_options::skip_permission_denied)) {
      const fs::path name = entry.path().filename();
      std::error_code failed;
      if (entry.is_directory(failed)) {
        // A link to a folder may lead back up: it stays a link.
        if (entry.is_symlink(failed)) fs::create_directory_symlink(fs::canonical(entry.path(), failed), to / name, failed);
        else if (deep && !name.string().starts_with(".")) copy_tree(entry.path(), to / name, deep);
      } else if (entry.is_regular_file(failed)) {
        copy_one(entry, to / name);
      }
    }
  }

 private:
  void copy_one(const fs::directory_entry& entry, const fs::path& to) {
    std::error_code failed;
    const std::uintmax_t size = entry.file_size(failed);
    if (failed) return;
    if (copied_ + size <= kCopyBytes) {
      fs::copy_file(entry.path(), to, failed);  // an unreadable neighbour is not the scene's problem unless the scene asks for it
      copied_ += size;
      std::error_code ignored;
      fs::permissions(to, fs::perms::owner_write, fs::perm_options::add, ignored);
    } else {
      fs::create_symlink(fs::absolute(entry.path()), to, failed);
    }
  }
  std::uintmax_t copied_ = 0;
};

bool many_files(const fs::path& folder) {
  int count = 0;
  std::error_code failed;
  for (auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, failed); !failed && it != fs::recursive_directory_iterator();
       it.increment(failed))
    if (++count > kMaxFiles) return true;
  return false;
}

void link_neighbours(const fs::path& folder, const fs::path& to) {
  const fs::path parent = folder.parent_path();
  if (parent == folder || parent == parent.root_path()) return;
  int count = 0;
  std::error_code failed;
  for (auto it = fs::directory_iterator(parent, failed); !failed && it != fs::directory_iterator() && ++count <= kMaxNeighbours; it.increment(failed)) {
    std::error_code ignored;
    if (it->path() != folder) fs::create_symlink(it->path(), to / it->path().filename(), ignored);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "verisim-XXXXXX").string();
  if (!mkdtemp(name.data())) throw fs::filesystem_error("cannot make a temporary folder", name, std::error_code(errno, std::generic_category()));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

WorkingCopy::WorkingCopy(const fs::path& scene) : name_(scene.filename()) {
  const fs::path from = fs::canonical(scene).parent_path();
  const fs::path base = root_.path() / "scenes";
  folder_ = base / (from.has_filename() ? from.filename() : fs::path("root"));
  fs::create_directories(home());
  fs::create_directories(out());
  Copier().copy_tree(from, folder_, !many_files(from));
  if (!fs::exists(folder_ / name_)) fs::copy_file(scene, folder_ / name_);  // the scene itself was reached through a link
  link_neighbours(from, base);
}

}  // namespace verisim::compare
