#include "cli/lsp/server.h"

#include <stdlib.h>
#include <unistd.h>

#include <fmt/format.h>

#include <csignal>
#include <functional>
#include <unordered_map>

#include "cli/lsp/diagnostics.h"
#include "cli/lsp/features.h"
#include "parser/editing/place.h"
#include "parser/keywords/keywords.h"

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

constexpr int kIncremental = 2;  // TextDocumentSyncKind

// A folder for what scenes write, removed at the end.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "verisim-lsp-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a folder for temporary files");
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

class Server {
 public:
  explicit Server(const ServerSettings& settings)
      : settings_(settings),
        connection_(settings.in, settings.out),
        workspace_(settings_.options, Columns::utf16),
        publisher_(connection_),
        analyst_(settings_.options, {settings.seconds, std::chrono::milliseconds(settings.delay_ms), settings.lints},
                 scratch_.path(), [this](auto analysis, const auto& lints) { read(std::move(analysis), lints); }) {
    publisher_.set_seconds(settings.seconds);
    add_methods();
  }
  ~Server() {
    stop_renders();
    for (std::thread& thread : background_) thread.join();
  }

  int run() {
    while (!exit_) {
      std::optional<Json> message = connection_.read();
      if (!message) return 1;
      take(*message);
    }
    return shut_down_ ? 0 : 1;
  }

 private:
  using Method = std::function<Json(const Json& params)>;

  void take(const Json& message) {
    if (message.is_discarded()) return connection_.fail(nullptr, kParseError, "this is no JSON");
    if (!message.is_object()) return connection_.fail(nullptr, kInvalidRequest, "a message is an object");
    const Json id = message.value("id", Json());
    if (!message.contains("method") || !message["method"].is_string()) return;  // an answer to what we asked
    const std::string method = message["method"];
    const Json params = message.value("params", Json::object());
    const bool wants_answer = message.contains("id");
    try {
      const auto found = methods_.find(method);
      if (!initialized_ && method != "initialize" && method != "exit")
        throw RequestError(kNotInitialized, "'initialize' comes first");
      if (shut_down_ && method != "exit") throw RequestError(kInvalidRequest, "the server is shut down");
      if (found == methods_.end()) {
        if (wants_answer) throw RequestError(kMethodNotFound, "there is no method " + method);
        return;
      }
      current_ = id;
      answered_later_ = false;
      Json result = found->second(params);
      if (wants_answer && !answered_later_) connection_.answer(id, std::move(result));
    } catch (const RequestError& error) {
      if (wants_answer) connection_.fail(id, error.code, error.what());
    } catch (const Json::exception& error) {
      if (wants_answer) connection_.fail(id, kInvalidParams, error.what());
    } catch (const std::exception& error) {
      if (wants_answer) connection_.fail(id, kInternalError, error.what());
    }
  }

