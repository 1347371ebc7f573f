#include "carom/result.hpp"

#include <gtest/gtest.h>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "carom/scene_file.hpp"

namespace {

using carom::Message;
using carom::MessageCode;
using carom::Result;

TEST(Message, HasATemplateAndANameForEveryCode) {
  std::set<std::string_view> names;
  for (int n = 0; n <= static_cast<int>(MessageCode::finite_numbers); ++n) {
    const auto code = static_cast<MessageCode>(n);
    EXPECT_FALSE(english(code).empty()) << n;
    EXPECT_TRUE(names.insert(name(code)).second) << name(code);
  }
  EXPECT_EQ(name(MessageCode::is_missing), "is_missing");
  EXPECT_EQ(english(MessageCode::is_missing), "is missing");
}

TEST(Message, IsFilledWithItsArguments) {
  EXPECT_EQ(to_string(Message(MessageCode::is_second_lead, {"\"cue\"", "\"red\""})),
            "is \"cue\", but ball 0 is \"red\" already");
  EXPECT_EQ(carom::fill("{1}{0}{1}", {"a", "{0}"}), "{0}a{0}");
  EXPECT_EQ(carom::fill("{0} of {2}", {"a"}), "a of ");
  EXPECT_EQ(carom::fill("{{\"x\": {0}}", {"1"}), "{\"x\": 1}");
  EXPECT_EQ(carom::fill("{", {}), "{");
  EXPECT_EQ(to_string(Message()), "");
  EXPECT_TRUE(Message("").empty());
  EXPECT_FALSE(Message(MessageCode::is_missing).empty());
}

TEST(Error, HasACodeAndArguments) {
  const auto scene = carom::read_scene(R"({"carom": 1, "width": -5, "height": 50})");
  ASSERT_FALSE(scene);
  ASSERT_EQ(scene.errors().size(), 2U);
  EXPECT_EQ(scene.errors()[0].problem, Message(MessageCode::is_missing));
  EXPECT_EQ(scene.errors()[0].expected, Message(MessageCode::array_of_balls));
  EXPECT_EQ(scene.errors()[1].problem, Message(MessageCode::is, {"-5"}));
  EXPECT_EQ(scene.errors()[1].expected,
            Message(MessageCode::number_from_to, {"0.001", "1000000000", " (px)"}));
}

TEST(Result, GivesAValueAwayByValue) {
  static_assert(std::is_same_v<decltype(std::declval<Result<std::string>>().value()), std::string>);
  const std::string& kept = Result<std::string>("a text that outlives its result").value();
  EXPECT_EQ(kept, "a text that outlives its result");
}

#if !defined(NDEBUG) && GTEST_HAS_DEATH_TEST
TEST(ResultDeathTest, ReadWithoutAValueStopsWithTheError) {
  const Result<int> none = carom::Error{.pointer = "/x", .problem = MessageCode::is_missing};
  EXPECT_DEATH(static_cast<void>(none.value()), "/x: is missing");
  const Result<int> one = 1;
  EXPECT_DEATH(static_cast<void>(one.errors()), "no error");
}
#endif

}  // namespace
