#include "tests/fuzz/entry_points.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "parser/lexer/lexer.h"
#include "parser/parse.h"
#include "tracer/base/resident_memory.h"
#include "tracer/functions/function.h"
#include "tracer/render/render.h"

namespace verisim::fuzz {
namespace {

using namespace parser;

void require(bool promise, const char* what) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

ParseOptions limited() {
  ParseOptions options;
  options.limits.max_steps = 20000;
  options.limits.max_depth = 100;
  options.limits.max_tokens = 1 << 20;
  options.limits.max_memory_bytes = std::size_t{2} << 30;
  options.allow_read = {"/nonexistent"};
  options.message = [](const Diagnostic& d) { (void)format(d); };
  options.debug = [](const std::string&) {};
  return options;
}

ParseResult parse(const std::string& text) {
  ParseResult result = parse_text(text, "fuzz.pov", limited());
  require(result.scene.has_value() == result.errors.empty(), "a scene, or errors that say why not");
  for (const Diagnostic& error : result.errors) require(!error.message.empty(), "every error has a text");
  return result;
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

FunctionPtr function_of(const scene::Object& object) {
  if (!object.texture || object.texture->layers.empty()) return nullptr;
  const auto* params = std::get_if<scene::FunctionParams>(&*object.texture->layers.back().pigment->pattern.params);
  return params ? params->function : nullptr;
}

// Says stop to the render that is under way after its time.
class Deadline {
 public:
  Deadline() {
    std::thread([this] {
      for (;; std::this_thread::sleep_for(std::chrono::milliseconds(50)))
        if (Clock::now().time_since_epoch().count() > end_) over_ = true;
    }).detach();
  }
  std::atomic<bool>& begin(std::chrono::milliseconds time) {
    end_ = (Clock::now() + time).time_since_epoch().count();
    return over_ = false, over_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::atomic<Clock::rep> end_{std::numeric_limits<Clock::rep>::max()};
  std::atomic<bool> over_{false};
};

// Nothing: not a picture of this program, or one that takes long.
std::optional<render::Framebuffer> drawn(const scene::Scene& scene, int threads) {
  static Deadline& deadline = *new Deadline;
  render::Options options;
  options.width = 8, options.height = 6, options.block_size = 4, options.threads = threads;
  options.antialias = true, options.pass_memory = std::size_t{64} << 20;
  options.cancel = &deadline.begin(std::chrono::milliseconds(300));
  render::Framebuffer picture;
  try {
    render::render(scene, options, picture);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
  if (*options.cancel) return std::nullopt;
  return picture;
}

}  // namespace

void lexer(std::string_view bytes) {
  // Words of the language are hundreds, and were most of the work: they stay, with the names that came since.
  static std::unique_ptr<Names> known;
  if (!known || known->size() > 10000) known = std::make_unique<Names>();
  Names& names = *known;
  const auto file = tokenise(std::make_shared<Source>("fuzz.pov", bytes), names, 1 << 20, true);
  const Tokens& tokens = file->tokens;
  require(!tokens.empty(), "a last token");
  const TokenKind last = tokens.back().kind;
  require(last == TokenKind::end || last == TokenKind::error, "the last token ends the file or says why it ends");
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& t = tokens[i];
    require(t.offset <= bytes.size() && t.offset >= before, "tokens follow each other in the text");
    before = t.kind == TokenKind::error ? before : t.offset;
    require(i + 1 == tokens.size() || (t.kind != TokenKind::end && t.kind != TokenKind::error),
            "the end is at the end");
    switch (t.kind) {
      case TokenKind::string:
        require(t.offset + 1 + t.id() <= bytes.size(), "a string lies in the text");
        break;
      case TokenKind::vector:
        require(t.terms() >= 2 && t.terms() <= 5 && t.id() + t.terms() <= file->numbers.size(),
                "a vector has its numbers");
        break;
      case TokenKind::identifier:
        require(t.id() > 0 && t.id() < names.size() && !names[t.id()].text.empty(), "an identifier has a name");
        break;
      case TokenKind::directive:
        require(t.link() == 0 ||
                    (t.link() > i && t.link() < tokens.size() && tokens[t.link()].kind == TokenKind::directive),
                "links lead forward to directives");
        break;
      default:
        break;
    }
  }
}

void scene(std::string_view bytes) { parse(std::string(bytes)); }

void render(std::string_view bytes) {
  memory_limit = std::size_t{2} << 30;
  const ParseResult result = parse(std::string(bytes));
  if (!result.scene) return;
  const auto one = drawn(*result.scene, 1), two = drawn(*result.scene, 2);
  if (!one || !two) return;
  const auto bits = [](const Color& c) { return std::bit_cast<std::array<std::uint32_t, 5>>(c); };
  require(std::equal(one->pixels.begin(), one->pixels.end(), two->pixels.begin(),
                     [&](const Color& a, const Color& b) { return bits(a) == bits(b); }),
          "the picture does not depend on threads");
}

void function(std::string_view bytes) {
  const std::string body(bytes);
  // Once as a pattern's function, once called by another function, which may inline it.
  const std::string declared =
      "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare F = function(x, y, z) {" + body +
      "}\nsphere { 0, 1 pigment { function { F(x, y, z) } } }\nsphere { 0, 1 pigment { function {" + body + "} } }\n";
  const ParseResult result = parse(declared);
  if (!result.scene || result.scene->objects.size() != 2) return;
  const FunctionPtr caller = function_of(*result.scene->objects[0]), direct = function_of(*result.scene->objects[1]);
  if (!caller || !direct || caller->components() != 1 || direct->components() != 1 || direct->parameters() != 3 ||
      caller->parameters() != 3)
    return;
  // Loops over huge ranges are legal and endless: they are not run.
  if (body.find("sum") != std::string::npos || body.find("prod") != std::string::npos) return;
  constexpr std::size_t kPoints = 37;
  std::vector<double> points(3 * kPoints), batch(kPoints);
  constexpr double kSpecial[] = {0, -0.0, 1, -1, 0.5, 1e-300, -1e300, INFINITY, -INFINITY, NAN, 2147483648.0, 1e-10};
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = i % 5 == 0 ? kSpecial[i / 5 % std::size(kSpecial)] : std::sin(static_cast<double>(i) * 12.9898) * 7;
  direct->evaluate_batch(points.data(), kPoints, kPoints, batch.data());
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double argument[3] = {points[i], points[kPoints + i], points[2 * kPoints + i]};
    double one, through;
    direct->evaluate(argument, &one);
    caller->evaluate(argument, &through);
    require(same(one, batch[i]), "a batch gives what single points give");
    require(same(one, through), "a call gives what the function gives");
  }
}

}  // namespace verisim::fuzz
