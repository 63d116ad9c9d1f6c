// The parser's inside, shared by the files of parser/language: the cursor's state, symbols, and one group of member
// functions a file.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

#include "parser/language/array.h"
#include "parser/language/file_handle.h"
#include "parser/language/macro.h"
#include "parser/language/parser.h"
#include "parser/language/symbols.h"
#include "parser/lexer/lexer.h"
#include "parser/source/search.h"
#include "tracer/base/coarse_clock.h"
#include "tracer/functions/evaluation_budget.h"
#include "tracer/textures/compile/texture_pool.h"
#include "tracer/textures/evaluation/evaluation_faults.h"
#include "tracer/query.h"

namespace verisim::parser {

// Numbers are compared with this tolerance where SDL does (spec 01 section 8.2).
inline constexpr double kEps = 1e-10;

// Truncation to 32 bits; out of range and NaN give the smallest integer (spec 01 section 8.2).
inline int to_int(double value) {
  if (!(value > -2147483649.0 && value < 2147483648.0)) return -2147483647 - 1;
  return static_cast<int>(value);
}

// The element that a subscript means, of so many; negative: none of them.
inline int subscripted(double subscript, int size) {
  const double element = subscript + kEps;
  return subscript >= -kEps && element < size ? static_cast<int>(element) : -1;
}

// strings.cpp: text of a program, in code units of 16 bits.
std::u16string from_utf8(std::string_view text);

// An open #if, #switch, loop or macro call.
struct Condition {
  enum class Kind : unsigned char { if_, else_, switch_, switch_else, while_, for_, macro };
  Kind kind;
  const TokenFile* file = nullptr;
  std::uint32_t opener = 0;  // index of its directive token
  std::uint32_t test = 0;    // while: first token of the condition; for: of the body
  std::size_t frames = 0;    // number of frames when it was opened
  // #for
  std::uint32_t variable = 0;
  double end = 0, step = 0;
};

// What returns when an include file or a macro ends.
struct Frame {
  std::shared_ptr<const Macro> macro;          // the callee; null: an include file
  std::shared_ptr<const TokenFile> including;  // the callee's file when it is an include
  const TokenFile* file = nullptr;             // of the caller
  std::uint32_t position = 0;                  // in the caller, behind the call
  std::uint32_t call = 0;                      // the token that called
};

// A token in its file: where a message points.
struct Spot {
  const TokenFile* file = nullptr;
  const Token* token = nullptr;
};

struct Parser::Impl {
  Impl(Parser& self, const ParseOptions& parse_options, ParseResult& parse_result);
  ~Impl();

