// Every switch and every INI keyword of spec 02 section 9.6, and the rules of 9.3.
#include "cli/settings/reading/switches.h"
#include "cli/settings/values.h"

#include <gtest/gtest.h>

#include <functional>

namespace verisim::cli {
namespace {

using Check = std::function<bool(const Options&)>;

struct SwitchCase {
  const char* word;
  Check holds;
};

// Accepted switches with what they change; `true` alone: accepted without effect on Options.
const std::vector<SwitchCase> kAccepted{
    {"+AG1.5", [](const Options& o) { return o.antialias_gamma == 1.5; }},
    {"+AM2", [](const Options& o) { return o.sampling_method == 2; }},
    {"+AM7", [](const Options& o) { return o.sampling_method == 2; }},
    {"+A0.3", [](const Options& o) { return o.antialias && o.antialias_threshold == 0.3; }},
    {"-A0.2", [](const Options& o) { return !o.antialias && o.antialias_threshold == 0.2; }},
    {"+A00.5", [](const Options& o) { return o.antialias && o.antialias_threshold == 0.5; }},
    {"+A01", [](const Options& o) { return o.antialias && o.antialias_threshold == 1; }},
    {"+A0.3x", [](const Options& o) { return o.antialias && o.antialias_threshold == 0.3; }},
    {"+A", [](const Options& o) { return o.antialias; }},
    {"-A", [](const Options& o) { return !o.antialias; }},
    {"+BM2", [](const Options& o) { return o.bounding_method == 2; }},
    {"+BS16", [](const Options& o) { return o.block_size == 16; }},
    {"-B", [](const Options& o) { return !o.bounding; }},
    {"+C", [](const Options& o) { return o.continue_trace; }},
    {"-D", [](const Options& o) { return !o.display; }},
    {"+DGT", [](const Options& o) { return o.display; }},
    {"+EC10", [](const Options& o) { return o.end_column == 10; }},
    {"+ER0.5", [](const Options& o) { return o.end_row == 0.5; }},
    {"+SC2", [](const Options& o) { return o.start_column == 2; }},
    {"+SR3", [](const Options& o) { return o.start_row == 3; }},
    {"+EF0.5", [](const Options& o) { return o.subset_end == 0.5; }},
    {"+EF7", [](const Options& o) { return o.subset_end == 7; }},
    {"+SF0.25", [](const Options& o) { return o.subset_start == 0.25; }},
    {"+SF3", [](const Options& o) { return o.subset_start == 3; }},
    {"+EP4", [](const Options& o) { return o.preview_end == 4; }},
    {"+SP8", [](const Options& o) { return o.preview_start == 8; }},
    {"+FN16", [](const Options& o) { return o.format == image::Format::png && o.bits == 16 && o.output_to_file; }},
    {"+fn3", [](const Options& o) { return o.bits == 5; }},
    {"+FNg", [](const Options& o) { return o.greyscale; }},
    {"+FPg", [](const Options& o) { return o.greyscale && o.format == image::Format::ppm; }},
    {"+FT", [](const Options& o) { return o.format == image::Format::tga; }},
    {"+FC", [](const Options& o) { return o.format == image::Format::tga_rle; }},
    {"+FP", [](const Options& o) { return o.format == image::Format::ppm; }},
    {"+FB", [](const Options& o) { return o.format == image::Format::bmp; }},
    {"+FJ", [](const Options& o) { return o.format == image::Format::jpeg; }},
    {"+FE", [](const Options& o) { return o.format == image::Format::exr; }},
    {"+FH", [](const Options& o) { return o.format == image::Format::hdr; }},
    {"-F", [](const Options& o) { return !o.output_to_file; }},
    {"-GA", [](const Options& o) { return o.all_given && !o.all.console; }},
    {"+GAall.txt", [](const Options& o) { return o.all.file == "all.txt"; }},
    {"-GD", [](const Options& o) { return !o.debug.console; }},
    {"+GDd.txt", [](const Options& o) { return o.debug.console && o.debug.file == "d.txt"; }},
    {"-GF", [](const Options& o) { return !o.fatal.console; }},
    {"+GFon", [](const Options& o) { return o.fatal.file == "fatal.out"; }},
    {"-GR", [](const Options& o) { return !o.render.console; }},
    {"+GRtrue", [](const Options& o) { return o.render.file == "render.out"; }},
    {"-GS", [](const Options& o) { return !o.statistic.console; }},
    {"+GS1", [](const Options& o) { return o.statistic.file == "stats.out"; }},
    {"-GW", [](const Options& o) { return !o.warning.console; }},
    {"+GWyes", [](const Options& o) { return o.warning.file == "warning.out"; }},
    {"+GIall.ini", [](const Options& o) { return o.create_ini == "all.ini"; }},
    {"+GP", [](const Options& o) { return o.append_files; }},
    {"+HIh.inc", [](const Options& o) { return o.include_header == "h.inc"; }},
    {"+HR", [](const Options&) { return true; }},
    {"+H240", [](const Options& o) { return o.height == 240; }},
    {"+Ifoo.pov", [](const Options& o) { return o.input_file == "foo.pov"; }},
    {"+J0.5", [](const Options& o) { return o.jitter && o.jitter_amount == 0.5; }},
    {"-J", [](const Options& o) { return !o.jitter; }},
    {"+KC", [](const Options& o) { return o.cyclic; }},
    {"+KI2", [](const Options& o) { return o.initial_clock == 2; }},
    {"+KFF10", [](const Options& o) { return o.final_frame == 10; }},
    {"+KFI2", [](const Options& o) { return o.initial_frame == 2; }},
    {"+KF3", [](const Options& o) { return o.final_clock == 3; }},
    {"+KLA", [](const Options& o) { return o.clockless; }},
    {"+K0.7", [](const Options& o) { return o.clock == 0.7; }},
    {"+Llib", [](const Options& o) { return o.library_paths == std::vector<std::string>{"lib"}; }},
    {"-MB", [](const Options& o) { return !o.bounding; }},
    {"+MB", [](const Options& o) { return o.bounding && o.bounding_threshold == 3; }},
    {"+MB10", [](const Options& o) { return o.bounding && o.bounding_threshold == 10; }},
    {"+MI64", [](const Options&) { return true; }},
    {"+MV3.5", [](const Options& o) { return o.version == 3.5; }},
    {"+Oout.png", [](const Options& o) { return o.output_file == "out.png"; }},
    {"+P", [](const Options& o) { return o.pause; }},
    {"+Q4", [](const Options& o) { return o.quality == 4; }},
    {"+Q11", [](const Options& o) { return o.quality == 9; }},
    {"+RFI", [](const Options& o) { return o.radiosity_from_file; }},
    {"+RFO", [](const Options& o) { return o.radiosity_to_file; }},
    {"+RFa.rca", [](const Options& o) { return o.radiosity_file == "a.rca"; }},
    {"+RVP", [](const Options&) { return true; }},
    {"+RS3", [](const Options&) { return true; }},
    {"+RP2", [](const Options&) { return true; }},
    {"+RTR", [](const Options& o) { return o.real_time; }},
    {"+R5", [](const Options& o) { return o.antialias_depth == 5; }},
    {"+R20", [](const Options& o) { return o.antialias_depth == 9; }},
    {"+STP2", [](const Options& o) { return o.frame_step == 2; }},
    {"+SU", [](const Options& o) { return o.split_unions; }},
    {"+THb2", [](const Options& o) { return o.dither && o.dither_method == image::Dither::bayer2; }},
    {"+TH", [](const Options& o) { return o.dither && o.dither_method == image::Dither::floyd_steinberg; }},
    {"+UA", [](const Options& o) { return o.output_alpha; }},
    {"-UR", [](const Options& o) { return !o.remove_bounds; }},
    {"+UD", [](const Options&) { return true; }},
    {"+UF", [](const Options&) { return true; }},
    {"+UL", [](const Options&) { return true; }},
    {"+UO", [](const Options&) { return true; }},
    {"+UV", [](const Options&) { return true; }},
    {"-V", [](const Options& o) { return !o.verbose; }},
    {"+WL5", [](const Options&) { return true; }},
    {"+WT4", [](const Options& o) { return o.threads == 4; }},
    {"+W320", [](const Options& o) { return o.width == 320; }},
    {"+w320", [](const Options& o) { return o.width == 320; }},
    {"+X", [](const Options&) { return true; }},
    {"+X100", [](const Options&) { return true; }},
};

TEST(Switches, EachDoesWhatItSays) {
  for (const SwitchCase& test : kAccepted) {
    Options options;
    ASSERT_NO_THROW(apply_switch(options, test.word)) << test.word;
    EXPECT_TRUE(test.holds(options)) << test.word;
  }
}

TEST(Switches, TheTableHasNoRowWithoutATest) {
  for (const Switch& entry : switches()) {
    bool used = false;
    for (const SwitchCase& test : kAccepted) {
      // The row that answers a word is the first that fits.
      const std::string body = test.word + 1;
      for (const Switch& row : switches()) {
        const bool prefix = body.size() >= row.name.size() &&
                            std::equal(row.name.begin(), row.name.end(), body.begin(),
                                       [](char a, char b) { return std::toupper(a) == std::toupper(b); });
        if (!prefix || (body.size() == row.name.size()) != row.value_key.empty()) continue;
        used |= &row == &entry;
        break;
      }
    }
    EXPECT_TRUE(used) << entry.name << (entry.value_key.empty() ? "" : " with a value");
  }
}

TEST(Switches, KeysOfTheTableExist) {
  for (const Switch& entry : switches()) {
    EXPECT_TRUE(entry.value_key.empty() || entry.value_key == "+F" || is_setting(entry.value_key)) << entry.name;
    EXPECT_TRUE(entry.flag_key.empty() || is_setting(entry.flag_key)) << entry.name;
  }
}

TEST(Switches, WhatPovRayRefusesIsRefused) {
  for (const char* word : {"+A.3", "+A1", "+A0", "+B1000", "+ZZ", "+W", "+Wx", "+FS", "+FZ", "+FTg", "+FBg", "+FN8x",
                           "+THXX", "+V3", "+I", "+UX", "+AM"}) {
    Options options;
    EXPECT_THROW(apply_switch(options, word), OptionError) << word;
  }
}

std::string error_of(const std::function<void(Options&)>& action) {
  Options options;
  try {
    action(options);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(Switches, ErrorsNameTheWordAndAdvise) {
  EXPECT_NE(error_of([](Options& o) { apply_switch(o, "+ZZ9"); }).find("'+ZZ9'"), std::string::npos);
  EXPECT_NE(error_of([](Options& o) { apply_switch(o, "+A.3"); }).find("+A0.3"), std::string::npos);
  EXPECT_NE(error_of([](Options& o) { set(o, "Widht", "3"); }).find("did you mean Width"), std::string::npos);
  EXPECT_NE(error_of([](Options& o) { set(o, "Antialias_Treshold", "3"); }).find("did you mean Antialias_Threshold"),
            std::string::npos);
  EXPECT_NE(error_of([](Options& o) { set(o, "Width", "many"); }).find("Width"), std::string::npos);
}

TEST(Settings, EachKeywordTakesAValue) {
  // A value every keyword's type accepts where there is one; the exceptions have their own.
  for (const Setting& setting : settings()) {
    std::string value = "1";
    if (setting.key == "Output_File_Type") value = "N8";
    if (setting.key == "Dither_Method") value = "B2";
    if (setting.key == "Declare") value = "a=1";
    Options options;
    EXPECT_NO_THROW(set(options, setting.key, value)) << setting.key;
    ASSERT_EQ(options.given.size(), 1u) << setting.key;
    EXPECT_EQ(options.given[0].first, setting.key);
  }
}

TEST(Settings, BooleansAgreeOverTheCommonLength) {
  for (const char* yes : {"on", "ON", "true", "t", "yes", "y", "1", "", "o", "only", "12"})
    EXPECT_TRUE(to_bool(yes)) << yes;
  for (const char* no : {"off", "false", "no", "0", "maybe"}) EXPECT_FALSE(to_bool(no)) << no;
}

TEST(Settings, OutputFileTypeReadsOnlyTheLetter) {
  Options options;
  set(options, "Output_File_Type", "n16");
  EXPECT_EQ(options.format, image::Format::png);
  EXPECT_EQ(options.bits, 8);
}

TEST(Settings, DeclarationsPassThroughFloatAndTheFirstCounts) {
  Options options;
  set(options, "Declare", "foo=3.14159265358979");
  set(options, "declare", "foo=2");
  set(options, "Declare", "bar=text");
  set(options, "Declare", "s=\"a b\"");
  ASSERT_EQ(options.declarations.size(), 3u);
  EXPECT_EQ(options.declarations[0], std::pair(std::string("foo"), std::string("3.14159")));
  EXPECT_EQ(options.declarations[1].second, "0");
  EXPECT_EQ(options.declarations[2].second, "\"a b\"");
  EXPECT_THROW(set(options, "Declare", "3=4"), OptionError);
}

TEST(Settings, FileGamma) {
  Options options;
  set(options, "File_Gamma", "1.0");
  EXPECT_FALSE(options.file_srgb);
  EXPECT_EQ(options.file_gamma, 1);
  set(options, "File_Gamma", "SRGB");
  EXPECT_TRUE(options.file_srgb);
  EXPECT_THROW(set(options, "File_Gamma", "foo"), OptionError);
  EXPECT_THROW(set(options, "File_Gamma", "0"), OptionError);
}

TEST(Settings, LibraryPathsAccumulateWithoutDuplicates) {
  Options options;
  for (const char* path : {"a", "b/", "a"}) set(options, "Library_Path", path);
  EXPECT_EQ(options.library_paths, (std::vector<std::string>{"a", "b"}));
}

TEST(Settings, ValidationRefusesWhatCannotBe) {
  const auto bad = [](std::initializer_list<const char*> words) {
    Options options;
    for (const char* word : words) apply_switch(options, word);
    EXPECT_THROW(validate(options), OptionError) << *words.begin();
  };
  bad({"+W0"});
  bad({"+H-5"});
  bad({"+BS3"});
  bad({"+W100000", "+H100000"});
  bad({"+FNg", "+FB"});
  bad({"+RTR"});
  Options fine;
  EXPECT_NO_THROW(validate(fine));
}

}  // namespace
}  // namespace verisim::cli
