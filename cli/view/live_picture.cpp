#include "cli/view/live_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "cli/console/seconds.h"
#include "cli/describe/diagnostics_json.h"
#include "cli/rays/ray_tree.h"
#include "cli/describe/stored_pixel.h"
#include "cli/rays/ray_drawing.h"
#include "compare/json_text.h"
#include "tracer/base/whole_file.h"
#include "tracer/render/explain.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

constexpr int kCoarse = 8, kMiddle = 3;  // pixels from one sample to the next
constexpr int kBlock = 32;

// An error that is not about a place in the scene.
nlohmann::json plain_error(const std::string& message) {
  parser::Diagnostic d;
  d.message = message;
  return as_json(d);
}

}  // namespace

LivePicture::LivePicture(const Options& options, fs::path scene, Interrupt& interrupt)
    : options_(options),
      scene_(std::move(scene)),
      interrupt_(interrupt),
      console_(options_, Style::verisim),
      animation_(animation(options_)),
      watch_([this] { files_changed(); }) {
  wish_.clock = animation_.frame(0).clock;
  watch_.watch({scene_});
  thread_ = std::thread([this] { run(); });
}

LivePicture::~LivePicture() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = again_ = true, cancel_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void LivePicture::ask(const Wish& wish) {
  const std::lock_guard lock(mutex_);
  files_ = files_ || wish.clock != wish_.clock || wish.values != wish_.values;
  wish_ = wish, again_ = true, cancel_ = true;
  changed_.notify_all();
}

Wish LivePicture::wish() const {
  const std::lock_guard lock(mutex_);
  return wish_;
}

void LivePicture::files_changed() {
  const std::lock_guard lock(mutex_);
  files_ = again_ = true, cancel_ = true;
  changed_.notify_all();
}

void LivePicture::tell(const std::string& status) {
  const std::lock_guard lock(mutex_);
  status_ = status, ++state_;
  seconds_ = seconds_since(began_);
  changed_.notify_all();
}

void LivePicture::run() {
  while (true) {
    Wish wish;
    bool files = false;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return again_; });
      if (stop_) return;
      again_ = false, cancel_ = false;
      files = std::exchange(files_, false);
      wish = wish_;
      began_ = Clock::now();
    }
    try {
      if (files && !parse(wish)) continue;
      if (parsed_) render(wish);
    } catch (const render::Unsupported& missing) {
      parser::Diagnostic d;
      d.severity = parser::Severity::unsupported;
      if (missing.place.file) d.file = *missing.place.file;
      d.line = missing.place.line, d.column = missing.place.column, d.message = missing.what();
      const std::lock_guard lock(mutex_);
      messages_ = {as_json(d)}, broken_ = true;
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      messages_ = {plain_error(error.what())}, broken_ = true;
    }
    bool broken = false;
    {
      const std::lock_guard lock(mutex_);
      broken = broken_;
    }
    if (broken) tell("error");
  }
}

