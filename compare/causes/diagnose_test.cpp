// Planted faults: each must be named, first of all.
#include "compare/causes/diagnose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/metrics/test_pictures.h"
#include "compare/metrics/values.h"
#include "compare/verdict/verdict.h"

namespace verisim::compare {
namespace {

using testing::HasSubstr;

// A scene that can be rendered at any place between the pixels, with soft shading and edges of 4x4 samples.
Picture scene(double dx = 0, double dy = 0, int width = 96, int height = 72) {
  const auto color = [=](double x, double y, int c) {
    const double u = x / width, v = y / height;
    if (std::hypot(u - 0.35, v - 0.5) < 0.22) return 60 + 120 * v + 20 * c;
    if (u > 0.7 && v > 0.3) return 170 - 45 * c + 30 * std::sin(9 * u);
    return 60 + 70 * u + 25 * std::sin(12 * v) + 12 * c;
  };
  return picture_of(width, height, [&](int x, int y, int c) {
    double sum = 0;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) sum += color(x + (i + 0.5) / 4 - dx, y + (j + 0.5) / 4 - dy, c);
    return std::round(sum / 16);
  });
}
Picture rounded(const Picture& p, const std::function<double(double)>& f) {
  return changed(p, [&](double v) { return std::round(std::clamp(f(v), 0.0, 255.0)); });
}
Suspicion first(const Picture& test) {
  const std::vector<Suspicion> all = diagnose(scene(), test);
  return all.empty() ? Suspicion{"nothing", "", 0} : all[0];
}

TEST(Diagnose, EqualPicturesAreNotSuspected) { EXPECT_TRUE(diagnose(scene(), scene()).empty()); }

TEST(Diagnose, ThreePercentDarker) {
  const Picture test = rounded(scene(), [](double v) { return 255 * linear_to_srgb(0.97 * srgb_to_linear(v / 255)); });
  EXPECT_EQ(first(test).what, "brightness") << first(test).detail;
  EXPECT_THAT(first(test).detail, testing::ContainsRegex("(2.9|3.0|3.1) % darker"));
}

TEST(Diagnose, GammaSlip) {
  const Picture test = rounded(scene(), [](double v) { return 255 * std::pow(v / 255, 1 / 1.1); });
  EXPECT_EQ(first(test).what, "gamma");
  EXPECT_THAT(first(test).detail, HasSubstr("0.9"));
  EXPECT_GT(first(test).explained, 0.95);
}

TEST(Diagnose, HalfPixelShift) {
  for (const auto& [dx, dy] : {std::pair(0.5, 0.0), std::pair(0.0, -0.5), std::pair(0.5, 0.5), std::pair(-1.0, 0.0)}) {
    const Suspicion s = first(scene(dx, dy));
    EXPECT_EQ(s.what, "shift") << dx << " " << dy << ": " << s.detail;
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(s.detail.c_str(), "the picture is moved by %lf, %lf", &x, &y), 2);
    EXPECT_NEAR(x, dx, 0.1);
    EXPECT_NEAR(y, dy, 0.1);
  }
}

TEST(Diagnose, SwappedChannels) {
  Picture test = scene();
  for (std::size_t i = 0; i < test.samples.size(); i += 3) std::swap(test.samples[i], test.samples[i + 2]);
  EXPECT_EQ(first(test).what, "swapped channels");
  EXPECT_THAT(first(test).detail, HasSubstr("b, g, r"));
}

TEST(Diagnose, LightOfAnotherColour) {
  Picture test = scene();
  const double gain[3] = {1.1, 1, 0.8};
  for (std::size_t i = 0; i < test.samples.size(); ++i)
    test.samples[i] = static_cast<float>(
        std::round(255 * linear_to_srgb(std::min(1.0, gain[i % 3] * srgb_to_linear(test.samples[i])))) / 255);
  EXPECT_EQ(first(test).what, "color balance") << first(test).detail;
}

TEST(Diagnose, Mirrored) {
  Picture test = scene();
  for (int y = 0; y < test.height; ++y)
    for (int x = 0; x < test.width / 2; ++x)
      for (int c = 0; c < 3; ++c)
        std::swap(test.samples[static_cast<std::size_t>(3 * (y * test.width + x) + c)],
                  test.samples[static_cast<std::size_t>(3 * (y * test.width + test.width - 1 - x) + c)]);
  EXPECT_EQ(first(test).what, "mirrored");
}