  void add_methods() {
    methods_["initialize"] = [this](const Json& p) { return initialize(p); };
    methods_["initialized"] = [](const Json&) { return Json(); };
    methods_["shutdown"] = [this](const Json&) {
      shut_down_ = true;
      return Json();
    };
    methods_["exit"] = [this](const Json&) {
      exit_ = true;
      return Json();
    };
    methods_["textDocument/didOpen"] = [this](const Json& p) { return open(p.at("textDocument")); };
    methods_["textDocument/didChange"] = [this](const Json& p) { return change(p); };
    methods_["textDocument/didSave"] = [this](const Json& p) {
      want(workspace_.document(p.at("textDocument").at("uri")));
      return Json();
    };
    methods_["textDocument/didClose"] = [this](const Json& p) { return close(p.at("textDocument").at("uri")); };
    methods_["workspace/didChangeWatchedFiles"] = [this](const Json&) {
      for (const auto& [uri, document] : workspace_.documents()) want(document);
      return Json();
    };
    at("textDocument/hover", hover);
    at("textDocument/signatureHelp", signature_help);
    at("textDocument/completion", completion);
    at("textDocument/definition", definition);
    at("textDocument/documentHighlight", document_highlight);
    at("textDocument/prepareRename", prepare_rename);
    methods_["textDocument/references"] = [this](const Json& p) {
      const Json context = p.value("context", Json::object());
      return references(question(p), context.value("includeDeclaration", true));
    };
    methods_["textDocument/rename"] = [this](const Json& p) { return rename(question(p), p.at("newName")); };
    methods_["textDocument/documentSymbol"] = [this](const Json& p) { return document_symbols(workspace_, of(p)); };
    methods_["textDocument/foldingRange"] = [this](const Json& p) { return folding_ranges(workspace_, of(p)); };
    methods_["textDocument/documentLink"] = [this](const Json& p) { return document_links(workspace_, of(p)); };
    methods_["textDocument/documentColor"] = [this](const Json& p) { return document_colors(workspace_, of(p)); };
    methods_["textDocument/colorPresentation"] = [this](const Json& p) {
      return color_presentations(workspace_, of(p), p);
    };
    methods_["textDocument/formatting"] = [this](const Json& p) { return formatting(workspace_, of(p), p); };
    methods_["textDocument/rangeFormatting"] = [this](const Json& p) { return formatting(workspace_, of(p), p); };
    methods_["textDocument/codeAction"] = [this](const Json& p) { return code_actions(p); };
    methods_["workspace/executeCommand"] = [this](const Json& p) { return execute(p); };
  }

  void at(const std::string& method, Json (*answer)(const Question&)) {
    methods_[method] = [this, answer](const Json& p) { return answer(question(p)); };
  }

  Document& of(const Json& params) { return workspace_.document(params.at("textDocument").at("uri")); }
  Question question(const Json& params) {
    Document& document = of(params);
    return {workspace_, document, document.text->offset(as_point(params.at("position")), workspace_.columns())};
  }

