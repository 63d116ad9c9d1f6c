// Probes P8 (image maps), P12 and P16 (density files) of spec 05 section 15.
#include <gtest/gtest.h>

#include "tracer/textures/lookup/image_lookup.h"
#include "tracer/textures/patterns/density_file.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {
namespace {

using namespace scene;

ImagePtr probe_image() {
  auto image = std::make_shared<Image>();
  image->width = 4;
  image->height = 2;
  const int values[8][3] = {{255, 0, 0},   {0, 255, 0},   {0, 0, 255},    {255, 255, 0},
                            {0, 255, 255}, {255, 0, 255}, {64, 128, 192}, {32, 16, 8}};
  image->channels = 3;
  std::vector<float> samples;
  for (const auto& v : values) {
    for (const int component : v) samples.push_back(static_cast<float>(component) / 255.0f);
  }
  image->samples = image::Samples(std::move(samples));
  return image;
}

const Vec3 kPoints[4] = {{0.1, 0.1, 0.2}, {0.3, 0.8, 0.5}, {1.6, -0.4, 0.1}, {-0.3, 0.3, -0.6}};

TEST(ImageMap, EqualsPovRay) {
  struct Probe {
    const char* option;
    void (*set)(ImageParams&);
    Color value[4];
  };
  const Probe probes[] = {
      {"(none)",
       [](ImageParams& p) { (void)p; },
       {{0.000000f, 1.000000f, 1.000000f, 0, 0},
        {0.000000f, 1.000000f, 0.000000f, 0, 0},
        {0.000000f, 0.000000f, 1.000000f, 0, 0},
        {0.250980f, 0.501961f, 0.752941f, 0, 0}}},
      {"interpolate 2",
       [](ImageParams& p) {
         p.interpolate = 2;
         (void)p;
       },
       {{0.308784f, 0.664392f, 0.632196f, 0, 0},
        {0.340000f, 0.660000f, 0.100000f, 0, 0},
        {0.097765f, 0.205529f, 0.863294f, 0, 0},
        {0.222000f, 0.363176f, 0.552824f, 0, 0}}},
      {"interpolate 3",
       [](ImageParams& p) {
         p.interpolate = 3;
         (void)p;
       },
       {{0.199822f, 0.773223f, 0.731880f, 0, 0},
        {0.272983f, 0.769066f, -0.042079f, 0, 0},
        {0.031356f, 0.126307f, 0.937939f, 0, 0},
        {0.170038f, 0.390973f, 0.526433f, 0, 0}}},
      {"interpolate 4",
       [](ImageParams& p) {
         p.interpolate = 4;
         (void)p;
       },
       {{0.209553f, 0.780885f, 0.722955f, 0, 0},
        {0.224138f, 0.775862f, 0.135468f, 0, 0},
        {0.091582f, 0.152376f, 0.884352f, 0, 0},
        {0.254318f, 0.426094f, 0.627021f, 0, 0}}},
      {"once",
       [](ImageParams& p) {
         p.once = true;
         (void)p;
       },
       {{0.000000f, 1.000000f, 1.000000f, 0, 0},
        {0.000000f, 1.000000f, 0.000000f, 0, 0},
        {1.000000f, 1.000000f, 1.000000f, 0, 1},
        {1.000000f, 1.000000f, 1.000000f, 0, 1}}},
      {"map_type 1",
       [](ImageParams& p) {
         p.map_type = 1;
         (void)p;
       },
       {{1.000000f, 0.000000f, 0.000000f, 0, 0},
        {1.000000f, 0.000000f, 0.000000f, 0, 0},
        {0.000000f, 1.000000f, 1.000000f, 0, 0},
        {0.000000f, 0.000000f, 1.000000f, 0, 0}}},
      {"map_type 2",
       [](ImageParams& p) {
         p.map_type = 2;
         (void)p;
       },
       {{0.000000f, 1.000000f, 1.000000f, 0, 0},
        {1.000000f, 0.000000f, 0.000000f, 0, 0},
        {1.000000f, 0.000000f, 0.000000f, 0, 0},
        {0.250980f, 0.501961f, 0.752941f, 0, 0}}},
      {"map_type 5",
       [](ImageParams& p) {
         p.map_type = 5;
         (void)p;
       },
       {{1.000000f, 0.000000f, 0.000000f, 0, 0},
        {1.000000f, 0.000000f, 0.000000f, 0, 0},
        {0.000000f, 1.000000f, 1.000000f, 0, 0},
        {0.000000f, 0.000000f, 1.000000f, 0, 0}}},
      {"repeat <3,2>",
       [](ImageParams& p) {
         p.repeat = {3, 2};
         (void)p;
       },
       {{1.000000f, 0.000000f, 1.000000f, 0, 0},
        {1.000000f, 1.000000f, 0.000000f, 0, 0},
        {0.125490f, 0.062745f, 0.031373f, 0, 0},
        {1.000000f, 0.000000f, 0.000000f, 0, 0}}},
      {"offset <.3,.6>",
       [](ImageParams& p) {
         p.offset = {0.3, 0.6};
         (void)p;
       },
       {{1.000000f, 1.000000f, 0.000000f, 0, 0},
        {0.000000f, 1.000000f, 1.000000f, 0, 0},
        {1.000000f, 0.000000f, 1.000000f, 0, 0},
        {0.000000f, 1.000000f, 0.000000f, 0, 0}}},
  };
  for (const Probe& probe : probes) {
    ImageParams params;
    params.image = probe_image();
    probe.set(params);
    auto description = std::make_shared<Pigment>();
    description->pattern.kind = PatternKind::image_map;
    description->pattern.frequency = 0;
    description->pattern.params = params;
    Compiler compiler{Settings{}};
    const CompiledPigment* pigment = compiler.pigment(description);
    for (int k = 0; k < 4; ++k) {
      Color c;
      const bool has_color = evaluate(*pigment, kPoints[k], nullptr, c);
      EXPECT_EQ(has_color, probe.value[k].t == 0) << probe.option;
      const Color& e = probe.value[k];
      EXPECT_NEAR(c.r, e.r, 1e-6) << probe.option << ", point " << k;
      EXPECT_NEAR(c.g, e.g, 1e-6) << probe.option << ", point " << k;
      EXPECT_NEAR(c.b, e.b, 1e-6) << probe.option << ", point " << k;
      EXPECT_NEAR(c.t, e.t, 1e-6) << probe.option << ", point " << k;
    }
  }
}

TEST(ImagePattern, EqualsPovRay) {
  ImageParams params;
  params.image = probe_image();
  params.interpolate = 2;
  const ImageLookup lookup = compile_image(params);
  const double expected[4] = {0.555106282234, 0.501120030880, 0.248508483171, 0.342866837978};
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(image_pattern(lookup, kPoints[k]), expected[k], 1e-6) << k;
}

TEST(ImagePattern, PixelsTellWhetherLightComesThrough) {
  auto image = std::make_shared<Image>();
  image->width = 2, image->height = 1;
  image->channels = 1, image->has_alpha = true;
  image->palette = {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1, 0, 1)};
  ImageParams params;
  for (const std::uint8_t second : {1, 2}) {
    image->samples = image::Samples(image::SampleType::byte, 2);
    image->samples.as<std::uint8_t>()[0] = 0, image->samples.as<std::uint8_t>()[1] = second;
    params.image = image;
    EXPECT_EQ(compile_image(params).transparent, second == 2);
  }
}

