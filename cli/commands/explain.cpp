// `verisim explain`: how one pixel came to be, as a tree of rays; and what the wrong pixels of a scene have in common.
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/commands.h"
#include "cli/commands/explain_scene.h"
#include "cli/frame/frame.h"
#include "cli/sandbox/sandbox.h"
#include "cli/settings/reading/own_options.h"
#include "cli/describe/pixel_tags.h"
#include "cli/rays/ray_drawing.h"
#include "cli/rays/ray_page.h"
#include "cli/rays/ray_tree.h"
#include "cli/describe/stored_pixel.h"
#include "cli/settings/reading/scene_words.h"
#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/report/display.h"
#include "tracer/render/explain.h"
#include "tracer/shading/tracer.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

std::string oracle_pixel(const fs::path& scene, const Options& options, std::vector<std::string> switches, int x, int y,
                         const std::vector<fs::path>& files) {
  try {
    compare::OracleOptions oracle;
    const compare::OracleProgram program = compare::find_oracle(oracle);
    compare::SceneRequest request;
    request.scene = fs::absolute(scene);
    request.name = scene.filename().string();
    request.width = options.width;
    request.height = options.height;
    // Only this pixel; a start or end of 1 would mean the whole width.
    switches.insert(switches.end(),
                    {"-A", fmt::format("+SC{}", x + 1), fmt::format("+SR{}", y + 1),
                     x == 0 ? fmt::format("+EC{:.9f}", 1.5 / options.width) : fmt::format("+EC{}", x + 1),
                     y == 0 ? fmt::format("+ER{:.9f}", 1.5 / options.height) : fmt::format("+ER{}", y + 1)});
    request.switches = switches;
    const compare::OracleRender render = compare::run_oracle(program, oracle, request, 0, files);
    if (!render.ok) return "POV-Ray failed: " + render.message;
    const std::size_t at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(render.picture.width) + static_cast<std::size_t>(x)) *
        static_cast<std::size_t>(render.picture.channels);
    const auto value = [&](std::size_t c) {
      return static_cast<int>(render.picture.samples[at + (render.picture.channels >= 3 ? c : 0)] * 255 + 0.5f);
    };
    return fmt::format("POV-Ray {}: {} {} {}", program.version, value(0), value(1), value(2));
  } catch (const compare::OracleMissing& missing) {
    return missing.what();
  }
}

// A position in pixels; whole numbers are centres.
double coordinate(const std::string& word, int limit, const char* name) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end || !(value >= -0.5 && value <= limit - 0.5))
    throw OptionError(fmt::format("{} must be a number from 0 to {}, not '{}'", name, limit - 1, word));
  return value;
}

// Every pixel's tags, and the trees of some: what `verisim compare` asks for.
void write_tags(const std::string& file, int step, const std::vector<std::string>& trees, render::Explainer& explainer,
                const scene::Scene& scene, const parser::Origins& origins, const Options& options) {
  TagWitness witness(scene, origins);
  compare::PixelTags& tags = witness.tags();
  tags.width = options.width, tags.height = options.height, tags.step = step;
  for (int y = 0; y < options.height; y += step)
    for (int x = 0; x < options.width; x += step) {
      explainer.pixel(x, y, witness);
      tags.set_of.push_back(witness.take());
    }
  tags.parts = witness.parts();
  for (const std::string& pixel : trees) {
    int x = 0, y = 0;
    if (std::sscanf(pixel.c_str(), "%d,%d", &x, &y) != 2 || x < 0 || y < 0 || x >= options.width || y >= options.height)
      throw OptionError(fmt::format("--tree {}: expected X,Y inside the picture", pixel));
    RayTree tree;
    const Color color = explainer.pixel(x, y, tree);
    tags.trees.push_back({x, y, tree.lines() + fmt::format("linear {}\n", text(color.rgb()))});
  }
  compare::write_report(compare::tags_json(tags), file);
}

// Files of one pixel's story, beside what is printed.
struct StoryFiles {
  std::string json, svg, html;
  std::string from = "30,25";  // the drawing's azimuth and elevation

  bool wanted() const { return !json.empty() || !svg.empty() || !html.empty(); }
  std::pair<double, double> angles() const {
    double azimuth = 0, elevation = 0;
    int end = 0;
    if (std::sscanf(from.c_str(), "%lf,%lf%n", &azimuth, &elevation, &end) != 2 ||
        from[static_cast<std::size_t>(end)] || !(std::fabs(azimuth) <= 360 && std::fabs(elevation) <= 90))
      throw OptionError(fmt::format("--from {}: expected AZIMUTH,ELEVATION in degrees, as in 30,25", from));
    return {azimuth, elevation};
  }
};