// False: there is nothing to render, and watchers are told why (or another wish came).
bool LivePicture::parse(const Wish& wish) {
  tell("reading");
  nlohmann::json messages = nlohmann::json::array();
  auto parsed = std::make_shared<Parsed>();
  std::string text;
  try {
    text = required_file(scene_);
    const Job job{options_, console_, interrupt_, {scene_, {}}, animation_};
    parser::ParseOptions parse = parse_options(job, {animation_.frame(0).number, wish.clock});
    parse.clock_on = true;
    parse.origins = &parsed->origins;
    parse.message = [&](const parser::Diagnostic& d) {
      constexpr std::size_t kMax = 50;
      if (messages.size() < kMax) messages.push_back(as_json(d));
    };
    parse.cancelled = [this] { return cancel_.load() || interrupt_.flag().load(); };
    parsed->result = parser::parse_text(turned(text, knobs_of(text), wish.values), scene_.string(), parse);
    console_.end_of_debug();
  } catch (const std::exception& error) {
    messages.push_back(plain_error(error.what()));
  }
  std::vector<fs::path> files = parsed->result.files_read;
  files.push_back(scene_);
  for (const parser::Diagnostic& d : parsed->result.errors)  // a mistake may lie before what is read later
    if (!d.file.empty()) files.emplace_back(d.file);
  const bool good = parsed->result.scene.has_value();
  if (good || !parsed_) watch_.watch(files);
  if (cancel_) return false;
  std::vector<float> steps;
  if (good) steps = stored_steps(*parsed->result.scene, options_);
  {
    const std::lock_guard lock(mutex_);
    messages_ = std::move(messages), broken_ = !good, knobs_ = knobs_of(text);
    if (good) parsed_ = std::move(parsed);
    scene_state_ = {{"knobs", nlohmann::json::array()},
                    {"clock", text.find("clock") != std::string::npos},
                    {"first", animation_.on ? animation_.initial_clock : 0.0},
                    {"last", animation_.on ? animation_.final_clock : 1.0},
                    {"frames", animation_.on ? animation_.count() : 0}};
    for (const Knob& knob : knobs_) {
      const auto value = wish.values.find(knob.name);
      scene_state_["knobs"].push_back({{"name", knob.name},
                                       {"value", value == wish.values.end() ? knob.value : value->second},
                                       {"low", knob.low},
                                       {"high", knob.high},
                                       {"step", knob.step}});
    }
    if (good) {
      const scene::Settings& settings = parsed_->result.scene->settings;
      scene_state_["steps"] = steps;
      scene_state_["gamma"] = settings.gamma == scene::Gamma::power ? settings.assumed_gamma : 1.0;
      scene_state_["srgb"] = settings.gamma == scene::Gamma::srgb;
    }
  }
  if (!good) tell("error");
  return good;
}

// What is rendered for a wish, one sample for `cell` by `cell` pixels.
LivePicture::Part LivePicture::part(const Wish& wish, int cell) const {
  const Job job{options_, const_cast<Console&>(console_), interrupt_, {scene_, {}}, animation_};
  Part part{render_options(job, {0, -1, 0, -1}), {}};
  part.options.width = (options_.width + cell - 1) / cell, part.options.height = (options_.height + cell - 1) / cell;
  part.options.block_size = kBlock;
  part.options.cancel = const_cast<std::atomic<bool>*>(&cancel_);
  const auto scaled = [&](double size) { return std::max(1, static_cast<int>(std::lround(size / cell))); };
  part.window.width = scaled(std::floor(options_.width * wish.zoom));
  part.window.height = scaled(std::floor(options_.height * wish.zoom));
  part.window.left = wish.left / cell, part.window.top = wish.top / cell;
  part.window.focus_column = (wish.focus_x < 0 ? options_.width / 2 : wish.focus_x) / cell;
  part.window.focus_row = (wish.focus_y < 0 ? options_.height / 2 : wish.focus_y) / cell;
  return part;
}

void LivePicture::publish(const render::Framebuffer& frame, int x, int y, int width, int height, int cell) {
  Tile tile{x * cell, y * cell, width, height, cell, {}};
  tile.colors.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (int row = y; row < y + height; ++row)
    for (int column = x; column < x + width; ++column) {
      const render::PixelColor& c = frame.at(column, row);
      tile.colors.insert(tile.colors.end(), {c.r, c.g, c.b, c.t});
    }
  const std::lock_guard lock(mutex_);
  if (tiles_.empty()) first_seconds_ = seconds_since(began_);
  tiles_.push_back(std::move(tile));
  changed_.notify_all();
}

render::Framebuffer LivePicture::render_pass(Parsed& parsed, const Wish& wish, int cell, bool antialias,
                                             render::Layers* layers) {
  auto [options, window] = part(wish, cell);
  options.antialias = antialias, options.layers = layers;
  render::Framebuffer frame;
  if (cell == kCoarse) {  // in one piece: many small ones would only be seen to flicker
    parsed.prepared->render(options, frame, window);
    if (!cancel_) publish(frame, 0, 0, options.width, options.height, cell);
    return frame;
  }
  options.block_done = [&, cell](int x, int y, int w, int h) { publish(frame, x, y, w, h, cell); };
  parsed.prepared->render(options, frame, window);
  return frame;
}

