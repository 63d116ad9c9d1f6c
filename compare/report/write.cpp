#include <cerrno>
#include <cstring>

#include "compare/compare.h"
#include "tracer/base/output_file.h"

namespace verisim::compare {

void write_report(const std::string& text, const std::filesystem::path& path) {
  if (path != "-") return write_text_file(path, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::runtime_error(std::string("cannot write to standard output: ") + std::strerror(errno));
}

}  // namespace verisim::compare
