#include "cli/rays/side_view.h"

#include "cli/describe/stored_pixel.h"
#include "compare/report/display.h"

namespace verisim::cli {
namespace {

// Shows at once where things are: light and surfaces, without shadows, reflections and what takes passes of its own.
constexpr int kQuality = 3;

}  // namespace

SideView::SideView(const scene::Scene& scene, const Options& options, const render::Options& render)
    : scene_(scene), options_(options), render_(render) {
  render_.quality = std::min(render_.quality, kQuality);
  render_.antialias = render_.replay = false;
  render_.path_samples = 0;
  render_.first_column = render_.first_row = 0, render_.last_column = render_.last_row = -1;
  render_.block_done = nullptr, render_.layers = nullptr;
  prepared_ = std::make_unique<render::PreparedScene>(scene_, render_);
}

std::string SideView::png(const Viewpoint& view, int width, int height) {
  scene::Camera camera;
  camera.kind = scene::CameraKind::orthographic;
  camera.location = view.center + view.forward * view.near;
  camera.direction = view.forward;
  camera.right = view.right * view.width, camera.up = view.up * view.height;
  scene_.camera = camera;
  render::Options options = render_;
  options.width = width, options.height = height;
  render::Framebuffer frame;
  prepared_->render(options, frame);
  return compare::png_bytes(stored_picture(frame, scene_, options_));
}

std::string data_address(const std::string& png) { return "data:image/png;base64," + compare::base64(png); }

}  // namespace verisim::cli
