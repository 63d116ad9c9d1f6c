// POV-Ray as the oracle: found, run in isolation, its pictures cached by content.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/oracle/content_hash.h"
#include "compare/oracle/povray.h"
#include "compare/oracle/process.h"
#include "compare/oracle/switches.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

// What its messages are made with, and nothing of the user's.
std::vector<std::pair<std::string, std::string>> clean_environment(const fs::path& home, const fs::path& ini) {
  std::vector<std::pair<std::string, std::string>> out = {
      {"HOME", home.string()}, {"PATH", "/usr/local/bin:/usr/bin:/bin"}, {"LC_ALL", "C"}};
  if (!ini.empty()) out.emplace_back("POVINI", ini.string());
  return out;
}

std::string trimmed(const std::string& s) {
  const auto first = s.find_first_not_of(" \t\r\n\""), last = s.find_last_not_of(" \t\r\n\"");
  return first == std::string::npos ? std::string() : s.substr(first, last - first + 1);
}

// The Library_Path lines of an INI file; those that exist.
void add_library_paths(const fs::path& ini, std::vector<fs::path>& out) {
  std::ifstream in(ini);
  for (std::string line; std::getline(in, line);) {
    const auto equals = line.find('=');
    if (equals == std::string::npos) continue;
    std::string key = trimmed(line.substr(0, equals));
    std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::tolower(c); });
    if (key != "library_path") continue;
    const fs::path path = trimmed(line.substr(equals + 1));
    std::error_code ignored;
    if (fs::is_directory(path, ignored) && std::find(out.begin(), out.end(), path) == out.end()) out.push_back(path);
  }
}

std::vector<fs::path> discover_library_paths(const fs::path& program) {
  const fs::path prefix = program.parent_path().parent_path();
  std::vector<fs::path> out;
  for (const fs::path& folder :
       {prefix / "etc/povray/3.7", fs::path("/etc/povray/3.7"), fs::path("/usr/local/etc/povray/3.7")}) {
    add_library_paths(folder / "povray.ini", out);
    if (!out.empty()) return out;
  }
  for (const fs::path& share :
       {prefix / "share/povray-3.7", fs::path("/usr/share/povray-3.7"), fs::path("/usr/local/share/povray-3.7")}) {
    std::error_code ignored;
    if (!fs::is_directory(share / "include", ignored)) continue;
    return {share, share / "ini", share / "include"};
  }
  return out;
}

fs::path cache_folder(const OracleOptions& options) {
  if (!options.cache.empty()) return options.cache;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache == '/')
    return fs::path(cache) / "verisim/oracle";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache/verisim/oracle";
  return fs::temp_directory_path() / "verisim-oracle-cache";
}

// Our own INI stands for the system's: the same search paths, and no other setting of this machine.
// POV-Ray's command line and INI syntax lose quotes and what is not ASCII: such a scene is read by another name, beside
// its own.
fs::path plainly_named(const fs::path& scene) {
  const std::string name = scene.filename().string();
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '_' || c == '-' || c == '+'; };
  if (std::all_of(name.begin(), name.end(), plain)) return scene;
  ContentHash hash;
  hash.add(name);
  const fs::path alias = scene.parent_path() / ("verisim-" + hash.hex().substr(0, 12) + ".pov");
  fs::copy_file(scene, alias, fs::copy_options::overwrite_existing);
  return alias;
}

std::string ini_text(const std::vector<fs::path>& library_paths) {
  std::string out = "Bounding_Threshold=3\n";
  for (const fs::path& path : library_paths) out += fmt::format("Library_Path=\"{}\"\n", path.string());
  return out;
}

// Where random numbers fall depends on which thread gets which block. With these orders no block of the even variants,
// or of the odd ones, comes at the same place of a thread's work in more than two of four. There are never more than
// eight threads: with many, most blocks of a small picture come first and repeat.
struct BlockOrder {
  int pattern, step;
};
constexpr BlockOrder kBlockOrders[] = {{0, 0}, {3, 0}, {5, 0}, {2, 0}, {3, 5}, {5, 5}, {2, 5}, {0, 5}};

