// Scenes that come to the program (VERISIM_BINARY_DIR/bin/verisim, cli/process_fixture.h) through standard input, pipes
// and devices, and pictures that leave through standard output.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/console/exit_status.h"
#include "cli/process_fixture.h"

namespace verisim::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Pipes : public Process {
 protected:
  Ended shell(const std::string& command, const std::string& scene = kQuickScene) const {
    return Process::shell(command, scene);
  }
};

TEST_F(Pipes, EveryFormatGoesThroughStandardOutputAsIntoAFile) {
  for (const auto& [letter, extension] : {std::pair{'N', "png"},
                                          {'T', "tga"},
                                          {'C', "tga"},
                                          {'P', "ppm"},
                                          {'B', "bmp"},
                                          {'J', "jpg"},
                                          {'E', "exr"},
                                          {'H', "hdr"}}) {
    const std::string name = std::string("file.") + extension, type = std::string(" +F") + letter + " ";
    ASSERT_EQ(shell("$V render scene.pov +W16 +H12 --output " + name + type).status, 0) << letter;
    const Ended streamed = shell("cat | $V render - +W16 +H12 --output -" + type + " | cat > streamed");
    ASSERT_EQ(streamed.status, 0) << letter << streamed.errors;
    const image::Picture in_file = image::read_picture(folder_ / name);
    fs::rename(folder_ / "streamed", folder_ / (std::string("streamed.") + extension));
    const image::Picture through = image::read_picture(folder_ / (std::string("streamed.") + extension));
    EXPECT_EQ(in_file.samples, through.samples) << letter;
    EXPECT_EQ(in_file.width, 16);
  }
  const Ended layers = shell("$V render - --output - --layers all +FE +W8 +H8");
  EXPECT_EQ(layers.output.substr(0, 4), "\x76\x2f\x31\x01");
}

// What stood on standard output before stays there.
TEST_F(Pipes, APictureIsAppendedToWhatTheStreamHolds) {
  const Ended ended = shell("echo before; $V render scene.pov +W8 +H8 +O- +FJ");
  EXPECT_THAT(ended.output, StartsWith("before\n\xff\xd8"));
}

TEST_F(Pipes, AnyReadableStreamIsAScene) {
  EXPECT_EQ(shell("cat | $V render - +W8 +H8").status, 0);
  EXPECT_TRUE(exists("stdin.png"));
  EXPECT_EQ(shell("cat | $V render /dev/stdin +W8 +H8 +Odevice.png").status, 0);
  EXPECT_TRUE(exists("device.png"));
  EXPECT_EQ(shell("mkfifo pipe.pov && (cat > pipe.pov & $V render pipe.pov +W8 +H8)").status, 0);
  EXPECT_TRUE(exists("pipe.png"));
  EXPECT_EQ(shell("cat | $V +I- +W8 +H8 +Opovray.png").status, 0);
  EXPECT_TRUE(exists("povray.png"));
  // A stream is read once, whatever the number of frames.
  EXPECT_EQ(shell("cat | $V render - +W8 +H8 +KFF2 +Oframe.png",
                  std::string(kQuickScene) + "sphere { clock*x, 1 pigment { rgb 1 } }")
                .status,
            0);
  EXPECT_NE(image::read_picture(folder_ / "frame1.png").samples, image::read_picture(folder_ / "frame2.png").samples);
}

TEST_F(Pipes, TextThatIsNotSavedIsCheckedUnderItsName) {
  fs::create_directories(folder_ / "sub");
  file("sub/part.inc", "#declare Size = 1;\n");
  const std::string scene = "#version 3.7;\n#include \"part.inc\"\nsphere { 0, Size } sphre { 0, 1 }\n";
  const Ended ended = shell("$V check - --stdin-name sub/unsaved.pov --json", scene);
  EXPECT_EQ(ended.status, kSceneErrors);
  const auto report = nlohmann::json::parse(ended.output);
  bool found = false;
  for (const auto& d : report["diagnostics"])
    if (d["severity"] == "error") {
      EXPECT_EQ(d["file"], "sub/unsaved.pov");
      EXPECT_EQ(d["line"], 3);
      EXPECT_THAT(d["message"].get<std::string>(), HasSubstr("sphre"));
      found = true;
    }
  EXPECT_TRUE(found);
  EXPECT_EQ(shell("$V check --stdin-name sub/unsaved.pov", kQuickScene).status, 0);
  const Ended wrong = shell("$V check scene.pov --stdin-name other.pov");
  EXPECT_EQ(wrong.status, kUsage);
  EXPECT_THAT(wrong.errors, HasSubstr("standard input"));
}

TEST_F(Pipes, PixelsOfAStreamAreExplained) {
  const Ended ended = shell("cat | $V explain - 4 4 +W8 +H8 --no-oracle");
  EXPECT_EQ(ended.status, 0) << ended.errors;
  EXPECT_THAT(ended.output, HasSubstr("hits "));
}

TEST_F(Pipes, AnEndlessStreamEnds) {
  const Ended ended = shell("yes | $V check - --max-file-bytes 100000");
  EXPECT_EQ(ended.status, kInputOutput);
  EXPECT_THAT(ended.errors, HasSubstr("--max-file-bytes"));
}

TEST_F(Pipes, ClosedAndUnreadableStreamsAreErrors) {
  EXPECT_THAT(shell("$V check - <&-").errors, HasSubstr("cannot read the scene from standard input"));
  EXPECT_EQ(shell("$V render scene.pov +W8 +H8 +O- >/dev/full").status, kInputOutput);
  EXPECT_EQ(shell("$V render scene.pov +W8 +H8 +O- +FJ >/dev/full").status, kInputOutput);
}

}  // namespace
}  // namespace verisim::cli
