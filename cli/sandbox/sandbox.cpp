#include "cli/sandbox/sandbox.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/sandbox/landlock.h"
#include "cli/sandbox/private_folder.h"
#include "cli/sandbox/system_calls.h"
#include "cli/settings/animation.h"
#include "cli/settings/reading/configuration.h"
#include "cli/settings/output_name.h"
#include "cli/settings/process_limits.h"
#include "parser/source/confinement.h"
#include "tracer/base/output_file.h"
#include "tracer/base/resident_memory.h"

namespace fs = std::filesystem;

#ifdef __SANITIZE_ADDRESS__
namespace {
bool confined = false;  // system calls are filtered
}
// The check for leaks looks on from outside, as a debugger does, which filters do not allow.
extern "C" int __lsan_is_turned_off() { return confined; }
#endif

namespace verisim::cli {
namespace {

constexpr const char* kFontFolders[] = {"/usr/share/fonts", "/usr/local/share/fonts"};

// Most file types are written by libraries that want a name; from there they are copied into a stream.
void grant_temporary_folder(Policy& policy, const Options& options) {
  if (options.format == image::Format::png || options.format == image::Format::ppm) return;
  static const PrivateFolder folder("verisim-");
  ::setenv("TMPDIR", folder.path().c_str(), 1);
  policy.read.push_back(folder.path());
  policy.write.push_back(folder.path());
}

void grant_pictures(Policy& policy, const Options& options, const SceneSource& scene) {
  const Animation frames = animation(options);
  for (std::size_t i = 0; i < frames.count(); ++i) {
    const OutputName name = output_name(options, scene.path, frames, frames.frame(i));
    if (name.path.empty()) return grant_temporary_folder(policy, options);
    grant_output(policy, name.path);
    if (!policy.write_files.empty()) grant_temporary_folder(policy, options);
    grant_output(policy, name.state_path);
    if (options.continue_trace) policy.read.push_back(behind_links(name.state_path));
    if (options.continue_trace) policy.read.push_back(behind_links(name.path));
  }
}

// The files of +GD and its like lie in the folder of the picture.
bool has_message_files(const Options& options) {
  for (const TextStream* stream :
       {&options.debug, &options.fatal, &options.render, &options.statistic, &options.warning, &options.all})
    if (!stream->file.empty()) return true;
  return false;
}

}  // namespace

bool wants_sandbox() {
  const std::string& mode = process_limits.sandbox;
  if (mode == "off") return false;
  if (mode != "strict" && mode != "best-effort")
    throw OptionError("--sandbox is `strict`, `best-effort` or `off`, not `" + mode + "`");
  return true;
}

Policy policy_of(const Options& options, const std::vector<SceneSource>& scenes) {
  Policy policy;
  for (const SceneSource& scene : scenes) {
    // Of a scene from standard input without a name there is no folder.
    const bool named = !scene.text || !options.stdin_name.empty();
    const fs::path folder = scene.path.parent_path();
    if (named) policy.read.push_back(folder.empty() ? "." : folder);
    for (const fs::path& path : search_paths(options, scene.path))
      if (path != folder || named) policy.read.push_back(path);
  }
  for (const char* folder : kFontFolders) policy.read.emplace_back(folder);
  for (const fs::path& path : options.allow_read) policy.read.push_back(path);
  for (const fs::path& path : options.allow_write) policy.read.push_back(path), policy.write.push_back(path);
  if (!options.include_header.empty()) policy.read.emplace_back(options.include_header);
  return policy;
}

void confine_scene(Options& options, const Policy& policy) {
  options.allow_read = policy.read;
  parser::confinement.writes_named_only = true;
}

void enter_sandbox(const Policy& policy) {
  if (!wants_sandbox()) return;
  const bool files = landlock_version() > 0, calls = has_system_call_filters();
  std::vector<std::string_view> missing;
  if (!files) missing.emplace_back("Landlock (files)");
  if (!calls) missing.emplace_back("seccomp filters (system calls)");
  if (!missing.empty()) {
    const std::string what =
        fmt::format("this kernel, or the container, does not give {}", fmt::join(missing, " and "));
    if (process_limits.sandbox == "strict")
      throw std::runtime_error(
          fmt::format("--sandbox: {}; --sandbox=best-effort goes on with what there is, --sandbox=off without", what));
    std::fprintf(stderr, "verisim: warning: --sandbox=best-effort: %s\n", what.c_str());
  }
  resident_memory();  // opens what it looks at
  Policy all = policy;
  for (const fs::path& path : system_files()) all.read.push_back(path);
  if (files) restrict_files(all);
  if (calls) restrict_system_calls(policy.server);
#ifdef __SANITIZE_ADDRESS__
  confined = calls;
#endif
}

void sandbox_render(Options& options, const SceneSource& scene) {
  if (!wants_sandbox()) return;
  if (options.allow_shell) throw OptionError("--allow-shell runs commands, and --sandbox none: give one of them");
  Policy policy = policy_of(options, {scene});
  confine_scene(options, policy);
  if (options.output_to_file || has_message_files(options)) grant_pictures(policy, options, scene);
  for (const std::string& file : {options.stats_file, options.create_ini})
    if (!file.empty() && file != "-") grant_output(policy, file);
  if (!options.prepass_file.empty()) policy.read.emplace_back(options.prepass_file);
  if (options.radiosity_from_file) policy.read.emplace_back(options.radiosity_file);
  if (options.radiosity_to_file) grant_output(policy, options.radiosity_file);
  enter_sandbox(policy);
}

}  // namespace verisim::cli
