// Every button says what it does, pointed at or with the focus, on every screen and in every
// window.

#include <set>

#include "app/every_screen.hpp"

namespace {

using app::Box;
using app::Language;
using every_screen::Shown;

/// Is true if a tip is shown, on one line or several, the last of which may be cut short.
bool tells(const Shown& shown, const std::string& tip) {
  std::string all;
  const app::DrawList& list = shown.draw();
  for (std::size_t i = list.covered; i < list.boxes.size(); ++i)
    if (list.boxes[i].kind != Box::Kind::button) all += list.boxes[i].text + ' ';
  return all.find(tip.substr(0, 24)) != std::string::npos;
}

void expect_tips(const Shown& shown) {
  shown.event(app::PointerLeft{});
  const std::vector<Box> buttons = shown.buttons();
  ASSERT_FALSE(buttons.empty()) << shown.where;
  for (const Box& button : buttons) {
    const std::string name = '"' + button.text + "\" of " + shown.where;
    ASSERT_FALSE(button.tip.empty()) << name;
    EXPECT_NE(button.tip, button.text) << name;
    // A level that cannot be shown says so all the time.
    if (button.text.find(button.tip) == std::string::npos) {
      EXPECT_FALSE(tells(shown, button.tip)) << name << " tells it all the time";
    }
    shown.event(app::PointerMoved{button.area.center()});
    EXPECT_TRUE(tells(shown, button.tip)) << name << ": " << button.tip;
    shown.event(app::PointerLeft{});
  }
  std::set<std::pair<float, float>> reached;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    shown.event(app::KeyPressed{app::Key::tab});
    for (const Box& button : shown.buttons()) {
      if (!button.focused) continue;
      reached.emplace(button.area.x, button.area.y);
      EXPECT_TRUE(tells(shown, button.tip)) << '"' << button.text << "\" in " << shown.where;
    }
  }
  EXPECT_EQ(reached.size(), buttons.size()) << "the focus passes by some in " << shown.where;
  shown.event(app::PointerPressed{{1, 1}, app::PointerButton::right});  // no focus
  shown.event(app::PointerLeft{});
}

class Tips : public testing::TestWithParam<std::tuple<Language, int>> {};

TEST_P(Tips, AreThereForEveryButton) {
  const auto [language, width] = GetParam();
  every_screen::Walk({.language = language, .width = width, .height = width * 9 / 16}, expect_tips)
      .all();
}

INSTANTIATE_TEST_SUITE_P(InAllLanguages, Tips,
                         testing::Combine(testing::ValuesIn(app::all_languages()),
                                          testing::Values(1280, 720)),
                         [](const auto& test) {
                           return std::string(app::code_of(std::get<0>(test.param))) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

}  // namespace
