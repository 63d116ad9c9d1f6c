// Delta debugging of scenes (Zeller and Hildebrandt, "Simplifying and isolating failure-inducing input", 2002).
//
// What may go is tried in ever smaller groups: statements from the outermost block inwards, then words of statements,
// then blocks are replaced by what stands in them, names by what they mean and numbers by rounder ones. Many candidates
// are judged at a time, because POV-Ray sleeps most of the time that a small scene takes it; what can go by itself is
// then tried together.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "compare/reduce/sdl_tree.h"

namespace verisim::compare {

// One thing that may be done to a text: edits in its order.
using Change = std::vector<TextEdit>;

class Reducer {
 public:
  struct Options {
    // Which of the texts still show the difference.
    std::function<std::vector<bool>(const std::vector<std::string>&)> judge;
    std::function<bool()> stop = [] { return false; };
    // The text of an include file that belongs to the scene; nothing: it stays.
    std::function<std::optional<std::string>(const std::string&)> include = [](const std::string&) {
      return std::nullopt;
    };
    std::function<void(const std::string& best)> better = [](const std::string&) {};
    // Nothing is left out any more: what follows must not show another difference, only the same in rounder numbers.
    std::function<void(const std::string& best)> before_rounding = [](const std::string&) {};
    std::size_t batch = 24;
  };
  explicit Reducer(Options options) : options_(std::move(options)) {}

  // The smallest text that was found. `text` shows the difference.
  std::string reduced(std::string text);

 private:
  std::vector<bool> judged(const std::vector<std::string>& texts);
  std::string without(const std::string& text, std::vector<Change> changes);
  std::vector<Change> merged(const std::string& text, const std::vector<Change>& accepted,
                             std::vector<std::vector<Change>>& good);
  using Cuts = std::function<std::vector<Change>(const std::string& text, const SdlBlock& tree, std::size_t depth)>;
  std::string pass(std::string text, const Cuts& cuts);
  std::string lines_cut(std::string text);
  std::string included(std::string text);
  std::string rounded(std::string text);

  Options options_;
  std::unordered_map<std::string, bool> known_;
};

}  // namespace verisim::compare
