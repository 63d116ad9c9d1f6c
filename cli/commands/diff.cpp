// `verisim diff`: how far one picture is from another.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/commands/layer_limits.h"
#include "cli/settings/reading/own_options.h"
#include "compare/compare.h"
#include "compare/regression/folders.h"
#include "compare/report/corner_page.h"

namespace verisim::cli {
namespace {

compare::FitOptions fit_options(const std::string& crop, const std::string& corners,
                                const std::vector<std::string>& fits) {
  compare::FitOptions out;
  if (!crop.empty()) {
    compare::Crop c;
    int end = 0;
    if (std::sscanf(crop.c_str(), "%d,%d,%d,%d%n", &c.x, &c.y, &c.width, &c.height, &end) != 4 ||
        static_cast<std::size_t>(end) != crop.size())
      throw OptionError(fmt::format("--crop {}: expected X,Y,WIDTH,HEIGHT", crop));
    out.crop = c;
  }
  if (!corners.empty()) {
    compare::Corners c;
    int end = 0;
    if (std::sscanf(corners.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf%n", &c[0].x, &c[0].y, &c[1].x, &c[1].y, &c[2].x,
                    &c[2].y, &c[3].x, &c[3].y, &end) != 8 ||
        static_cast<std::size_t>(end) != corners.size())
      throw OptionError(
          fmt::format("--corners {}: expected eight numbers: x and y of the upper left, upper right, lower right and "
                      "lower left corner",
                      corners));
    out.corners = c;
  }
  for (const std::string& what : fits) {
    if (what == "exposure")
      out.exposure = true;
    else if (what == "white_balance")
      out.white_balance = true;
    else if (what == "distortion")
      out.distortion = true;
    else if (what == "vignetting")
      out.vignetting = true;
    else
      throw OptionError(fmt::format("--fit {}: expected exposure, white_balance, distortion or vignetting", what));
  }
  return out;
}

compare::Thresholds threshold_options(const std::vector<std::string>& thresholds) {
  compare::Thresholds limits;
  for (const std::string& text : thresholds) {
    const std::size_t equals = text.find('=');
    char* end = nullptr;
    const double limit = equals == std::string::npos ? 0 : std::strtod(text.c_str() + equals + 1, &end);
    if (!end || *end || end == text.c_str() + equals + 1)
      throw OptionError(fmt::format("--threshold {}: expected NAME=NUMBER", text));
    limits[text.substr(0, equals)] = limit;
  }
  return limits;
}

// A line on the terminal when it takes longer than a moment.
class Progress {
 public:
  void show(double done) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (!terminal_ || elapsed < 2 || elapsed < shown_ + 0.2) return;
    shown_ = elapsed;
    std::fprintf(stderr, "\r%.0f %%, about %.0f s left\x1b[K", 100 * done, elapsed / done - elapsed);
  }
  void end() {
    if (shown_ > 0) std::fputs("\r\x1b[K", stderr);
    shown_ = 0;
  }
  ~Progress() { end(); }

 private:
  const bool terminal_ = isatty(STDERR_FILENO) != 0;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double shown_ = 0;
};

int diff_folders(const std::string& reference, const std::string& test, const compare::FolderOptions& options,
                 const std::string& json, const std::string& html, bool color) {
  compare::Run run;
  try {
    run = compare::run_of_folders(reference, test, options);
  } catch (const std::invalid_argument& error) {
    throw OptionError(error.what());
  }
  std::FILE* const people = json == "-" || html == "-" ? stderr : stdout;
  std::fputs(
      compare::terminal_table(run, color || isatty(fileno(people)) != 0, isatty(fileno(people)) ? 120 : 0).c_str(),
      people);
  if (!json.empty()) compare::write_report(compare::json_report(run), json);
  if (!html.empty()) compare::write_report(compare::html_report(run), html);
  return run.summary.failed() ? kDifferent : kOk;
}

// What the options say.
struct DiffOptions {
  std::string json, html, heat_map;
  std::vector<std::string> thresholds, fits, targets, layer_limits;
  std::string crop, corners, pick;
  compare::MetricOptions metric;
  double gain = 16;
  bool color = false, antialiased = false;
};

void declare_options(OwnOptions& own, DiffOptions& o) {
  own.synopsis("REFERENCE PICTURE [options]")
      .summary("how much two pictures differ")
      .example("verisim diff povray.png verisim.png --heat-map difference.png",
               "figures, and where the differences are")
      .section("Reports");
  own.value("--json FILE", o.json, "write the figures as JSON (- for standard output)");
  own.value("--html FILE", o.html, "write a page with both pictures and their difference");
  own.value("--heat-map FILE", o.heat_map, "write the difference as a picture (PNG)");
  own.value("--gain X", o.gain, "factor for the differences of the heat map (16)");
  own.flag("--color", o.color, "colour the table also when it does not go to a terminal");
  own.section("What counts as the same");
  own.values("--threshold LIMIT", o.thresholds,
             "in place of the usual rules: max_rmse=1.5, min_within_1_pct=99 ... (may be given again)");
  own.values("--layer LAYER:LIMITS", o.layer_limits, compare::kLayerHelp);
  own.flag("--antialiased", o.antialiased,
           "the pictures are anti-aliased: differences of 2/255 are allowed where 1/255 would be");
  own.value("--pixels-per-degree X", o.metric.flip_pixels_per_degree, "how large the pictures are seen, for FLIP");
  own.section("Photographs");
  own.value("--crop X,Y,WIDTH,HEIGHT", o.crop,
            "the part of the reference, a photograph, that the picture shows; averaged to its size");
  own.value("--corners X,Y,X,Y,X,Y,X,Y", o.corners,
            "where the picture's corners are in the reference, a photograph, from the upper left one clockwise; a few "
            "pixels off is near enough: they are refined");
  own.value("--pick FILE", o.pick,
            "compare nothing: write a page in which the four corners are picked by the mouse, and which says what to "
            "type");
  own.values("--fit WHAT", o.fits,
             "fit exposure, white_balance, the lens's distortion (with --corners) or vignetting (may be given again)");
  own.values("--target X,Y,WIDTH,HEIGHT=R,G,B", o.targets,
             "a patch of a colour chart in the photograph, in the picture's pixels, and its known sRGB colour: the "
             "photograph's colours are mended by all of them");
}

}  // namespace

