// The pause menu, leaving and going on, in both games by every device.

#include <gtest/gtest.h>

#include "app/player.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;
using app::PadButton;

enum class Device : std::uint8_t { keys, mouse, finger, pad, back };

class Pause : public testing::TestWithParam<std::tuple<Device, bool>> {
 protected:
  Device device() const { return std::get<0>(GetParam()); }
  bool table() const { return std::get<1>(GetParam()); }

  void pad(PadButton button) {
    game.app().event(app::PadPressed{button});
    game.app().event(app::PadReleased{button});
  }
  void pause() {
    switch (device()) {
      case Device::keys:
        return game.key(Key::escape);
      case Device::mouse:
      case Device::finger:
        return game.press("Paused");  // the gear
      case Device::pad:
        return pad(PadButton::b);
      case Device::back:
        EXPECT_TRUE(game.app().back());
    }
  }
  /// The n-th button of the menu, from 0.
  void choose(int number, std::string_view label) {
    if (device() == Device::mouse || device() == Device::finger || device() == Device::back)
      return game.press(label);
    for (int i = 0; i <= number; ++i) {
      if (device() == Device::keys)
        game.key(Key::tab);
      else
        pad(PadButton::x);
    }
    if (device() == Device::keys)
      game.key(Key::enter);
    else
      pad(PadButton::a);
  }
  void go_back() {
    switch (device()) {
      case Device::keys:
      case Device::mouse:
      case Device::finger:
        return game.key(Key::escape);
      case Device::pad:
        return pad(PadButton::b);
      case Device::back:
        EXPECT_TRUE(game.app().back());
    }
  }
  void begin() {
    if (table()) {
      game.press("Billiards");
    } else {
      game.press("Angry Balls");
      game.press("First steps");
    }
    const app::Point ball = game.app().screen().aim_prompt()->at;
    game.NullPlatform::click(ball);
    game.NullPlatform::click(ball + app::Point{-60, -10});
    game.pass(100ms);
    ASSERT_TRUE(moves());
    game.touches = device() == Device::finger;
  }
  bool moves() {
    const std::vector<app::Vertex> before = game.app().draw().vertices;
    game.pass(100ms);
    return game.app().draw().vertices != before;
  }

  app::MemoryStore store;
  Player game{app::Language::en, 1280, 720, {}, store};
};

TEST_P(Pause, WaitsAndGoesOn) {
  begin();
  pause();
  ASSERT_TRUE(game.says("paused: ")) << game.title();
  for (const char* label : {"Resume", "Restart", "Settings", "Help", "Leave"})
    EXPECT_TRUE(game.offers(label)) << label;
  EXPECT_FALSE(moves());
  EXPECT_FALSE(game.app().animating());
  choose(0, "Resume");
  EXPECT_FALSE(game.says("paused: ")) << game.title();
  EXPECT_TRUE(moves());
  pause();
  go_back();
  EXPECT_FALSE(game.says("paused: ")) << "back is resume";
}

TEST_P(Pause, LeadsToSettingsAndHelpAndBackToTheGame) {
  begin();
  const std::string before = game.title();
  pause();
  choose(2, "Settings");
  EXPECT_TRUE(game.says("Settings · General")) << game.title();
  go_back();
  EXPECT_EQ(game.title(), before);
  pause();
  choose(3, "Help");
  EXPECT_TRUE(game.says("Help")) << game.title();
  go_back();
  EXPECT_EQ(game.title(), before);
}

TEST_P(Pause, RestartsAfterAQuestion) {
  begin();
  pause();
  choose(1, "Restart");
  ASSERT_TRUE(game.says("Restart?")) << game.title();
  choose(0, "New game");
  EXPECT_TRUE(game.says(table() ? "Player 1 aims" : "throws left: 3")) << game.title();
}

TEST_P(Pause, LeavingKeepsTheGameAndContinuingGoesOn) {
  begin();
  pause();
  choose(4, "Leave");
  EXPECT_TRUE(game.says(table() ? "title screen" : "level menu")) << game.title();
  if (!table()) go_back();
  ASSERT_TRUE(game.says("title screen")) << game.title();
  game.press("Continue");
  for (int i = 0; i < 1000 && game.says("Loading"); ++i) game.pass(10ms);
  EXPECT_TRUE(game.says(table() ? "Player 1 watches" : "throws left: 2")) << game.title();
}

std::string name_of(const testing::TestParamInfo<std::tuple<Device, bool>>& info) {
  constexpr std::array names{"Keys", "Mouse", "Finger", "Pad", "Back"};
  return std::string(names[static_cast<std::size_t>(std::get<0>(info.param))]) +
         (std::get<1>(info.param) ? "OnATable" : "InALevel");
}
INSTANTIATE_TEST_SUITE_P(By, Pause,
                         testing::Combine(testing::Values(Device::keys, Device::mouse,
                                                          Device::finger, Device::pad,
                                                          Device::back),
                                          testing::Bool()),
                         name_of);

TEST(PauseMenu, OnTheTitleThereIsNothingToGoBackTo) {
  Player game(app::Language::en, 1280, 720);
  EXPECT_FALSE(game.app().back());
  game.press("Settings");
  EXPECT_TRUE(game.app().back());
  EXPECT_TRUE(game.says("title screen"));
  EXPECT_FALSE(game.app().back());
}

}  // namespace
