// Where names are declared and used; what is in a file.
#include <algorithm>
#include <cctype>

#include "cli/lsp/features.h"
#include "parser/editing/place.h"
#include "parser/lexer/words.h"

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

using parser::NameDeclaration;
using parser::NameUse;

// The name at a place, with what it means.
struct Named {
  std::vector<SceneFile> files;
  std::string name;
  std::size_t offset = 0;
  Meaning meaning;
  // Declared in one file only for a part of it.
  bool local() const { return meaning && !meaning.declaration->global; }
};

std::optional<Named> name_at(const Question& q) {
  const parser::EditPlace place = parser::place_at(q.document.index().tokens(), q.document.text->str(), q.offset);
  if (place.in != parser::EditPlace::In::code) return std::nullopt;
  const NameUse* use = q.document.index().use_at(q.offset);
  if (!use) return std::nullopt;
  Named named;
  named.files = q.workspace.files_of(q.document);
  named.name = use->name;
  named.offset = use->offset;
  named.meaning = q.workspace.meaning(named.files, q.document, use->name, use->offset);
  return named;
}

Json location(const Workspace& workspace, const SceneFile& file, std::size_t offset, std::size_t length) {
  return {{"uri", file.uri}, {"range", range_json(*file.text, offset, offset + length, workspace.columns())}};
}

// Where a name means the same, file by file.
struct Uses {
  const SceneFile* file;
  std::vector<NameUse> uses;
};

std::vector<Uses> uses_of(const Question& q, const Named& named) {
  std::vector<Uses> all;
  for (const SceneFile& file : named.files) {
    if (file.uri == q.document.uri) {
      all.push_back({&file, file.index->same_name(named.name, named.offset)});
      continue;
    }
    if (named.local()) continue;
    Uses uses{&file, {}};
    for (const NameUse& use : file.index->uses()) {
      if (use.name != named.name) continue;
      const NameDeclaration* d = file.index->meaning(use.name, use.offset);
      if (!d || d->global) uses.uses.push_back(use);
    }
    if (!uses.uses.empty()) all.push_back(std::move(uses));
  }
  return all;
}

bool is_declaration(const SceneFile& file, const NameUse& use) {
  const auto& all = file.index->declarations();
  return std::any_of(all.begin(), all.end(), [&](const NameDeclaration& d) { return d.offset == use.offset; });
}

}  // namespace

Json definition(const Question& q) {
  const parser::TokenFile& tokens = q.document.index().tokens();
  const parser::EditPlace place = parser::place_at(tokens, q.document.text->str(), q.offset);
  if (place.in == parser::EditPlace::In::string && place.opener == parser::Word::include) {
    const std::string name(tokens.raw_string(parser::token_at(tokens, q.offset)));
    for (const SceneFile& file : q.workspace.files_of(q.document))
      if (!file.path.empty() && file.path.string().ends_with("/" + name)) return location(q.workspace, file, 0, 0);
    return nullptr;
  }
  const std::optional<Named> named = name_at(q);
  if (!named || !named->meaning) return nullptr;
  return location(q.workspace, *named->meaning.file, named->meaning.declaration->offset, named->name.size());
}

Json references(const Question& q, bool with_declarations) {
  const std::optional<Named> named = name_at(q);
  if (!named) return nullptr;
  Json found = Json::array();
  for (const Uses& uses : uses_of(q, *named))
    for (const NameUse& use : uses.uses)
      if (with_declarations || !is_declaration(*uses.file, use))
        found.push_back(location(q.workspace, *uses.file, use.offset, use.name.size()));
  return found;
}

Json document_highlight(const Question& q) {
  const NameUse* use = q.document.index().use_at(q.offset);
  if (!use) return nullptr;
  Json found = Json::array();
  for (const NameUse& same : q.document.index().same_name(use->name, use->offset))
    found.push_back(
        {{"range", range_json(*q.document.text, same.offset, same.offset + same.name.size(), q.workspace.columns())}});
  return found;
}