int command_diff(const std::vector<std::string>& arguments) {
  OwnOptions own("diff",
                 "Compares two pictures, or all pictures of two folders by their names, pixel by pixel. Exit status 0 "
                 "when they match, 1 when they do not.");
  DiffOptions o;
  declare_options(own, o);
  const std::vector<std::string> words = own.parse(arguments);
  if (words.size() != 2) throw OptionError("two pictures are needed: verisim diff REFERENCE PICTURE");

  if (!o.pick.empty()) {
    compare::write_report(compare::corner_page(words[0], words[1]), o.pick);
    return kOk;
  }
  compare::FitOptions wanted = fit_options(o.crop, o.corners, o.fits);
  try {
    for (const std::string& target : o.targets) wanted.targets.push_back(compare::color_target_of(target));
  } catch (const std::invalid_argument& error) {
    throw OptionError(std::string("--target ") + error.what());
  }
  const compare::Thresholds limits = threshold_options(o.thresholds);
  const std::vector<compare::LayerRule> rules = layer_options(o.layer_limits);
  if (std::filesystem::is_directory(words[0]) && std::filesystem::is_directory(words[1])) {
    if (wanted.any() || !o.heat_map.empty())
      throw OptionError(
          "--crop, --corners, --fit, --target and --heat-map are for one pair of pictures, not for folders");
    return diff_folders(words[0], words[1], {o.metric, limits, rules, o.antialiased}, o.json, o.html, o.color);
  }
  compare::Pair pair{words[0], words[1], {}, {}, {}, {}};
  compare::Layers layers;
  Progress progress;
  o.metric.progress = [&](double done) { progress.show(done); };
  try {
    if (wanted.any()) {
      pair.fitted = compare::fit_to_reference(image::read_picture(words[0]), image::read_picture(words[1]), wanted);
      pair.metrics = compare::measure(pair.fitted->reference, pair.fitted->test, o.metric);
    } else {
      pair.metrics =
          compare::measure_files(words[0], words[1], o.metric);  // row by row, without holding them in memory
      layers = compare::compare_layers(words[0], words[1], rules, o.antialiased);
      pair.layers = layers.all;
    }
  } catch (const compare::PictureMismatch& mismatch) {
    std::fprintf(stderr, "verisim diff: %s\n", mismatch.what());
    return kDifferent;
  }
  progress.end();
  try {
    pair.verdict = limits.empty() ? compare::judge_deterministic(pair.metrics, o.antialiased)
                                  : compare::judge_thresholds(pair.metrics, limits);
    pair.verdict = compare::with_layers(pair.verdict, layers);
  } catch (const std::invalid_argument& error) {
    throw OptionError(error.what());
  }
  const compare::Verdict& verdict = pair.verdict;
  std::FILE* const people = o.json == "-" || o.html == "-" ? stderr : stdout;  // standard output is the report's alone
  std::fputs(compare::terminal_metrics(pair.metrics, o.color || isatty(fileno(people)) != 0).c_str(), people);
  std::fputs(compare::terminal_layers(pair.layers).c_str(), people);
  if (pair.fitted && !pair.fitted->fit.text().empty()) std::fprintf(people, "%s\n", pair.fitted->fit.text().c_str());
  std::fprintf(people, "%s%s%s\n", compare::to_string(verdict.status), verdict.reason.empty() ? "" : ": ",
               verdict.reason.c_str());
  if (!o.json.empty() || !o.html.empty()) {
    const compare::Run run = compare::run_of_pair(pair);
    if (!o.json.empty()) compare::write_report(compare::pair_json(run), o.json);
    if (!o.html.empty()) compare::write_report(compare::html_report(run), o.html);
  }
  if (!o.heat_map.empty()) {
    if (pair.fitted)
      compare::write_heat_map(pair.fitted->reference, pair.fitted->test, o.heat_map, o.gain);
    else
      compare::write_heat_map(pair.reference, pair.test, o.heat_map, o.gain);
  }
  return verdict.status == compare::Status::exact || verdict.status == compare::Status::match ? kOk : kDifferent;
}

}  // namespace verisim::cli
