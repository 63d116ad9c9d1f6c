// What POV-Ray and verisim print of a scene, and how it differs.
#include "compare/reduce/messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace verisim::compare {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kPovRay =
    "POV-Ray 3.7.0\n"
    "==== [Parsing...] ===\n"
    "hello\n"
    "Parsing 3K tokens\rFile 'a.pov' line 2: Parse Warning: Unnecessary bounding\n"
    " object removed.\n"
    "one two that is wrapped\n"
    " here\n"
    "File 'a.pov' line 9: Possible Parse Error: A semicolon is missing.\n"
    "Parse Warning: assumed_gamma not specified\n"
    "----------\n"
    "Parser Statistics\n";
constexpr const char* kVerisim =
    "hello\n"
    "a.pov:2:46: warning: Unnecessary bounding object removed. [no-effect]\n"
    "     8 | sphere { 0, 1 bounded_by { sphere { 0, 2 } } }\n"
    "       |                                              ^\n"
    "one two that is wrapped here\n"
    "a.pov:9:1: possible error: A semicolon is missing. [missing-semicolon]\n"
    "16 by 12: parsed in 0.00 s, rendered in 0.00 s, wrote w.png\n";

TEST(Messages, OfBothPrograms) {
  for (const char* console : {kPovRay, kVerisim}) {
    const Messages said = messages_of(console);
    EXPECT_THAT(said.warnings, ElementsAre("Unnecessary bounding object removed.", "A semicolon is missing."));
    EXPECT_EQ(said.debug, "helloonetwothatiswrappedhere");
  }
  EXPECT_EQ(message_difference(messages_of(kVerisim), messages_of(kPovRay)).kind, Difference::Kind::none);
}

Messages said(std::vector<std::string> warnings, std::string debug = "") {
  return {std::move(warnings), std::move(debug)};
}

TEST(Messages, AWarningOfOneOnly) {
  const Difference d = message_difference(said({"Bounds of no use.", "No objects in 3."}), said({"No objects in 7."}));
  EXPECT_EQ(d.kind, Difference::Kind::verisim_warns);
  EXPECT_EQ(d.message, "Bounds of no use.");
  EXPECT_EQ(in_words(d), "only verisim warns: Bounds of no use.");
  EXPECT_EQ(message_difference(said({}), said({"Bounds"})).kind, Difference::Kind::povray_warns);
}

// Equally many that the other does not know: they are of the same things in other words.
TEST(Messages, EachHasWordsOfItsOwn) {
  EXPECT_EQ(message_difference(said({"Prism closed."}), said({"Linear prism not closed. Closing it."})).kind,
            Difference::Kind::none);
  const Difference d = message_difference(said({"Prism closed."}), said({"Camera bad", "Linear prism not closed."}));
  EXPECT_EQ(d.kind, Difference::Kind::povray_warns);
  EXPECT_EQ(d.message, "Camera bad");
}

TEST(Messages, TheOneThatIsWantedAmongSeveral) {
  Difference wanted;
  wanted.kind = Difference::Kind::povray_warns, wanted.message = "No 'b' here";
  EXPECT_EQ(message_difference(said({}), said({"One a", "No 'c' here"}), &wanted).message, "No 'c' here");
}

TEST(Messages, TextOfDebug) {
  EXPECT_EQ(message_difference(said({}, "ab"), said({}, "a")).kind,
            Difference::Kind::none);  // POV-Ray writes whole lines only
  const Difference d = message_difference(said({}, "x=1,y=2"), said({}, "x=1,y=3"));
  EXPECT_EQ(d.kind, Difference::Kind::debug_text);
  EXPECT_THAT(d.message, HasSubstr("'3' in POV-Ray, '2' here"));
}

}  // namespace
}  // namespace verisim::compare