TEST(ImagePattern, AlphaOfAPaletteWithoutAnyIsZero) {
  auto image = std::make_shared<Image>();
  image->width = image->height = 1;
  image->channels = 1;
  image->samples = image::Samples(image::SampleType::byte, 1);
  *image->samples.as<std::uint8_t>() = 0;
  image->palette = {Color(.7f, .5f, .3f)};
  ImageParams params;
  params.image = image;
  params.use_alpha = true;
  EXPECT_EQ(image_pattern(compile_image(params), {.5, .5, 0}), 0);
}

TEST(ImageLookup, SurvivesFarAndInvalidPoints) {
  for (const int map_type : {0, 1, 2, 5})
    for (const int interpolate : {0, 2, 3, 4})
      for (const bool once : {false, true}) {
        ImageParams params;
        params.image = probe_image();
        params.map_type = map_type;
        params.interpolate = interpolate;
        params.once = once;
        const ImageLookup lookup = compile_image(params);
        for (const double x : {0.0, 1.0, -1e17, 1e17, 1e300, std::numeric_limits<double>::quiet_NaN()})
          image_pattern(lookup, {x, 1, x});
      }
}

// Material number m with K textures: m > K wraps, m = K shows the last (spec 05 12.7).
TEST(MaterialMap, ChoosesTextures) {
  auto image = std::make_shared<Image>();
  image->width = 7;
  image->height = 1;
  image->channels = 3;
  std::vector<float> samples;
  for (int m = 0; m < 7; ++m) samples.insert(samples.end(), {static_cast<float>(m) / 255.0f, 0, 0});
  image->samples = image::Samples(std::move(samples));
  auto map = std::make_shared<BlendMap<TexturePtr>>();
  for (int k = 0; k < 3; ++k) {
    auto child = std::make_shared<Texture>();
    auto pigment = std::make_shared<Pigment>();
    pigment->pattern.kind = PatternKind::plain;
    child->layers.push_back({pigment, nullptr, {}});
    map->push_back({0, child});
  }
  auto texture = std::make_shared<Texture>();
  texture->pattern.kind = PatternKind::image_map;
  ImageParams params;
  params.image = image;
  texture->pattern.params = params;
  texture->texture_map = map;
  Compiler compiler{Settings{}};
  const CompiledTexture* compiled = compiler.texture(texture);
  const int expected[7] = {0, 1, 2, 2, 1, 2, 0};
  for (int m = 0; m < 7; ++m) {
    WeightedTexture storage[3];
    Vec3 warped;
    const auto chosen = select(*compiled, {(m + 0.5) / 7, 0.5, 0}, nullptr, storage, warped);
    ASSERT_EQ(chosen.size(), 1u);
    EXPECT_EQ(chosen[0].texture, compiled->map[expected[m]].value) << "material " << m;
  }
}

