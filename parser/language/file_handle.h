// A file opened by #fopen (spec 01 section 18).
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>

#include "parser/lexer/lexer.h"

namespace verisim::parser {

struct FileHandle {
  std::filesystem::path path;
  std::shared_ptr<const TokenFile> input;  // of a file opened for reading; it is tokenised as a whole
  std::size_t position = 0;                // the next token of input
  std::ofstream output;
};

}  // namespace verisim::parser