// The whole picture, made smaller where it is large.
std::string small_picture(const scene::Scene& scene, const Options& options, render::Options render) {
  constexpr int kMax = 480;
  const int shrink = (std::max(options.width, options.height) + kMax - 1) / kMax;
  render.width = std::max(1, options.width / shrink), render.height = std::max(1, options.height / shrink);
  render.first_column = render.first_row = 0, render.last_column = render.last_row = -1;
  render::Framebuffer frame;
  render::render(scene, render, frame);
  return compare::png_bytes(stored_picture(frame, scene, options));
}

void write_story(const StoryFiles& files, PixelStory story, const scene::Scene& scene, const Options& options,
                 const render::Options& render) {
  if (!files.json.empty()) compare::write_report(compare::json_text(story.json, 1) + "\n", files.json);
  if (files.svg.empty() && files.html.empty()) return;
  SideView side(scene, options, render);
  if (!files.svg.empty()) {
    DrawingStyle style{640, 480, {}, true};
    const auto [azimuth, elevation] = files.angles();
    const nlohmann::json& rays = story.json["rays"];
    const Viewpoint view = viewpoint_of(points_of(rays), azimuth, elevation, style.width, style.height);
    style.picture = data_address(side.png(view, style.width, style.height));
    compare::write_report(ray_svg(rays, view, style), files.svg);
  }
  if (!files.html.empty()) {
    story.picture = small_picture(scene, options, render);
    compare::write_report(ray_page(story, side), files.html);
  }
}

// What the options say.
struct ExplainOptions {
  Options options;
  SceneExplanation whole;
  bool no_oracle = false;
  std::string tags;
  StoryFiles story_files;
  int step = 1;
  std::vector<std::string> trees;
};

void declare_options(OwnOptions& own, ExplainOptions& o) {
  own.synopsis("SCENE [X Y] [options] [switches]")
      .summary("how one pixel came to be")
      .example("verisim explain scene.pov 320 200 +W640 +H480", "the rays behind the pixel in column 320, row 200")
      .example("verisim explain scene.pov 320 200 --html pixel.html", "the same as a page, with the rays drawn")
      .example("verisim explain scene.pov", "what the pixels have in common that differ from POV-Ray's")
      .example("verisim explain --reduce scene.pov", "the smallest scene that still shows the difference")
      .section("Options");
  own.flag("--no-oracle", o.no_oracle, "do not ask POV-Ray for its colour");
  own.value("--html FILE", o.story_files.html,
            "write the rays as a page, too: drawn from all sides, and the sum that makes the colour");
  own.value("--svg FILE", o.story_files.svg, "write a drawing of the rays, too");
  own.value("--from AZIMUTH,ELEVATION", o.story_files.from,
            "the way --svg looks, in degrees; 0,0: along +z; 90,0: along +x; 0,90: down");
  own.value("--json FILE", o.story_files.json, "write the tree as JSON, too (docs/view.md)");
  own.value("--tags FILE", o.tags, "write what every pixel shows (objects, patterns, lights, features) as JSON");
  own.value("--tags-step N", o.step, "only every so many pixels and rows, for --tags");
  own.values("--tree X,Y", o.trees, "put the ray tree of this pixel into the file of --tags, too (may be given again)");
  own.section("Of a scene without a pixel");
  own.flag("--reduce", o.whole.reduce,
           "make the scene as small as it can be while it still shows the difference, then look for suspects in that");
  own.value("--reduce-to FILE", o.whole.reduce_to,
            "where the reduced scene goes; default: SCENE.reduced.pov beside the scene, whose files it may need");
  own.value("--seconds X", o.whole.seconds,
            "time for all of --reduce, 60 if not told otherwise: the best so far counts");
  own.value("--oracle PROGRAM", o.whole.oracle, "a POV-Ray, or another verisim; default: povray in PATH");
  own.value("--native PROGRAM", o.whole.native, "another verisim to be judged; default: this one");
  add_pixel_options(own, o.options);
  refuse_render_options(own);
  own.switches({Topic::scene, Topic::size, Topic::speed, Topic::animation, Topic::messages});
}

// What POV-Ray says of the pixel.
std::string asked_oracle(const SceneSource& scene, const Options& options, const std::vector<std::string>& words, int x,
                         int y, std::vector<fs::path> files_read) {
  std::vector<std::string> switches;
  for (const std::string& word : words)
    if (is_setting_word(word)) switches.push_back(word);
  std::optional<SpooledScene> spooled;
  if (scene.text) {  // POV-Ray needs a file, and the folder that the text's includes are in
    files_read.push_back(spooled.emplace(scene).path());
    switches.push_back("+L" + fs::current_path().string());
  }
  return oracle_pixel(spooled ? spooled->path() : scene.path, options, switches, x, y, files_read);
}

// POV-Ray is not let run.
void confine(ExplainOptions& o, const SceneSource& scene) {
  o.no_oracle = true;
  Policy policy = policy_of(o.options, {scene});
  confine_scene(o.options, policy);
  for (const std::string& file : {o.story_files.json, o.story_files.html, o.story_files.svg, o.tags})
    if (!file.empty() && file != "-") grant_output(policy, file);
  enter_sandbox(policy);
}