std::vector<std::string> command_line(const OracleProgram& program, const OracleOptions& options,
                                      const SceneRequest& scene, const std::string& input, const std::string& output,
                                      int variant) {
  constexpr int kOrders = static_cast<int>(std::size(kBlockOrders));
  std::vector<std::string> out = {program.path.string(), "+I" + input};
  out.insert(out.end(), scene.switches.begin(), scene.switches.end());
  if (!output_type(scene.switches)) out.push_back(kFinePicture);
  for (const std::string& s : {"+O" + output, fmt::format("+W{}", scene.width), fmt::format("+H{}", scene.height),
                               fmt::format("+WT{}", std::max(1, options.threads) + variant % kOrders)})
    out.push_back(s);
  if (variant > 0) {
    const auto [pattern, step] = kBlockOrders[variant % kOrders];
    out.push_back(fmt::format("+RP{}", pattern)), out.push_back(fmt::format("+RS{}", step + 6 * (variant / kOrders)));
    // Of the few blocks of a small picture each is some thread's first whatever the order. Anti-aliasing sees them.
    if (!scene.antialiased()) out.push_back(fmt::format("+BS{}", 8 + 7 * variant % 17));
    if (program.name == "verisim")
      out.push_back(fmt::format("--seed={}", variant));  // its pictures do not depend on threads
  }
  for (const char* s : {"-D", "-P", "-V"}) out.emplace_back(s);
  return out;
}

// Everything that decides how the picture will look. Of files beyond kContentBytes their size and time count: a scene
// may lie in a folder of terabytes.
constexpr std::uintmax_t kContentBytes = std::uintmax_t{1} << 30;
std::string cache_key(const OracleProgram& program, const OracleOptions& options, const SceneRequest& scene,
                      int variant, const std::vector<fs::path>& files_read) {
  ContentHash hash;
  hash.add("verisim oracle 1");
  hash.add(program.version_text);
  hash.add(ini_text(program.library_paths));
  for (const std::string& s : command_line(program, options, scene, scene.scene.filename().string(), "", variant))
    hash.add(s == program.path ? "" : s);
  const fs::path folder = scene.scene.parent_path();
  std::vector<fs::path> files = files_read;
  std::error_code failed;
  if (files.empty()) {
    files = files_below(folder).files;
    for (const fs::path& library : program.library_paths)
      for (auto it = fs::directory_iterator(library, failed); !failed && it != fs::directory_iterator();
           it.increment(failed))
        if (it->is_regular_file(failed)) files.push_back(it->path());
  }
  files.push_back(scene.scene);
  for (fs::path& file : files) file = file.lexically_normal();
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  std::uintmax_t unread = kContentBytes;
  for (const fs::path& file : files) {
    const fs::path relative = file.lexically_relative(folder);
    hash.add(relative.empty() ? file.string() : relative.string());  // the same scene elsewhere is the same scene
    const std::uintmax_t size = fs::file_size(file, failed);
    if (failed || size <= unread) {
      unread -= failed ? 0 : size;
      hash.add_file(file);
    } else {
      hash.add(fmt::format("{} {}", size, fs::last_write_time(file, failed).time_since_epoch().count()));
    }
  }
  return hash.hex();
}

struct CacheEntry {
  fs::path folder, picture, meta;
  CacheEntry(const fs::path& cache, const std::string& key, const std::string& extension)
      : folder(cache / key.substr(0, 2) / key), picture(folder / ("picture" + extension)), meta(folder / "meta.json") {}

  // True: `out` is what the cache knows, a picture or that there was no end within at least this time.
  bool load(OracleRender& out, double time_limit) const {
    std::ifstream in(meta);
    if (!in) return false;
    try {
      const auto json = parse_json(in);
      if (json.contains("no_end_after")) {
        out.message = json.at("message").get<std::string>() + " (known from an earlier run; --no-cache tries again)",
        out.from_cache = true;
        return time_limit > 0 && time_limit <= json.at("no_end_after").get<double>();
      }
      out.picture = image::read_picture(picture);
      out.seconds = json.at("seconds"), out.cpu_seconds = json.at("cpu_seconds"),
      out.peak_bytes = json.at("peak_bytes");
      out.ok = out.from_cache = true;
    } catch (const std::exception&) {
      return false;  // damaged: rendered again
    }
    return true;
  }