  // ---- cursor.cpp ----
  const Token& peek() {
    if (!ready) {
      if (!is_plain(*position)) return fetch();
      ready = true;
    }
    return *position;
  }
  const Token& peek_blocked() { return ready || is_plain(*position) ? *position : fetch_blocked(); }
  // Nothing has to be done before such a token can be used.
  static bool is_plain(const Token& token) {
    return token.kind == TokenKind::punctuation || token.kind == TokenKind::number || token.kind == TokenKind::word ||
           token.kind == TokenKind::string || token.kind == TokenKind::vector;
  }
  const Token& fetch();
  const Token& fetch_blocked();
  // Where an operator, a comma or a terminator is expected: blocked at the top level of a right-hand side (spec 01
  // section 4, B2 and B3).
  const Token& peek_operator() { return blocked ? peek_blocked() : peek(); }
  // Where an item of a block is expected: blocked in the further layers of a declared texture (B6).
  const Token& peek_item() { return in_further_layer ? peek_blocked() : peek(); }
  bool stopped();  // there, by a directive or a macro's name
  void skip_token() {
    ready = false;
    ++position;
  }
  Token take_raw();  // the next token as written, consumed
  bool accept_operator(char punctuation) {
    if (peek_operator().punctuation != punctuation) return false;
    skip_token();
    return true;
  }
  void comma_operator() { accept_operator(','); }  // consumes an optional comma at an operator position
  void expect_operator(char punctuation);
  std::uint32_t index(const Token* token) const { return static_cast<std::uint32_t>(token - file->tokens.data()); }
  void go_to(const TokenFile* target, std::uint32_t token);
  bool end_of_file();  // leaves an include file; false: the main file ends here
  void enter_file(std::shared_ptr<const TokenFile> entered, std::uint32_t call);
  void leave_frame();
  void count_steps(std::size_t tokens) {
    steps += tokens + 1;
    if (steps >= next_check) check_limits();
  }
  // What takes some time by itself (values of functions, queries, objects, strings) does not wait for so many steps.
  void look_at_clock() {
    if (coarse_milliseconds() >= next_look) check_limits();
  }
  void look_at_clock_now_and_then() {
    if (++looks % 16 == 0) look_at_clock();
  }
  void check_limits();
  // A function's value, or the answer to a query, has to come by itself: nobody looks at limits meanwhile.
  template <typename Evaluate>
  void within_budget(std::string_view what, Evaluate&& evaluate) {
    functions::EvaluationBudget::take_overrun(), textures::MissingSurface::take();
    {
      functions::EvaluationBudget budget;
      budget.open();
      evaluate();
    }
    if (functions::EvaluationBudget::take_overrun()) too_many_passes(what);
    if (textures::MissingSurface::take()) missing_surface(what);
  }
  [[noreturn]] void too_many_passes(std::string_view what);
  [[noreturn]] void nested_too_deeply();
  [[noreturn]] void missing_surface(std::string_view what);
  void start(std::shared_ptr<const TokenFile> main);
  void top_level();         // statements up to the end of the main file
  bool legacy_directive();  // declare, include, default ... without '#'
  void finish();            // checks and messages at the end of parsing

  // ---- recovery.cpp ----
  void mark_statement();
  bool recover(ParseError& failure);
  bool touches_failed_name() const;
  bool skip_statement();
  bool skip_block_of_directives();
  void fail_names_of(const Macro& macro);

  // ---- directives.cpp, loops.cpp ----
  void directive();
  void execute(const Token& token);
  Token skip(const TokenFile* in,
             std::uint32_t link);  // to the next branch or #end of the same construct; consumes and returns it
  void skip_to_end(const TokenFile* in, std::uint32_t link);
  bool condition_value();  // ( full expression ), true or false
  void if_chain(bool taken, const TokenFile* in, std::uint32_t link);
  void else_branch(const Token& token);
  [[noreturn]] void stray_branch(Word word);
  void refuse_strays(std::uint32_t begin, std::uint32_t end);
  void refuse_ended(std::size_t open);
  void end_directive(const Token& token);
  void end_macro();
  void switch_directive(const Token& token);
  bool case_matches(Word word, double value);
  void while_directive(const Token& token);
  void test_while();
  void for_directive(const Token& token);
  void end_for();
  void break_directive();
  void open_condition(Condition::Kind kind, std::uint32_t opener);
  bool defined_argument();  // the X of #ifdef(X) and defined(X), with its parentheses

  // ---- declare.cpp ----
  void declare(bool local);
  void undef();
  bool declare_fast(bool local);
  [[noreturn]] void missing_semicolon();
  static Fix semicolon_behind(Spot value);
  void declare_target(bool local, std::optional<Target>& target, Symbol*& created);
  enum class Ending : unsigned char { free, semicolon };
  Ending right_hand_side(Value& value);
  void assign(Target& target, Value&& value);
  void check_type(const Target& target, const Value& value);
  bool starts_numeric(const Token& token);
  void copy_identifier(Value& value);
  void record(Spot name, const Value& value);  // for ParseOptions::recorder
  // For ParseOptions::origins: a place with the macro calls around it; the name of an object that is declared.
  scene::SourceLocation with_calls(const scene::SourceLocation& place) const;
  void name_object(Spot name, const Value& value) const;