TEST(Diagnose, FewPixels) {
  Picture test = scene();
  for (int i = 0; i < 20; ++i)
    test.samples[static_cast<std::size_t>(997 * i)] = 1 - test.samples[static_cast<std::size_t>(997 * i)];
  EXPECT_EQ(first(test).what, "specks");
  EXPECT_THAT(first(test).detail, HasSubstr("lone wrong pixels"));
}

TEST(Diagnose, Noise) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 6);
  EXPECT_EQ(first(rounded(scene(), [&](double v) { return v + noise(random); })).what, "noise");
}

// A copy of the scene whose pixel at x, y, seen from the middle, is what the scene has at `place`.
Picture seen_from(const std::function<std::pair<double, double>(double, double)>& place) {
  const Picture original = scene(0, 0, 192, 144);  // twice as fine, so that edges stay sharp
  return picture_of(96, 72, [&](int x, int y, int c) {
    const auto [u, v] = place(x - 47.5, y - 35.5);
    const int i = std::clamp(static_cast<int>(std::lround(2 * (u + 47.5) + 0.5)), 0, 191),
              j = std::clamp(static_cast<int>(std::lround(2 * (v + 35.5) + 0.5)), 0, 143);
    return std::round(255.0 * original.samples[static_cast<std::size_t>(3 * (j * 192 + i) + c)]);
  });
}

TEST(Diagnose, TheCamera) {
  EXPECT_THAT(first(seen_from([](double x, double y) { return std::pair(x / 1.06, y / 1.06); })).what, "zoom");
  const Suspicion turned = first(seen_from([](double x, double y) {
    return std::pair(x * std::cos(0.05) + y * std::sin(0.05), y * std::cos(0.05) - x * std::sin(0.05));
  }));
  EXPECT_EQ(turned.what, "rotation") << turned.detail;
  EXPECT_THAT(turned.detail, testing::ContainsRegex("2\\.[789][0-9]* degrees|3\\.0")) << turned.detail;
  EXPECT_EQ(first(seen_from([](double x, double y) { return std::pair(x / 1.08, y); })).what, "stretched");
}

TEST(Diagnose, ValuesAfterThePicture) {
  const auto each = [](const std::function<void(float*)>& change) {
    Picture test = scene();
    for (std::size_t i = 0; i < test.samples.size(); i += 3) change(&test.samples[i]);
    return first(test).what;
  };
  const auto of_values = [&](const std::function<double(double)>& f) { return first(rounded(scene(), f)).what; };
  EXPECT_EQ(of_values([](double v) { return v + 8; }), "offset");
  EXPECT_EQ(of_values([](double v) { return 128 + 0.8 * (v - 128); }), "contrast");
  EXPECT_EQ(of_values([](double v) { return 255 - v; }), "inverted");
  EXPECT_EQ(of_values([](double v) { return std::min(v, 150.0); }), "clipped");
  EXPECT_EQ(of_values([](double v) { return 32 * std::round(v / 32); }), "quantised");
  EXPECT_EQ(of_values([](double v) { return 255 * srgb_to_linear(v / 255); }), "gamma");
  EXPECT_EQ(each([](float* p) { p[1] = 0; }), "channel missing");
  EXPECT_EQ(each([](float* p) {
              const float grey = 0.299f * p[0] + 0.587f * p[1] + 0.114f * p[2];
              for (int c = 0; c < 3; ++c) p[c] = 0.4f * p[c] + 0.6f * grey;
            }),
            "saturation");
}

// `place`: where the pixel at x, y comes from; what the picture does not hold is black.
Picture rearranged(const std::function<std::pair<int, int>(int, int)>& place) {
  const Picture original = scene();
  return picture_of(96, 72, [&](int x, int y, int c) {
    const auto [i, j] = place(x, y);
    return i < 0 || j < 0 || i >= 96 || j >= 72
               ? 0
               : std::round(255.0 * original.samples[static_cast<std::size_t>(3 * (j * 96 + i) + c)]);
  });
}

