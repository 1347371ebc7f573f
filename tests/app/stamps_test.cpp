#include "app/graphics/stamps.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "app/graphics/raster.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/balls.hpp"

namespace {

constexpr int side = 160;
constexpr app::Color ground = app::rgb(0x105050);

app::Image picture(const app::DrawList& list, const app::Atlas& atlas) {
  app::Image image(side, side, ground);
  app::rasterize(list, atlas, image);
  return image;
}

/// How far two pictures are apart: on average where either shows anything, and at most. 0 to 255.
struct Distance {
  double mean = 0;
  int most = 0;
};
Distance distance(const app::Image& a, const app::Image& b) {
  double sum = 0;
  int drawn = 0;
  Distance result;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const app::Color p = a.pixels[i], q = b.pixels[i];
    if (p == ground && q == ground) continue;
    ++drawn;
    for (const int apart : {std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) {
      sum += apart / 3.0;
      result.most = std::max(result.most, apart);
    }
  }
  result.mean = drawn > 0 ? sum / drawn : 0;
  return result;
}

TEST(Stamps, ABallLooksAsInTriangles) {
  app::Atlas atlas;
  app::Stamps stamps(atlas);
  const bool ok = rc::check([&] {
    const float radius = static_cast<float>(*rc::gen::inRange(5, 50));
    const app::Point center{80 + static_cast<float>(*rc::gen::inRange(-8, 8)) / 8,
                            80 + static_cast<float>(*rc::gen::inRange(-8, 8)) / 8};
    app::DrawList triangles, stamped;
    stamped.stamps = &stamps;
    app::draw_ball(triangles, center, radius, app::BallKind::red);
    app::draw_ball(stamped, center, radius, app::BallKind::red);
    RC_ASSERT(stamped.indices.size() == 6u);
    const Distance apart = distance(picture(triangles, atlas), picture(stamped, atlas));
    RC_LOG() << apart.mean << ' ' << apart.most;
    RC_ASSERT(apart.mean < 8);
    RC_ASSERT(apart.most < 110);  // the glint of a small ball, and edges between pixels
  });
  EXPECT_TRUE(ok);
}

TEST(Stamps, AGlowLooksAsInTriangles) {
  app::Atlas atlas;
  app::Stamps stamps(atlas);
  app::DrawList triangles, stamped;
  stamped.stamps = &stamps;
  for (app::DrawList* list : {&triangles, &stamped})
    app::glow(*list, {80, 80}, 60, 30, {250, 200, 40, 220});
  EXPECT_EQ(stamped.indices.size(), 6u);
  EXPECT_LT(distance(picture(triangles, atlas), picture(stamped, atlas)).most, 6);
}

TEST(Stamps, ABallTooLargeForAStampIsDrawnInTriangles) {
  app::Atlas atlas;
  app::Stamps stamps(atlas);
  app::DrawList triangles, stamped;
  stamped.stamps = &stamps;
  for (app::DrawList* list : {&triangles, &stamped})
    app::draw_ball(*list, {80, 80}, 70, app::BallKind::red);
  EXPECT_GT(stamped.indices.size(), 1000u);
  EXPECT_LT(distance(picture(triangles, atlas), picture(stamped, atlas)).most, 6);
}

TEST(Stamps, TooManyAreDrawnInTriangles) {
  app::Atlas atlas;
  app::Stamps stamps(atlas);
  app::DrawList list;
  list.stamps = &stamps;
  for (int i = 0; i < 200; ++i) {
    list.clear();
    app::draw_ball(list, {80, 80}, 40 + static_cast<float>(i) / 200, app::BallKind::red);
    if (atlas.full()) atlas.grow();
  }
  EXPECT_GT(list.indices.size(), 6u);
  EXPECT_LE(atlas.side(), 2048) << "the atlas does not grow without end";
}

TEST(Stamps, AClearedAtlasGetsThemAnew) {
  app::Atlas atlas;
  app::Stamps stamps(atlas);
  app::DrawList before, after;
  before.stamps = after.stamps = &stamps;
  app::draw_ball(before, {80, 80}, 20, app::BallKind::ivory);
  const app::Image first = picture(before, atlas);
  atlas.clear();
  EXPECT_TRUE(atlas.parts().empty());
  after.palette = &app::Palette::of(app::Colours::high_contrast);
  app::draw_ball(after, {80, 80}, 20, app::BallKind::ivory);
  EXPECT_EQ(atlas.parts().size(), 1u);
  EXPECT_EQ(picture(after, atlas).pixels, first.pixels);
}

}  // namespace