  // ---- macros.cpp ----
  void define_macro(const Token& token);
  Token take_own_name(const char* what);
  void call_macro(Symbol& symbol);
  void macro_argument();  // pushes one on `arguments`

  // ---- include.cpp, file_io.cpp ----
  void include();
  std::shared_ptr<const TokenFile> load(const std::filesystem::path& path, const std::string& name, bool main_file);
  std::shared_ptr<const TokenFile> load_unsaved(const std::filesystem::path& path, const std::string& name,
                                                const std::string& text, bool main);
  [[noreturn]] void missing_include(const std::string& name, Spot at);
  void allow_read(const std::filesystem::path& path);
  void open_search(std::filesystem::path scene_folder);
  void end_if_failed() const;  // a scene with errors does nothing more than to name them: called before it writes
  void fopen();
  std::shared_ptr<FileHandle> opened_file(const Token& name);  // of a name that was just taken
  void fclose();
  void read();
  void write();
  bool read_value(FileHandle& handle, Value& value);

  // ---- messages.cpp ----
  Diagnostic diagnostic(Severity severity, Code code, const std::string& message, const std::string& advice,
                        Spot at) const;
  // Once for each place.
  void message(Severity severity, Code code, const std::string& text, const std::string& advice = {});
  void message_at(Spot at, Severity severity, Code code, const std::string& text, const std::string& advice = {},
                  std::optional<Fix> fix = {});
  void give(Severity severity, Code code, const std::string& text, const std::string& advice, Spot at,
            std::optional<Fix> fix = {});
  [[noreturn]] void error(Code code, const std::string& text, const std::string& advice = {});
  [[noreturn]] void error_at(Spot at, Code code, const std::string& text, const std::string& advice = {});
  [[noreturn]] void fatal(Code code, const std::string& text,
                          const std::string& advice = {});  // an error after which parsing does not go on
  [[noreturn]] void expected(std::string_view what);
  [[noreturn]] void unclosed_block();
  [[noreturn]] void unclosed_condition();
  [[noreturn]] void undeclared(std::uint32_t name);
  [[noreturn]] void lex_error(const Token& token);
  std::string describe(const Token& token);
  static const char* kind_of(const Value& value);  // "float", "pigment" ...
  void text_directive(Word word);

  // ---- places.cpp ----
  Spot here() const;  // the token that was looked at last: under the cursor, or just consumed
  Spot next() const { return {file, position}; }
  Spot place_of(Code code) const;  // where a message with this code points
  static Excerpt excerpt(Spot at);
  std::vector<std::string> trail() const;
  // The innermost '{', '(' or '[' that is open before a token; null: none.
  static const Token* open_bracket(Spot before);
  // A '}' before that token whose indentation says that it was meant for another block than it closes: that block.
  static const Token* badly_indented(Spot before);
  Spot opener(const Token* bracket) const;  // the word before it, if there is one
  std::string written(Spot at) const;       // "union {", "#while"

  // ---- advice.cpp ----
  void advise_name(Diagnostic& d, std::uint32_t name, Spot at);
  void advise_file(Diagnostic& d, const std::string& name, Spot at, bool include);
  void check_deprecated(Symbol& symbol);