  Json initialize(const Json& params) {
    initialized_ = true;
    const Json& encodings = params.value("/capabilities/general/positionEncodings"_json_pointer, Json::array());
    const bool utf8 = std::find(encodings.begin(), encodings.end(), "utf-8") != encodings.end();
    workspace_.set_columns(utf8 ? Columns::utf8 : Columns::utf16);
    publisher_.set_columns(workspace_.columns());
    shows_documents_ = params.value("/capabilities/window/showDocument/support"_json_pointer, false);
    return {
        {"serverInfo", {{"name", "verisim"}, {"version", VERISIM_VERSION}}},
        {"capabilities",
         {{"positionEncoding", utf8 ? "utf-8" : "utf-16"},
          {"textDocumentSync", {{"openClose", true}, {"change", kIncremental}, {"save", true}}},
          {"hoverProvider", true},
          {"completionProvider", {{"triggerCharacters", {"#", ".", "\"", "/"}}}},
          {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
          {"definitionProvider", true},
          {"referencesProvider", true},
          {"documentHighlightProvider", true},
          {"documentSymbolProvider", true},
          {"documentLinkProvider", {{"resolveProvider", false}}},
          {"codeActionProvider", {{"codeActionKinds", {"quickfix", "source.fixAll"}}}},
          {"colorProvider", true},
          {"documentFormattingProvider", true},
          {"documentRangeFormattingProvider", true},
          {"renameProvider", {{"prepareProvider", true}}},
          {"foldingRangeProvider", true},
          {"executeCommandProvider", {{"commands", {"verisim.render", "verisim.explain", "verisim.explainCode"}}}}}}};
  }

  Json open(const Json& item) {
    Document document;
    document.uri = item.at("uri");
    document.path = path_of(document.uri);
    document.version = item.value("version", 0);
    document.text = std::make_shared<const Text>(item.at("text").get<std::string>());
    Document& kept = workspace_.documents()[document.uri] = std::move(document);
    want(kept);
    return {};
  }

  Json change(const Json& params) {
    Document& document = of(params);
    Text text = *document.text;
    for (const Json& step : params.at("contentChanges")) {
      const std::string with = step.at("text");
      const auto range = step.find("range");
      if (range == step.end() || range->is_null()) {
        text = Text(with);
      } else {
        const std::size_t begin = text.offset(as_point(range->at("start")), workspace_.columns());
        text.replace(begin, text.offset(as_point(range->at("end")), workspace_.columns()), with);
      }
    }
    document.text = std::make_shared<const Text>(std::move(text));
    document.version = params.at("textDocument").value("version", document.version);
    document.changed();
    want(document);
    return {};
  }

  Json close(const std::string& uri) {
    const auto found = workspace_.documents().find(uri);
    if (found == workspace_.documents().end()) return {};
    const Document document = found->second;
    const std::vector<Root> roots = workspace_.roots_of(document);
    workspace_.documents().erase(found);
    // Its scenes are read on as long as another file of them is open.
    for (const Root& root : roots) {
      bool used = false;
      for (const auto& [other_uri, other] : workspace_.documents())
        for (const Root& other_root : workspace_.roots_of(other)) used |= other_root.key() == root.key();
      if (used) {
        analyst_.want(root, workspace_.snapshot());
      } else {
        analyst_.forget(root.key());
        workspace_.drop(root.key());
        publisher_.drop(root.key());
      }
    }
    return {};
  }

  void want(const Document& document) {
    const auto snapshot = workspace_.snapshot();
    {
      const std::lock_guard lock(uris_mutex_);
      open_uris_.clear();
      for (const auto& [uri, open] : workspace_.documents())
        if (!open.path.empty()) open_uris_[open.path] = uri;
    }
    for (Root& root : workspace_.roots_of(document)) {
      if (root.path.empty()) {
        root.text = document.text;
        root.version = document.version;
      }
      root.uri = root.path.empty() ? document.uri : workspace_.uri_for(root.path);
      analyst_.want(root, snapshot);
    }
  }

  // On the analyst's thread.
  void read(std::shared_ptr<const Analysis> analysis, const std::vector<LintFinding>& lints) {
    std::map<fs::path, std::string> uris;
    {
      const std::lock_guard lock(uris_mutex_);
      uris = open_uris_;
    }
    workspace_.store(analysis);
    publisher_.publish(*analysis, lints, uris);
  }

  Json code_actions(const Json& params) {
    const Document& document = of(params);
    std::shared_ptr<const Text> text;
    const std::vector<KnownFix> fixes = publisher_.fixes(document.uri, &text);
    Json actions = Json::array();
    if (!text || text->str() != document.text->str()) return actions;  // they are for another text
    const std::size_t begin = text->offset(as_point(params.at("range").at("start")), workspace_.columns()),
                      end = text->offset(as_point(params.at("range").at("end")), workspace_.columns());
    Json all = Json::array();
    std::size_t done = 0;
    for (const KnownFix& known : fixes) {
      const Json edit{
          {"range", range_json(*text, known.fix.offset, known.fix.offset + known.fix.length, workspace_.columns())},
          {"newText", known.fix.text}};
      if (all.empty() || known.fix.offset >= done) {
        all.push_back(edit);
        done = known.fix.offset + known.fix.length;
      }
      const std::size_t from = text->offset(as_point(known.range.at("start")), workspace_.columns()),
                        to = text->offset(as_point(known.range.at("end")), workspace_.columns());
      if (to < begin || from > end) continue;
      std::string title = known.fix.title;
      if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
      actions.push_back({{"title", title},
                         {"kind", "quickfix"},
                         {"isPreferred", true},
                         {"diagnostics", Json::array({known.diagnostic})},
                         {"edit", {{"changes", {{document.uri, Json::array({edit})}}}}}});
    }
    const Json only = params.value("/context/only"_json_pointer, Json::array());
    const bool wants_all = std::find(only.begin(), only.end(), "source.fixAll") != only.end();
    if (!all.empty() && (all.size() > 1 || wants_all))
      actions.push_back({{"title", "Correct everything that is certain"},
                         {"kind", "source.fixAll"},
                         {"edit", {{"changes", {{document.uri, all}}}}}});
    return actions;
  }

  Json execute(const Json& params) {
    const std::string command = params.at("command");
    const Json arguments = params.value("arguments", Json::array());
    if (command == "verisim.explainCode") {
      const std::string name = arguments.at(0);
      if (const Lint* lint = lint_named(name)) return {{"text", explanation(*lint)}};
      const auto code = parser::code_named(name);
      if (!code) throw RequestError(kInvalidParams, "there is no such code");
      return {{"text", parser::explanation(parser::entry(*code))}};
    }
    if (command != "verisim.render" && command != "verisim.explain")
      throw RequestError(kInvalidParams, "there is no command " + command);
    const Json& what = arguments.at(0);
    Document& document = workspace_.document((what.is_string() ? what : what.at("uri")).get<std::string>());
    Root root = workspace_.roots_of(document).front();
    if (command == "verisim.render") {
      if (const auto open = workspace_.documents().find(workspace_.uri_for(root.path));
          !root.path.empty() && open != workspace_.documents().end())
        root.text = open->second.text;
      later([this, root, settings = what](const Json& id) {
        Json result = render_command(settings_.program, settings_.options, root, scratch_.path(), settings);
        if (result.contains("uri") && shows_documents_)
          connection_.request(fmt::format("show-{}", ++asked_), "window/showDocument",
                              {{"uri", result["uri"]}, {"external", false}, {"takeFocus", false}});
        connection_.answer(id, std::move(result));
      });
      return {};
    }
    const std::size_t offset = document.text->offset(as_point(what.at("position")), workspace_.columns());
    const std::size_t line = opening_line(document, offset);
    later([this, root, snapshot = workspace_.snapshot(), path = document.path, line](const Json& id) {
      connection_.answer(id, explain_command(settings_.options, root, snapshot, scratch_.path(), path, line));
    });
    return {};
  }

  // The line, counted from 1, of the word of the innermost object around a place.
  static std::size_t opening_line(const Document& document, std::size_t offset) {
    std::size_t best = document.text->point(offset, Columns::utf8).line, size = std::string::npos;
    for (const parser::TextRange& fold : document.index().folds()) {
      if (!fold.contains(offset) || fold.end - fold.begin >= size) continue;
      const parser::Token& word = parser::token_at(document.index().tokens(), fold.begin);
      bool object = false;
      for (const parser::Keyword* use : parser::keyword_uses(parser::spelling(word.word)))
        object |= parser::may_stand(*use, "union");
      if (!object || word.word == parser::Word::texture || word.word == parser::Word::pigment) continue;
      size = fold.end - fold.begin;
      best = document.text->point(fold.begin, Columns::utf8).line;
    }
    return best + 1;
  }

  // Work that takes a while: the request is answered when it is done.
  void later(std::function<void(const Json& id)> work) {
    answered_later_ = true;
    background_.emplace_back([this, id = current_, work = std::move(work)] {
      try {
        work(id);
      } catch (const std::exception& error) {
        connection_.fail(id, kRequestFailed, error.what());
      }
    });
  }

  ServerSettings settings_;
  Scratch scratch_;
  Connection connection_;
  Workspace workspace_;
  Publisher publisher_;
  std::mutex uris_mutex_;
  std::map<fs::path, std::string> open_uris_;
  std::unordered_map<std::string, Method> methods_;
  std::vector<std::thread> background_;
  std::atomic<int> asked_ = 0;
  Json current_;  // the id of the request that is being answered
  bool initialized_ = false, shut_down_ = false, exit_ = false, answered_later_ = false, shows_documents_ = false;
  Analyst analyst_;  // last: its thread uses what is above
};

}  // namespace

int serve(const ServerSettings& settings) {
  std::signal(SIGPIPE, SIG_IGN);
  return Server(settings).run();
}

}  // namespace verisim::cli::lsp
