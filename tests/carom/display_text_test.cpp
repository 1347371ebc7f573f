#include "carom/display_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <string>

#include "carom/result.hpp"

namespace {

TEST(DisplayText, LeavesWhatCanBeSeen) {
  for (const char* text : {"", "plain", "Zoé", "日本語", "שלום",
                           "a\xe2\x80\x8d"
                           "b",
                           "🎱", "back\\slash", "…"})
    EXPECT_EQ(carom::display_text(text), text);
}

TEST(DisplayText, WritesOutWhatMovesOrHides) {
  EXPECT_EQ(carom::display_text("a\nb\r\tc\x1b[2J\x7f"), "a\\u{a}b\\u{d}\\u{9}c\\u{1b}[2J\\u{7f}");
  EXPECT_EQ(carom::display_text(std::string("a\0b", 3)), "a\\u{0}b");
  EXPECT_EQ(carom::display_text("\xc2\x85\xc2\x9b"), "\\u{85}\\u{9b}");
  EXPECT_EQ(carom::display_text("\xe2\x80\xae"
                                "gpj.exe\xe2\x81\xa6"),
            "\\u{202e}gpj.exe\\u{2066}");
  EXPECT_EQ(carom::display_text("\xe2\x80\xa8\xe2\x80\xa9\xef\xbb\xbf\xe2\x80\x8b\xf3\xa0\x81\x81"),
            "\\u{2028}\\u{2029}\\u{feff}\\u{200b}\\u{e0041}");
}

TEST(DisplayText, WritesOutWhatIsNoUtf8) {
  EXPECT_EQ(carom::display_text("\xff\xc3"), "\\x{ff}\\x{c3}");
  EXPECT_EQ(carom::display_text("\xc0\xaf"), "\\x{c0}\\x{af}") << "overlong";
  EXPECT_EQ(carom::display_text("\xed\xa0\x80"), "\\x{ed}\\x{a0}\\x{80}") << "a surrogate";
  EXPECT_EQ(carom::display_text("\xf4\x90\x80\x80"), "\\x{f4}\\x{90}\\x{80}\\x{80}");
}

TEST(DisplayText, OfAnyBytesIsFitToShow) {
  rc::check("nothing is left to write out the second time", [](const std::string& bytes) {
    const std::string shown = carom::display_text(bytes);
    RC_ASSERT(carom::display_text(shown) == shown);
  });
}

TEST(DisplayText, ErrorsAreOneLine) {
  const carom::Error error{.pointer = "/a\x1b[2J", .problem = "is \"x\ny\"", .line = 2};
  EXPECT_EQ(carom::to_string(error, "evil\n\x1b]0;name.json"),
            "evil\\u{a}\\u{1b}]0;name.json:2: /a\\u{1b}[2J: is \"x\\u{a}y\"");
}

}  // namespace
