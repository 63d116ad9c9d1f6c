// Formatting.
#include <algorithm>

#include "cli/lsp/features.h"
#include "parser/editing/format.h"

namespace verisim::cli::lsp {

Json formatting(const Workspace& workspace, const Document& document, const Json& params) {
  parser::Layout layout;
  if (const auto options = params.find("options"); options != params.end() && options->is_object()) {
    layout.width = std::clamp(options->value("tabSize", 2), 1, 16);
    layout.tabs = !options->value("insertSpaces", true);
  }
  const Text& text = *document.text;
  std::size_t begin = 0, end = text.str().size();
  if (const auto range = params.find("range"); range != params.end()) {
    begin = text.offset(as_point(range->at("start")), workspace.columns());
    end = text.offset(as_point(range->at("end")), workspace.columns());
    begin = begin ? text.str().find_last_of('\n', begin - 1) + 1 : 0;  // npos + 1 is 0
  }
  Json edits = Json::array();
  for (const parser::TextEdit& edit : parser::format_edits(text.str(), layout))
    if (edit.range.begin >= begin && edit.range.end <= end)
      edits.push_back(
          {{"range", range_json(text, edit.range.begin, edit.range.end, workspace.columns())}, {"newText", edit.text}});
  return edits;
}

}  // namespace verisim::cli::lsp
