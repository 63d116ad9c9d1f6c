// For the tests of blocks: a scene from a piece of SDL, or its first error.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "parser/parse.h"

namespace verisim::parser::testing {

struct Parsed {
  std::optional<scene::Scene> scene;
  std::string error;     // empty: none
  std::string messages;  // warnings, one a line
};

// Text that does not begin with #version gets #version 3.7 and assumed_gamma 1.
inline Parsed parse(const std::string& text) {
  Parsed parsed;
  ParseOptions options;
  options.message = [&parsed](const Diagnostic& d) {
    if (d.severity == Severity::warning || d.severity == Severity::possible_error) parsed.messages += d.message + "\n";
  };
  const bool complete = text.starts_with("#version");
  ParseResult result =
      parse_text(complete ? text : "#version 3.7; global_settings{assumed_gamma 1}\n" + text, "test.pov", options);
  parsed.scene = std::move(result.scene);
  if (!result.errors.empty()) parsed.error = result.errors.front().message;
  if (!parsed.scene && parsed.error.empty()) parsed.error = "no scene and no error";
  return parsed;
}

inline std::string first_error(const std::string& text) { return parse(text).error; }

// The scene, which must be free of errors.
inline scene::Scene scene_of(const std::string& text) {
  Parsed parsed = parse(text);
  EXPECT_EQ(parsed.error, "") << text;
  return parsed.scene.value_or(scene::Scene());
}

// The only object of a scene.
inline scene::ObjectPtr object_of(const std::string& text) {
  const scene::Scene scene = scene_of(text);
  EXPECT_EQ(scene.objects.size(), 1u) << text;
  return scene.objects.empty() ? std::make_shared<scene::Object>() : scene.objects.front();
}

// `items` inside the braces of a sphere.
inline scene::ObjectPtr sphere_with(const std::string& items, const std::string& before = {}) {
  return object_of(before + " sphere{0,1 " + items + "}");
}

inline scene::Finish finish_of(const std::string& items, const std::string& before = {}) {
  return sphere_with("finish{" + items + "}", before)->texture->layers.back().finish;
}

inline scene::PigmentPtr pigment_of(const std::string& items, const std::string& before = {}) {
  return sphere_with("pigment{" + items + "}", before)->texture->layers.back().pigment;
}

inline scene::NormalPtr normal_of(const std::string& items) {
  return sphere_with("normal{" + items + "}")->texture->layers.back().normal;
}

}  // namespace verisim::parser::testing