TEST(DensityFile, EqualsPovRay) {
  DensityFileParams d;
  d.samples = std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{0, 65535, 32768});
  d.size[0] = 3, d.size[1] = 1, d.size[2] = 1;
  d.bytes = 2;
  const double x[6] = {0.1, 0.25, 0.4, 0.55, 0.7, 0.9};
  const double expected[3][6] = {{0, 0, 1, 1, 0.50000763, 0.50000763},
                                 {0.3, 0.75, 0.900001526, 0.675004959, 0.450006867, 0.150002289},
                                 {0.273749769, 0.832030714, 0.996001303, 0.734724522, 0.443257451, 0.0397522449}};
  for (int mode = 0; mode < 3; ++mode)
    for (int k = 0; k < 6; ++k) {
      d.interpolate = mode;
      EXPECT_NEAR(density_file(d, {x[k], 0.5, 0.5}), expected[mode][k], mode == 2 ? 3e-7 : 1e-8)
          << "interpolate " << mode << " at " << x[k];
    }
  EXPECT_EQ(density_file(d, {1, 0.5, 0.5}), 0);
  EXPECT_EQ(density_file(d, {-1e-9, 0.5, 0.5}), 0);
  EXPECT_EQ(density_file(d, {std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5}), 0);
}

}  // namespace
}  // namespace verisim::textures
