#include "tests/fuzz/targets.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <thread>

#include "tests/fuzz/limited_parse.h"
#include "tests/fuzz/promise.h"
#include "tracer/base/resident_memory.h"
#include "tracer/render/render.h"

namespace verisim::fuzz {
namespace {

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

void render(std::string_view bytes) {
  memory_limit = std::size_t{2} << 30;
  const parser::ParseResult result = parse(std::string(bytes));
  if (!result.scene) return;
  const auto one = drawn(*result.scene, 1), two = drawn(*result.scene, 2);
  if (!one || !two) return;
  const auto bits = [](const Color& c) { return std::bit_cast<std::array<std::uint32_t, 5>>(c); };
  require(std::equal(one->pixels.begin(), one->pixels.end(), two->pixels.begin(),
                     [&](const Color& a, const Color& b) { return bits(a) == bits(b); }),
          "the picture does not depend on threads");
}

}  // namespace verisim::fuzz
