#include "app/widgets/level_fault.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace {

using app::Language;

std::string in_french(const std::string& bytes) {
  return app::problem_of(app::Words(Language::fr), app::read_level("a.json", bytes));
}

TEST(LevelFault, IsToldInThePlayersLanguage) {
  const std::string bytes = R"({"carom": 1, "width": -5, "height": 50, "balls": []})";
  const app::Level level = app::read_level("a.json", bytes);
  EXPECT_EQ(app::problem_of(app::Words(Language::en), level), level.problem);
  EXPECT_EQ(in_french(bytes),
            "a.json:1:23: /width: vaut -5 ; attendu : un nombre de 0.001 à 1000000000 (px)");
  EXPECT_EQ(in_french(R"({"carom": 1, "width": 9, "height": 5, "balls": [], "thing": 1})"),
            "a.json:1:52: /thing: est une clé inconnue ; attendu : l’une de $schema, carom, name, "
            "author, licence, description, width, "
            "height, edges, friction, gravity, hole_pull, damage_per_speed, damage_threshold, "
            "throws, holes, obstacles, balls");
  EXPECT_EQ(in_french("{"), "a.json:1:2: n’est pas du JSON valable");
  EXPECT_EQ(in_french(""), "a.json:1:1: est vide");
  EXPECT_EQ(app::problem_of(app::Words(Language::fr), app::shipped_levels()[0]), "");
  EXPECT_EQ(
      app::problem_of(
          app::Words(Language::fr),
          app::read_level("b.json",
                          carom::Error{.problem = {carom::MessageCode::cannot_be_opened, {"x"}}})),
      "b.json: ne s’ouvre pas");
}

/// Of all that the tests know to be wrong in a level.
TEST(LevelFault, LeavesNoEnglishInAnotherLanguage) {
  int wrong = 0;
  for (const char* const folder : {"/tests/levels/wrong", "/tests/scenes/wrong"}) {
    for (const auto& entry :
         std::filesystem::directory_iterator(SOURCE_DIR + std::string(folder))) {
      if (entry.path().extension() != ".json") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string bytes(std::istreambuf_iterator<char>(file), {});
      const app::Level level = app::read_level("a.json", bytes);
      if (level.scene) continue;
      ++wrong;
      for (const Language language : app::all_languages()) {
        if (language == Language::en) continue;
        const std::string text = app::problem_of(app::Words(language), level);
        for (const char* const word : {" is ", " are ", " has ", " have ", " must ", "expected",
                                       " at ", " of ", " and ", " to ", " a number", " than "})
          EXPECT_EQ(text.find(word), std::string::npos) << text << "\n" << entry.path();
      }
    }
  }
  EXPECT_GT(wrong, 50);
}

}  // namespace