TEST(Diagnose, PartsOfThePicture) {
  const auto inside = [](int x, int y) { return x >= 20 && x < 52 && y >= 10 && y < 42; };
  const Suspicion lost =
      first(rearranged([&](int x, int y) { return inside(x, y) ? std::pair(-1, -1) : std::pair(x, y); }));
  EXPECT_EQ(lost.what, "rectangle");
  EXPECT_THAT(lost.detail, HasSubstr("columns 20 to 51, rows 10 to 41, all 0 0 0"));
  const Suspicion moved =
      first(rearranged([&](int x, int y) { return inside(x, y) ? std::pair(x + 6, y + 2) : std::pair(x, y); }));
  EXPECT_EQ(moved.what, "part shifted");
  EXPECT_THAT(moved.detail, HasSubstr("moved by -6, -2"));
  EXPECT_EQ(first(rearranged([&](int x, int y) { return std::pair(y == 30 ? std::min(x + 9, 95) : x, y); })).what,
            "part shifted");
  EXPECT_EQ(first(rearranged([&](int x, int y) { return std::pair(x, y == 30 ? -1 : y); })).what, "rows");
  EXPECT_EQ(first(rearranged([&](int x, int y) { return std::pair(x / 4 * 4, y / 4 * 4); })).what, "pixelation");
}

TEST(Diagnose, WhatLensesDo) {
  const Picture original = scene();
  const auto filtered = [&](double s) {
    return picture_of(96, 72, [&](int x, int y, int c) {
      double sum = 0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          sum += 255.0 *
                 original.samples[static_cast<std::size_t>(
                     3 * (std::clamp(y + j, 0, 71) * 96 + std::clamp(x + i, 0, 95)) + c)] /
                 9;
      const double v = 255.0 * original.samples[static_cast<std::size_t>(3 * (y * 96 + x) + c)];
      return std::round(std::clamp(v + s * (sum - v), 0.0, 255.0));
    });
  };
  EXPECT_EQ(first(filtered(0.8)).what, "blur");
  EXPECT_EQ(first(filtered(-0.8)).what, "sharpening");
  EXPECT_EQ(first(picture_of(96, 72,
                             [&](int x, int y, int c) {
                               const double u = x / 47.5 - 1, v = y / 35.5 - 1;
                               return std::round(255.0 *
                                                 original.samples[static_cast<std::size_t>(3 * (y * 96 + x) + c)] *
                                                 (1 - 0.15 * (u * u + v * v)));
                             }))
                .what,
            "vignetting");
}

TEST(Diagnose, TheSuspectHoldsThePixelsThatItExplains) {
  const Suspicion lost =
      first(rearranged([](int x, int y) { return x < 4 && y < 4 ? std::pair(-1, -1) : std::pair(x, y); }));
  const std::vector<unsigned char> mask = mask_of(lost.pixels, 96 * 72);
  EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 16);
  EXPECT_EQ(mask[0] + mask[3] + mask[3 * 96 + 3], 3);
  EXPECT_DOUBLE_EQ(lost.precision, 1);
  EXPECT_DOUBLE_EQ(lost.explained, 1);
  EXPECT_GT(lost.sure, 0.8);
}

TEST(Diagnose, OnePixelAndNan) {
  EXPECT_NO_THROW(diagnose(constant_picture(1, 1, 1, 2, 3), constant_picture(1, 1, 9, 2, 3)));
  Picture broken = scene();
  broken.is_float = true;
  broken.samples[7] = NAN;
  EXPECT_NO_THROW(diagnose(broken, broken));
  EXPECT_THROW(diagnose(scene(), constant_picture(1, 1, 0, 0, 0)), PictureMismatch);
}

// What verisim says of its pixels: every pixel has the first tag, those in columns 10 to 39 the second, too.
PixelTags with_tag(const std::string& kind, const std::string& name) {
  PixelTags tags;
  tags.width = 96, tags.height = 72;
  tags.tags = {{"object", "box (s.pov:1)"}, {kind, name}};
  tags.sets = {{0}, {0, 1}};
  for (int i = 0; i < 96 * 72; ++i) tags.set_of.push_back(i % 96 >= 10 && i % 96 < 40);
  return tags;
}
// Five pixels of those columns become white.
Picture with_white_pixels() {
  Picture test = scene();
  for (const int x : {12, 17, 23, 29, 38})
    for (int c = 0; c < 3; ++c) test.samples[static_cast<std::size_t>((3 * x * 96 / 3 + x) * 3 + c)] = 1;
  return test;
}