Json prepare_rename(const Question& q) {
  const std::optional<Named> named = name_at(q);
  if (!named) return nullptr;
  if (named->meaning && named->meaning.file->standard)
    throw RequestError(kRequestFailed, named->name + " is declared in " + named->meaning.file->path.string() +
                                           ", which belongs to POV-Ray: it cannot be renamed.");
  return {
      {"range", range_json(*q.document.text, named->offset, named->offset + named->name.size(), q.workspace.columns())},
      {"placeholder", named->name}};
}

Json rename(const Question& q, const std::string& name) {
  if (prepare_rename(q).is_null()) throw RequestError(kRequestFailed, "There is no name here.");
  const std::optional<Named> named = name_at(q);
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (name.empty() || name.size() > 40 || std::isdigit(static_cast<unsigned char>(name[0])) ||
      !std::all_of(name.begin(), name.end(), fits))
    throw RequestError(kInvalidParams, "A name has up to 40 letters, digits and '_', and does not begin with a digit.");
  for (const parser::WordEntry& word : parser::all_words())
    if (word.text == name) throw RequestError(kInvalidParams, "'" + name + "' is a word of the language.");
  if (name == named->name) return {{"changes", Json::object()}};
  const std::vector<Uses> all = uses_of(q, *named);
  for (const Uses& uses : all) {
    if (uses.file->standard)
      throw RequestError(kRequestFailed, named->name + " is used in " + uses.file->path.string() +
                                             ", which belongs to POV-Ray: it cannot be renamed.");
    for (const NameUse& use : uses.uses) {
      const NameDeclaration* taken = uses.file->index->meaning(name, use.offset);
      const auto& names = uses.file->index->uses();
      const bool used = std::any_of(names.begin(), names.end(), [&](const NameUse& u) { return u.name == name; });
      if (taken || used)
        throw RequestError(kRequestFailed, "The name '" + name + "' is used already in " +
                                               (uses.file->path.empty() ? "this file" : uses.file->path.string()) +
                                               ".");
    }
  }
  Json changes = Json::object();
  for (const Uses& uses : all)
    for (const NameUse& use : uses.uses)
      changes[uses.file->uri].push_back(
          {{"range", range_json(*uses.file->text, use.offset, use.offset + use.name.size(), q.workspace.columns())},
           {"newText", name}});
  return {{"changes", changes}};
}

