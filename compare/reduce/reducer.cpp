#include "compare/reduce/reducer.h"

#include <algorithm>
#include <deque>
#include <numeric>

#include "compare/reduce/cuts.h"

namespace verisim::compare {
namespace {

using Group = std::vector<Change>;

// Nothing when two of them are about the same place.
std::optional<std::string> changed(const std::string& text, const std::vector<const Group*>& groups) {
  std::vector<TextEdit> edits;
  for (const Group* group : groups)
    for (const Change& change : *group) edits.insert(edits.end(), change.begin(), change.end());
  std::sort(edits.begin(), edits.end(),
            [](const TextEdit& a, const TextEdit& b) { return a.range.begin < b.range.begin; });
  for (std::size_t i = 1; i < edits.size(); ++i)
    if (edits[i].range.begin < edits[i - 1].range.end) return std::nullopt;
  return stripped(parser::applied(text, edits));
}

std::deque<Group> divided(const Group& changes, std::size_t groups) {
  groups = std::clamp<std::size_t>(groups, 1, changes.size());
  std::deque<Group> out(groups);
  for (std::size_t i = 0; i < changes.size(); ++i) out[i * groups / changes.size()].push_back(changes[i]);
  return out;
}

std::size_t removed_bytes(const Group& group) {
  std::size_t sum = 0;
  for (const Change& change : group)
    for (const TextEdit& edit : change) sum += edit.range.end - edit.range.begin;
  return sum;
}

// How many of the first of n groups are tried together: n, three quarters of it, half ...
std::vector<std::size_t> shares_of(std::size_t n) {
  std::vector<std::size_t> out;
  for (std::size_t k = n; k >= 2; k = k * 3 / 4) out.push_back(k);
  return out;
}

}  // namespace

std::vector<bool> Reducer::judged(const std::vector<std::string>& texts) {
  std::vector<std::string> fresh;
  for (const std::string& text : texts)
    if (!known_.contains(text) && std::find(fresh.begin(), fresh.end(), text) == fresh.end()) fresh.push_back(text);
  if (!fresh.empty()) {
    const std::vector<bool> verdicts = options_.judge(fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i) known_[fresh[i]] = verdicts[i];
  }
  std::vector<bool> out;
  for (const std::string& text : texts) out.push_back(known_[text]);
  return out;
}

// Of groups that may be applied each by itself as many as may be applied together, the first of all events. What is
// not taken stays in `good`.
std::vector<Change> Reducer::merged(const std::string& text, const Group& accepted, std::vector<Group>& good) {
  std::sort(good.begin(), good.end(),
            [](const Group& a, const Group& b) { return removed_bytes(a) > removed_bytes(b); });
  const std::vector<std::size_t> shares = shares_of(good.size());
  std::vector<std::string> together;
  for (const std::size_t share : shares) {
    std::vector<const Group*> groups{&accepted};
    for (std::size_t i = 0; i < share; ++i) groups.push_back(&good[i]);
    together.push_back(changed(text, groups).value_or(std::string()));
  }
  std::size_t taken = 1;
  if (!together.empty()) {
    const std::vector<bool> verdicts = judged(together);
    const auto first = std::find(verdicts.begin(), verdicts.end(), true);
    if (first != verdicts.end()) taken = shares[static_cast<std::size_t>(first - verdicts.begin())];
  }
  Group out = accepted;
  for (std::size_t i = 0; i < taken; ++i) out.insert(out.end(), good[i].begin(), good[i].end());
  good.erase(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(taken));
  return out;
}

std::string Reducer::without(const std::string& text, Group changes) {
  if (changes.empty()) return text;
  Group accepted;
  std::deque<Group> waiting = divided(changes, options_.batch);
  while (!waiting.empty() && !options_.stop()) {
    std::vector<Group> tried;
    std::vector<std::string> texts;
    while (!waiting.empty() && tried.size() < options_.batch) {
      if (auto candidate = changed(text, {&accepted, &waiting.front()})) {
        tried.push_back(std::move(waiting.front()));
        texts.push_back(std::move(*candidate));
      }
      waiting.pop_front();
    }
    const std::vector<bool> verdicts = judged(texts);
    std::vector<Group> good;
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (verdicts[i])
        good.push_back(std::move(tried[i]));
      else if (tried[i].size() > 1)
        for (Group& half : divided(tried[i], 2)) waiting.push_back(std::move(half));
    }
    if (good.empty()) continue;
    accepted = merged(text, accepted, good);
    for (Group& group : good) waiting.push_front(std::move(group));
    options_.better(*changed(text, {&accepted}));
  }
  return accepted.empty() ? text : *changed(text, {&accepted});
}

std::string Reducer::pass(std::string text, const Cuts& cuts) {
  for (std::size_t depth = 0; !options_.stop(); ++depth) {
    const auto tree = sdl_tree(text);
    if (!tree || depth >= depth_of(*tree)) break;
    text = without(text, cuts(text, *tree, depth));
  }
  return text;
}

// For texts whose brackets do not match.
std::string Reducer::lines_cut(std::string text) { return without(text, lines_left_out(text)); }

std::string Reducer::included(std::string text) {
  constexpr int kNested = 5;
  for (int i = 0; i < kNested && !options_.stop(); ++i) {
    std::string next = without(text, includes_replaced(text, options_.include));
    if (next == text) break;
    text = std::move(next);
  }
  return text;
}

std::string Reducer::rounded(std::string text) {
  for (const char digit : {'0', '1', '2', '\0'})
    if (!options_.stop()) text = without(text, numbers_replaced(text, digit));
  return text;
}

std::string Reducer::reduced(std::string text) {
  known_[text] = true;
  if (const std::string plain = stripped(text); judged({plain})[0]) text = plain;
  if (!sdl_tree(text)) text = lines_cut(text);
  for (std::string before; before != text && !options_.stop();) {
    before = text;
    text =
        pass(text, [](const std::string&, const auto& tree, auto depth) { return statements_left_out(tree, depth); });
    text = included(text);
    text = pass(text, [](const std::string&, const auto& tree, auto depth) { return parts_left_out(tree, depth); });
    for (const bool last : {true, false})
      text = pass(text, [last](const std::string& whole, const auto& tree, auto depth) {
        return contents_of_blocks(whole, tree, depth, last);
      });
    text = pass(text, loops_once);
    for (const Meaning meaning : {Meaning::value, Meaning::in_parentheses, Meaning::content})
      if (!options_.stop()) text = without(text, names_replaced(text, meaning));
  }
  if (!options_.stop()) options_.before_rounding(text);
  return laid_out(rounded(text));
}

}  // namespace verisim::compare
