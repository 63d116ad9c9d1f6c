// A whole parse: predeclared identifiers, the statements of the main file, and what is checked at the end.
#include "parser/language/parser.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <utility>

#include "parser/language/impl.h"
#include "parser/language/blocks.h"

namespace verisim::parser {
namespace fs = std::filesystem;
namespace {

// Values from the command line pass through a text of six significant digits (spec 01 section 22).
double six_digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", value);
  return std::strtod(text, nullptr);
}

// The text of a default texture: one layer, nothing set.
scene::TexturePtr plain_texture() {
  auto texture = std::make_shared<scene::Texture>();
  texture->layers.push_back({std::make_shared<scene::Pigment>(), nullptr, scene::Finish{}});
  return texture;
}

void declare_number(Parser::Impl& p, std::string_view name, double value) {
  p.symbols.create(p.names.intern(name), 0).value() = Numeric{{six_digits(value)}, 1};
}

// A value that a program gives, as it is.
Value value_of(Parser::Impl& p, const DeclaredValue& given) {
  if (const auto* number = std::get_if<double>(&given.value)) return Numeric{{*number}, 1};
  if (const auto* text = std::get_if<std::string>(&given.value)) return from_utf8(*text);
  if (const auto* object = std::get_if<scene::ObjectPtr>(&given.value)) {
    if (!*object) p.error(Code::bad_value, "An object that is declared from outside is null.");
    return *object;
  }
  if (const auto* terms = std::get_if<std::vector<double>>(&given.value)) {
    if (terms->size() < 2 || terms->size() > 5)
      p.error(Code::wrong_terms, "A vector that is declared from outside has 2 to 5 terms.");
    Numeric out;
    out.terms = static_cast<int>(terms->size());
    for (std::size_t i = 0; i < terms->size(); ++i)  // colours are single
      out.v[i] = out.terms == 5 ? static_cast<double>(static_cast<float>((*terms)[i])) : (*terms)[i];
    return out;
  }
  const auto& list = std::get<DeclaredArray>(given.value);
  auto array = std::make_shared<Array>();
  array->sizes = list.sizes;
  double product = 1;
  for (const int size : list.sizes) product *= size < 1 ? 0 : size;
  if (list.sizes.empty() || list.sizes.size() > kMaxDimensions || product < 1 ||
      product != static_cast<double>(list.elements.size()))
    p.error(Code::array_size,
            "An array that is declared from outside has 1 to 5 dimensions, none of them empty, and as many elements.");
  array->elements.set_size(list.elements.size());
  for (std::size_t i = 0; i < list.elements.size(); ++i) p.store_element(*array, i, value_of(p, list.elements[i]));
  return array;
}

void declare_value(Parser::Impl& p, const std::string& name, const DeclaredValue& given) {
  const bool identifier =
      !name.empty() &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string::npos &&
      (name[0] < '0' || name[0] > '9');
  if (!identifier) p.error(Code::bad_value, fmt::format("'{}' cannot be declared: it is not an identifier.", name));
  const std::uint32_t id = p.names.intern(name);
  if (p.names[id].word != Word::none)
    p.error(Code::reserved_word, fmt::format("'{}' cannot be declared: it is a reserved word.", name));
  Symbol* old = p.names[id].symbol;
  (old ? *old : p.symbols.create(id, 0)).value() = value_of(p, given);
}

void predeclare(Parser::Impl& p) {
  const ParseOptions& o = p.options;
  declare_number(p, "image_width", o.width);
  declare_number(p, "image_height", o.height);
  declare_number(p, "clock_delta", o.clock_delta);
  declare_number(p, "final_clock", o.final_clock);
  declare_number(p, "initial_clock", o.initial_clock);
  declare_number(p, "frame_number", o.frame_number);
  declare_number(p, "initial_frame", o.initial_frame);
  declare_number(p, "final_frame", o.final_frame);
  for (const auto& [name, text] : o.declarations) {
    const std::uint32_t id = p.names.intern(name);
    if (p.names[id].word != Word::none)
      p.error(Code::reserved_word, fmt::format("Declare={}=...: '{}' is a reserved word.", name, name));
    Symbol* old = p.names[id].symbol;
    Value& value = old ? old->value() : p.symbols.create(id, 0).value();
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
      std::u16string content;
      for (const char c : text.substr(1, text.size() - 2))
        content += static_cast<char16_t>(static_cast<unsigned char>(c));
      value = std::move(content);
    } else {
      value = Numeric{{six_digits(std::strtod(text.c_str(), nullptr))}, 1};
    }
  }
  for (const auto& [name, value] : o.values) declare_value(p, name, value);
}

}  // namespace

Parser::Impl::Impl(Parser& self, const ParseOptions& parse_options, ParseResult& parse_result)
    : parser(self), options(parse_options), report(parse_result), default_texture(plain_texture()) {
  if (options.version) set_version(options.version);
}

Parser::Impl::~Impl() = default;

