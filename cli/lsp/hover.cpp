// What a word or a name means.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "cli/lsp/features.h"
#include "parser/editing/place.h"
#include "parser/keywords/keywords.h"

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

std::string trimmed(std::string text) {
  const auto blank = [](unsigned char c) { return std::isspace(c) != 0; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  std::size_t begin = 0;
  while (begin < text.size() && blank(text[begin])) ++begin;
  return text.substr(begin);
}

// The colour that a value of five numbers shows, as a style sheet writes it; empty: it is none.
std::string color_of(const DeclaredName& name) {
  if (name.kind.find("color") == std::string::npos && name.kind.find("colour") == std::string::npos) return {};
  double c[3];
  if (std::sscanf(name.value.c_str(), "<%lf, %lf, %lf", &c[0], &c[1], &c[2]) != 3) return {};
  int byte[3];
  for (int i = 0; i < 3; ++i) {
    const double linear = std::clamp(c[i], 0.0, 1.0);
    const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    byte[i] = static_cast<int>(std::lround(encoded * 255));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", byte[0], byte[1], byte[2]);
}

Json markdown(const std::string& text) { return {{"kind", "markdown"}, {"value", text}}; }

std::string describe_name(Workspace& workspace, const Meaning& meaning) {
  std::string text = "```pov\n" + written(workspace, meaning) + "\n```\n";
  if (const auto value = workspace.value_of(meaning)) {
    text += "A " + value->kind;
    if (const std::string color = color_of(*value); !color.empty()) text += ", " + color + " on the screen";
    text += ".\n";
  }
  const bool parameter = meaning.declaration->kind == parser::NameDeclaration::Kind::parameter;
  const std::string comment =
      parameter ? ""
                : comment_above(*meaning.file->text, meaning.file->index->tokens(), meaning.declaration->whole.begin);
  if (!comment.empty()) text += "\n" + comment + "\n";
  const Point at = meaning.file->text->point(meaning.declaration->offset, workspace.columns());
  const std::string name =
      meaning.file->path.empty() ? std::string("this file") : meaning.file->path.filename().string();
  text += fmt::format("\n{} in {}, line {}.\n", parameter ? "Parameter" : "Declared", name, at.line + 1);
  return text;
}

}  // namespace

std::string comment_above(const Text& text, const parser::TokenFile& tokens, std::size_t offset) {
  const std::string& all = text.str();
  // Comments that end on the line before, and those that end before them.
  std::vector<std::string> lines;
  std::size_t below = offset;
  const std::vector<parser::Comment> comments = parser::comments_of(tokens);
  for (auto comment = comments.rbegin(); comment != comments.rend() && lines.size() < 30; ++comment) {
    if (comment->end > below) continue;
    const std::string_view between(all.data() + comment->end, below - comment->end);
    if (std::count(between.begin(), between.end(), '\n') > 1 ||
        between.find_first_not_of(" \t\r\n") != std::string_view::npos)
      break;
    const std::size_t line = all.find_last_of('\n', comment->begin);
    const std::size_t start = line == std::string::npos ? 0 : line + 1;
    if (all.find_first_not_of(" \t", start) != comment->begin) break;  // it belongs to what stands before it
    std::istringstream body(all.substr(comment->begin, comment->end - comment->begin));
    std::vector<std::string> own;
    for (std::string one; std::getline(body, one);) {
      one = trimmed(std::move(one));
      while (!one.empty() && (one.front() == '/' || one.front() == '*')) one.erase(0, 1);
      while (!one.empty() && (one.back() == '/' || one.back() == '*')) one.pop_back();
      own.push_back(trimmed(std::move(one)));
    }
    lines.insert(lines.begin(), own.begin(), own.end());
    below = start;
  }
  std::string out;
  for (const std::string& line : lines)
    if (line.find_first_not_of("-=_*/#+~ ") != std::string::npos) out += (out.empty() ? "" : "\n") + line;
  return out;
}

std::string written(const Workspace& workspace, const Meaning& meaning) {
  const parser::NameDeclaration& d = *meaning.declaration;
  using Kind = parser::NameDeclaration::Kind;
  switch (d.kind) {
    case Kind::macro: {
      std::string text = "#macro " + d.name + "(";
      for (std::size_t i = 0; i < d.parameters.size(); ++i) text += (i ? ", " : "") + d.parameters[i];
      return text + ")";
    }
    case Kind::parameter:
      return d.name;
    case Kind::file:
      return "#fopen " + d.name;
    case Kind::variable:
      break;
  }
  const std::string& text = meaning.file->text->str();
  const std::string_view directive = std::string_view(text).substr(d.whole.begin, d.offset - d.whole.begin);
  std::string out = directive.find("local") != std::string_view::npos ? "#local " : "#declare ";
  if (directive.find("for") != std::string_view::npos) out = "#for ";
  out += d.name;
  if (const auto value = workspace.value_of(meaning))
    if (!value->value.empty()) out += (value->value.starts_with('[') ? " = array" : " = ") + value->value;
  return out;
}

Json hover(const Question& q) {
  const parser::NameIndex& index = q.document.index();
  const parser::TokenFile& tokens = index.tokens();
  const parser::EditPlace place = parser::place_at(tokens, q.document.text->str(), q.offset);
  if (place.in == parser::EditPlace::In::comment) return nullptr;
  const parser::Token& token = parser::token_at(tokens, q.offset);
  const auto answer = [&](const std::string& text) -> Json {
    if (text.empty()) return nullptr;
    return {{"contents", markdown(text)},
            {"range",
             range_json(*q.document.text, token.offset, token.offset + tokens.length(token), q.workspace.columns())}};
  };
  switch (token.kind) {
    case parser::TokenKind::word:
      return answer(parser::keyword_markdown(
          tokens.source->text().substr(token.offset, tokens.length(token)),
          parser::word_class(token.word) == parser::WordClass::keyword ? place.place : "expression"));
    case parser::TokenKind::directive:
      return answer(parser::keyword_markdown(parser::spelling(token.word), "#"));
    case parser::TokenKind::identifier: {
      const parser::NameUse* use = index.use_at(q.offset);
      if (!use) return nullptr;
      const std::vector<SceneFile> files = q.workspace.files_of(q.document);
      const Meaning meaning = q.workspace.meaning(files, q.document, use->name, use->offset);
      return meaning ? answer(describe_name(q.workspace, meaning)) : Json(nullptr);
    }
    case parser::TokenKind::string: {
      if (place.opener != parser::Word::include) return nullptr;
      const std::string name(tokens.raw_string(token));
      for (const SceneFile& file : q.workspace.files_of(q.document))
        if (!file.path.empty() && file.path.string().ends_with("/" + name)) return answer(file.path.string() + "\n");
      return nullptr;
    }
    default:
      return nullptr;
  }
}

namespace {

// The call around an offset: whose parenthesis is open, and in which argument the offset is.
struct Call {
  std::string name;
  std::size_t argument = 0;
};

std::optional<Call> call_at(const parser::TokenFile& file, std::size_t offset) {
  struct Open {
    char bracket;
    std::string name;
    std::size_t argument = 0;
  };
  std::vector<Open> open;
  const parser::Tokens& tokens = file.tokens;
  const auto is_operand = [](const parser::Token& t) {
    return t.kind == parser::TokenKind::identifier || t.kind == parser::TokenKind::number ||
           t.kind == parser::TokenKind::vector || t.punctuation == ')' || t.punctuation == ']';
  };
  for (std::size_t i = 0; i < tokens.size() && tokens[i].offset < offset; ++i) {
    const parser::Token& t = tokens[i];
    if (t.kind == parser::TokenKind::directive || t.punctuation == ';') open.clear();
    if (t.kind != parser::TokenKind::punctuation) continue;
    switch (t.punctuation) {
      case '(': {
        std::string name;
        if (i && (tokens[i - 1].kind == parser::TokenKind::identifier || tokens[i - 1].kind == parser::TokenKind::word))
          name = file.source->text().substr(tokens[i - 1].offset, file.length(tokens[i - 1]));
        open.push_back({'(', std::move(name)});
        break;
      }
      case '<':
        if (i && !is_operand(tokens[i - 1])) open.push_back({'<', {}});
        break;
      case '{':
      case '[':
        open.push_back({t.punctuation, {}});
        break;
      case '>':
        if (!open.empty() && open.back().bracket == '<') open.pop_back();
        break;
      case ')':
      case '}':
      case ']':
        if (!open.empty()) open.pop_back();
        break;
      case ',':
        if (!open.empty()) ++open.back().argument;
        break;
      default:
        break;
    }
  }
  for (auto o = open.rbegin(); o != open.rend(); ++o) {
    if (o->bracket == '{') return std::nullopt;
    if (o->bracket == '(' && !o->name.empty()) return Call{o->name, o->argument};
  }
  return std::nullopt;
}

// A signature with its parameters, "name(A, B [, C])".
Json signature(const std::string& label, const std::string& documentation, std::size_t argument) {
  Json parameters = Json::array();
  const std::size_t open = label.find('('), close = label.rfind(')');
  if (open != std::string::npos && close != std::string::npos) {
    std::size_t begin = open + 1;
    int depth = 0;
    for (std::size_t i = begin; i <= close; ++i) {
      const char c = label[i];
      depth += (c == '<' || c == '(') - ((c == '>' || c == ')') && i != close);
      if ((c != ',' || depth > 0) && i != close) continue;
      while (begin < i && (label[begin] == ' ' || label[begin] == '[')) ++begin;
      std::size_t end = i;
      while (end > begin && (label[end - 1] == ' ' || label[end - 1] == '[' || label[end - 1] == ']')) --end;
      if (end > begin) parameters.push_back({{"label", {begin, end}}});
      begin = i + 1;
    }
  }
  const std::size_t last = parameters.empty() ? 0 : parameters.size() - 1;
  Json entry{{"label", label}, {"parameters", parameters}, {"activeParameter", std::min(argument, last)}};
  if (!documentation.empty()) entry["documentation"] = markdown(documentation);
  return {{"signatures", Json::array({entry})}, {"activeSignature", 0}, {"activeParameter", std::min(argument, last)}};
}

}  // namespace

Json signature_help(const Question& q) {
  const parser::NameIndex& index = q.document.index();
  const std::optional<Call> call = call_at(index.tokens(), q.offset);
  if (!call) return nullptr;
  for (const parser::Keyword* use : parser::keyword_uses(call->name))
    if (parser::may_stand(*use, "expression") && use->syntax.find('(') != std::string_view::npos)
      return signature(std::string(use->syntax), std::string(use->meaning), call->argument);
  const std::vector<SceneFile> files = q.workspace.files_of(q.document);
  const Meaning meaning = q.workspace.meaning(files, q.document, call->name, q.offset);
  if (!meaning || meaning.declaration->kind != parser::NameDeclaration::Kind::macro) return nullptr;
  return signature(written(q.workspace, meaning).substr(7),
                   comment_above(*meaning.file->text, meaning.file->index->tokens(), meaning.declaration->whole.begin),
                   call->argument);
}

}  // namespace verisim::cli::lsp
