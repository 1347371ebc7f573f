#include "app/input/pad.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace std::chrono_literals;
using app::Key;
using app::PadAxis;
using app::PadButton;

class PadTest : public testing::Test {
 protected:
  std::vector<app::Input> move(PadAxis axis, float value, bool steers = true) {
    return pad.event(app::PadMoved{axis, value}, steers);
  }
  /// The only input there is, as a key.
  static Key key(const std::vector<app::Input>& inputs) {
    EXPECT_EQ(inputs.size(), 1u);
    const auto* pressed = inputs.empty() ? nullptr : std::get_if<app::KeyPressed>(&inputs[0]);
    return pressed ? pressed->key : Key::copy;
  }
  app::Pad pad;
};

TEST_F(PadTest, ButtonsAreKeys) {
  EXPECT_EQ(key(pad.event(app::PadPressed{PadButton::a}, false)), Key::enter);
  EXPECT_EQ(key(pad.event(app::PadPressed{PadButton::b}, false)), Key::escape);
  EXPECT_EQ(key(pad.event(app::PadPressed{PadButton::x}, true)), Key::tab);
  EXPECT_EQ(key(pad.event(app::PadPressed{PadButton::y}, true)), Key::help);
  const auto fine = pad.event(app::PadPressed{PadButton::right_shoulder}, true);
  EXPECT_EQ(key(fine), Key::right);
  EXPECT_TRUE(std::get<app::KeyPressed>(fine[0]).shift);
  EXPECT_FALSE(pad.held());
  const auto start = pad.event(app::PadPressed{PadButton::start}, true);
  ASSERT_EQ(start.size(), 1u);
  EXPECT_TRUE(app::is_command(start[0], app::Command::pause));
}

/// While nothing is aimed.
TEST_F(PadTest, TheRightTriggerIsTheCommandThatHurries) {
  EXPECT_TRUE(move(PadAxis::right_trigger, 0.5f, false).empty());
  const auto pressed = move(PadAxis::right_trigger, 0.9f, false);
  ASSERT_EQ(pressed.size(), 1u);
  EXPECT_TRUE(app::is_command(pressed[0], app::Command::fast));
  EXPECT_TRUE(move(PadAxis::right_trigger, 1, false).empty());
  const auto let_go = move(PadAxis::right_trigger, 0.1f, false);
  ASSERT_EQ(let_go.size(), 1u);
  EXPECT_EQ(std::get<app::CommandReleased>(let_go[0]).command, app::Command::fast);
  EXPECT_TRUE(move(PadAxis::right_trigger, 1, true).empty()) << "it makes the throw stronger";
  const auto unplugged = pad.event(app::PadUnplugged{}, false);
  ASSERT_EQ(unplugged.size(), 1u) << "all is let go";
  EXPECT_EQ(std::get<app::CommandReleased>(unplugged[0]).command, app::Command::fast);
  EXPECT_TRUE(pad.event(app::PadUnplugged{}, false).empty());
}

TEST_F(PadTest, TheCrossRepeatsUntilItIsLetGo) {
  EXPECT_EQ(key(pad.event(app::PadPressed{PadButton::left}, true)), Key::left);
  EXPECT_TRUE(pad.held());
  EXPECT_TRUE(pad.advance(399ms, true).empty());
  EXPECT_EQ(key(pad.advance(1ms, true)), Key::left);
  EXPECT_TRUE(pad.advance(59ms, true).empty());
  EXPECT_EQ(key(pad.advance(1ms, true)), Key::left);
  pad.event(app::PadReleased{PadButton::left}, true);
  EXPECT_FALSE(pad.held());
  EXPECT_TRUE(pad.advance(10s, true).empty());
}

TEST_F(PadTest, SticksSteerBeyondTheDeadZone) {
  for (const float still : {0.0f, 0.2f, -0.2f, std::numeric_limits<float>::quiet_NaN(), 1.1f}) {
    move(PadAxis::left_x, still);
    EXPECT_FALSE(pad.held()) << still;
    EXPECT_TRUE(pad.advance(1s, true).empty());
  }
  move(PadAxis::left_x, 1);
  move(PadAxis::left_y, -0.6f);
  move(PadAxis::left_trigger, 0.6f);
  EXPECT_TRUE(pad.held());
  const auto inputs = pad.advance(16ms, true);
  ASSERT_EQ(inputs.size(), 1u);
  const auto steered = std::get<app::Steered>(inputs[0]);
  EXPECT_FLOAT_EQ(steered.across, 1);
  EXPECT_FLOAT_EQ(steered.up, 0.5f);
  EXPECT_FLOAT_EQ(steered.power, -0.5f);
  EXPECT_EQ(steered.time, 16ms);
  EXPECT_TRUE(pad.advance(16ms, false).empty()) << "nothing is steered";
}

TEST_F(PadTest, InMenusTheStickIsACross) {
  EXPECT_TRUE(move(PadAxis::left_y, 0.5f, false).empty());
  EXPECT_EQ(key(move(PadAxis::left_y, 0.7f, false)), Key::down);
  EXPECT_TRUE(move(PadAxis::left_y, 0.9f, false).empty()) << "it is down already";
  EXPECT_EQ(key(pad.advance(400ms, false)), Key::down);
  EXPECT_TRUE(move(PadAxis::left_y, 0, false).empty());
  EXPECT_FALSE(pad.held());
  EXPECT_EQ(key(move(PadAxis::left_x, -1, false)), Key::left);
}

TEST_F(PadTest, UnpluggedItHoldsNothing) {
  pad.event(app::PadPressed{PadButton::up}, true);
  move(PadAxis::right_y, 1);
  EXPECT_TRUE(pad.held());
  pad.event(app::PadUnplugged{}, true);
  EXPECT_FALSE(pad.held());
  const auto start = pad.event(app::PadPressed{PadButton::start}, true);
  ASSERT_EQ(start.size(), 1u);
  EXPECT_TRUE(app::is_command(start[0], app::Command::pause));
}

}  // namespace
