#include "compare/regression/review.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "compare/json_text.h"
#include "compare/oracle/content_hash.h"
#include "compare/regression/renders.h"
#include "compare/report/display.h"
#include "compare/report/markdown_cell.h"
#include "compare/report/why.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

// What is accepted or refused: our picture, or that there is none any more.
std::string picture_of(const SceneResult& scene) {
  if (scene.native_picture.empty()) return to_string(scene.status);
  ContentHash hash;
  hash.add_file(scene.native_picture);
  return hash.hex();
}

Picture joined(const std::vector<Picture>& parts) {
  constexpr int kGap = 4;
  Picture out;
  for (const Picture& p : parts)
    out.width += p.width + (out.width ? kGap : 0), out.height = std::max(out.height, p.height);
  out.channels = 3;
  out.samples.assign(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 3, 1.0f);
  int left = 0;
  for (const Picture& p : parts) {
    for (int y = 0; y < p.height; ++y)
      std::copy_n(p.samples.begin() + static_cast<std::ptrdiff_t>(y) * p.width * 3, p.width * 3,
                  out.samples.begin() + (static_cast<std::ptrdiff_t>(y) * out.width + left) * 3);
    left += p.width + kGap;
  }
  return out;
}

// Reference, change and difference side by side, as far as there are any. False: none.
bool write_strip(const SceneResult& scene, const fs::path& file) {
  constexpr int kWidth = 320, kHeight = 240;
  std::vector<Picture> parts;
  const fs::path& test = scene.judged_picture.empty() ? scene.native_picture : scene.judged_picture;
  for (const fs::path& path : {scene.oracle_picture, test})
    if (!path.empty()) parts.push_back(thumbnail(shown(path), kWidth, kHeight));
  if (parts.empty()) return false;
  if (scene.metrics) parts.push_back(difference_thumbnail(shown(scene.oracle_picture), shown(test), kWidth, kHeight));
  image::write_picture(joined(parts), file);
  return true;
}

}  // namespace

Review::Review(const fs::path& folder, const fs::path& baseline) : folder_(folder), kept_(load_run(folder)) {
  // A run from elsewhere may name any folder: what it names counts if stored pictures are there.
  if (!baseline.empty())
    kept_.baseline = baseline;
  else if (!fs::exists(kept_.baseline / "baseline.json"))
    kept_.baseline.clear();
  std::ifstream in(folder_ / "review.json");
  if (!in) return;
  const Json json = parse_json(in);
  if (!json.is_object() || !json.contains("decisions"))
    throw std::runtime_error((folder_ / "review.json").string() + ": not a review");
  for (const SceneResult& scene : kept_.run.scenes) {
    const auto found = json["decisions"].find(scene.request.name);
    if (found == json["decisions"].end() || found->value("picture", "") != picture_of(scene)) continue;
    decisions_[scene.request.name] = {found->value("decision", "") == "accepted", found->value("stored", false),
                                      found->value("note", ""), found->value("picture", "")};
  }
}

Json Review::state() const {
  Json json{{"baseline", kept_.baseline.string()}, {"decisions", Json::object()}};
  for (const auto& [scene, d] : decisions_)
    json["decisions"][scene] = {{"decision", d.accepted ? "accepted" : "refused"},
                                {"note", d.note},
                                {"stored", d.stored},
                                {"picture", d.picture}};
  return json;
}

void Review::write() const { write_report(json_text(state(), 1) + "\n", folder_ / "review.json"); }

const SceneResult& Review::changed(const std::string& scene) const {
  for (const SceneResult& s : kept_.run.scenes) {
    if (s.request.name != scene) continue;
    if (s.passed()) throw std::runtime_error(scene + " did not change: there is nothing to decide");
    return s;
  }
  throw std::runtime_error("there is no scene " + scene + " in this run");
}

void Review::decide(const std::string& scene, const std::string& decision, const std::string& note) {
  const SceneResult& of = changed(scene);
  if (decision == "open") {
    decisions_.erase(scene);
  } else if (decision == "accepted" || decision == "refused") {
    if (decision == "accepted" && of.native_picture.empty() && of.status != Status::removed)
      throw std::runtime_error(scene + " has no picture to accept: " + of.reason);
    decisions_[scene] = {decision == "accepted", false, note, picture_of(of)};
  } else {
    throw std::runtime_error("a decision is accepted, refused or open");
  }
  write();
}

std::vector<std::string> Review::store() {
  if (kept_.baseline.empty())
    throw std::runtime_error(
        "there are no stored pictures where the run found its baseline: name the folder with --baseline FOLDER");
  Run accepted;
  accepted.native_version = kept_.run.native_version, accepted.started = kept_.run.started;
  std::map<std::string, std::string> notes;
  for (const SceneResult& scene : kept_.run.scenes) {
    const auto found = decisions_.find(scene.request.name);
    if (found == decisions_.end() || !found->second.accepted || found->second.stored) continue;
    accepted.scenes.push_back(scene);
    notes[scene.request.name] = found->second.note;
  }
  const std::vector<std::string> changes = update_baseline(accepted, kept_.baseline, false, notes);
  for (const auto& [scene, note] : notes) decisions_[scene].stored = true;
  if (!notes.empty()) write();
  return changes;
}

Review::Left Review::left() const {
  Left left;
  for (const SceneResult& scene : kept_.run.scenes) {
    if (!scene.failed()) continue;
    const auto found = decisions_.find(scene.request.name);
    if (found == decisions_.end())
      ++left.undecided;
    else if (!found->second.accepted)
      ++left.refused;
    else
      left.not_stored += !found->second.stored;
  }
  return left;
}

void Review::write_markdown(const fs::path& file) const {
  const fs::path pictures = file.parent_path() / (file.stem().string() + "_pictures");
  const Left now = left();
  const auto changes = std::count_if(kept_.run.scenes.begin(), kept_.run.scenes.end(),
                                     [](const SceneResult& scene) { return scene.failed(); });
  std::string out = fmt::format(
      "### {} {} of {} scenes changed\n\n{} to decide, {} refused, {} accepted and not stored yet.\n\n",
      changes == 0 ? "✅" : "❌", changes, kept_.run.scenes.size(), now.undecided, now.refused, now.not_stored);
  if (changes > 0) out += "| scene | reference, change, difference | why | decision |\n| --- | --- | --- | --- |\n";
  for (const SceneResult& scene : kept_.run.scenes) {
    if (!scene.failed()) continue;
    fs::create_directories(pictures);
    const std::string name = file_stem(scene.request.name) + ".png";
    const bool drawn = write_strip(scene, pictures / name);
    const auto found = decisions_.find(scene.request.name);
    const std::string decision = found == decisions_.end()
                                     ? "open"
                                     : fmt::format("{}{}{}", found->second.accepted ? "accepted" : "refused",
                                                   found->second.note.empty() ? "" : ": ", found->second.note);
    out += fmt::format("| {} | {} | {} | {} |\n", markdown_cell(scene.request.name),
                       drawn ? fmt::format("![](<{}/{}>)", pictures.filename().string(), name) : "",
                       markdown_cell(why(scene)), markdown_cell(decision));
  }
  write_report(out, file);
}

}  // namespace verisim::compare