  // ---- expression.cpp, primary.cpp, scalar.cpp ----
  void additive(int width, Numeric& out);
  void multiplicative(int width, Numeric& out);
  void unary(int width, Numeric& out);
  void primary(int width, Numeric& out);
  void full(Numeric& out);
  void logical(Numeric& out);
  void relation(Numeric& out);
  void string_relation(Numeric& out);
  void parenthesis(Numeric& out);
  void vector_literal(Numeric& out);
  void identifier_operand(Numeric& out);
  void call_function(const Function& function, Numeric& out);
  void call_spline(const Spline& spline, Numeric& out);
  void component(int width, Numeric& out);
  double scalar();  // additive, one term
  double full_scalar();
  void fit(Numeric& value, int width, const Token* start);
  double divide(double a, double b, const Token* divisor);
  // Runs of plain tokens without side effects; false: nothing consumed.
  bool scalar_fast(double& out);
  bool vector_fast(Vec3& out);
  bool additive_fast(int width, Numeric& out);
  bool full_fast(Numeric& out);
  bool condition_fast(double& out);  // with its parentheses
  void move_behind(const Token* token) {
    position = token;
    ready = false;
  }
  bool ends_expression(const Token& token, bool in_full_expression) const;
  // What cannot follow an operand: an expression ends before it. Macros may yield anything, unless they are `kept`.
  bool begins_operand(const Token& token, bool macros_are_kept) const {
    switch (token.kind) {
      case TokenKind::identifier:
        return macros_are_kept || !names[token.id()].symbol || !names[token.id()].symbol->is_macro;
      case TokenKind::word:
      case TokenKind::number:
      case TokenKind::vector:
      case TokenKind::string:
        return true;
      default:
        return false;
    }
  }
  bool literal_vector(std::size_t terms, double* out);  // of that many literal numbers; false: nothing consumed
  bool literal(bool in_full_expression, Numeric& out);  // a number or vector on its own; false: nothing consumed

  // ---- float_functions.cpp, vector_functions.cpp ----
  bool word_operand(Word word, Numeric& out);  // word not yet consumed
  bool float_function(Word word, double& out);
  bool vector_function(Word word, Numeric& out);
  double argument();  // ( full scalar )
  Vec3 vector_argument();
  void open_arguments();
  void close_arguments();
  scene::ObjectPtr object_argument();
  const query::Target& query_target(const scene::ObjectPtr& object);

  // ---- strings.cpp, text.cpp ----
  bool at_string();
  std::u16string string(bool path);
  std::u16string decode(const Token& token, bool path);
  std::u16string string_function(Word word, bool path);
  std::string utf8(std::u16string_view text) const;
  void check_length(std::size_t characters);

  // ---- color.cpp ----
  enum class ColorTerms : unsigned char { five, rgb };
  Numeric color(ColorTerms terms = ColorTerms::five);
  Numeric color_base();  // at rgb..., srgb...
  void color_items(Numeric& out);
  void to_working_space(Numeric& value);

  // ---- arrays.cpp ----
  std::shared_ptr<Array> array();
  void initialise(Array& array, std::size_t dimension, std::size_t& element);
  std::size_t subscripts(const Array& array);
  bool at_subscript();
  void store_element(Array& array, std::size_t element, Value&& value);
  // Resolves the identifier at the cursor with its subscripts; consumes it.
  struct Resolved {
    Symbol* symbol = nullptr;
    Variable* variable = nullptr;
    std::shared_ptr<Array> array;
    std::size_t element = 0;
    Value& value() const { return array ? array->elements.at(element) : variable->value; }
    // A name without subscripts: a variable, or the element that a parameter stands for.
    static Resolved named(Symbol& symbol) {
      if (symbol.element_of) return {&symbol, nullptr, symbol.element_of, symbol.element};
      return {&symbol, symbol.variable, nullptr, 0};
    }
  };
  void refer_to_follower(Resolved& resolved) const;  // macros.cpp
  Resolved resolve();
  const Value* peek_value();  // resolves without consuming; subscripts are evaluated once only

  // ---- functions.cpp ----
  FunctionPtr function();  // the keyword is consumed
  Shared<Spline> spline();

  // ---- version.cpp ----
  void version_directive();
  void set_version(int value);

  Parser& parser;
  const ParseOptions& options;
  ParseResult& report;
  Names names;
  SymbolTables symbols{names};
  std::unique_ptr<FileSearch> search;

