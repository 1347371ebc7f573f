// The settings, changed by all that a player can do, hold at once, everywhere, and at the next
// start.

#include "app/screens/settings_screen.hpp"

#include "app/player.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;
using app::Language;

app::Settings stored(app::Store& store) { return app::KeptSettings(store).get(); }

/// Presses the line of the language, in whatever language it is, until `language` is chosen.
void choose(Player& game, Language language) {
  for (std::size_t i = 0; i <= app::language_codes.size(); ++i) {
    const auto now = game.app().settings().get().language;
    if (now == language) return;
    game.press(app::Words(now.value_or(Language::en))(app::Text::set_language) + "\n");
  }
  ADD_FAILURE() << "no " << app::name_of(language);
}

/// One start of the program.
struct Start : Player {
  explicit Start(app::Store& shared, app::StartLanguage language = Language::en)
      : Player(language, 1000, 720, {}, shared) {}

  void type(const std::string& text) { app().event(app::TextTyped{text}); }
  app::Rect line(std::string_view label) {
    for (const app::Box& box : boxes())
      if (box.kind == app::Box::Kind::button && box.text.starts_with(std::string(label) + "\n"))
        return box.area;
    ADD_FAILURE() << "no line " << label << " in " << title();
    return {};
  }
  std::string value(std::string_view label) {
    for (const app::Box& box : boxes())
      if (box.kind == app::Box::Kind::button && box.text.starts_with(std::string(label) + "\n"))
        return box.text.substr(label.size() + 1);
    return "no line " + std::string(label);
  }
};

TEST(SettingsScreen, AClickGoesToTheNextValueAndOnTheArrowBack) {
  app::MemoryStore store;
  Start game(store);
  game.press("Settings");
  ASSERT_TRUE(game.says("Settings · General")) << game.title();
  EXPECT_EQ(game.value("Volume"), "80%");
  game.press("Volume\n");
  EXPECT_EQ(game.value("Volume"), "90%");
  for (int i = 0; i < 3; ++i) game.press("Volume\n");
  EXPECT_EQ(game.value("Volume"), "100%") << "no further";
  EXPECT_EQ(stored(store).volume, 100);
  const app::Rect line = game.line("Volume");
  game.click({line.x + line.w * 0.52f + 20, line.center().y});
  EXPECT_EQ(game.value("Volume"), "90%");
  game.click({line.right() - 20, line.center().y});
  EXPECT_EQ(game.value("Volume"), "100%");
  game.press("Mute");
  EXPECT_TRUE(stored(store).mute);
  game.press("Close");
  EXPECT_TRUE(game.says("title screen"));
}

/// On a phone in a browser no keyboard comes up by itself.
TEST(SettingsScreen, AFingerIsAskedForAName) {
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  std::optional<std::string> answer = "  Zoé\n";
  std::vector<std::string> asked;
  app::HostEnvironment page;
  page.ask_text = [&](const std::string& what, const std::string& text) {
    asked.push_back(what + "|" + text);
    return answer;
  };
  app::App game(Language::en, 390, 844, store, clipboard, {}, page);
  const auto tap = [&](std::string_view label) {
    const auto boxes = game.draw().boxes;
    const auto box = std::ranges::find_if(boxes, [&](const app::Box& one) {
      return one.kind == app::Box::Kind::button && one.text.starts_with(label);
    });
    ASSERT_NE(box, boxes.end()) << label;
    for (const auto phase : {app::Finger::Phase::down, app::Finger::Phase::up})
      game.event(app::Finger{1, phase, box->area.center()});
  };
  tap("Settings");
  tap("Players");
  tap("Name of player 2");
  EXPECT_EQ(stored(store).names[1], "Zoé");
  answer.reset();
  tap("Name of player 2");
  EXPECT_EQ(stored(store).names[1], "Zoé") << "taken back";
  EXPECT_EQ(asked, (std::vector<std::string>{"Name of player 2|", "Name of player 2|Zoé"}));
  EXPECT_EQ(game.describe().find("Name"), std::string::npos) << "no field waits for keys";
}

/// The help needs no keyboard: it opens over the settings and leaves them as they were.
TEST(SettingsScreen, TheHelpIsATapAway) {
  app::MemoryStore store;
  Start game(store);
  game.press("Settings");
  game.press("Help");
  EXPECT_TRUE(game.says("Help")) << game.title();
  game.press("Close");
  EXPECT_TRUE(game.says("Settings · General")) << game.title();
}

