#include "platform/sdl_input.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace {

using app::Key;

SDL_Keysym press(SDL_Scancode place, SDL_Keycode printed, Uint16 held = KMOD_NONE) {
  return {.scancode = place, .sym = printed, .mod = held, .unused = 0};
}

TEST(SdlKeys, LettersAreKnownByTheirPlace) {
  // On a French keyboard an A is printed where a Q is in the United States.
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_Q, SDLK_a)), Key::q);
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_N, SDLK_n)), Key::n);
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_R, 0x43a)), Key::r) << "a Cyrillic one";
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_R, SDLK_r, KMOD_LCTRL)), std::nullopt);
}

TEST(SdlKeys, CopyAndPasteAreKnownByTheirLetters) {
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_I, SDLK_c, KMOD_LCTRL)), Key::copy);
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_V, SDLK_v, KMOD_RCTRL)), Key::paste);
}

TEST(SdlKeys, TheOthersAreFixed) {
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_TAB, SDLK_TAB)), Key::tab);
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_TAB, SDLK_TAB, KMOD_LSHIFT)), Key::back_tab);
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_F1, SDLK_F1)), Key::help);
  EXPECT_EQ(platform::key_of(press(SDL_SCANCODE_F5, SDLK_F5)), std::nullopt);
}

/// A gamepad that only SDL sees: plugged in, used, and pulled out.
class GamepadTest : public testing::Test {
 protected:
  void SetUp() override {
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    if (SDL_Init(SDL_INIT_GAMECONTROLLER) != 0) GTEST_SKIP() << SDL_GetError();
    device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                       SDL_CONTROLLER_BUTTON_MAX, 0);
    if (device < 0) GTEST_SKIP() << SDL_GetError();
    // Its buttons and axes are given in their own order.
    inputs();
    stick = SDL_JoystickOpen(device);
    ASSERT_NE(stick, nullptr);
    inputs();
  }
  void TearDown() override { SDL_Quit(); }

  /// The app's input for all that has happened.
  std::vector<app::Input> inputs() {
    std::vector<app::Input> all;
    SDL_PumpEvents();
    for (SDL_Event event; SDL_PollEvent(&event) != 0;)
      if (const auto input = pads.event(event)) all.push_back(*input);
    return all;
  }
  platform::Gamepads pads;
  int device = -1;
  SDL_Joystick* stick = nullptr;
};

TEST_F(GamepadTest, ButtonsAndSticksReachTheApp) {
  SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_B, SDL_PRESSED);
  auto got = inputs();
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(std::get<app::PadPressed>(got[0]).button, app::PadButton::b);
  SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_B, SDL_RELEASED);
  got = inputs();
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(std::get<app::PadReleased>(got[0]).button, app::PadButton::b);

  SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_LEFTY, SDL_JOYSTICK_AXIS_MIN);
  got = inputs();
  ASSERT_EQ(got.size(), 1u);
  const auto moved = std::get<app::PadMoved>(got[0]);
  EXPECT_EQ(moved.axis, app::PadAxis::left_y);
  EXPECT_EQ(moved.value, -1);
}

TEST_F(GamepadTest, PulledOutItLetsGoAndComesBack) {
  SDL_JoystickDetachVirtual(device);
  auto got = inputs();
  bool unplugged = false;
  for (const app::Input& input : got) unplugged |= std::holds_alternative<app::PadUnplugged>(input);
  EXPECT_TRUE(unplugged);
  device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                     SDL_CONTROLLER_BUTTON_MAX, 0);
  ASSERT_GE(device, 0);
  inputs();
  stick = SDL_JoystickOpen(device);
  SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_A, SDL_PRESSED);
  got = inputs();
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(std::get<app::PadPressed>(got[0]).button, app::PadButton::a);
}

}  // namespace
