// The HTML report: a page, its data as JSON, and its pictures; as one file, or in pieces for a server.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/compare.h"

namespace verisim::compare {

// As the text of a script element, where "</script>" and "<!--" would end it: no '<' is written as itself.
std::string script_safe(const nlohmann::json& json);

class HtmlReport {
 public:
  // The run outlives this. `review`: what has been decided on its scenes (compare/regression/review.h), or null.
  explicit HtmlReport(const Run& run, nlohmann::json review = nullptr) : run_(run), review_(std::move(review)) {}

  // One self-contained file that asks for nothing.
  std::string file() const;
  // The page alone, with what has been decided by now; it asks for report.css, report.js and `picture?id=` ...
  std::string served(const nlohmann::json& review) const;
  static std::string style();
  static std::string script();
  // ... a PNG file by its id: "p", the number of the scene and a key of ScenePictures. Throws std::runtime_error for an
  // id that there is not.
  std::string picture(const std::string& id) const;

 private:
  const Run& run_;
  nlohmann::json review_;
  mutable nlohmann::json scenes_;  // made once; served() is for one thread at a time
};

}  // namespace verisim::compare