/// A phone speaks of fingers before the first touches it, until a mouse is there.
TEST(SettingsScreen, APhoneIsForFingersFromTheStart) {
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::HostEnvironment page;
  page.touch = true;
  app::App game(Language::en, 390, 844, store, clipboard, {}, page);
  game.event(app::KeyPressed{Key::settings});
  const auto shows = [&](std::string_view text) {
    const auto boxes = game.draw().boxes;
    return std::ranges::any_of(boxes,
                               [&](const app::Box& box) { return box.text.starts_with(text); });
  };
  EXPECT_TRUE(shows("Tap a line to change it."));
  for (const app::Box& box : game.draw().boxes)
    EXPECT_TRUE(box.kind != app::Box::Kind::button || box.area.h >= app::finger_target) << box.text;
  game.event(app::PointerPressed{{1, 1}});
  EXPECT_TRUE(shows("Click a line"));
}

/// A phone shows a page of it at a time.
TEST(SettingsScreen, TheHelpBeginsWithTheHandInUse) {
  for (const bool finger : {false, true}) {
    Player game(Language::en, 390, 844);
    game.touches = finger;
    game.press("Settings");
    game.press("Help");
    EXPECT_EQ(game.shows("Two taps"), finger);
    EXPECT_EQ(game.shows("Turn by 1°"), true);
  }
}

/// A press that slips off, and the right button, change nothing.
TEST(SettingsScreen, OnlyAWholeClickCounts) {
  app::MemoryStore store;
  Start game(store);
  game.press("Settings");
  const app::Point at = game.line("Mute").center();
  game.app().event(app::PointerPressed{at});
  game.app().event(app::PointerReleased{game.line("Hints").center()});
  game.click(at, app::PointerButton::right);
  EXPECT_EQ(stored(store), app::Settings{});
}

TEST(SettingsScreen, EveryLineIsReachedAndChangedByKeys) {
  app::MemoryStore store;
  Start game(store);
  game.key(Key::settings);
  for (int page = 0; page < 4; ++page) {
    game.key(Key::tab);  // from nothing, later from "Close", to the first page's button
    for (int i = 0; i < page; ++i) game.key(Key::right);
    for (int i = page; i < 4; ++i) game.key(Key::tab);
    // Through the lines to "Help" and "Close".
    while (game.title().find(": ") != std::string::npos) {
      game.key(Key::right);
      game.type("é ");
      game.key(Key::down);
    }
    game.key(Key::down);
  }
  game.key(Key::escape);
  EXPECT_TRUE(game.says("title screen")) << game.title();
  app::Settings expected;
  expected.language = app::Language::en;
  expected.volume = 90;
  expected.mute = true;
  expected.hints = false;
  expected.colours = app::Colours::red_green;
  expected.reduced_motion = app::ReducedMotion::on;
  expected.screen_shake = true;
  expected.aiming = {app::PreviewLength::full, app::AimWay::clicks};
  expected.go_on = true;
  expected.quick_rolling = false;
  expected.names = {"é", "é"};
  expected.breaks = app::Breaks::player_2;
  expected.hand = app::Steadiness::four;
  EXPECT_EQ(stored(store), expected);
}

TEST(SettingsScreen, LeftGoesBackAndEnterOn) {
  app::MemoryStore store;
  Start game(store);
  game.press("Settings");
  for (int i = 0; i < 5; ++i) game.key(Key::tab);
  ASSERT_TRUE(game.says("Language: System default")) << game.title();
  game.key(Key::left);
  EXPECT_TRUE(game.says("Langue: Français")) << game.title();
  game.key(Key::enter);
  EXPECT_TRUE(game.says("Language: System default")) << game.title();
  game.key(Key::up);
  game.key(Key::space);
  EXPECT_TRUE(game.says("Settings · Players")) << game.title();
}

