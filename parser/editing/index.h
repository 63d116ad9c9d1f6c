// The names of a file as an editor sees them: where each is declared, in which part of the text it means that, and
// where it is used. Made from the tokens alone, so it knows branches that are not taken, macros that are never called,
// and files that are broken.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "parser/lexer/lexer.h"

namespace verisim::parser {

// Bytes [begin, end) of a file.
struct TextRange {
  std::size_t begin = 0, end = 0;
  bool contains(std::size_t offset) const { return begin <= offset && offset <= end; }
  friend bool operator==(const TextRange&, const TextRange&) = default;
};

struct NameDeclaration {
  enum class Kind : std::uint8_t { variable, macro, parameter, file };
  std::string name;
  Kind kind = Kind::variable;
  std::size_t offset = 0;  // of the name
  TextRange whole;         // the directive, as far as it can be told
  TextRange scope;         // where the name means this; of a global name: the whole file
  bool global = false;
  std::vector<std::string> parameters;  // of a macro
};

struct NameUse {
  std::string_view name;
  std::size_t offset = 0;
};

class NameIndex {
 public:
  explicit NameIndex(std::string_view text);

  const std::vector<NameDeclaration>& declarations() const { return declarations_; }
  const std::vector<NameUse>& uses() const { return uses_; }  // every identifier, in order
  // Names in "#include" directives: the range between the quotes.
  const std::vector<TextRange>& includes() const { return includes_; }
  // Blocks, conditionals, loops and macros, from their first to their last byte.
  const std::vector<TextRange>& folds() const { return folds_; }

  // The identifier that contains or ends at an offset; null: none.
  const NameUse* use_at(std::size_t offset) const;
  // What a name means at an offset; null: nothing that is declared in this file.
  const NameDeclaration* meaning(std::string_view name, std::size_t offset) const;
  // Where a name means the same as at the offset, in the order of the text. A name that this file does not declare is
  // global.
  std::vector<NameUse> same_name(std::string_view name, std::size_t offset) const;
  const TokenFile& tokens() const { return *file_; }

 private:
  void read();
  void read_directive(std::uint32_t at);
  void read_macro(std::uint32_t at);
  void declare_parameters(std::uint32_t at, TextRange scope, std::vector<std::string>* list = nullptr);
  bool is(std::uint32_t token, char punctuation) const;
  std::size_t end_of_function(std::uint32_t at) const;
  std::uint32_t declare(std::uint32_t at, NameDeclaration::Kind kind, bool local);
  std::size_t end_of(std::uint32_t token) const;  // the byte behind it

  std::unique_ptr<Names> names_ = std::make_unique<Names>();
  std::shared_ptr<const TokenFile> file_;
  std::vector<NameDeclaration> declarations_;
  std::vector<NameUse> uses_;
  std::vector<TextRange> includes_, folds_;
  std::vector<TextRange> macros_;  // open ones while the tokens are read
};

}  // namespace verisim::parser
