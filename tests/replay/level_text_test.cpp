#include "replay/level_text.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

#include "carom/scene_file.hpp"
#include "games/angry_balls.hpp"
#include "replay/replay_text.hpp"
#include "replay/text_of.hpp"

namespace {

constexpr char version = 65;

std::string problem(std::string_view text) {
  const auto read = replay::read_level_text(text);
  return read ? "no problem" : carom::to_string(read.errors().front());
}

carom::Scene shipped(const std::string& name) {
  std::ifstream file(SOURCE_DIR "/levels/" + name, std::ios::binary);
  return games::angry_balls::read_level(std::string(std::istreambuf_iterator<char>(file), {}))
      .value();
}

TEST(LevelText, FollowsTheDocumentedFormatAndReadsBack) {
  const carom::Scene level = shipped("01-first-steps.json");
  const std::string text = replay::write_level_text(level);
  EXPECT_EQ(text, recorded::text_of(carom::write_scene(level), version));
  EXPECT_EQ(replay::read_level_text(text).value(), level);
}

TEST(LevelText, RefusesATextCutOffOrChangedAnywhere) {
  const std::string text = replay::write_level_text(shipped("01-first-steps.json"));
  for (std::size_t i = 0; i < text.size(); ++i) {
    EXPECT_NE(problem(std::string_view(text).substr(0, i)), "no problem") << i;
    std::string changed = text;
    changed[i] = changed[i] == 'A' ? 'B' : 'A';
    EXPECT_NE(problem(changed), "no problem") << i;
  }
}

TEST(LevelText, RefusesWhatIsNoLevelOrNotWrittenSo) {
  const std::string level = carom::write_scene(shipped("01-first-steps.json"));
  EXPECT_EQ(
      problem(recorded::text_of(level + "\n", version)),
      "is damaged: it is not written as it should be; expected the text of a level, whole and "
      "unchanged");
  EXPECT_NE(problem(recorded::text_of("{}", version)), "no problem");
  EXPECT_NE(problem(recorded::text_of({}, version)), "no problem");
  EXPECT_NE(problem(recorded::text_of(std::string(5 << 20, ' ') + level, version)), "no problem");
}

TEST(LevelText, AndAReplaysTextAreNotTakenForEachOther) {
  EXPECT_EQ(problem(replay::write_text({})),
            "is version 1 of the text of a level; expected version 65");
  const auto read = replay::read_text(replay::write_level_text(shipped("01-first-steps.json")));
  ASSERT_FALSE(read);
  EXPECT_EQ(carom::to_string(read.errors().front()),
            "is version 65 of the text of a replay; expected version 1");
}

}  // namespace
