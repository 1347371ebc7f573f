#include "app/storage/level.hpp"

#include <gtest/gtest.h>
#include <set>

#include "app/text/text.hpp"

namespace {

const std::string sound = R"({"carom": 1, "name": "Mine", "width": 100, "height": 50, "balls": [
  {"x": 10, "y": 10, "role": "projectile"}, {"x": 60, "y": 10, "role": "enemy"}]})";

TEST(Level, ASoundOneHasItsNameAndAnIdentity) {
  const app::Level level = app::read_level("mine.json", sound);
  ASSERT_TRUE(level.scene);
  EXPECT_EQ(level.name, "Mine");
  EXPECT_EQ(level.problem, "");
  EXPECT_EQ(level.identity.size(), 16u);
}

TEST(Level, IsCalledLikeItsFileIfItHasNoName) {
  std::string text = sound;
  text.replace(text.find("\"name\": \"Mine\", "), 16, "");
  EXPECT_EQ(app::read_level("mine.json", text).name, "mine");
  // A link has no file's name, and that of a file kept for the player says nothing.
  const app::Level kept =
      app::read_level(app::read_level("mine.json", text).identity + ".json", text);
  EXPECT_EQ(kept.name, "");
  EXPECT_EQ(app::Words(app::Language::en).level_name(kept.name), "Unnamed level");
}

TEST(Level, TheIdentityIsThatOfTheContents) {
  const std::string identity = app::read_level("a.json", sound).identity;
  EXPECT_EQ(app::read_level("b.json", sound + "\n").identity, identity);
  std::string moved = sound;
  moved.replace(moved.find("60"), 2, "61");
  EXPECT_NE(app::read_level("a.json", moved).identity, identity);
}

TEST(Level, TheIdentityIsWithoutTheTextsForPeople) {
  std::string signed_one = sound;
  signed_one.insert(1, R"("author": "A", "licence": "B", "description": "C", )");
  EXPECT_EQ(app::read_level("a.json", signed_one).identity,
            app::read_level("a.json", sound).identity);
}

TEST(Level, ABrokenOneTellsItsFirstErrorWithItsPlace) {
  const app::Level level = app::read_level("mine.json", std::string("{\n  \"carom\": 1,\n x"));
  EXPECT_FALSE(level.scene);
  EXPECT_EQ(level.name, "mine");
  EXPECT_EQ(level.identity, "");
  EXPECT_TRUE(level.problem.starts_with("mine.json:3:2: ")) << level.problem;
}

TEST(Level, ASceneThatIsNotALevelTellsWhy) {
  const app::Level level = app::read_level(
      "table.json", std::string("{\"carom\": 1, \"width\": 100, \"height\": 50,\n \"balls\": []}"));
  EXPECT_FALSE(level.scene);
  EXPECT_TRUE(level.problem.starts_with("table.json:2:")) << level.problem;
  EXPECT_NE(level.problem.find("projectile"), std::string::npos) << level.problem;
}

TEST(Level, AFileThatCannotBeOpenedTellsWhy) {
  const app::Level level =
      app::read_level("none.json", carom::Error{.problem = "cannot be opened: No such file"});
  EXPECT_FALSE(level.scene);
  EXPECT_EQ(level.problem, "none.json: cannot be opened: No such file");
}

TEST(ShippedLevels, AreAllSoundAndDifferent) {
  const auto levels = app::shipped_levels();
  EXPECT_GE(levels.size(), 2u);
  std::set<std::string> identities;
  for (const app::Level& level : levels) {
    EXPECT_TRUE(level.scene) << level.problem;
    identities.insert(level.identity);
  }
  EXPECT_EQ(identities.size(), levels.size());
  EXPECT_EQ(levels.front().name, "First steps");
}

}  // namespace