namespace {

// SymbolKind of the protocol.
enum Symbol { kFile = 1, kModule = 2, kClass = 5, kFunction = 12, kVariable = 13, kObject = 19 };

// Blocks that stand between statements: objects, lights, the camera, settings.
struct Block {
  std::size_t begin = 0, end = 0, word_end = 0;
  std::string name;
};

std::vector<Block> blocks_of(const parser::NameIndex& index) {
  std::vector<Block> blocks;
  const parser::TokenFile& file = index.tokens();
  const parser::Tokens& tokens = file.tokens;
  int depth = 0;
  std::size_t opened = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const char c = tokens[i].punctuation;
    if (tokens[i].kind != parser::TokenKind::punctuation) continue;
    if (c == '{' && depth++ == 0) opened = i;
    if (c != '}' || depth == 0 || --depth > 0 || opened == 0) continue;
    const parser::Token& word = tokens[opened - 1];
    const bool value = opened > 1 && tokens[opened - 2].punctuation == '=';
    if (word.kind != parser::TokenKind::word || value) continue;
    Block block{word.offset, tokens[i].offset + std::size_t{1}, word.offset + file.length(word),
                std::string(parser::spelling(word.word))};
    if (word.word == parser::Word::object && tokens[opened + 1].kind == parser::TokenKind::identifier)
      block.name +=
          " " + std::string(file.source->text().substr(tokens[opened + 1].offset, file.length(tokens[opened + 1])));
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace

Json document_symbols(Workspace& workspace, const Document& document) {
  const parser::NameIndex& index = document.index();
  const Text& text = *document.text;
  struct Entry {
    std::size_t begin, end;
    Json json;
  };
  std::vector<Entry> entries;
  const auto add = [&](const std::string& name, int kind, const std::string& detail, std::size_t begin, std::size_t end,
                       std::size_t name_begin, std::size_t name_end) {
    Json symbol{{"name", name},
                {"kind", kind},
                {"range", range_json(text, begin, end, workspace.columns())},
                {"selectionRange", range_json(text, name_begin, name_end, workspace.columns())},
                {"children", Json::array()}};
    if (!detail.empty()) symbol["detail"] = detail;
    entries.push_back({begin, end, std::move(symbol)});
  };
  SceneFile self{document.path, document.uri, document.text, &index, false};
  std::set<std::string> seen;  // each name once: where it is declared first
  for (const NameDeclaration& d : index.declarations()) {
    if (d.kind == NameDeclaration::Kind::parameter) continue;
    if (d.global && !seen.insert(d.name).second) continue;
    const bool macro = d.kind == NameDeclaration::Kind::macro;
    const auto value = workspace.value_of({&self, &d});
    add(d.name,
        macro                           ? kFunction
        : value && value->value.empty() ? kClass
                                        : kVariable,
        macro   ? written(workspace, {&self, &d}).substr(7 + d.name.size())
        : value ? value->kind + " " + value->value
                : "",
        std::min(d.whole.begin, d.offset), std::max(d.whole.end, d.offset + d.name.size()), d.offset,
        d.offset + d.name.size());
  }
  for (const parser::TextRange& include : index.includes())
    add(text.str().substr(include.begin, include.end - include.begin), kModule, "#include", include.begin, include.end,
        include.begin, include.end);
  for (const Block& block : blocks_of(index))
    add(block.name, kObject, "", block.begin, block.end, block.begin, block.word_end);
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
  });
  // What lies within a macro belongs to it.
  Json symbols = Json::array();
  for (std::size_t i = 0; i < entries.size();) {
    Json symbol = std::move(entries[i].json);
    const std::size_t end = entries[i].end;
    std::size_t next = i + 1;
    for (; next < entries.size() && entries[next].begin < end && entries[next].end <= end; ++next) {
      entries[next].json.erase("children");
      symbol["children"].push_back(std::move(entries[next].json));
    }
    if (symbol["children"].empty()) symbol.erase("children");
    symbols.push_back(std::move(symbol));
    i = next;
  }
  return symbols;
}

Json folding_ranges(const Workspace& workspace, const Document& document) {
  const Text& text = *document.text;
  Json folds = Json::array();
  const auto add = [&](std::size_t begin, std::size_t end, const char* kind) {
    const std::size_t first = text.point(begin, workspace.columns()).line,
                      last = text.point(end, workspace.columns()).line;
    if (last <= first) return;
    Json fold{{"startLine", first}, {"endLine", *kind ? last : last - 1}};
    if (*kind) fold["kind"] = kind;
    if (*kind || last - 1 > first) folds.push_back(std::move(fold));
  };
  for (const parser::TextRange& fold : document.index().folds()) add(fold.begin, fold.end, "");
  for (const parser::Comment& comment : parser::comments_of(document.index().tokens()))
    add(comment.begin, comment.end, "comment");
  return folds;
}

Json document_links(Workspace& workspace, const Document& document) {
  Json links = Json::array();
  const std::vector<SceneFile> files = workspace.files_of(document);
  const std::string& text = document.text->str();
  for (const parser::TextRange& range : document.index().includes()) {
    const std::string name = text.substr(range.begin, range.end - range.begin);
    for (const SceneFile& file : files)
      if (!file.path.empty() && file.path.string().ends_with("/" + name)) {
        links.push_back(
            {{"range", range_json(*document.text, range.begin, range.end, workspace.columns())}, {"target", file.uri}});
        break;
      }
  }
  return links;
}

}  // namespace verisim::cli::lsp
