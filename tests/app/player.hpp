#pragma once

#include <chrono>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "platform/null_platform.hpp"

/// Plays the whole game by what is on screen.
struct Player : platform::NullPlatform {
  using NullPlatform::NullPlatform;

  std::string title() { return app().describe(); }
  std::vector<app::Box> boxes() { return app().draw().boxes; }
  bool shows(std::string_view text) {
    for (const app::Box& box : boxes())
      if (box.text.find(text) != std::string::npos) return true;
    return false;
  }
  /// The same of a button.
  bool offers(std::string_view text) {
    for (const app::Box& box : boxes())
      if (box.kind == app::Box::Kind::button && box.text.find(text) != std::string::npos)
        return true;
    return false;
  }
  bool says(std::string_view text) { return title().find(text) != std::string::npos; }
  /// Clicks the button whose label has `text` in it; of several, the one on top.
  void press(std::string_view text) {
    const auto area = find(text);
    ASSERT_TRUE(area) << "no button " << text << " in " << title();
    click(area->center());
  }
  std::optional<app::Rect> find(std::string_view text) {
    std::optional<app::Rect> area;
    for (const app::Box& box : boxes())
      if (box.kind == app::Box::Kind::button && box.text.find(text) != std::string::npos)
        area = box.area;
    return area;
  }
  /// By a finger, if it `touches`.
  void click(app::Point at, app::PointerButton button = app::PointerButton::left) {
    if (!touches) return NullPlatform::click(at, button);
    app().event(app::Finger{1, app::Finger::Phase::down, at});
    app().event(app::Finger{1, app::Finger::Phase::up, at});
  }
  bool touches = false;
  void key(app::Key key) { app().event(app::KeyPressed{key}); }
  /// Leaves a game by the last button of the pause menu.
  void leave() {
    // The first Tab is on the first button, either way.
    for (const app::Key by :
         {app::Key::escape, app::Key::back_tab, app::Key::back_tab, app::Key::enter})
      key(by);
  }
  /// Lets time pass until the title says so.
  void wait_for(std::string_view text) {
    for (int i = 0; i < 4000 && !says(text); ++i) pass(std::chrono::milliseconds{10});
    EXPECT_TRUE(says(text)) << "waited for " << text << ", got " << title();
  }
};