  void store(const OracleRender& render, const fs::path& from, const OracleProgram& program,
             const SceneRequest& scene) const {
    store({{"scene", scene.name},
           {"version", program.version},
           {"switches", scene.switches},
           {"width", scene.width},
           {"height", scene.height},
           {"seconds", render.seconds},
           {"cpu_seconds", render.cpu_seconds},
           {"peak_bytes", render.peak_bytes}},
          from);
  }
  // Waiting once is enough.
  void store_no_end(const std::string& message, double time_limit) const {
    store({{"no_end_after", time_limit}, {"message", message}}, {});
  }

 private:
  // The folder appears complete or not at all; a cache that cannot be written is no reason to fail.
  void store(const nlohmann::json& about, const fs::path& from) const {
    std::error_code failed;
    fs::create_directories(folder.parent_path(), failed);
    std::string temporary = (folder.parent_path() / "new-XXXXXX").string();
    if (failed || !mkdtemp(temporary.data())) return;
    if (!from.empty()) fs::copy_file(from, fs::path(temporary) / picture.filename(), failed);
    std::ofstream(fs::path(temporary) / "meta.json") << json_text(about, 1) << "\n";
    if (!failed) fs::remove_all(folder, failed);
    if (!failed) fs::rename(temporary, folder, failed);
    if (failed) fs::remove_all(temporary, failed);
  }
};

// POV-Ray's messages without progress; what was wrapped at 80 columns (continuation lines start with a blank) is one
// line again.
std::vector<std::string> message_lines(const std::string& err) {
  std::istringstream in(err);
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) {
    if (const auto cr = line.find_last_of('\r'); cr != std::string::npos) line.erase(0, cr + 1);
    if (line.starts_with(" ") && !out.empty())
      out.back() += line;
    else
      out.push_back(line);
  }
  return out;
}

// What it says about its failure, without the banner and the option blocks.
std::string pov_messages(const std::string& err) {
  std::string out, last;
  for (const std::string& line : message_lines(err)) {
    const bool worth = line.find("Error") != std::string::npos || line.find("error") != std::string::npos ||
                       line.starts_with("Problem with") || line.starts_with("Failed to") || line.starts_with("Cannot");
    if (worth && out.size() < 2000) out += (out.empty() ? "" : "; ") + trimmed(line);
    if (!trimmed(line).empty()) last = trimmed(line);
  }
  return out.empty() ? last : out;
}

// "POV-Ray: exit status 1: Parse Error: ..."
std::string failure(const OracleProgram& program, const ProcessResult& run, double time_limit) {
  std::string out = fmt::format("{}: {}", program.name, run.how_it_ended(time_limit));
  if (const std::string said = pov_messages(run.err); !said.empty()) out += ": " + said;
  return out;
}

}  // namespace

OracleProgram find_oracle(const OracleOptions& options) {
  OracleProgram out;
  out.path = find_program(options.program.empty() ? "povray" : options.program.string());
  if (out.path.empty())
    throw OracleMissing(
        options.program.empty()
            ? "POV-Ray is not installed: install the Debian package povray (and povray-includes for the standard "
              "include files)"
            : fmt::format("{} is not a program; POV-Ray is in the Debian package povray", options.program.string()));
  const TemporaryFolder home;
  const ProcessResult run =
      run_process({{out.path.string(), "--version"}, home.path(), clean_environment(home.path(), {}), 30, nullptr});
  const std::string text = run.err + run.out;
  // Through a link named povray it would be compared with itself; who wants that names it.
  if (options.program.empty() && text.starts_with("verisim "))
    throw OracleMissing(
        fmt::format("{} is verisim itself, under the name of povray: that would prove nothing. Name a POV-Ray with "
                    "--oracle PROGRAM (it is in the Debian package povray), or another verisim to compare the two",
                    out.path.string()));
  if (run.succeeded() && text.starts_with("verisim ")) {  // its version does not change with every build
    ContentHash hash;
    hash.add_file(out.path);
    out.name = "verisim", out.version = trimmed(text.substr(8, text.find_first_of(" \n", 8) - 8)),
    out.version_text = text + hash.hex();
    const fs::path povray = find_program("povray");
    out.library_paths = options.library_paths.empty()
                            ? discover_library_paths(povray.empty() ? "/usr/bin/povray" : fs::canonical(povray))
                            : options.library_paths;
    return out;
  }
  const auto at = text.find("POV-Ray ");
  if (!run.succeeded() || at == std::string::npos)
    throw OracleMissing(
        fmt::format("{} --version does not answer as POV-Ray does ({}); POV-Ray is in the Debian package povray",
                    out.path.string(), run.how_it_ended(30)));
  out.version_text = text.substr(at);
  out.version = trimmed(out.version_text.substr(8, out.version_text.find('\n') - 8));
  out.library_paths =
      options.library_paths.empty() ? discover_library_paths(fs::canonical(out.path)) : options.library_paths;
  return out;
}

