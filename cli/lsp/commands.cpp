// "Render this" and "explain this object": work that takes a while and runs in the background.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>

#include "cli/describe/dump.h"
#include "cli/describe/object_names.h"
#include "cli/lsp/features.h"
#include "tracer/base/whole_file.h"

namespace fs = std::filesystem;
extern char** environ;

namespace verisim::cli::lsp {
namespace {

// Renders that are under way.
std::mutex running_mutex;
std::set<pid_t> running;

// Runs the program; its input and its messages are files. Returns the exit status.
int run(const std::string& program, const std::vector<std::string>& words, const fs::path& input,
        const fs::path& messages) {
  std::vector<char*> arguments;
  arguments.push_back(const_cast<char*>(program.c_str()));
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_addopen(&files, 0, input.c_str(), O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_addopen(&files, 2, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int failed = ::posix_spawn(&child, program.c_str(), &files, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  if (failed) throw std::runtime_error(fmt::format("cannot run {}: {}", program, std::strerror(failed)));
  {
    const std::lock_guard lock(running_mutex);
    running.insert(child);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const std::lock_guard lock(running_mutex);
  running.erase(child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

// Objects by where they are written.
class Finder {
 public:
  Finder(const fs::path& file, std::size_t line) : file_(file.string()), line_(static_cast<int>(line)) {}

  void look(const scene::Object& object) {
    if (object.place.file && object.place.line == line_ && normal(*object.place.file) == file_) {
      ++count;
      if (!first) first = &object;
      return;
    }
    for (const scene::ObjectPtr& child : scene::children_of(object)) look(*child);
  }
  const scene::Object* first = nullptr;
  std::size_t count = 0;

 private:
  std::string file_;
  int line_;
};

std::string three(const std::array<float, 3>& v) { return fmt::format("<{:.4g}, {:.4g}, {:.4g}>", v[0], v[1], v[2]); }

}  // namespace

void stop_renders() {
  const std::lock_guard lock(running_mutex);
  for (const pid_t child : running) ::kill(child, SIGKILL);
}

Json render_command(const fs::path& program, const Options& options, const Root& root, const fs::path& scratch,
                    const Json& settings) {
  const fs::path folder = scratch / "renders";
  fs::create_directories(folder);
  const std::string name = root.path.empty() ? "untitled" : root.path.stem().string();
  const fs::path picture = folder / (name + ".png"), messages = folder / (name + ".txt"),
                 input = folder / (name + ".pov");
  std::vector<std::string> words{"render"};
  fs::path in = "/dev/null";
  if (root.text) {  // what the editor holds
    std::ofstream(input, std::ios::binary) << root.text->str();
    in = input;
    words.insert(words.end(), {"-", "--stdin-name", root.path.empty() ? "untitled.pov" : root.path.string()});
  } else {
    words.push_back(root.path.string());
  }
  const auto number = [&](const char* key, int otherwise) {
    return settings.is_object() ? std::clamp(settings.value(key, otherwise), 1, 16384) : otherwise;
  };
  words.push_back(fmt::format("+W{}", number("width", 640)));
  words.push_back(fmt::format("+H{}", number("height", 480)));
  if (!settings.is_object() || settings.value("antialias", true)) words.push_back("+A0.3");
  for (const std::string& path : options.library_paths) words.push_back("--library=" + path);
  words.push_back("+O" + picture.string());
  words.push_back("--max-seconds=600");
  std::error_code ignored;
  fs::remove(picture, ignored);
  const int status = run(program.string(), words, in, messages);
  Json result{{"status", status}, {"messages", whole_file(messages).value_or("")}};
  if (fs::exists(picture, ignored)) result["picture"] = picture.string(), result["uri"] = uri_of(picture);
  return result;
}

Json explain_command(const Options& options, const Root& root, std::shared_ptr<const Snapshot> snapshot,
                     const fs::path& scratch, const fs::path& file, std::size_t line) {
  constexpr double kSeconds = 30;
  const auto analysis = analyse(
      options, root, std::move(snapshot), scratch, kSeconds, [] { return false; }, true);
  if (!analysis->scene) throw std::runtime_error("The scene has errors: mend them first.");
  Finder finder(file.empty() ? fs::path(root.uri) : file, line);
  for (const scene::ObjectPtr& object : analysis->scene->objects) finder.look(*object);
  if (!finder.first)
    throw std::runtime_error(
        "No object of the scene is written here: it may be declared and not used, or be a part of another.");
  const scene::Object& object = *finder.first;
  std::string text = object_name(object);
  if (finder.count > 1) text += fmt::format(", the first of {} that this line makes", finder.count);
  text += '\n';
  if (scene::is_infinite(object)) {
    text += "It has no end.\n";
  } else {
    const auto& b = object.bounds;
    text += fmt::format("Its box: {} to {}.\n", three(b.low),
                        three({b.low[0] + b.size[0], b.low[1] + b.size[1], b.low[2] + b.size[2]}));
  }
  if (const std::size_t children = scene::children_of(object).size())
    text += fmt::format("It has {} parts.\n", children);
  if (scene::is_patch(object)) text += "It is a surface without an inside.\n";
  if (object.is_hollow()) text += "It is hollow: media and fog fill it.\n";
  if (object.no_shadow) text += "It throws no shadow.\n";
  if (object.no_image) text += "The camera does not see it.\n";
  if (object.inverted) text += "Its inside and outside are swapped.\n";
  if (object.interior && object.interior->ior > 0)
    text += fmt::format("Its index of refraction is {:.4g}.\n", object.interior->ior);
  if (object.texture)
    text += fmt::format("Its texture has {} layer{}.\n", object.texture->layers.size(),
                        object.texture->layers.size() == 1 ? "" : "s");
  SceneDump dump;
  Json details(dump.object(object));
  return {{"text", text}, {"object", std::move(details)}};
}

}  // namespace verisim::cli::lsp
