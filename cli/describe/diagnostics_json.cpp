#include "cli/describe/diagnostics_json.h"

#include <algorithm>
#include <map>

#include "compare/json_text.h"
#include "tracer/base/output_file.h"

namespace verisim::cli {
namespace {

// SARIF's levels are error, warning and note.
const char* level_of(parser::Severity severity) {
  return severity == parser::Severity::error || severity == parser::Severity::unsupported ? "error" : "warning";
}

nlohmann::json place_json(const parser::Excerpt& place) {
  return {{"file", place.file}, {"line", place.line}, {"column", place.column}, {"length", place.length}};
}

nlohmann::json location(const parser::Excerpt& place) {
  nlohmann::json where{{"artifactLocation", {{"uri", place.file}}}};
  if (place.line > 0) {
    where["region"] = {{"startLine", place.line}};
    if (place.column > 0) {
      where["region"]["startColumn"] = place.column;
      where["region"]["endColumn"] = place.column + std::max(place.length, 1);
    }
  }
  return {{"physicalLocation", where}};
}

}  // namespace

const char* name_of(parser::Severity severity) {
  switch (severity) {
    case parser::Severity::warning:
      return "warning";
    case parser::Severity::possible_error:
      return "possible error";
    case parser::Severity::error:
      return "error";
    case parser::Severity::unsupported:
      return "unsupported";
  }
  return "";
}

nlohmann::json as_json(const parser::Diagnostic& d) {
  nlohmann::json out = place_json(d);
  out.update({{"severity", name_of(d.severity)},
              {"code", parser::name(d.code)},
              {"message", d.message},
              {"advice", d.advice},
              {"source", d.source_line},
              {"trail", d.trail}});
  out["related"] = nlohmann::json::array();
  for (const parser::Related& r : d.related) {
    nlohmann::json related = place_json(r.place);
    related["message"] = r.message;
    out["related"].push_back(std::move(related));
  }
  if (d.fix)
    out["fix"] = {{"title", d.fix->title},
                  {"file", d.fix->file},
                  {"offset", d.fix->offset},
                  {"length", d.fix->length},
                  {"text", d.fix->text}};
  return out;
}

void write_sarif(const std::vector<parser::Diagnostic>& diagnostics, const std::vector<OtherFinding>& others,
                 const std::string& file) {
  nlohmann::json rules = nlohmann::json::array(), results = nlohmann::json::array();
  for (const parser::CodeEntry& e : parser::all_codes())
    rules.push_back(
        {{"id", e.name}, {"shortDescription", {{"text", e.title}}}, {"fullDescription", {{"text", e.text}}}});
  for (const parser::Diagnostic& d : diagnostics) {
    nlohmann::json result{{"ruleId", parser::name(d.code)},
                          {"ruleIndex", static_cast<int>(d.code)},
                          {"level", level_of(d.severity)},
                          {"message", {{"text", d.advice.empty() ? d.message : d.message + " " + d.advice}}}};
    if (!d.file.empty()) result["locations"] = nlohmann::json::array({location(d)});
    for (const parser::Related& r : d.related) {
      nlohmann::json related = location(r.place);
      related["message"] = {{"text", r.message}};
      result["relatedLocations"].push_back(std::move(related));
    }
    results.push_back(std::move(result));
  }
  std::map<std::string_view, std::size_t> more;  // rules by name, behind the codes
  for (const OtherFinding& o : others) {
    const auto [rule, added] = more.emplace(o.rule, rules.size());
    if (added)
      rules.push_back(
          {{"id", o.rule}, {"shortDescription", {{"text", o.title}}}, {"fullDescription", {{"text", o.text}}}});
    nlohmann::json result{
        {"ruleId", o.rule}, {"ruleIndex", rule->second}, {"level", "note"}, {"message", {{"text", o.message}}}};
    if (!o.place.file.empty()) result["locations"] = nlohmann::json::array({location(o.place)});
    results.push_back(std::move(result));
  }
  const nlohmann::json driver{{"name", "verisim"}, {"version", VERISIM_VERSION}, {"rules", rules}};
  const nlohmann::json log{
      {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
      {"version", "2.1.0"},
      {"runs", nlohmann::json::array(
                   {{{"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", results}}})}};
  write_text_file(file, compare::json_text(log, 1) + "\n");
}

}  // namespace verisim::cli
