// A scene's picture that follows what happens: files that are saved, another part that is looked at, knobs that are
// turned. Coarse at once, then finer; whoever watches gets the pieces as they are made.
#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/frame/frame.h"
#include "cli/rays/side_view.h"
#include "parser/source/origins.h"
#include "cli/view/file_watch.h"
#include "cli/view/live_scene.h"
#include "compare/compare.h"
#include "tracer/film/layers.h"
#include "tracer/render/prepared_scene.h"

namespace verisim::cli {

// What somebody wants to see: a window of options.width by options.height pixels in the picture `zoom` times as large.
struct Wish {
  double zoom = 1;
  int left = 0, top = 0;
  int focus_x = -1, focus_y = -1;  // in the window: where the eye is; below 0: its middle
  double clock = 0;
  bool quick = false;                    // one coarse picture, as a frame of an animation that plays
  std::map<std::string, double> values;  // of knobs
};

// A drawing of rays: the way it looks in degrees (see viewpoint_of), its size in pixels.
struct DrawnFrom {
  double azimuth = 0, elevation = 0;
  int width = 0, height = 0;
};

class LivePicture {
 public:
  // `options` holds absolute paths. Starts at once.
  LivePicture(const Options& options, std::filesystem::path scene, Interrupt& interrupt);
  ~LivePicture();

  void ask(const Wish& wish);
  Wish wish() const;
  void files_changed();

  // The state, and what was made since the caller's picture `generation` had `pieces` pieces: waits until there is
  // something new, at most `seconds`. A little-endian uint32 with the size of the JSON text, that text filled with
  // blanks to a multiple of four, then red, green, blue and transmit of the pixels of its `tiles`, as float32.
  std::string update(std::uint64_t generation, std::size_t pieces, std::uint64_t state, double seconds);
  // Of the finished picture, as float32: all depths, normals, albedos and object numbers. Empty: not finished yet.
  std::string layers(std::uint64_t generation) const;
  // The ray tree of a position in the window. Throws std::runtime_error.
  nlohmann::json explain(double x, double y);
  // The finished picture of the window as a file of 8 bits holds it. Throws std::runtime_error: not finished.
  compare::Picture stored_picture() const;
  std::vector<std::filesystem::path> files_read() const;
  // Of the ray tree that was asked for last: a drawing (SVG) whose picture is at `behind`, and that picture (PNG).
  // Throws std::runtime_error.
  std::string drawing(const DrawnFrom& from, const std::string& behind);
  std::string behind(const DrawnFrom& from);
  // The same rays laid over the picture's window; empty: of cameras that are neither perspective nor orthographic.
  std::string overlay();

 private:
  struct Tile {
    int x, y, width, height, cell;  // in the window; each pixel of it covers cell by cell
    std::vector<float> colors;
  };
  struct Parsed {
    parser::ParseResult result;
    parser::Origins origins;
    std::unique_ptr<render::PreparedScene> prepared;  // of the thread that renders
    std::mutex asked;
    std::unique_ptr<render::PreparedScene> explained;
    nlohmann::json rays;  // that were asked for last
    std::unique_ptr<SideView> side;
  };

  void run();
  bool parse(const Wish& wish);
  void render(const Wish& wish);
  render::Framebuffer render_pass(Parsed& parsed, const Wish& wish, int cell, bool antialias, render::Layers* layers);
  struct Part {
    render::Options options;
    render::Window window;
  };
  Part part(const Wish& wish, int cell) const;
  std::shared_ptr<Parsed> parsed(Wish* shown = nullptr) const;  // throws: there is none yet
  void publish(const render::Framebuffer& frame, int x, int y, int width, int height, int cell);
  void tell(const std::string& status);

  const Options options_;
  const std::filesystem::path scene_;
  Interrupt& interrupt_;
  Console console_;
  Animation animation_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> cancel_{false};
  bool stop_ = false, again_ = true, files_ = true;
  Wish wish_;
  // What watchers are told.
  std::uint64_t generation_ = 0, state_ = 0;
  std::string status_ = "reading";
  nlohmann::json messages_ = nlohmann::json::array(), scene_state_;
  bool broken_ = false;
  std::vector<Tile> tiles_;
  Wish shown_;  // what the tiles are of
  double seconds_ = 0, first_seconds_ = 0;
  std::chrono::steady_clock::time_point began_;
  render::Layers layers_;
  compare::Picture finished_;
  bool layers_ready_ = false;
  std::shared_ptr<Parsed> parsed_;
  std::string text_;
  std::vector<Knob> knobs_;

  FileWatch watch_;
  std::thread thread_;
};

}  // namespace verisim::cli