void Parser::Impl::start(std::shared_ptr<const TokenFile> main) {
  main_file = std::move(main);
  go_to(main_file.get(), 0);
  if (main_file->starts_with_high_bytes) charset = Charset::utf8;
  const std::string& name = main_file->source->name();
  Symbol& symbol = symbols.create(names.intern("input_file_name"), 0);
  symbol.value() = std::u16string(name.begin(), name.end());
  predeclare(*this);
  scene.source_name = name;
  for (std::size_t i = options.include_headers.size(); i-- > 0;) {
    const std::string& header = options.include_headers[i];
    const std::optional<fs::path> found = search->find_include(header);
    if (!found) missing_include(header, {});
    enter_file(load(*found, found->string(), false), 0);
  }
  try {
    for (bool more = true; more;) {
      more = false;
      try {
        top_level();
      } catch (ParseError& failure) {
        more = recover(failure);
        if (!more) {
          report.whole = false;
          return;
        }
      }
    }
    if (report.errors.empty()) finish();
  } catch (const std::bad_alloc&) {
    fatal(Code::size_limit, "The scene needs more memory than there is.");
  } catch (const std::exception& e) {  // from the tracer: what it cannot make of an object
    fatal(Code::internal, e.what());
  }
}

void Parser::Impl::top_level() {
  for (;;) {
    const Token token = peek();
    mark_statement();
    if (token.kind == TokenKind::end) {
      if (!conditions.empty()) unclosed_condition();
      return;
    }
    count_steps(1);
    const Nesting statement(*this);
    if (parse_statement(parser)) continue;
    if (token.kind == TokenKind::word && token.word == Word::version)
      return;  // the rest is ignored (spec 01 section 25)
    if (!legacy_directive()) expected("object or directive");
  }
}

// Directives that may lack their '#' at top level.
bool Parser::Impl::legacy_directive() {
  const Token token = peek();
  if (token.kind != TokenKind::word) return false;
  if (token.word != Word::declare && token.word != Word::include && token.word != Word::default_) return false;
  if (language_version > 295 && token.word != Word::default_)
    message_at(here(), Severity::warning, Code::missing_hash,
               fmt::format("Directive '{}' should have '#' in front of it.", spelling(token.word)), {},
               Fix{"put '#' before it", file->source->name(), token.offset, 0, "#"});
  skip_token();
  const Nesting nesting(*this);
  execute(token);
  return true;
}

void Parser::Impl::finish() {
  scene.version = parser.effective_version();
  const Spot start{main_file.get(), main_file->tokens.data()};
  if (!scene.settings.gamma_given && scene.version >= 370) {
    message_at(start, Severity::possible_error, Code::missing_gamma, "assumed_gamma is not set: 1.0 is taken.",
               "Put global_settings { assumed_gamma 1.0 } into the scene.");
    scene.settings.gamma = scene::Gamma::power;
    scene.settings.assumed_gamma = 1;
  } else if (!scene.settings.gamma_given) {
    message_at(start, Severity::warning, Code::missing_gamma,
               "assumed_gamma is not set: colours are not corrected, as before version 3.7.");
  }
  if (!version_seen && !options.version)
    message_at(start, Severity::warning, Code::missing_version,
               "This scene has no #version directive: it is rendered as version 3.62.", "Begin it with #version 3.7;");
  else if (version_seen && !version_is_first)
    message(Severity::warning, Code::late_version, "The #version directive is not the first statement of the scene.");
  if (scene.version <= 310)
    message(Severity::warning, Code::version_limits,
            "The scene ends with language version 3.1 or earlier: not every oddity of those versions is imitated.");
  if (scene.version < 350) scene.version = 350;
  finish_scene(parser);
  if (spline_used) message(Severity::warning, Code::experimental, "Splines are an experimental feature of POV-Ray.");
}

// ---- The public face ----

Parser::Parser(const ParseOptions& options, ParseResult& result)
    : impl_(std::make_unique<Impl>(*this, options, result)) {}
Parser::~Parser() = default;

const ParseOptions& Parser::options() const { return impl_->options; }
scene::Scene& Parser::scene() { return impl_->scene; }
scene::TexturePtr& Parser::default_texture() { return impl_->default_texture; }
textures::TexturePool& Parser::texture_pool() { return impl_->texture_pool; }
scene::Camera& Parser::default_camera() { return impl_->default_camera; }

Parser::Depth::Depth(Parser& p) : parser(p) {
  Impl& impl = *p.impl_;
  if (++impl.depth > impl.options.limits.max_depth) {
    --impl.depth;
    impl.fatal(Code::size_limit, fmt::format("Nested deeper than {} levels.", impl.options.limits.max_depth),
               "--max-depth raises this limit.");
  }
}
Parser::Depth::~Depth() { --parser.impl_->depth; }

Parser::FurtherLayer::FurtherLayer(Parser& p)
    : parser(p),
      items_before(std::exchange(p.impl_->in_further_layer, true)),
      operators_before(std::exchange(p.impl_->blocked, true)) {}
Parser::FurtherLayer::~FurtherLayer() {
  parser.impl_->in_further_layer = items_before;
  parser.impl_->blocked = operators_before;
}

void Parser::run(const fs::path& main_file) {
  Impl& impl = *impl_;
  fs::path folder = main_file.parent_path();
  if (folder.empty()) folder = ".";
  impl.open_search(folder);
  fs::path path = main_file;
  if (std::error_code error; !fs::exists(path, error))
    if (const auto found = impl.search->find_exact(main_file.string())) path = *found;
  impl.start(impl.load(path, main_file.string(), true));
}

void Parser::run_text(std::string_view text, const std::string& name) {
  Impl& impl = *impl_;
  impl.open_search(impl.options.scene_folder);
  if (text.size() > impl.options.limits.max_file_bytes)
    impl.error(Code::size_limit, "The scene has more bytes than --max-file-bytes allows.");
  impl.start(tokenise(std::make_shared<Source>(name, text), impl.names, impl.options.limits.max_tokens, true));
}

}  // namespace verisim::parser