TEST(Diagnose, SurfacesInOnePlace) {
  const PixelTags tags = with_tag("coincidence", "box (s.pov:1) and box (s.pov:2)");
  const std::vector<Suspicion> all = diagnose(scene(), with_white_pixels(), nullptr, &tags);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].what, "coincident surfaces");
  EXPECT_THAT(all[0].detail, HasSubstr("box (s.pov:2)"));
}

TEST(Diagnose, WhereAnEffectIsSeen) {
  const PixelTags tags = with_tag("effect", "photons");
  const std::vector<Suspicion> all = diagnose(scene(), with_white_pixels(), nullptr, &tags);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].what, "photons");
}

TEST(Diagnose, AnObjectOfWhichOnlyTheBoxIsMet) {
  const PixelTags tags = with_tag("passed object", "sor (s.pov:7)");
  const std::vector<Suspicion> all = diagnose(scene(), with_white_pixels(), nullptr, &tags);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].what, "object missing");
  EXPECT_THAT(all[0].detail, HasSubstr("sor (s.pov:7)"));
}

Picture darker_where(const std::function<bool(int, int)>& wrong) {
  const Picture original = scene();
  return picture_of(96, 72, [&](int x, int y, int c) {
    const double v = 255.0 * original.samples[static_cast<std::size_t>(3 * (y * 96 + x) + c)];
    return std::round(wrong(x, y) ? 0.7 * v + 7 * c * std::sin(x * y) : v);
  });
}
std::string first_with(const Picture& test, const PixelTags& tags) {
  const std::vector<Suspicion> all = diagnose(scene(), test, nullptr, &tags);
  return all.empty() ? "nothing" : all[0].what;
}

// An object may fill a rectangle, whose border is then its own; a tile cuts through objects.
TEST(Diagnose, ARectangleCutsThroughObjects) {
  const PixelTags tags = with_tag("object", "plane (s.pov:2)");
  EXPECT_NE(first_with(darker_where([](int x, int) { return x >= 10 && x < 40; }), tags), "rectangle");
  EXPECT_EQ(first_with(darker_where([](int x, int y) { return x >= 14 && x < 34 && y >= 20 && y < 44; }), tags),
            "rectangle");
}

// The surface of one object is not to blame where others are wrong, too, though by less.
TEST(Diagnose, WhatAllWrongPixelsShowComesFirst) {
  const auto box = [](int x, int y) { return x > 0.7 * 96 && y > 0.3 * 72; };
  const auto disc = [](int x, int y) { return std::hypot(x / 96.0 - 0.35, y / 72.0 - 0.5) < 0.21; };
  PixelTags tags = with_tag("copy", "box (s.pov:2)");
  tags.tags.push_back({"feature", "noise (turbulence)"}), tags.sets = {{0}, {1, 2}, {0, 2}};
  for (int i = 0; i < 96 * 72; ++i)
    tags.set_of[static_cast<std::size_t>(i)] = box(i % 96, i / 96) ? 1 : disc(i % 96, i / 96) ? 2 : 0;
  Picture test = darker_where(box);
  for (int i = 0; i < 96 * 72; ++i)
    if (disc(i % 96, i / 96)) test.samples[static_cast<std::size_t>(3 * i)] *= 0.9f;
  EXPECT_EQ(first_with(test, tags), "noise functions");
}

// Shadows seen in a mirror have their cause elsewhere: pixels without one tell it.
TEST(Diagnose, MirrorsDoNotTell) {
  PixelTags tags = with_tag("light", "in the shadow of the light at <0, 0, 0>");
  tags.tags.push_back({"secondary object", "box (s.pov:1), in a reflection"}), tags.sets.push_back({0, 2});
  for (int i = 0; i < 96 * 72; ++i)
    if (i % 96 >= 50) tags.set_of[static_cast<std::size_t>(i)] = 2;
  EXPECT_EQ(
      first_with(darker_where([](int x, int y) { return (x >= 10 && x < 40) || (x >= 50 && (x + y) % 3 != 0); }), tags),
      "shadows");
}

TEST(Diagnose, HighlightsAreWhereTheirLightIs) {
  PixelTags tags = with_tag("shape", "sphere");
  PixelTags::Part& part = tags.parts.emplace_back();
  part.kind = "highlights";
  const auto in_spot = [](int x, int y) { return std::hypot(x - 25, y - 30) < 4; };
  for (int i = 0; i < 96 * 72; ++i)
    for (int c = 0; c < 3; ++c) part.light.push_back(in_spot(i % 96, i / 96) ? 0.2f : 0);
  EXPECT_EQ(first_with(darker_where(in_spot), tags), "highlights");
}

