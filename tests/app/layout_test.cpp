// Nothing overlaps and nothing is cut off, whatever the window's size and the language.

#include <gtest/gtest.h>

#include "app/table_view.hpp"
#include "platform/null_platform.hpp"

namespace {

using namespace std::chrono_literals;
using app::Box;

struct Size {
  int width, height;
};
constexpr Size sizes[] = {{800, 600},  {1280, 720}, {1920, 1080}, {500, 900},
                          {1600, 500}, {480, 360},  {700, 1300},  {3840, 2160},
                          {1024, 768}, {760, 601},  {667, 480},   {2560, 1080}};

std::string describe(const Box& box) {
  return "\"" + box.text + "\" at " + std::to_string(box.area.x) + "," +
         std::to_string(box.area.y) + " " + std::to_string(box.area.w) + "x" +
         std::to_string(box.area.h);
}

bool within(const app::Rect& inner, const app::Rect& outer) {
  const float slack = 0.51f;  // px, of rounding
  return inner.x >= outer.x - slack && inner.y >= outer.y - slack &&
         inner.right() <= outer.right() + slack && inner.bottom() <= outer.bottom() + slack;
}

/// A modal question covers what lies under it: boxes before its title do not count.
std::vector<Box> visible(const std::vector<Box>& boxes, const std::string& modal_title) {
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].text == modal_title)
      return {boxes.begin() + static_cast<std::ptrdiff_t>(i), boxes.end()};
  return boxes;
}

void expect_sound(const std::vector<Box>& boxes, Size size) {
  const app::Rect window{0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& a = boxes[i];
    EXPECT_TRUE(within(a.area, window)) << describe(a) << " is cut off";
    if (a.kind == Box::Kind::text) {
      EXPECT_GE(a.text_size, 14) << describe(a) << " is too small";
    }
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Box& b = boxes[j];
      if (a.kind == Box::Kind::text && b.kind == Box::Kind::button && a.text == b.text)
        EXPECT_TRUE(within(a.area, b.area)) << describe(a) << " leaves its button";
      else
        EXPECT_FALSE(a.area.overlaps(b.area)) << describe(a) << " overlaps " << describe(b);
    }
  }
}

class Layout : public testing::TestWithParam<std::tuple<Size, app::Language>> {
 protected:
  Size size = std::get<0>(GetParam());
  platform::NullPlatform game{std::get<1>(GetParam()), size.width, size.height};

  app::Point cue() const {
    const app::View view = app::View::of(size.width, size.height);
    const app::Viewport viewport(app::GameLayout::of(view).world.inset(view.px(8)), {800, 400},
                                 app::table_margin);
    return viewport.to_window({200, 200});
  }
  void check(const std::string& modal_title = {}) {
    expect_sound(visible(game.app().draw().boxes, modal_title), size);
  }
  void key(app::Key key) { game.app().event(app::KeyPressed{key}); }
};

TEST_P(Layout, Title) { check(); }

TEST_P(Layout, FirstTurnAnnounced) {
  key(app::Key::enter);
  game.pass(500ms);
  check();
}

TEST_P(Layout, AimWeakStrongAndCapped) {
  key(app::Key::enter);
  game.pass(3s);
  game.click({cue().x, cue().y + 60});  // beside the ball
  check();
  game.click(cue());
  check();
  game.app().event(app::PointerMoved{{cue().x + 60, cue().y}});
  check();
  game.app().event(app::PointerMoved{{cue().x + 4000, cue().y}});
  check();
}

TEST_P(Layout, WatchAndQuestion) {
  key(app::Key::enter);
  game.pass(3s);
  game.click(cue());
  game.click({cue().x + 100, cue().y});
  game.pass(50ms);
  check();
  key(app::Key::escape);
  const bool french = std::get<1>(GetParam()) == app::Language::french;
  check(french ? "Quitter la table ?" : "Leave the table?");
}

TEST(LayoutOfAnySize, IsSurvived) {
  for (const Size size : {Size{1, 1}, {64, 64}, {1, 2000}, {2000, 1}, {130, 97}, {8192, 8192}}) {
    platform::NullPlatform game(app::Language::french, size.width, size.height);
    EXPECT_FALSE(game.app().draw().indices.empty());
    game.app().event(app::KeyPressed{app::Key::enter});
    game.pass(500ms);
    EXPECT_FALSE(game.app().draw().indices.empty());
    game.app().event(app::Resized{size.height, size.width});
    EXPECT_FALSE(game.app().draw().indices.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(AllSizes, Layout,
                         testing::Combine(testing::ValuesIn(sizes),
                                          testing::Values(app::Language::english,
                                                          app::Language::french)),
                         [](const auto& test) {
                           const Size size = std::get<0>(test.param);
                           const bool french = std::get<1>(test.param) == app::Language::french;
                           return std::to_string(size.width) + "x" + std::to_string(size.height) +
                                  (french ? "_fr" : "_en");
                         });

}  // namespace
