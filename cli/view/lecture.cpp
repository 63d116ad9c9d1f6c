#include "cli/view/lecture.h"

#include <chrono>
#include <map>
#include <mutex>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/own_program.h"
#include "cli/describe/stored_pixel.h"
#include "cli/frame/frame.h"
#include "cli/rays/ray_tree.h"
#include "cli/settings/reading/switches.h"
#include "compare/json_text.h"
#include "compare/report/display.h"
#include "tracer/base/whole_file.h"
#include "tracer/render/explain.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

constexpr int kMaxPixels = 1 << 20, kMaxSide = 2000;
constexpr double kPatience = 20;  // seconds for one picture

// Scenes of people who try things end at some time.
class Deadline {
 public:
  bool over() {
    if (std::chrono::steady_clock::now() > end_) over_ = true;
    return over_;
  }
  std::atomic<bool>& flag() { return over_; }

 private:
  std::chrono::steady_clock::time_point end_ =
      std::chrono::steady_clock::now() +
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(kPatience));
  std::atomic<bool> over_{false};
};

struct Asked {
  Options options;
  fs::path scene;  // whose place the text takes
  std::string text;
  double x = 0, y = 0;
};

Asked asked(const PageRequest& request, const Options& common, const fs::path& scenes) {
  const nlohmann::json body = compare::parse_json(request.body);
  const fs::path name = fs::path(body.at("name").get<std::string>()).lexically_normal();
  if (name.is_absolute() || name.begin() == name.end() || *name.begin() == ".." || !fs::exists(scenes / name))
    throw std::runtime_error("there is no such scene here");
  Asked a{common, scenes / name, body.at("text"), body.value("x", 0.0), body.value("y", 0.0)};
  std::istringstream switches(body.value("switches", ""));
  for (std::string word; switches >> word;)
    if (word.starts_with("+A") || word.starts_with("+R")) apply_switch(a.options, word);  // how it is sampled, no more
  a.options.width = body.at("width"), a.options.height = body.at("height");
  const auto side = [](int pixels) { return pixels >= 1 && pixels <= kMaxSide; };
  if (!side(a.options.width) || !side(a.options.height) || a.options.width * a.options.height > kMaxPixels)
    throw std::runtime_error("the picture is too large");
  return a;
}

std::string messages_of(const parser::ParseResult& parsed, const fs::path& scene) {
  std::string all;
  for (const parser::Diagnostic& d : parsed.errors) all += parser::format(d) + "\n";
  const std::string folder = scene.parent_path().string() + "/";  // the reader knows the scene by its name
  for (std::size_t at; (at = all.find(folder)) != std::string::npos;) all.erase(at, folder.size());
  return all.empty() ? "This scene is not finished." : all;
}

class Desk {
 public:
  Desk(const Options& options, Interrupt& interrupt)
      : common_(options), console_(common_, Style::verisim), interrupt_(interrupt) {}

  // Calls `use(scene, options of the render, origins)`. Throws std::runtime_error with the scene's mistakes.
  template <class Use>
  auto with_scene(const Asked& a, const Use& use) {
    const std::lock_guard lock(busy_);
    Deadline deadline;
    const Job job{a.options, console_, interrupt_, {a.scene, {}}, animation(a.options)};
    parser::ParseOptions parse = parse_options(job, job.animation.frame(0));
    parser::Origins origins;
    parse.origins = &origins;
    parse.scene_folder = a.scene.parent_path();
    parse.cancelled = [&] { return deadline.over() || interrupt_.flag(); };
    parse.message = nullptr, parse.debug = nullptr;
    const parser::ParseResult parsed = parser::parse_text(a.text, a.scene.string(), parse);
    if (!parsed.scene)
      throw std::runtime_error(deadline.over() ? "Reading this scene takes too long." : messages_of(parsed, a.scene));
    render::Options options = render_options(job, {0, -1, 0, -1});
    options.cancel = &deadline.flag();
    options.progress = [&](double) { deadline.over(); };
    auto result = use(*parsed.scene, options, origins);
    if (deadline.over()) throw std::runtime_error("This scene takes too long.");
    return result;
  }

 private:
  const Options common_;
  Console console_;
  Interrupt& interrupt_;
  std::mutex busy_;
};

std::string drawn(const Asked& a, Desk& desk) {
  return desk.with_scene(a, [&](const scene::Scene& scene, const render::Options& options, const parser::Origins&) {
    render::Framebuffer frame;
    render::render(scene, options, frame);
    return compare::png_bytes(stored_picture(frame, scene, a.options));
  });
}

std::string told(const Asked& a, Desk& desk) {
  return desk.with_scene(
      a, [&](const scene::Scene& scene, const render::Options& options, const parser::Origins& origins) {
        RayTree tree(&origins);
        const Color color = render::explain(scene, options, a.x, a.y, tree);
        return fmt::format("Pixel {:.6g}, {:.6g}\n{}linear {}, in a file of 8 bits {}\n", a.x, a.y, tree.lines(),
                           text(color.rgb()), fmt::join(stored(color, scene, a.options), " "));
      });
}

const char* type_of(const fs::path& file) {
  static const std::map<std::string, const char*> types{{".html", "text/html; charset=utf-8"},
                                                        {".css", "text/css; charset=utf-8"},
                                                        {".js", "text/javascript; charset=utf-8"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".jpg", "image/jpeg"}};
  const auto found = types.find(file.extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

}  // namespace

fs::path lecture_folder() {
  const fs::path program = own_program().parent_path();
  for (const char* place : {"../share/doc/verisim/docs/lecture", "../../../docs/lecture"})
    if (fs::exists(program / place / "index.html")) return fs::canonical(program / place);
  throw std::runtime_error("the pages of the lecture are not installed (share/doc/verisim/docs/lecture)");
}

fs::path lecture_scenes(const fs::path& folder) { return (folder / "../../scenes").lexically_normal(); }

void serve_lecture(Server& server, const fs::path& folder, const Options& options, Interrupt& interrupt) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const fs::path file = entry.path();
    const auto answer = [file](const PageRequest&) { return PageReply{type_of(file), required_file(file)}; };
    server.on(fs::relative(file, folder).generic_string(), answer);
    if (file.filename() == "index.html" && file.parent_path() == folder) server.on("", answer);
  }
  server.on("live", [](const PageRequest&) { return PageReply{"text/plain", "yes"}; });
  const fs::path scenes = lecture_scenes(folder);
  const auto desk = std::make_shared<Desk>(options, interrupt);
  server.on("draw", [desk, options, scenes](const PageRequest& request) {
    return PageReply{"image/png", drawn(asked(request, options, scenes), *desk)};
  });
  server.on("pixel", [desk, options, scenes](const PageRequest& request) {
    return PageReply{"text/plain; charset=utf-8", told(asked(request, options, scenes), *desk)};
  });
}

}  // namespace verisim::cli