TEST(Diagnose, AFewPixelsOfOneColorFitNoFormula) {
  const PixelTags tags = with_tag("shape", "sphere");
  Picture test = scene();
  for (int x = 12; x < 20; ++x)
    for (int c = 0; c < 3; ++c) test.samples[static_cast<std::size_t>((40 * 96 + x) * 3 + c)] = 0;
  for (const Suspicion& s : diagnose(scene(), test, nullptr, &tags))
    EXPECT_THAT(s.what, testing::Not(testing::AnyOf("brightness", "clipped", "pixelation", "part shifted", "zoom")));
}

// A disc on a ground, both with patterns that stay where they are.
Picture disc(double x, double y, double radius) {
  return picture_of(96, 72, [=](int u, int v, int c) {
    return std::hypot(u - x, v - y) < radius ? 190 + 25 * std::sin(u) * std::cos(v) - 40 * c
                                             : 80 + 40 * std::sin(u / 4.0) * std::cos(v / 5.0) + 9 * c;
  });
}
PixelTags of_disc(double x, double y, double radius) {
  PixelTags tags = with_tag("copy", "sphere (s.pov:2) at <0, 0, 0>, size <1, 1, 1>");
  for (int i = 0; i < 96 * 72; ++i)
    tags.set_of[static_cast<std::size_t>(i)] = std::hypot(i % 96 - x, i / 96 - y) < radius;
  return tags;
}

TEST(Diagnose, WhatIsElsewhereWasNotAdded) {
  const PixelTags tags = of_disc(45, 35, 14);
  for (const auto& [reference, what] :
       {std::pair(disc(45, 40, 14), "object moved"), std::pair(disc(39, 35, 14), "object moved"),
        std::pair(disc(45, 35, 11.5), "object scaled"), std::pair(disc(45, 35, 17), "object scaled")}) {
    const std::vector<Suspicion> all = diagnose(reference, disc(45, 35, 14), nullptr, &tags);
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all[0].what, what) << all[0].detail;
    EXPECT_THAT(all[0].detail, HasSubstr("sphere (s.pov:2)"));
  }
  const Picture none = disc(-90, -90, 1);
  const std::vector<Suspicion> added = diagnose(none, disc(45, 35, 14), nullptr, &tags);
  ASSERT_FALSE(added.empty());
  EXPECT_EQ(added[0].what, "object added");
}

// The test has a light that the reference has not, or one that is twice as strong.
TEST(Diagnose, ALightThatOnlyTheTestHas) {
  PixelTags tags = with_tag("light", "lit by the light at <1, 2, 3>");
  PixelTags::Part light{"light", "light at <1, 2, 3>", {}}, own{"own light", "ambient and emission", {}};
  for (int i = 0; i < 96 * 72; ++i)
    for (int c = 0; c < 3; ++c)
      light.light.push_back(i % 96 < 40 ? 0.1f + 0.002f * static_cast<float>(i % 96) : 0),
          own.light.push_back(0.1f + 0.001f * static_cast<float>(i / 96));
  tags.parts = {light, own};
  const auto picture = [&](float factor) {
    return picture_of(96, 72, [&](int x, int y, int c) {
      const auto i = static_cast<std::size_t>(3 * (y * 96 + x) + c);
      return std::round(255 * linear_to_srgb(own.light[i] + factor * light.light[i]));
    });
  };
  const std::vector<Suspicion> added = diagnose(picture(0), picture(1), nullptr, &tags),
                               stronger = diagnose(picture(0.5f), picture(1), nullptr, &tags);
  ASSERT_FALSE(added.empty() || stronger.empty());
  EXPECT_EQ(added[0].what, "light added") << added[0].detail;
  EXPECT_EQ(stronger[0].what, "light strength") << stronger[0].detail;
  EXPECT_THAT(stronger[0].detail, testing::ContainsRegex("(99|100).[0-9] % more"));
}

