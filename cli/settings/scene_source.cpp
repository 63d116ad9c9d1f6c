#include "cli/settings/scene_source.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "cli/settings/output_name.h"
#include "tracer/base/descriptor.h"
#include "tracer/base/output_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

std::string read_stream(const fs::path& path, std::size_t limit) {
  const std::string name = path == "-" ? "standard input" : "'" + path.string() + "'";
  const auto fail = [&] {
    throw std::runtime_error(fmt::format("cannot read the scene from {}: {}", name, std::strerror(errno)));
  };
  const Descriptor stream(path == "-" ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (stream.get() < 0) fail();
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t n = ::read(stream.get(), buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail();
    if (n == 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
    if (text.size() > limit)
      throw std::runtime_error(fmt::format("the scene from {} has more bytes than --max-file-bytes {}", name, limit));
  }
}

}  // namespace

bool is_stream(const std::string& name) {
  if (name == "-") return true;
  std::error_code ignored;
  const fs::file_status status = fs::status(name, ignored);
  return fs::is_fifo(status) || fs::is_character_file(status) || fs::is_socket(status);
}

SceneSource open_scene(const Options& options) {
  if (!options.stdin_name.empty() && options.input_file != "-")
    throw OptionError("--stdin-name is for a scene that is read from standard input: give - as the scene");
  const fs::path path = options.input_file == "-" ? fs::path("-") : find_scene(options);
  if (path.empty() || !is_stream(path.string())) return {path, std::nullopt};
  std::string text = read_stream(path, options.limits.max_file_bytes);
  if (path != "-") return {path, std::move(text)};
  return {options.stdin_name.empty() ? fs::path("stdin") : fs::path(options.stdin_name), std::move(text)};
}

SpooledScene::SpooledScene(const SceneSource& source) {
  std::string folder = (fs::temp_directory_path() / "verisim-XXXXXX").string();
  if (!::mkdtemp(folder.data()))
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder, std::strerror(errno)));
  path_ = fs::path(folder) / (source.path.stem().string() + ".pov");
  write_text_file(path_, *source.text);
}

SpooledScene::~SpooledScene() {
  std::error_code ignored;
  fs::remove_all(path_.parent_path(), ignored);
}

}  // namespace verisim::cli
