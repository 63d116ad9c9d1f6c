// What the server answers: one function a request of the protocol, each a question about a place in a file.
#pragma once

#include "cli/lsp/workspace.h"

namespace verisim::cli::lsp {

// A request's file and place.
struct Question {
  Workspace& workspace;
  Document& document;
  std::size_t offset = 0;  // bytes
};

// hover.cpp
Json hover(const Question& question);
Json signature_help(const Question& question);

// completion.cpp
Json completion(const Question& question);

// navigation.cpp
Json definition(const Question& question);
Json references(const Question& question, bool with_declarations);
Json document_highlight(const Question& question);
Json prepare_rename(const Question& question);
Json rename(const Question& question, const std::string& name);  // throws RequestError
Json document_symbols(Workspace& workspace, const Document& document);
Json folding_ranges(const Workspace& workspace, const Document& document);
Json document_links(Workspace& workspace, const Document& document);

// colors.cpp
Json document_colors(const Workspace& workspace, const Document& document);
Json color_presentations(const Workspace& workspace, const Document& document, const Json& params);

// layout.cpp
Json formatting(const Workspace& workspace, const Document& document, const Json& params);  // whole file or a range

// commands.cpp: what is slow and runs in the background; both throw std::exception.
// Renders the scene of a file to a PNG with this program; the answer has its path and what was said.
Json render_command(const std::filesystem::path& program, const Options& options, const Root& root,
                    const std::filesystem::path& scratch, const Json& settings);
void stop_renders();  // of all servers of the process
// The object that stands at a place, in words.
Json explain_command(const Options& options, const Root& root, std::shared_ptr<const Snapshot> snapshot,
                     const std::filesystem::path& scratch, const std::filesystem::path& file, std::size_t line);

// The comment right above a declaration, without its marks.
std::string comment_above(const Text& text, const parser::TokenFile& tokens, std::size_t offset);
// A declaration as it would be written: "#declare Red = <1, 0, 0>", "#macro Wheel(Radius, Spokes)".
std::string written(const Workspace& workspace, const Meaning& meaning);

}  // namespace verisim::cli::lsp
