// The table as text: for a terminal, for editors, as one page, as a grammar.
#include <algorithm>
#include <set>

#include "parser/keywords/keywords.h"
#include "parser/lexer/words.h"

namespace verisim::parser {
namespace {

// A place as people say it.
std::string spoken(std::string_view place) {
  if (place == "scene") return "between statements";
  if (place == "value") return "behind #declare NAME =";
  if (place == "#") return "anywhere";
  if (place == "expression") return "expressions";
  if (place == "@object") return "wherever an object may stand";
  if (place == "@modifier") return "every object";
  if (place == "@transform") return "everything that can be transformed";
  if (place == "@pattern" || place == "@modified") return "pigment, normal, texture, density";
  if (place == "@mapped") return "pigment, density";
  if (place == "@image") return "image_map, bump_map, material_map, image_pattern, height_field";
  if (place == "@texel") return "image_map, bump_map, material_map, image_pattern";
  if (place == "#default") return "#default";
  if (place == "component") return "components of blob";
  if (place == "function_pattern") return "function { pattern { } }";
  std::string text(place);
  if (place.starts_with('+')) return "behind " + text.substr(1);
  for (const std::string_view whole : {"global_", "object_", "light_", "finish_", "mesh_"}) {
    if (!place.starts_with(whole) || place == "object_pattern" || place == "light_source" || place == "light_group" ||
        place == "global_settings" || place == "mesh_camera")
      continue;
    text[whole.size() - 1] = ' ';
    if (whole == "global_") text = "global_settings " + text.substr(whole.size());
  }
  return text;
}

std::string places_in_words(const Keyword& keyword) {
  std::string text;
  std::string_view rest = keyword.places;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    text += (text.empty() ? "" : ", ") + spoken(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return text.empty() ? "nowhere" : text;
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t columns) {
  std::string out(indent, ' ');
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > indent && column + 1 + end > columns) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      out += ' ';
      ++column;
    }
    out += text.substr(0, end);
    column += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + "\n";
}

// Text between backquotes that may not end a cell of a table.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '>' || c == '*' || c == '_') out += '\\';
    out += c;
  }
  return out;
}

void add_words(std::string& out, std::string_view scope, std::string_view before,
               const std::set<std::string_view>& words) {
  out += ",\n    { \"name\": \"" + std::string(scope) + ".pov\", \"match\": \"" + std::string(before) + "\\\\b(";
  bool first = true;
  for (const std::string_view word : words) {
    if (!first) out += '|';
    out += word;
    first = false;
  }
  out += ")\\\\b\" }";
}

}  // namespace

std::string keyword_text(std::string_view word) {
  std::string out;
  for (const Keyword* use : keyword_uses(word)) {
    if (!out.empty()) out += "\n";
    out += use->syntax.empty() ? std::string(word) + "\n" : wrapped(use->syntax, 0, 100);
    out += wrapped(use->meaning, 2, 100);
    out += wrapped("In: " + places_in_words(*use) + ".", 2, 100);
    if (!use->fallback.empty()) out += wrapped("Without it: " + std::string(use->fallback) + ".", 2, 100);
  }
  return out;
}

std::string keyword_markdown(std::string_view word, std::string_view place) {
  std::vector<const Keyword*> uses = keyword_uses(word);
  const auto fits = [&](const Keyword* use) { return may_stand(*use, place); };
  if (std::any_of(uses.begin(), uses.end(), fits)) std::erase_if(uses, [&](const Keyword* use) { return !fits(use); });
  std::string out;
  for (const Keyword* use : uses) {
    if (!out.empty()) out += "\n---\n";
    out +=
        "```pov\n" + std::string(use->syntax.empty() ? word : use->syntax) + "\n```\n" + escaped(use->meaning) + "\n";
    if (!use->fallback.empty()) out += "\nWithout it: " + escaped(use->fallback) + "\n";
    out += "\nIn: " + escaped(places_in_words(*use)) + "\n";
  }
  return out;
}