// The test's fog is 1.4 times as dense as the reference's.
TEST(Diagnose, FogOfAnotherDensity) {
  PixelTags tags = with_tag("object", "plane (s.pov:1)");
  PixelTags::Part fog{"fog", "", {}}, own{"own light", "ambient and emission", {}};
  constexpr float kColor[3] = {0.6f, 0.7f, 0.8f};
  const auto passed = [](int x, double density) { return x >= 90 ? 0.0 : std::exp(-density * 0.02 * (x + 5)); };
  const auto behind = [](int x, int y, int c) { return 0.3 + 0.2 * std::sin(x / 5.0 + c) * std::cos(y / 7.0); };
  for (int i = 0; i < 96 * 72; ++i)
    for (int c = 0; c < 3; ++c) {
      const double t = passed(i % 96, 1.4);
      fog.light.push_back(static_cast<float>((1 - t) * kColor[c]));
      own.light.push_back(static_cast<float>(t * behind(i % 96, i / 96, c)));
    }
  tags.parts = {fog, own};
  const auto picture = [&](double density) {
    return picture_of(96, 72, [&](int x, int y, int c) {
      const double t = passed(x, density);
      return std::round(255 * linear_to_srgb(t * behind(x, y, c) + (1 - t) * kColor[c]));
    });
  };
  const std::vector<Suspicion> all = diagnose(picture(1), picture(1.4), nullptr, &tags);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].what, "fog") << all[0].detail;
  EXPECT_THAT(all[0].detail, testing::ContainsRegex("1.(39|40|41) times as dense"));
}

// What is seen through one object is half as bright in the reference.
TEST(Diagnose, TransparencyIsToldWithItsObject) {
  PixelTags tags = with_tag("object", "plane (s.pov:1)");
  tags.tags = {{"object", "plane (s.pov:1)"}, {"object", "box (s.pov:3)"}}, tags.sets = {{0}, {1}};
  PixelTags::Part through{"transparency", "", {}}, own{"own light", "ambient and emission", {}};
  const auto glass = [](int x, int y) { return x >= 10 && x < 40 && y >= 20 && y < 50; };
  for (int i = 0; i < 96 * 72; ++i) {
    tags.set_of[static_cast<std::size_t>(i)] = glass(i % 96, i / 96);
    for (int c = 0; c < 3; ++c) {
      own.light.push_back(0.2f + 0.001f * static_cast<float>(i % 96 + 5 * c));
      through.light.push_back(glass(i % 96, i / 96) ? 0.1f + 0.001f * static_cast<float>(i / 96) : 0);
    }
  }
  tags.parts = {through, own};
  const auto picture = [&](float part) {
    return picture_of(96, 72, [&](int x, int y, int c) {
      const auto i = static_cast<std::size_t>(3 * (y * 96 + x) + c);
      return std::round(255 * linear_to_srgb(own.light[i] - (1 - part) * through.light[i]));
    });
  };
  const std::vector<Suspicion> all = diagnose(picture(0.5f), picture(1), nullptr, &tags);
  const auto told = std::find_if(all.begin(), all.end(), [](const Suspicion& s) { return s.what == "transparency"; });
  ASSERT_NE(told, all.end());
  EXPECT_THAT(told->detail, testing::ContainsRegex("box \\(s.pov:3\\): (99|100).[0-9] % more"));
}

// The sky that only mirrors show.
TEST(Diagnose, TheSkyInMirrorsIsTheBackground) {
  PixelTags tags = with_tag("secondary object", "sky or background by a secondary ray");
  tags.tags.push_back({"feature", "reflection"}), tags.sets = {{0}, {1, 2}};
  EXPECT_EQ(first_with(darker_where([](int x, int) { return x >= 10 && x < 40; }), tags), "background");
}

// A texture of one object is told with it; a shape of which there is one is told as that object.
TEST(Diagnose, WhatOneObjectHasIsToldWithIt) {
  PixelTags tags = with_tag("copy", "sphere (s.pov:2)");
  tags.tags.push_back({"object", "sphere (s.pov:2)"}), tags.tags.push_back({"texture", "pigment bozo"}),
      tags.tags.push_back({"shape", "sphere"});
  tags.sets = {{0}, {1, 2, 3, 4}};
  bool told = false;
  for (const Suspicion& s :
       diagnose(scene(), darker_where([](int x, int) { return x >= 10 && x < 40; }), nullptr, &tags)) {
    told = told || s.detail == "pigment bozo of sphere (s.pov:2)";
    EXPECT_NE(s.what, "shape");
  }
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace verisim::compare
