// For the tests of the language: runs SDL from memory and collects what it prints.
#pragma once

#include <string>

#include "parser/parse.h"

namespace verisim::parser::testing {

struct Outcome {
  std::string text;   // of #debug
  std::string error;  // the first error's message; empty: none
  int line = 0;       // of the first error
  std::string advice;
  ParseResult result;
};

inline Outcome run(const std::string& sdl, ParseOptions options = {}) {
  Outcome outcome;
  options.debug = [&outcome](const std::string& text) { outcome.text += text; };
  outcome.result = parse_text(sdl, "test.pov", options);
  if (!outcome.result.errors.empty()) {
    outcome.error = outcome.result.errors.front().message;
    outcome.line = outcome.result.errors.front().line;
    outcome.advice = outcome.result.errors.front().advice;
  }
  return outcome;
}

// What a scene prints, or its error message.
inline std::string printed(const std::string& sdl) {
  const Outcome outcome = run("#version 3.7; global_settings { assumed_gamma 1 }\n" + sdl);
  return outcome.error.empty() ? outcome.text : "error: " + outcome.error;
}

inline bool accepts(const std::string& sdl) {
  return run("#version 3.7; global_settings { assumed_gamma 1 }\n" + sdl).error.empty();
}

// Zeros at the end of decimals cut: "0.5000" is "0.5", "7.000" is "7".
inline std::string cut(std::string number) {
  if (number.find('.') == std::string::npos) return number;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number;
}

// A float with 16 decimals, zeros at the end cut.
inline std::string number(const std::string& expression, const std::string& before = {}) {
  const std::string text = printed(before + "#debug str(" + expression + ",0,16)");
  return text.starts_with("error") ? text : cut(text);
}

// The first `terms` components with `digits` decimals, zeros cut.
inline std::string components(int terms, int digits, const std::string& expression, const std::string& before = {}) {
  const std::string text = printed(before + "#declare Value_ = " + expression + "; #debug vstr(" +
                                   std::to_string(terms) + ",Value_,\" \",0," + std::to_string(digits) + ")");
  if (text.starts_with("error")) return text;
  std::string out, part;
  for (const char c : text + ' ') {
    if (c != ' ') {
      part += c;
      continue;
    }
    out += (out.empty() ? "" : " ") + cut(part);
    part.clear();
  }
  return out;
}

}  // namespace verisim::parser::testing
