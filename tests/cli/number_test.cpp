#include "cli/number.hpp"

#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <optional>

namespace {

TEST(Number, WholeNumbersAreDecimalDigits) {
  EXPECT_EQ(cli::read_whole("0"), 0U);
  EXPECT_EQ(cli::read_whole("010"), 10U);
  EXPECT_EQ(cli::read_whole("0100"), 100U);
  EXPECT_EQ(cli::read_whole("08"), 8U);
  EXPECT_EQ(cli::read_whole("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  for (const char* wrong : {"",
                            " ",
                            "18446744073709551616",
                            "99999999999999999999999",
                            "0x10",
                            "0b1",
                            "1e3",
                            "1.0",
                            "1.",
                            "-1",
                            "-0",
                            "+1",
                            "1-",
                            "1+",
                            "1 ",
                            " 1",
                            "1,",
                            "1'000",
                            "1_000",
                            "١",
                            "many",
                            "1\n"})
    EXPECT_EQ(cli::read_whole(wrong), std::nullopt) << wrong;
  EXPECT_EQ(cli::read_whole(std::string_view("1\0", 2)), std::nullopt);
}

TEST(Number, NumbersAreDecimal) {
  EXPECT_EQ(cli::read_number("0100"), 100);
  EXPECT_EQ(cli::read_number("010.5"), 10.5);
  EXPECT_EQ(cli::read_number("-.5"), -0.5);
  EXPECT_EQ(cli::read_number("1e3"), 1000);
  EXPECT_EQ(cli::read_number("1E-3"), 0.001);
  for (const char* wrong :
       {"",   " ",  "-",  ".",  "e5",  "0x10", "0x1p3", "inf", "-inf", "nan", "1e999", "-1e999",
        "+1", "1+", "1-", "1e", "1e+", "--1",  "1 ",    " 1",  "1,5",  "1'0", "1.2.3", "1\n"})
    EXPECT_EQ(cli::read_number(wrong), std::nullopt) << wrong;
}

}  // namespace