  const TokenFile* file = nullptr;
  const Token* position = nullptr;
  Spot value_read, path_read;       // the expression, and the file name, that a block read last
  const Token* not_fast = nullptr;  // where the fast paths have just given up
  bool ready = false;               // *position is a token for the parser: directives before it are done
  bool blocked = false;             // operator positions do not execute directives (spec 01 section 4)
  bool in_further_layer = false;    // nor do items of blocks
  std::shared_ptr<const TokenFile> main_file;
  std::vector<Frame> frames;
  std::vector<Condition> conditions;
  // Arguments of the macro calls under way: by reference (variable or array element) or by value.
  struct Argument {
    Variable* variable = nullptr;
    std::shared_ptr<Array> array;
    std::size_t element = 0;
    Value value;
  };
  std::vector<Argument> arguments;
  // An identifier whose subscripts were evaluated by peek_value, and where it ends.
  struct Pending {
    const Token* at = nullptr;
    const Token* behind = nullptr;
    Resolved resolved;
  } pending;

  struct CachedFile {
    std::shared_ptr<const TokenFile> tokens;
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;
  };
  // Where the statement under way began, and what failed before.
  struct Recovery {
    const TokenFile* file = nullptr;
    std::uint32_t token = 0;
    std::size_t frames = 0, conditions = 0;
    std::set<std::uint32_t> failed_names;
    std::set<std::tuple<std::string, int, std::string>> reported;
    int failures = 0;
    std::uint64_t steps_left = 0;
  } recovery;
  std::unordered_map<std::string, CachedFile> file_cache;  // by path
  std::unordered_map<std::string, std::string> fonts;  // where they were found; forgotten when the scene writes a file
  std::unordered_map<std::string, std::filesystem::path> include_locations;
  std::set<std::string> files_seen;
  std::size_t tokens_total = 0;
  std::uint64_t steps = 0, next_check = 1 << 16;
  std::int64_t next_look = 0;  // by coarse_milliseconds()
  unsigned looks = 0;
  int depth = 0;
  int depth_of_parentheses = 0;

  int language_version = 370;
  bool version_seen = false, version_is_first = true;
  bool noise_generator_given = false;
  const std::shared_ptr<int> noise_generator = std::make_shared<int>(2);  // the scene's; functions follow it
  Charset charset = Charset::ascii;
  bool spline_used = false;
  std::set<std::tuple<const TokenFile*, std::uint32_t, std::size_t>> messages_given;

  std::vector<std::uint32_t> random_streams;
  struct QueryTarget {
    scene::ObjectPtr object;
    std::unique_ptr<query::Target> target;
  };
  std::unordered_map<const scene::Object*, QueryTarget> query_targets;
  std::uint32_t declaring =
      0;  // the name that a #declare or #local under way gives a value: a function may call itself

  scene::Scene scene;
  scene::TexturePtr default_texture;
  textures::TexturePool texture_pool;
  scene::Camera default_camera;
  std::array<Value, 16> handed_out;  // values handed out by take_value, in turn
  std::size_t next_handed_out = 0;
};

// Inside brackets everything is live again (spec 01 section 4).
class Live {
 public:
  explicit Live(Parser::Impl& impl, bool blocked = false) : impl_(impl), saved_(impl.blocked) {
    impl.blocked = blocked;
  }
  ~Live() { impl_.blocked = saved_; }
  Live(const Live&) = delete;
  Live& operator=(const Live&) = delete;

 private:
  Parser::Impl& impl_;
  bool saved_;
};

// Counts recursion of any kind; the limit is far below what a thread's stack holds.
class Nesting {
 public:
  explicit Nesting(Parser::Impl& impl) : impl_(impl) {
    impl.look_at_clock_now_and_then();
    if (++impl.depth > impl.options.limits.max_depth) [[unlikely]]
      impl.nested_too_deeply();
  }
  ~Nesting() { --impl_.depth; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  Parser::Impl& impl_;
};

}  // namespace verisim::parser
