#include "cli/describe/fixes.h"

#include <fmt/format.h>

#include <map>

#include "parser/source/source.h"
#include "tracer/base/output_file.h"

namespace verisim::cli {

bool apply_fixes(const std::vector<parser::Diagnostic>& diagnostics, Console& console) {
  // By file, and from its end to its beginning, so that offsets stay right.
  std::map<std::string, std::map<std::size_t, const parser::Diagnostic*, std::greater<>>> by_file;
  for (const parser::Diagnostic& d : diagnostics)
    if (d.fix) by_file[d.fix->file].emplace(d.fix->offset, &d);
  for (const auto& [file, fixes] : by_file) {
    std::string text(parser::Source::read(file, file, std::size_t{1} << 31)->text());
    std::size_t untouched = text.size();  // what lies before it
    for (const auto& [offset, d] : fixes) {
      if (offset + d->fix->length > untouched) continue;  // overlaps one that was made
      text.replace(offset, d->fix->length, d->fix->text);
      untouched = offset;
      console.line(Stream::statistic, fmt::format("{}:{}:{}: fixed: {}", d->file, d->line, d->column, d->fix->title));
    }
    write_text_file(file, text);
  }
  return !by_file.empty();
}

}  // namespace verisim::cli
