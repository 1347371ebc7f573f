#include "platform/painter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <string>

#include "app/graphics/shapes.hpp"
#include "app/graphics/stamps.hpp"
#include "app/view/balls.hpp"

namespace {

constexpr int width = 200;
constexpr int height = 120;

/// A window that nobody sees, painted by SDL's own renderer in software.
class PainterTest : public testing::Test {
 protected:
  void SetUp() override {
    SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
    SDL_SetHint(SDL_HINT_RENDER_DRIVER, "software");
    ASSERT_EQ(SDL_Init(SDL_INIT_VIDEO), 0) << SDL_GetError();
  }
  void TearDown() override { SDL_Quit(); }

  static platform::Owned<SDL_Window> window() {
    return platform::owned(SDL_CreateWindow("", 0, 0, width, height, 0));
  }
  static std::vector<std::uint8_t> pixels(const platform::Painter& painter) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
    EXPECT_EQ(SDL_RenderReadPixels(painter.renderer(), nullptr, SDL_PIXELFORMAT_RGBA32, rgba.data(),
                                   4 * width),
              0);
    return rgba;
  }
};

/// Where two pictures first differ, and how.
std::string difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    const std::size_t pixel = i / 4;
    return "at (" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) +
           "): " + std::to_string(a[i]) + ", not " + std::to_string(b[i]);
  }
  return {};
}

/// Content of a frame: over one of three grounds, discs, balls and panes anywhere, in part
/// outside.
struct Frame {
  struct Thing {
    int what;
    float x, y, size;
  };
  int ground;
  std::vector<Thing> things;

  void draw(app::DrawList& list, app::Stamps& stamps) const {
    list.clear();
    list.stamps = &stamps;
    app::fill_rounded(list, {0, 0, width, height}, 0, app::rgb(0x204060));
    app::fill_disc(list, {60.0f + 30.0f * static_cast<float>(ground), 50}, 30, app::rgb(0xc0a020));
    list.stand_still();
    for (const auto& [what, x, y, size] : things) {
      if (what == 0) app::fill_disc(list, {x, y}, size, app::Color{255, 0, 0, 120});
      if (what == 1) app::draw_ball(list, {x, y}, size, app::BallKind::ivory);
      if (what == 2) app::fill_rounded(list, {x, y, 4 * size, size}, 3, app::Color{0, 0, 0, 90});
    }
  }
};

Frame any_frame() {
  const auto coordinate = [](int low, int high) {
    return static_cast<float>(*rc::gen::inRange(low * 4, high * 4)) / 4;
  };
  Frame frame{*rc::gen::inRange(0, 3), {}};
  for (int left = *rc::gen::inRange(0, 6); left > 0; --left)
    frame.things.push_back({*rc::gen::inRange(0, 3), coordinate(-20, width + 20),
                            coordinate(-20, height + 20), coordinate(2, 15)});
  return frame;
}

TEST_F(PainterTest, ARestoredPictureEqualsOneDrawnAnew) {
  const auto seen = window();
  const auto other = window();
  platform::Painter painter(seen.get());
  app::Atlas atlas;
  app::Stamps stamps(atlas);
  app::DrawList list;
  // Frames of one ground often follow each other: then the painter restores.
  int ground = 0;
  const bool ok = rc::check([&] {
    for (int i = 0; i < 4; ++i) {
      Frame frame = any_frame();
      if (*rc::gen::inRange(0, 4) != 0) frame.ground = ground;
      ground = frame.ground;
      frame.draw(list, stamps);
      painter.show(list, atlas);
      platform::Painter anew(other.get());
      list.still_indices = list.still_vertices = 0;  // draws all
      anew.show(list, atlas);
      RC_ASSERT(difference(pixels(painter), pixels(anew)) == "");
    }
  });
  EXPECT_TRUE(ok);
}

TEST_F(PainterTest, AfterALossAllIsDrawnAgain) {
  const auto seen = window();
  platform::Painter painter(seen.get());
  app::Atlas atlas;
  app::Stamps stamps(atlas);
  app::DrawList list;
  const Frame frame{1, {{1, 30, 40, 12}}};
  for (int i = 0; i < 3; ++i) {
    frame.draw(list, stamps);
    painter.show(list, atlas);
  }
  const auto before = pixels(painter);
  SDL_SetRenderDrawColor(painter.renderer(), 9, 9, 9, 255);
  SDL_RenderClear(painter.renderer());
  SDL_SetRenderDrawColor(painter.renderer(), 0, 0, 0, 255);
  painter.frame_lost();
  painter.show(list, atlas);
  EXPECT_EQ(pixels(painter), before);
  painter.forget();
  painter.show(list, atlas);
  EXPECT_EQ(pixels(painter), before);
}

}  // namespace
