#include "tracer/textures/compile/texture_pool.h"

#include <functional>

#include <gtest/gtest.h>

namespace verisim::textures {
namespace {

// A marble with bumps, moved; made anew at each call.
std::shared_ptr<scene::Texture> marble() {
  scene::Pigment pigment;
  pigment.pattern.kind = scene::PatternKind::marble;
  pigment.pattern.prepend(Transform::translation({1, 2, 3}));
  pigment.color_map =
      std::make_shared<scene::ColorMap>(scene::ColorMap{{0, Color(1, 0, 0)}, {1, Color(0, 0, 1, 0, 0.5f)}});
  scene::Normal normal;
  normal.pattern.kind = scene::PatternKind::bumps;
  auto texture = std::make_shared<scene::Texture>();
  texture->layers.push_back({std::make_shared<scene::Pigment>(pigment), std::make_shared<scene::Normal>(normal),
                             scene::Rare<scene::Finish>(scene::Finish{})});
  return texture;
}

template <class Change>
scene::TexturePtr changed_marble(Change change) {
  const std::shared_ptr<scene::Texture> texture = marble();
  change(*texture);
  return texture;
}
template <class Change>
scene::TexturePtr with_pigment(Change change) {
  return changed_marble([&](scene::Texture& t) {
    auto pigment = std::make_shared<scene::Pigment>(*t.layers[0].pigment);
    change(*pigment);
    t.layers[0].pigment = pigment;
  });
}
template <class Change>
scene::TexturePtr with_normal(Change change) {
  return changed_marble([&](scene::Texture& t) {
    auto normal = std::make_shared<scene::Normal>(*t.layers[0].normal);
    change(*normal);
    t.layers[0].normal = normal;
  });
}

TEST(TexturePool, EqualTexturesAreOne) {
  TexturePool pool;
  const scene::TexturePtr first = pool.one(marble()), second = pool.one(marble());
  EXPECT_EQ(first, second);
  EXPECT_EQ(pool.one(nullptr), nullptr);
}

TEST(TexturePool, WhatLooksOtherwiseStaysItself) {
  const std::function<scene::TexturePtr()> others[] = {
      [] { return with_pigment([](auto& p) { p.color = Color(1, 1, 1); }); },
      [] { return with_pigment([](auto& p) { p.quick_color = Color(1, 0, 0); }); },
      [] { return with_pigment([](auto& p) { p.pattern.kind = scene::PatternKind::wood; }); },
      [] { return with_pigment([](auto& p) { p.pattern.phase = 0.5f; }); },
      [] { return with_pigment([](auto& p) {
             p.pattern.prepend(Transform::translation({0, 0, 1}));
           }); },
      [] { return with_pigment([](auto& p) {
             p.pattern.turbulence = scene::Turbulence{{1, 1, 1}, 6, 2, 0.5f};
           }); },
      [] {
        return with_pigment([](auto& p) {
          p.color_map = std::make_shared<scene::ColorMap>(scene::ColorMap{{0, Color(1, 0, 0)}, {1, Color(0, 0, 1)}});
        });
      },
      [] { return with_pigment([](auto& p) { p.color_map = nullptr; }); },
      [] { return with_normal([](auto& n) { n.amount = 1; }); },
      [] { return with_normal([](auto& n) {
             n.pattern.prepend(Transform::scaling({2, 2, 2}));
           }); },
      [] { return with_normal([](auto& n) { n.no_bump_scale = true; }); },
      [] { return changed_marble([](auto& t) { t.layers[0].normal = nullptr; }); },
      [] { return changed_marble([](auto& t) { t.layers[0].finish.edit().phong = 1; }); },
      [] { return changed_marble([](auto& t) { t.no_bump_scale = true; }); },
      [] { return changed_marble([](auto& t) { t.layers.push_back(t.layers[0]); }); },
  };
  for (const auto& other : others) {
    TexturePool pool;
    const scene::TexturePtr first = pool.one(marble()), second = pool.one(other());
    EXPECT_NE(first, second) << &other - others;
    EXPECT_EQ(second, pool.one(other())) << &other - others;
  }
}

// Layers of old versions would change its filter for both.
TEST(TexturePool, MapsWithFilterAreNotShared) {
  const auto filtering = [] {
    return with_pigment([](auto& p) {
      p.color_map = std::make_shared<scene::ColorMap>(scene::ColorMap{{0, Color(1, 0, 0, 0.5f, 0)}});
    });
  };
  TexturePool pool;
  const scene::TexturePtr first = pool.one(filtering());
  EXPECT_NE(pool.one(filtering()), first);
}

// What is declared is one already, and not looked at.
TEST(TexturePool, SharedTexturesAreLeftAlone) {
  TexturePool pool;
  const scene::TexturePtr first = pool.one(marble()), declared = marble();
  EXPECT_NE(pool.one(declared), first);
}

}  // namespace
}  // namespace verisim::textures
