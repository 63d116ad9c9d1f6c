// Builds a scene without SDL, renders it, and looks at two pixels; writes and reads a file by a plug-in, which the
// library finds by itself.
#include <cmath>
#include <cstdio>
#include <memory>

#include <tracer/image/output.h>
#include <tracer/render/render.h>
#include <tracer/scene/scene.h>

int main() {
  using namespace verisim;
  auto sphere = std::make_shared<scene::Object>();
  sphere->shape = scene::Sphere{{0, 0, 3}, 1};
  scene::compute_bounds(*sphere);
  auto pigment = std::make_shared<scene::Pigment>();
  pigment->pattern.kind = scene::PatternKind::plain;
  pigment->color = Color(1, 0.5f, 0.25f);
  auto texture = std::make_shared<scene::Texture>();
  texture->layers.resize(1);
  texture->layers[0].pigment = pigment;
  texture->layers[0].finish.edit().emission = Rgb(1);
  texture->layers[0].finish.edit().ambient = Rgb(0);
  texture->layers[0].finish.edit().diffuse = 0;
  sphere->texture = texture;
  scene::finish_statement(*sphere, texture);

  scene::Scene scene;
  scene.objects.push_back(sphere);
  render::Options options;
  options.width = options.height = 15;
  render::Framebuffer picture;
  render::render(scene, options, picture);
  const Color middle = picture.at(7, 7), corner = picture.at(0, 0);
  std::printf("middle %g %g %g, corner %g %g %g\n", double(middle.r), double(middle.g), double(middle.b),
              double(corner.r), double(corner.g), double(corner.b));
  image::OutputOptions output;
  output.format = image::Format::exr;
  image::write(picture, "consumer.exr", output);
  const image::Picture back = image::read_picture("consumer.exr");
  const float green = back.samples[static_cast<std::size_t>((7 * back.width + 7) * back.channels + 1)];
  std::printf("green in the file: %g\n", double(green));
  return middle.r == 1 && middle.g == 0.5f && corner.r == 0 && std::fabs(green - 0.5f) < 0.01f ? 0 : 1;
}