std::string language_page() {
  std::string out =
      "# The scene description language\n\n"
      "Every word of POV-Ray 3.7's scene description language: what it takes, what holds without it, what it does, and "
      "where it may stand. `verisim help WORD` prints an entry, `verisim lsp` shows it in an editor. A test asks the "
      "parser about every word in every place, so this page says what verisim accepts. In the syntax, `[ ]` may be "
      "left out, `...` is repeated and words in capitals stand for values.\n\n";
  for (const KeywordSection& section : keyword_sections())
    out += "- [" + std::string(section.title) + "](#" + std::string(section.name) + ")\n";
  for (const KeywordSection& section : keyword_sections()) {
    out += "\n<a id=\"" + std::string(section.name) + "\"></a>\n\n## " + std::string(section.title) + "\n\n" +
           std::string(section.opening) + "\n\n";
    for (const std::string_view pictured : {"shapes", "patterns", "textures"})
      if (section.name == pictured)
        out += "![" + std::string(section.title) + "](" + std::string(pictured) + ".png)\n\n";
    out += "| word | syntax | without it | what it does | where |\n| --- | --- | --- | --- | --- |\n";
    for (const Keyword& k : section.keywords) {
      std::string syntax;
      for (const char c : k.syntax) syntax += c == '|' ? std::string("\\|") : std::string(1, c);
      out += "| `" + std::string(k.word) + "` | " + (syntax.empty() ? "" : "`" + syntax + "`") + " | " +
             escaped(k.fallback) + " | " + escaped(k.meaning) + " | " + escaped(places_in_words(k)) + " |\n";
    }
  }
  return out;
}

std::string text_mate_grammar() {
  std::set<std::string_view> directives, objects, functions, constants, colors, rest;
  for (const WordEntry& entry : all_words()) {
    bool directive = false, object = false;
    for (const Keyword* use : keyword_uses(entry.text)) {
      directive |= may_stand(*use, "#");
      object |= may_stand(*use, "scene") || may_stand(*use, "value");
    }
    if (directive) directives.insert(entry.text);
    if (entry.word_class == WordClass::color)
      colors.insert(entry.text);
    else if (entry.word_class != WordClass::keyword)
      (keyword_uses(entry.text).front()->syntax.find('(') == std::string_view::npos ? constants : functions)
          .insert(entry.text);
    else
      (object ? objects : rest).insert(entry.text);
  }
  std::string out = R"TM({
  "$schema": "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json",
  "name": "POV-Ray SDL",
  "scopeName": "source.pov",
  "fileTypes": ["pov", "inc", "mcr"],
  "patterns": [
    { "include": "#comment" },
    { "name": "comment.line.double-slash.pov", "match": "//.*$" },
    { "name": "string.quoted.double.pov", "begin": "\"", "end": "\"",
      "patterns": [{ "name": "constant.character.escape.pov", "match": "\\\\." }] },
    { "match": "(#\\s*macro)\\s+([A-Za-z_]\\w*)",
      "captures": { "1": { "name": "keyword.control.directive.pov" }, "2": { "name": "entity.name.function.pov" } } },
    { "match": "(#\\s*(?:declare|local))\\s+([A-Za-z_]\\w*)",
      "captures": { "1": { "name": "keyword.control.directive.pov" }, )TM"
                    R"TM("2": { "name": "variable.other.declaration.pov" } } },
    { "name": "constant.numeric.pov", "match": "(?<![\\w.])(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?(?!\\w)" })TM";
  add_words(out, "keyword.control.directive", "#\\\\s*", directives);
  add_words(out, "storage.type.object", "", objects);
  add_words(out, "support.function", "", functions);
  add_words(out, "constant.language", "", constants);
  add_words(out, "support.constant.color", "", colors);
  add_words(out, "keyword.other", "", rest);
  out += R"TM(,
    { "match": "\\b([A-Za-z_]\\w*)(?=\\s*\\()", "name": "entity.name.function.call.pov" }
  ],
  "repository": {
    "comment": { "name": "comment.block.pov", "begin": "/\\*", "end": "\\*/", "patterns": [{ "include": "#comment" }] }
  }
}
)TM";
  return out;
}

}  // namespace verisim::parser
