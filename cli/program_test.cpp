#include "cli/program.h"

#include <gtest/gtest.h>

TEST(Program, WithoutArgumentsIsBadUsage) { EXPECT_EQ(verisim::cli::run({"verisim"}), verisim::cli::kUsage); }
