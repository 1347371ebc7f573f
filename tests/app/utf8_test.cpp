#include "app/base/utf8.hpp"

#include <gtest/gtest.h>
#include <string>

namespace {

TEST(Utf8, FirstCodePointIsReadWithItsSize) {
  EXPECT_EQ(app::first_code_point("ab").code, U'a');
  EXPECT_EQ(app::first_code_point("ß").code, U'ß');
  EXPECT_EQ(app::first_code_point("ß").size, 2U);
  EXPECT_EQ(app::first_code_point("…x").size, 3U);
  EXPECT_EQ(app::first_code_point("\U0001F3B1!").code, U'\U0001F3B1');
  EXPECT_EQ(app::first_code_point("\U0001F3B1!").size, 4U);
  EXPECT_EQ(app::first_code_point("\U0010FFFF").size, 4U);
}

TEST(Utf8, InvalidBytesAreRefused) {
  for (const char* const wrong : {"", "\x80", "\xc3", "\xc0\x80", "\xe2\x80", "\xed\xa0\x80",
                                  "\xf4\x90\x80\x80", "\xff", "\xc3(", "\xe0\x80\x80"})
    EXPECT_EQ(app::first_code_point(wrong).size, 0U) << wrong;
}

TEST(Utf8, TakingCodePointsEndsForAnyBytes) {
  std::string_view text = "a\xc3\xa9\xff\xe2\x80";
  std::u32string taken;
  while (!text.empty()) taken += app::take_code_point(text);
  EXPECT_EQ(taken, U"aé\ufffd\ufffd\ufffd");
}

TEST(Utf8, LastCodePointIsCutOffWhole) {
  EXPECT_EQ(app::without_last_code_point("aé"), "a");
  EXPECT_EQ(app::without_last_code_point("a\U0001F3B1"), "a");
  EXPECT_EQ(app::without_last_code_point("a"), "");
  EXPECT_EQ(app::without_last_code_point(""), "");
  EXPECT_EQ(app::without_last_code_point("\x80\x80"), "");
}

}  // namespace