void LivePicture::render(const Wish& wish) {
  Parsed& parsed = *parsed_;
  {
    const std::lock_guard lock(mutex_);
    ++generation_, ++state_;
    tiles_.clear(), shown_ = wish, layers_ready_ = false, layers_ = {}, status_ = "rendering";
    finished_ = {};
  }
  const scene::Settings& settings = parsed.result.scene->settings;
  bool coarse_first = true;
  if (!parsed.prepared || parsed.prepared->spoilt()) {
    if (settings.radiosity.enabled || settings.photons.enabled) {
      coarse_first = false;  // or the passes before the picture would be made for the coarse one
      // The first picture does not wait for the passes before the picture.
      render::Options options = part(wish, 1).options;
      options.quality = std::min(options.quality, 8);
      parsed.prepared = std::make_unique<render::PreparedScene>(*parsed.result.scene, options);
      render_pass(parsed, wish, kCoarse, false, nullptr);
    }
    if (cancel_) return parsed.prepared.reset();
    parsed.prepared = std::make_unique<render::PreparedScene>(*parsed.result.scene, part(wish, 1).options);
  }
  if (wish.quick) {
    render_pass(parsed, wish, kMiddle, false, nullptr);
    if (!cancel_) tell("done");
    return;
  }
  render::Layers layers;
  layers.depth = layers.normal = layers.albedo = layers.id = true;
  const bool antialias = options_.antialias && options_.sampling_method != 0;
  for (const int cell : {kCoarse, kMiddle}) {
    if (!coarse_first) break;
    render_pass(parsed, wish, cell, false, nullptr);
    if (cancel_) return;
  }
  render::Framebuffer frame = render_pass(parsed, wish, 1, false, antialias ? nullptr : &layers);
  if (antialias && !cancel_) frame = render_pass(parsed, wish, 1, true, &layers);
  if (cancel_) return;
  compare::Picture finished = cli::stored_picture(frame, *parsed.result.scene, options_);
  {
    const std::lock_guard lock(mutex_);
    layers_ = std::move(layers), layers_ready_ = true, finished_ = std::move(finished);
  }
  tell("done");
}

std::string LivePicture::update(std::uint64_t generation, std::size_t pieces, std::uint64_t state, double seconds) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds), [&] {
    return stop_ || state != state_ || (generation == generation_ ? tiles_.size() > pieces : !tiles_.empty());
  });
  if (generation != generation_) pieces = 0;
  // Until there is something of the new picture the old one stays.
  const bool newer = generation == generation_ || !tiles_.empty();
  nlohmann::json head{{"generation", newer ? generation_ : generation},
                      {"pieces", newer ? tiles_.size() : pieces},
                      {"state", state_},
                      {"status", status_},
                      {"scene", scene_.filename().string()},
                      {"width", options_.width},
                      {"height", options_.height},
                      {"messages", messages_},
                      {"broken", broken_},
                      {"about", scene_state_},
                      {"zoom", shown_.zoom},
                      {"left", shown_.left},
                      {"top", shown_.top},
                      {"clock", shown_.clock},
                      {"quick", shown_.quick},
                      {"layers", layers_ready_},
                      {"seconds", seconds_},
                      {"first_seconds", first_seconds_},
                      {"tiles", nlohmann::json::array()}};
  std::size_t floats = 0;
  for (std::size_t i = std::min(pieces, tiles_.size()); i < tiles_.size(); ++i) {
    const Tile& t = tiles_[i];
    head["tiles"].push_back({t.x, t.y, t.width, t.height, t.cell});
    floats += t.colors.size();
  }
  std::string json = compare::json_text(head);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto size = static_cast<std::uint32_t>(json.size());
  std::string out(reinterpret_cast<const char*>(&size), sizeof size);
  out.reserve(sizeof size + json.size() + floats * sizeof(float));
  out += json;
  for (std::size_t i = std::min(pieces, tiles_.size()); i < tiles_.size(); ++i)
    out.append(reinterpret_cast<const char*>(tiles_[i].colors.data()), tiles_[i].colors.size() * sizeof(float));
  return out;
}