TEST(SettingsScreen, TheLanguageChangesAtOnceAndStays) {
  app::MemoryStore store;
  Start game(store);
  game.press("Settings");
  game.press("Language");
  EXPECT_TRUE(game.says("Settings"));
  game.press("Language");
  EXPECT_TRUE(game.says("Optionen")) << game.title();
  game.press("Sprache");
  EXPECT_TRUE(game.says("Ajustes")) << game.title();
  choose(game, Language::fr);
  EXPECT_TRUE(game.says("Réglages")) << game.title();
  EXPECT_EQ(game.value("Volume"), "80\u202f%");
  game.press("Fermer");
  EXPECT_TRUE(game.says("écran titre"));
  for (const char* label : {"Billard", "S’exercer", "Revoir", "Réglages", "Quitter"})
    EXPECT_TRUE(game.shows(label)) << label;
  Start again(store);
  EXPECT_TRUE(again.says("écran titre"));
  Start asked(store, {Language::en, true});
  EXPECT_TRUE(asked.says("title screen")) << "--lang is stronger";
  asked.press("Settings");
  asked.press("Language");
  EXPECT_TRUE(asked.says("Settings")) << "as the system: what --lang said";
  choose(asked, Language::fr);
  EXPECT_TRUE(asked.says("Réglages")) << "but not than what is chosen later";
}

TEST(SettingsScreen, AGameIsGoneBackToAndSpeaksTheOtherLanguage) {
  app::MemoryStore store;
  for (const bool level : {false, true}) {
    Start game(store, Language::en);
    if (level) {
      game.press("Angry Balls");
      game.press("First steps");
    } else {
      game.press("Practice");
    }
    const std::string before = game.title();
    game.press("Paused");
    game.press("Settings");
    ASSERT_TRUE(game.says("Settings · General"));
    choose(game, Language::fr);
    game.key(Key::escape);
    for (const char* label : level ? std::array{"Recommencer", "Menu", "Pause"}
                                   : std::array{"Recommencer", "Quitter", "Répéter"})
      EXPECT_TRUE(game.shows(label)) << label;
    game.key(Key::settings);
    choose(game, Language::en);
    game.key(Key::settings);
    EXPECT_EQ(game.title(), before);
  }
}

TEST(SettingsScreen, NamesAreTypedAndShownEverywhere) {
  app::MemoryStore store;
  Start game(store);
  game.press("Settings");
  game.press("Players");
  game.type("ignored");
  game.press("Name of player 1");
  game.type("Zoé  B");
  game.key(Key::backspace);
  game.key(Key::backspace);
  game.key(Key::backspace);
  game.key(Key::backspace);
  EXPECT_EQ(game.value("Name of player 1"), "Zo");
  game.type("é");
  EXPECT_EQ(stored(store).names[0], "") << "not yet";
  game.press("Name of player 2");
  EXPECT_EQ(stored(store).names[0], "Zoé");
  for (int i = 0; i < 30; ++i) game.type("12 ");
  game.key(Key::enter);
  EXPECT_EQ(stored(store).names[1], "12 12 12 12 12 12 12 12");
  EXPECT_EQ(game.value("Who breaks"), "Zoé");
  game.key(Key::escape);
  game.press("Billiards");
  EXPECT_TRUE(game.says("Zoé aims")) << game.title();
  EXPECT_TRUE(game.shows("Zoé to play"));
  EXPECT_TRUE(game.says("12 12 12 12 12 12 12 12: 0"));
  Start again(store, Language::fr);
  again.press("Billard");
  EXPECT_TRUE(again.says("Zoé vise")) << again.title();
}

TEST(SettingsScreen, WhoBreaksHoldsFromTheNextGameOn) {
  app::MemoryStore store;
  Start game(store);
  game.press("Billiards");
  game.key(Key::settings);
  game.press("Players");
  game.press("Who breaks");
  game.key(Key::escape);
  EXPECT_TRUE(game.says("Player 1 aims"));
  game.press("Restart");
  EXPECT_TRUE(game.says("Player 2 aims")) << game.title();
}

TEST(SettingsScreen, BrokenSettingsAreToldOnceAndSetAside) {
  app::MemoryStore store;
  ASSERT_TRUE(store.save("settings.json", "{"));
  Start game(store);
  EXPECT_TRUE(game.says("Settings: back to defaults")) << game.title();
  EXPECT_TRUE(game.shows("settings.json.broken"));
  EXPECT_EQ(store.load("settings.json.broken").value(), "{");
  game.key(Key::enter);
  EXPECT_TRUE(game.says("title screen"));
  game.press("Settings");
  game.key(Key::escape);
  EXPECT_TRUE(game.says("title screen"));
}

TEST(SettingsScreen, TheTableStandsStillMeanwhile) {
  app::MemoryStore store;
  Start game(store);
  game.press("Billiards");
  game.pass(3s);
  const auto describe = game.title();
  game.key(Key::settings);
  EXPECT_FALSE(game.app().animating());
  game.pass(1s);
  game.key(Key::escape);
  EXPECT_EQ(game.title(), describe);
}

}  // namespace
