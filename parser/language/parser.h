// The token cursor that executes directives and macros as it goes, and the expression language on top of it.
//
// Blocks (parser/scene) are plain recursive descent over this class and never see a directive: every peek() executes
// what stands in the way.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "parser/language/value.h"
#include "parser/lexer/token.h"
#include "parser/source/options.h"

namespace verisim::textures {
class TexturePool;
}

namespace verisim::parser {

// Thrown by error(); caught where parsing can go on (recovery.cpp), or by parse_file.
struct ParseError {
  Diagnostic diagnostic;
  bool last = false;  // parsing must not go on
};

class Parser {
 public:
  Parser(const ParseOptions& options, ParseResult& result);
  ~Parser();

  // ---- Cursor. Tokens are compared by `Word` (keyword) or by punctuation character. ----
  const Token& peek();  // the next token after executing directives and expanding macros
  Token next();
  bool at(Word word);  // peek() is this keyword
  bool at(char punctuation);
  bool accept(Word word);  // at() and consume
  bool accept(char punctuation);
  void expect(Word word);  // accept or error "Expected 'x', y found instead"
  void expect(char punctuation);
  void optional_comma() { accept(','); }
  bool at_number_start();  // the next token can start a numeric expression (spec 01 section 7, optional arguments)
  scene::SourceLocation place();  // of the next token
  // The place of a declared object that is copied at another one: it stays, but ParseOptions::origins remember.
  scene::SourceLocation copied_to(const scene::SourceLocation& declared, const scene::SourceLocation& copy) const;

  // ---- Expressions (spec 01 section 8). Additive terms unless `full`. ----
  double parse_float();
  int parse_int();  // truncated to 32 bits
  bool parse_flag(
      bool absent = true);  // optional numeric argument of a flag keyword: value > 0; `absent` when there is none
  double parse_optional_float(double absent);
  Vec2 parse_vec2();
  Vec3 parse_vec3();
  Numeric parse_numeric(int width);  // context width 1..5
  Numeric parse_full_numeric();
  Color parse_color();  // spec 01 section 9; five terms
  Rgb parse_rgb();      // where only rgb counts: warns about filter and transmit
  std::u16string parse_string();
  std::string parse_path();  // a string used as a file name: no escapes (spec 01 12.1)
  bool at_string();
  bool at_color_keyword();  // color, colour, rgb..., srgb..., red, green, blue, filter, transmit, alpha

  // ---- Identifiers ----
  // If the next token is an identifier (or array element) that holds a T, consumes it and returns the value; else null
  // and nothing is consumed.
  template <class T>
  const T* accept_value() {
    const Value* value = peek_value();
    if (!value || !std::holds_alternative<T>(*value)) return nullptr;
    return &std::get<T>(take_value());
  }
  const Value* peek_value();  // value of the identifier at the cursor, or null
  const Value& take_value();  // consumes the identifier with its subscripts
  // function { ... } and friends; the keyword `function` is already consumed (spec 01 section 23).
  FunctionPtr parse_function_body();
  FunctionPtr parse_function_or_identifier();

  // ---- Messages ----
  // At the value read last when the code is about values, else at the last token read.
  [[noreturn]] void error(Code code, const std::string& message, const std::string& advice = {});
  [[noreturn]] void fatal(Code code, const std::string& message,
                          const std::string& advice = {});  // the same, and parsing ends here: limits
  [[noreturn]] void error_expected(std::string_view what);  // "Expected 'what', <next token> found instead"
  [[noreturn]] void error_unclosed();                       // the block under way should end at the next token
  [[noreturn]] void unsupported(const std::string& what);   // exit status 4
  void warning(Code code, const std::string& message);
  void possible_error(Code code, const std::string& message);

  // ---- State that blocks share ----
  int version() const;            // current language version times 100
  int effective_version() const;  // 362 while no #version was seen (spec 01 section 20)
  const ParseOptions& options() const;
  scene::Scene& scene();  // under construction
  scene::TexturePtr& default_texture();
  textures::TexturePool& texture_pool();
  scene::Camera& default_camera();
  // global_settings { charset }: how bytes >= 0x80 of later strings are read (spec 01 section 1.1).
  enum class Charset : unsigned char { ascii, utf8, sys };
  void set_charset(Charset charset);
  Charset charset() const;
  // global_settings { noise_generator }: overrides the one that follows from the language version.
  void set_noise_generator(int generator);
  // Finds a file as #include does without the .inc variants: current folder, library paths; records it as read. Error
  // when missing or not allowed. A name without an extension is tried with each of `extensions` (separated by blanks)
  // first.
  std::filesystem::path find_file(const std::string& name, std::string_view extensions = {});
  // What the program gave under this name (ParseOptions::files); null: nothing. find_file makes a file of it where it
  // holds the bytes of one.
  std::shared_ptr<const MemoryFile> memory_file(const std::string& name) const;
  // The same for fonts, remembered: a scene may have thousands of texts, and asking the file system takes longer than
  // reading one.
  const std::string& find_font(const std::string& name);
  // A file the scene wants written, now or after rendering. Error where it may not write (ParseOptions::allow_write).
  std::filesystem::path writable_file(const std::string& name);
  // Guards recursion of blocks; throws when Limits::max_depth is reached.
  struct Depth {
    explicit Depth(Parser& p);
    ~Depth();
    Parser& parser;
  };

  // While it lives, directives and macros are not executed where an item of a block may stand (spec 01 section 4, B6).
  struct FurtherLayer {
    explicit FurtherLayer(Parser& p);
    ~FurtherLayer();
    Parser& parser;
    const bool items_before, operators_before;
  };

  void run(const std::filesystem::path& main_file);
  void run_text(std::string_view text, const std::string& name);

  struct Impl;  // impl.h; for the files of parser/language only

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace verisim::parser
