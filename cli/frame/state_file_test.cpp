// Continue-trace: what is read back after any kind of end.
#include "cli/frame/state_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "cli/parts/fingerprint.h"

namespace verisim::cli {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr int kWidth = 40, kHeight = 24, kBlock = 8;

render::Framebuffer blank() {
  render::Framebuffer result;
  result.width = kWidth;
  result.height = kHeight;
  result.pixels.assign(kWidth * kHeight, Color());
  result.done.assign(kWidth * kHeight, 0);
  return result;
}

render::Framebuffer painted() {
  render::Framebuffer result = blank();
  for (int i = 0; i < kWidth * kHeight; ++i)
    result.pixels[static_cast<std::size_t>(i)] =
        Color(0.1f * static_cast<float>(i), 1.0f / static_cast<float>(i + 1), -2e-30f, 0, 0.25f);
  return result;
}

class StateFileTest : public testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::path(testing::TempDir()) / ("state_" + std::to_string(::getpid()) + ".pov-state");
  }
  void TearDown() override { fs::remove(path_); }

  void write(int blocks, std::uint64_t key = 7) {
    const render::Framebuffer picture = painted();
    StateFile state(path_, key, milliseconds(0));
    for (int i = 0; i < blocks; ++i) state.finished(block(i), picture);
    EXPECT_EQ(state.failure(), "");
  }
  static Block block(int i) { return {i % (kWidth / kBlock) * kBlock, i / (kWidth / kBlock) * kBlock, kBlock, kBlock}; }
  static void expect_blocks(StateFile& state, const render::Framebuffer& got, int blocks) {
    const render::Framebuffer want = painted();
    EXPECT_EQ(state.known_count(), static_cast<std::size_t>(blocks));
    for (int i = 0; i < 15; ++i)
      for (int y = 0; y < kBlock; ++y)
        for (int x = 0; x < kBlock; ++x) {
          const Block b = block(i);
          const render::PixelColor& pixel = got.at(b.x + x, b.y + y);
          ASSERT_EQ(pixel, i < blocks ? want.at(b.x + x, b.y + y) : render::PixelColor()) << i;
        }
  }
  fs::path path_;
};

TEST_F(StateFileTest, BlocksComeBackBitForBit) {
  write(9);
  render::Framebuffer got = blank();
  StateFile state(path_, 7, milliseconds(0));
  ASSERT_EQ(state.resume(got), StateFile::Found::blocks);
  expect_blocks(state, got, 9);
  EXPECT_TRUE(state.known(block(8)));
  EXPECT_FALSE(state.known(block(9)));
}

TEST_F(StateFileTest, AnyCutLeavesTheWholeRecordsBeforeItAndCanGoOn) {
  write(4);
  std::string bytes;
  {
    std::ifstream stream(path_, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  }
  const std::size_t record = 16 + kBlock * kBlock * 16 + 8, header = 32;
  ASSERT_EQ(bytes.size(), header + 4 * record);
  for (std::size_t cut = 0; cut <= bytes.size(); cut += 37) {
    std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(cut));
    render::Framebuffer got = blank();
    StateFile state(path_, 7, milliseconds(0));
    const StateFile::Found found = state.resume(got);
    if (cut < header) {
      EXPECT_EQ(found, StateFile::Found::nothing) << cut;
      continue;
    }
    const int whole = static_cast<int>((cut - header) / record);
    expect_blocks(state, got, whole);
    // The next run appends where the damage was.
    const render::Framebuffer picture = painted();
    state.finished(block(10), picture);
    render::Framebuffer again = blank();
    StateFile next(path_, 7, milliseconds(0));
    ASSERT_EQ(next.resume(again), StateFile::Found::blocks);
    EXPECT_EQ(next.known_count(), static_cast<std::size_t>(whole + 1)) << cut;
    EXPECT_TRUE(next.known(block(10)));
  }
}

TEST_F(StateFileTest, ADamagedByteEndsTheReading) {
  write(4);
  for (std::size_t at : {40u, 1500u, 3000u}) {
    write(4);
    std::fstream stream(path_, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(at));
    stream.put('\x5a');
    stream.close();
    render::Framebuffer got = blank();
    StateFile state(path_, 7, milliseconds(0));
    ASSERT_EQ(state.resume(got), StateFile::Found::blocks);
    EXPECT_EQ(state.known_count(), (at - 32) / (16 + kBlock * kBlock * 16 + 8)) << at;
  }
}

TEST_F(StateFileTest, AnotherRendersFileIsNotUsed) {
  write(4, 8);
  render::Framebuffer got = blank();
  StateFile state(path_, 7, milliseconds(0));
  EXPECT_EQ(state.resume(got), StateFile::Found::other_render);
  EXPECT_EQ(state.known_count(), 0u);
}

TEST_F(StateFileTest, QuickRendersLeaveNoFile) {
  const render::Framebuffer picture = painted();
  StateFile state(path_, 7, std::chrono::hours(1));
  state.finished(block(0), picture);
  EXPECT_FALSE(fs::exists(path_));
  state.flush(picture);
  EXPECT_TRUE(is_state_file(path_));
  state.remove();
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(StateFileTest, AFullDiskDoesNotStopTheRender) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  const render::Framebuffer picture = painted();
  StateFile state("/dev/full", 7, milliseconds(0));
  state.finished(block(0), picture);
  EXPECT_NE(state.failure(), "");
  state.remove();
  EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST(FingerprintTest, DependsOnEverythingAndItsOrder) {
  const auto of = [](std::initializer_list<const char*> parts) {
    Fingerprint f;
    for (const char* part : parts) f.add(part);
    return f.value();
  };
  EXPECT_EQ(of({"a", "b"}), of({"a", "b"}));
  EXPECT_NE(of({"a", "b"}), of({"b", "a"}));
  EXPECT_NE(of({"ab"}), of({"a", "b"}));
}

}  // namespace
}  // namespace verisim::cli
