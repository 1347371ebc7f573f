#include "app/widgets/widgets.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace {

using app::Key;

class ButtonsTest : public testing::Test {
 protected:
  ButtonsTest() {
    buttons.place({}, 0, {0, 0, 100, 40});
    buttons.place({}, 1, {0, 50, 100, 40});
  }
  auto press(app::Point at) { return buttons.event(app::PointerPressed{at}, sounds); }
  auto release(app::Point at) { return buttons.event(app::PointerReleased{at}, sounds); }
  auto key(Key key) { return buttons.event(app::KeyPressed{key}, sounds); }

  app::Buttons buttons{{{0, "first"}, {1, "second"}}, 0};
  app::Sounds sounds;
};

TEST_F(ButtonsTest, ActsOnRelease) {
  EXPECT_FALSE(press({50, 60}));
  EXPECT_EQ(release({50, 60}), 1u);
}

TEST_F(ButtonsTest, SlidingOffTakesThePressBack) {
  press({50, 60});
  EXPECT_FALSE(release({50, 20}));
  press({300, 300});
  EXPECT_FALSE(release({50, 20}));
}

TEST_F(ButtonsTest, EnterMeansThePrimaryButtonUntilAnotherHasTheFocus) {
  EXPECT_EQ(key(Key::enter), 0u);
  EXPECT_FALSE(key(Key::space));
  key(Key::tab);
  key(Key::tab);
  EXPECT_EQ(key(Key::enter), 1u);
  EXPECT_EQ(key(Key::space), 1u);
  key(Key::down);
  EXPECT_EQ(key(Key::space), 0u);
  key(Key::back_tab);
  EXPECT_EQ(key(Key::space), 1u);
}

TEST_F(ButtonsTest, TheFocusGoesThroughGroupsAsIfTheyWereOne) {
  app::Buttons others(std::vector<app::Buttons::Button>{{0, "third"}});
  const auto tab = [&](Key key) {
    return app::Buttons::move_focus({&buttons, nullptr, &others}, app::KeyPressed{key});
  };
  const auto focus = [&] {
    return std::vector{buttons.focused(0), buttons.focused(1), others.focused(0)};
  };
  const std::vector first{true, false, false}, second{false, true, false},
      third{false, false, true};
  EXPECT_FALSE(tab(Key::enter));
  EXPECT_TRUE(tab(Key::back_tab));
  EXPECT_EQ(focus(), third);
  for (const auto& expected : {first, second, third, first}) {
    EXPECT_TRUE(tab(Key::tab));
    EXPECT_EQ(focus(), expected);
  }
  for (const auto& expected : {third, second, first}) {
    EXPECT_TRUE(tab(Key::back_tab));
    EXPECT_EQ(focus(), expected);
  }
}

TEST_F(ButtonsTest, TheRightButtonPressesNothing) {
  buttons.event(app::PointerPressed{{50, 60}, app::PointerButton::right}, sounds);
  EXPECT_FALSE(buttons.event(app::PointerReleased{{50, 60}, app::PointerButton::right}, sounds));
}

TEST_F(ButtonsTest, AClickSoundsWhenAButtonIsPressed) {
  press({300, 300});
  EXPECT_TRUE(sounds.empty()) << "beside all buttons";
  buttons.event(app::PointerPressed{{50, 60}, app::PointerButton::right}, sounds);
  key(Key::space);
  EXPECT_TRUE(sounds.empty()) << "nothing has the focus";
  press({50, 60});
  release({50, 60});
  EXPECT_EQ(sounds.take(), std::vector{app::SoundEvent{app::SoundKind::click}});
  key(Key::enter);
  EXPECT_EQ(sounds.take().size(), 1u);
}

TEST_F(ButtonsTest, TheFocusStaysOnAButtonThatIsStillThere) {
  key(Key::tab);
  key(Key::tab);
  app::Buttons longer(std::vector<app::Buttons::Button>{{0}, {7}, {1}});
  longer.keep_focus(buttons);
  EXPECT_TRUE(longer.focused(1));
  app::Buttons without(std::vector<app::Buttons::Button>{{0}, {7}});
  without.keep_focus(buttons);
  EXPECT_FALSE(without.has_focus());
}

TEST_F(ButtonsTest, AFingerNeedNotBeExact) {
  buttons.place({}, 0, {0, 0, 20, 20});
  buttons.place({}, 1, {30, 0, 20, 20});
  const auto tap = [&](app::Point at) {
    buttons.event(app::PointerPressed{at, app::PointerButton::left, true}, sounds);
    return release(at);
  };
  EXPECT_EQ(tap({10, 31}), 0u);
  EXPECT_FALSE(tap({10, 33}));
  EXPECT_EQ(tap({24, 10}), 0u) << "the nearer one";
  EXPECT_EQ(tap({26, 10}), 1u);
  press({10, 31});
  EXPECT_FALSE(release({10, 31})) << "a mouse is exact";
  // On a fine display the same finger covers more pixels.
  buttons.place(app::View::of(1200, 800, 3), 0, {0, 0, 20, 20});
  EXPECT_EQ(tap({10, 75}), 0u);
  EXPECT_FALSE(tap({10, 77}));
}

TEST_F(ButtonsTest, ACancelledPressPressesNothing) {
  press({50, 60});
  buttons.event(app::PointerCancelled{}, sounds);
  EXPECT_FALSE(buttons.hovered(1));
  EXPECT_FALSE(release({50, 60}));
  buttons.event(app::PointerMoved{{50, 60}}, sounds);
  EXPECT_TRUE(buttons.hovered(1));
  buttons.event(app::PointerLeft{}, sounds);
  EXPECT_FALSE(buttons.hovered(1));
}

}  // namespace