PixelStory story_of(const RayTree& tree, const SceneSource& scene, const Options& options, const scene::Scene& parsed,
                    const Color& color, double x, double y) {
  PixelStory story;
  story.json = tree.json();
  story.json["scene"] = scene.path.string(), story.json["x"] = x, story.json["y"] = y,
  story.json["text"] = tree.lines();
  story.json["linear"] = {color.r, color.g, color.b}, story.json["stored"] = stored(color, parsed, options);
  story.title = fmt::format("{}, pixel {:.6g}, {:.6g}", scene.path.filename().string(), x, y);
  story.width = options.width, story.height = options.height, story.x = x, story.y = y;
  return story;
}

}  // namespace

int command_explain(const std::vector<std::string>& arguments) {
  ExplainOptions o;
  OwnOptions own("explain",
                 "Shows how one pixel came to be, as a tree of rays: hits, textures, lights. X and Y count from 0 at "
                 "the top left, whole numbers are centres of pixels; without anti-aliasing. Without a pixel it "
                 "compares the scene with POV-Ray and says "
                 "what the wrong pixels have in common.");
  declare_options(own, o);
  const std::vector<std::string> words = own.parse(arguments), files = apply_words(o.options, words);
  if (files.size() == 1 && o.tags.empty()) {
    if (wants_sandbox()) throw OptionError("--sandbox does not let POV-Ray run: give a pixel, too");
    o.whole.replay = o.options.replay;
    return explain_scene(words, o.whole);
  }
  if (o.whole.reduce) throw OptionError("--reduce takes a scene without a pixel: verisim explain --reduce SCENE");
  if (files.size() != (o.tags.empty() ? 3 : 1))
    throw OptionError("a scene and a pixel are needed: verisim explain SCENE X Y [switches]");
  if (o.step < 1) throw OptionError("--tags-step must be at least 1");
  if (o.options.replay && o.tags.empty())
    throw OptionError(
        "--replay: a pixel's random numbers hang on all pixels before it; `verisim explain SCENE --replay` compares "
        "the whole picture");
  o.options.input_file = files[0];
  o.options.antialias = false;
  validate(o.options);
  o.story_files.angles();  // before the work
  const double x = o.tags.empty() ? coordinate(files[1], o.options.width, "X") : 0,
               y = o.tags.empty() ? coordinate(files[2], o.options.height, "Y") : 0;
  if (x != std::floor(x) || y != std::floor(y)) o.no_oracle = true;  // POV-Ray tells the colours of centres only
  const SceneSource scene = open_scene(o.options);
  if (!scene.found()) throw std::runtime_error(fmt::format("cannot find the scene '{}'", o.options.input_file));
  if (wants_sandbox()) confine(o, scene);

  Console console(o.options, Style::verisim);
  Interrupt interrupt(watch(o.options, console));
  const Job job{o.options, console, interrupt, scene, animation(o.options)};
  parser::Origins origins;
  parser::ParseOptions parse = parse_options(job, job.animation.frame(0));
  parse.origins = &origins;
  const parser::ParseResult parsed = parse_scene(job, parse);
  console.end_of_debug();
  if (!parsed.scene) {
    for (const parser::Diagnostic& error : parsed.errors)
      if (error.severity == parser::Severity::unsupported) return kUnsupported;
    return kSceneErrors;
  }
  RayTree tree(&origins);
  Color color;
  const render::Options render = render_options(job, {0, o.options.width - 1, 0, o.options.height - 1});
  try {
    render::Explainer explainer(*parsed.scene, render);
    if (!o.tags.empty()) {
      write_tags(o.tags, o.step, o.trees, explainer, *parsed.scene, origins, o.options);
      return kOk;
    }
    color = explainer.pixel(x, y, tree);
  } catch (const render::Unsupported& missing) {
    std::fprintf(stderr, "verisim explain: %s\n", missing.what());
    return kUnsupported;
  }
  std::printf("%s, pixel (%.6g, %.6g) of %d by %d\n%s", scene.path.string().c_str(), x, y, o.options.width,
              o.options.height, tree.lines().c_str());
  std::printf("linear %s, in a file of 8 bits %s\n", text(color.rgb()).c_str(),
              fmt::format("{}", fmt::join(stored(color, *parsed.scene, o.options), " ")).c_str());
  PixelStory story = story_of(tree, scene, o.options, *parsed.scene, color, x, y);
  if (!o.no_oracle) {
    const std::string told =
        asked_oracle(scene, o.options, words, static_cast<int>(x), static_cast<int>(y), parsed.files_read);
    std::printf("%s\n", told.c_str());
    story.json["oracle"] = told;
  }
  if (o.story_files.wanted()) write_story(o.story_files, std::move(story), *parsed.scene, o.options, render);
  return kOk;
}

}  // namespace verisim::cli