std::string LivePicture::layers(std::uint64_t generation) const {
  const std::lock_guard lock(mutex_);
  if (!layers_ready_ || generation != generation_) return {};
  std::vector<float> values = layers_.depths;
  for (const Vec3& n : layers_.normals)
    for (const double part : {n.x, n.y, n.z}) values.push_back(static_cast<float>(part));
  for (const Rgb& a : layers_.albedos) values.insert(values.end(), {a.r, a.g, a.b});
  for (const std::uint32_t id : layers_.ids) values.push_back(static_cast<float>(id));
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

compare::Picture LivePicture::stored_picture() const {
  const std::lock_guard lock(mutex_);
  if (finished_.samples.empty()) throw std::runtime_error("the picture is not finished");
  return finished_;
}

std::vector<fs::path> LivePicture::files_read() const { return parsed()->result.files_read; }

std::shared_ptr<LivePicture::Parsed> LivePicture::parsed(Wish* shown) const {
  const std::lock_guard lock(mutex_);
  if (!parsed_) throw std::runtime_error("there is no picture yet");
  if (shown) *shown = shown_;
  return parsed_;
}

nlohmann::json LivePicture::explain(double x, double y) {
  Wish wish;
  const std::shared_ptr<Parsed> parsed = this->parsed(&wish);
  if (!(x >= -0.5 && y >= -0.5 && x <= options_.width - 0.5 && y <= options_.height - 0.5))
    throw std::runtime_error("the place is outside of the picture");
  const std::lock_guard lock(parsed->asked);
  auto [options, window] = part(wish, 1);
  options.cancel = &interrupt_.flag();
  if (!parsed->explained) {
    auto prepared = std::make_unique<render::PreparedScene>(*parsed->result.scene, options);
    parsed->explained = std::move(prepared);
  }
  RayTree tree(&parsed->origins);
  render::Explainer explainer(*parsed->explained, options, window);
  const Color color = explainer.pixel(x, y, tree);
  nlohmann::json result = tree.json();
  result["text"] = tree.lines();
  result["linear"] = {color.r, color.g, color.b};
  result["stored"] = stored(color, *parsed->result.scene, options_);
  result["x"] = x + wish.left, result["y"] = y + wish.top;
  parsed->rays = result["rays"];
  return result;
}

std::string LivePicture::drawing(const DrawnFrom& from, const std::string& behind) {
  const std::shared_ptr<Parsed> parsed = this->parsed();
  const std::lock_guard lock(parsed->asked);
  if (parsed->rays.is_null()) throw std::runtime_error("no ray is followed");
  const Viewpoint view = viewpoint_of(points_of(parsed->rays), from.azimuth, from.elevation, from.width, from.height);
  return ray_svg(parsed->rays, view, {from.width, from.height, behind, false});
}

std::string LivePicture::overlay() {
  Wish wish;
  const std::shared_ptr<Parsed> parsed = this->parsed(&wish);
  const std::lock_guard lock(parsed->asked);
  const scene::Camera& camera = parsed->result.scene->camera;
  const bool flat = camera.kind == scene::CameraKind::orthographic;
  if (parsed->rays.is_null() || (!flat && camera.kind != scene::CameraKind::perspective)) return {};
  // A point is location + depth direction + x right + y up; of a perspective camera x and y are depth times those of
  // the pixel.
  const Vec3 normal = cross(camera.right, camera.up);
  const double volume = dot(normal, camera.direction);
  if (volume == 0) return {};
  const auto project = [&](const Vec3& p) {
    const Vec3 d = p - camera.location;
    Seen seen;
    seen.depth = dot(normal, d) / volume;
    const double scale = flat ? 1 : std::max(seen.depth, 1e-9);
    const double x = dot(cross(camera.up, camera.direction), d) / volume / scale;
    const double y = dot(cross(camera.direction, camera.right), d) / volume / scale;
    seen.at = {(0.5 + x) * options_.width * wish.zoom - wish.left, (0.5 - y) * options_.height * wish.zoom - wish.top};
    if (flat) seen.depth = std::max(seen.depth, 1.0);  // what is behind its plane may be on the way of a light
    return seen;
  };
  return overlay_svg(parsed->rays, project, options_.width, options_.height);
}

std::string LivePicture::behind(const DrawnFrom& from) {
  Wish wish;
  const std::shared_ptr<Parsed> parsed = this->parsed(&wish);
  const std::lock_guard lock(parsed->asked);
  if (parsed->rays.is_null()) throw std::runtime_error("no ray is followed");
  if (!parsed->side) {
    render::Options options = part(wish, 1).options;
    options.cancel = &interrupt_.flag();
    parsed->side = std::make_unique<SideView>(*parsed->result.scene, options_, options);
  }
  const Viewpoint view = viewpoint_of(points_of(parsed->rays), from.azimuth, from.elevation, from.width, from.height);
  return parsed->side->png(view, from.width, from.height);
}

}  // namespace verisim::cli
