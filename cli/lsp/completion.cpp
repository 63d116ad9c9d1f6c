// What may be written at a place: words of the language, names, macros, files.
#include <algorithm>
#include <set>

#include "cli/lsp/features.h"
#include "parser/editing/place.h"
#include "parser/keywords/keywords.h"
#include "parser/lexer/words.h"
#include "parser/source/suggest.h"

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

// CompletionItemKind of the protocol.
enum class CompletionKind {
  kFunction = 3,
  kVariable = 6,
  kClass = 7,
  kProperty = 10,
  kKeyword = 14,
  kColor = 16,
  kFile = 17,
  kFolder = 19,
  kConstant = 21
};

constexpr int kSnippet = 2;  // InsertTextFormat

class Items {
 public:
  Items(const Question& q, std::size_t begin)
      : range_(range_json(*q.document.text, begin, q.offset, q.workspace.columns())) {}

  Json& add(const std::string& label, CompletionKind kind, char rank, const std::string& insert = {}) {
    items_.push_back({{"label", label},
                      {"kind", static_cast<int>(kind)},
                      {"sortText", rank + parser::lowered(label)},
                      {"textEdit", {{"range", range_}, {"newText", insert.empty() ? label : insert}}}});
    return items_.back();
  }
  Json list() { return {{"isIncomplete", false}, {"items", std::move(items_)}}; }

 private:
  Json range_, items_ = Json::array();
};

void add_words(Items& items, const std::string& place, bool directives) {
  std::set<std::string_view> seen;
  for (const parser::KeywordSection& section : parser::keyword_sections())
    for (const parser::Keyword& keyword : section.keywords) {
      const bool expression = !directives && parser::may_stand(keyword, "expression");
      const bool here = directives      ? parser::may_stand(keyword, "#")
                        : place.empty() ? !parser::may_stand(keyword, "#")
                                        : parser::may_stand(keyword, place);
      // Nothing but statements stands between statements; and a word of directives needs its '#'.
      if (!here && (!expression || place == "scene")) continue;
      if (!directives && place == "scene" && parser::may_stand(keyword, "#")) continue;
      if (!seen.insert(keyword.word).second) continue;
      const bool function = expression && keyword.syntax.find('(') != std::string_view::npos;
      Json& item = items.add(std::string(keyword.word),
                             function     ? CompletionKind::kFunction
                             : expression ? CompletionKind::kConstant
                                          : CompletionKind::kKeyword,
                             here && !expression ? '1' : '4');
      item["detail"] = keyword.syntax;
      item["documentation"] = keyword.meaning;
    }
}

void add_names(Items& items, const Question& q) {
  using Declaration = parser::NameDeclaration;
  std::set<std::string> seen;
  const std::vector<SceneFile> files = q.workspace.files_of(q.document);
  const auto add = [&](const SceneFile& file, const Declaration& d, char rank) {
    if (!seen.insert(d.name).second) return;
    const Meaning meaning{&file, &d};
    if (d.kind == Declaration::Kind::macro) {
      std::string insert = d.name + "(";
      for (std::size_t i = 0; i < d.parameters.size(); ++i)
        insert += (i ? ", ${" : "${") + std::to_string(i + 1) + ":" + d.parameters[i] + "}";
      Json& item = items.add(d.name, CompletionKind::kFunction, rank, insert + ")");
      item["insertTextFormat"] = kSnippet;
      item["detail"] = written(q.workspace, meaning);
      return;
    }
    const auto value = q.workspace.value_of(meaning);
    const bool color = value && value->kind.find("colo") != std::string::npos;
    const bool block = value && value->value.empty();
    Json& item = items.add(d.name,
                           color   ? CompletionKind::kColor
                           : block ? CompletionKind::kClass
                                   : CompletionKind::kVariable,
                           rank);
    if (value) item["detail"] = value->kind + (value->value.empty() ? "" : " " + value->value);
  };
  for (const SceneFile& file : files)
    if (file.uri == q.document.uri)
      for (const Declaration& d : file.index->declarations())
        if (d.scope.contains(q.offset) && d.offset != q.offset) add(file, d, d.global ? '2' : '0');
  for (const SceneFile& file : files)
    for (const Declaration& d : file.index->declarations())
      if (d.global) add(file, d, file.standard ? '3' : '2');
}

bool has_extension(const fs::path& path, std::initializer_list<const char*> extensions) {
  const std::string own = parser::lowered(path.extension().string());
  return std::any_of(extensions.begin(), extensions.end(), [&](const char* e) { return own == e; });
}

// Files that fit behind the word before the string; folders lead on.
void add_files(Items& items, const Question& q, const parser::EditPlace& place) {
  const std::string& text = q.document.text->str();
  const std::string typed = text.substr(place.begin, q.offset - place.begin);
  const std::size_t slash = typed.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : typed.substr(0, slash + 1);
  const bool include = place.opener == parser::Word::include;
  const auto fits = [&](const fs::path& path) {
    if (include) return has_extension(path, {".inc", ".mcr", ".pov"});
    if (place.opener == parser::Word::ttf) return has_extension(path, {".ttf", ".ttc", ".otf"});
    if (place.opener == parser::Word::df3) return has_extension(path, {".df3"});
    return has_extension(path, {".png", ".jpg", ".jpeg", ".gif", ".tga", ".bmp", ".tif", ".tiff", ".exr", ".hdr",
                                ".ppm", ".pgm", ".iff", ".df3", ".ttf", ".txt", ".dat", ".csv"});
  };
  std::vector<fs::path> folders{q.document.path.parent_path()};
  for (const fs::path& path : q.workspace.library_paths(q.document.path)) folders.push_back(path);
  std::set<std::string> seen;
  for (const fs::path& base : folders) {
    std::error_code failed;
    int count = 0;
    for (fs::directory_iterator i(base / folder, failed), end; !failed && i != end && count < 2000;
         i.increment(failed)) {
      const std::string name = i->path().filename().string();
      if (name.starts_with('.') || !seen.insert(name).second) continue;
      const bool directory = i->is_directory(failed);
      if (!directory && !fits(i->path())) continue;
      ++count;
      items.add(folder + name + (directory ? "/" : ""), directory ? CompletionKind::kFolder : CompletionKind::kFile,
                base == folders.front() ? '1' : '2');
    }
  }
}

}  // namespace

Json completion(const Question& q) {
  const parser::EditPlace place = parser::place_at(q.document.index().tokens(), q.document.text->str(), q.offset);
  Items items(q, place.begin);
  if (place.in == parser::EditPlace::In::comment) return items.list();
  if (place.in == parser::EditPlace::In::string) {
    add_files(items, q, place);
    return items.list();
  }
  if (place.behind_hash) {
    add_words(items, "#", true);
    return items.list();
  }
  if (place.behind_dot) {
    for (const char* part : {"x", "y", "z", "t", "u", "v", "red", "green", "blue", "filter", "transmit", "gray"})
      items.add(part, CompletionKind::kProperty, '1');
    return items.list();
  }
  const bool in_list =
      place.opener != parser::Word::none && !parser::keyword_uses(parser::spelling(place.opener)).empty();
  if (in_list) {  // words that stand right behind another
    const std::string behind = "+" + std::string(parser::spelling(place.opener));
    for (const parser::KeywordSection& section : parser::keyword_sections())
      for (const parser::Keyword& keyword : section.keywords)
        if (parser::may_stand(keyword, behind)) items.add(std::string(keyword.word), CompletionKind::kKeyword, '0');
  }
  add_words(items, place.place, false);
  add_names(items, q);
  return items.list();
}

}  // namespace verisim::cli::lsp