OracleRender run_oracle(const OracleProgram& program, const OracleOptions& options, const SceneRequest& scene,
                        int variant, const std::vector<fs::path>& files_read, std::atomic<bool>* cancel) {
  OracleRender out;
  try {
    const std::string extension = output_extension(scene.switches);
    const CacheEntry entry(cache_folder(options), cache_key(program, options, scene, variant, files_read), extension);
    if (options.use_cache && entry.load(out, options.time_limit)) return out;
    out = {};

    const WorkingCopy copy(scene.scene);
    const fs::path ini = copy.home() / "oracle.ini", picture = copy.out() / ("picture" + extension);
    std::ofstream(ini) << ini_text(program.library_paths);
    const ProcessResult run =
        run_process({command_line(program, options, scene, plainly_named(copy.scene()).filename().string(),
                                  picture.string(), variant),
                     copy.folder(), clean_environment(copy.home(), ini), options.time_limit, cancel});
    out.seconds = run.wall, out.cpu_seconds = run.cpu, out.peak_bytes = run.peak_bytes;
    if (!run.succeeded()) {
      out.message = failure(program, run, options.time_limit);
      if (run.timed_out && options.use_cache) entry.store_no_end(out.message, options.time_limit);
      return out;
    }
    std::error_code ignored;
    if (!fs::exists(picture, ignored)) {
      out.message = program.name + ": ended well but wrote no picture";
      return out;
    }
    out.picture = image::read_picture(picture);
    if (out.picture.width != scene.width || out.picture.height != scene.height) {
      out.message = fmt::format("{}: wrote a picture of {}x{} in the place of {}x{}", program.name, out.picture.width,
                                out.picture.height, scene.width, scene.height);
      return out;
    }
    out.ok = true;
    if (options.use_cache) entry.store(out, picture, program, scene);
  } catch (const std::exception& error) {
    out.ok = false;
    out.message = fmt::format("{}: {}", program.name, error.what());
  }
  return out;
}

NativeResult render_with_povray(const OracleProgram& program, const OracleOptions& options,
                                const NativeRequest& request, int variant) {
  NativeResult out;
  SceneRequest scene;
  scene.switches = request.switches, scene.width = request.width, scene.height = request.height;
  const TemporaryFolder home;
  const fs::path ini = home.path() / "oracle.ini";
  std::ofstream(ini) << ini_text(program.library_paths);
  const ProcessResult run =
      run_process({command_line(program, options, scene, plainly_named(request.scene).filename().string(),
                                request.output.string(), variant),
                   request.folder, clean_environment(home.path(), ini), request.time_limit, request.cancel});
  out.seconds = run.wall, out.cpu_seconds = run.cpu, out.peak_bytes = run.peak_bytes;
  if (run.succeeded())
    out.outcome = NativeResult::Outcome::rendered, out.console = run.err;
  else
    out.message = failure(program, run, request.time_limit), out.ending = ending_of(run);
  return out;
}

NativeRenderer povray_renderer(const OracleProgram& program, const OracleOptions& options) {
  return [program, options](NativeRequest request) {
    request.time_limit = options.time_limit;
    return render_with_povray(program, options, request, 2 * request.run + 1);
  };
}

}  // namespace verisim::compare
