#include "app/graphics/raster.hpp"

#include <array>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "app/graphics/shapes.hpp"

namespace {

using app::Image;
using app::Point;

const app::Atlas blank(8);
constexpr app::Color half_white{255, 255, 255, 128};

int red(const Image& image, int x, int y) { return image.at(x, y).r; }

Image draw(const app::DrawList& list, int width = 32, int height = 32) {
  Image image(width, height, app::rgb(0x000000));
  app::rasterize(list, blank, image);
  return image;
}

/// The four corners and a point within, as four triangles.
app::DrawList fan(std::array<Point, 4> corner, Point within, app::Color color) {
  app::DrawList list;
  for (const Point& p : corner) list.add(p, color);
  const auto middle = list.add(within, color);
  for (std::int32_t i = 0; i < 4; ++i) list.triangle(middle, i, (i + 1) % 4);
  return list;
}

TEST(Raster, CoversExactlyThePixelsWhoseCentresAreInside) {
  app::DrawList list = fan({Point{4, 5}, {20, 5}, {20, 11}, {4, 11}}, {9, 8}, {255, 0, 0, 255});
  const Image image = draw(list);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      EXPECT_EQ(red(image, x, y), x >= 4 && x < 20 && y >= 5 && y < 11 ? 255 : 0);
}

TEST(Raster, SharedEdgesAreBlendedOnce) {
  // Wherever the triangles meet, on pixel centres too, each pixel is blended once, not twice, not
  // never.
  const bool ok = rc::check([] {
    const auto coordinate = [](int low, int high) {
      return static_cast<float>(*rc::gen::inRange(low * 4, high * 4)) / 4;
    };
    const Point within{coordinate(1, 31), coordinate(1, 31)};
    const Image image = draw(fan({Point{0, 0}, {32, 0}, {32, 32}, {0, 32}}, within, half_white));
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) RC_ASSERT(red(image, x, y) == 128);
  });
  EXPECT_TRUE(ok);
}

TEST(Raster, BothWindingsAreDrawn) {
  app::DrawList list;
  list.add({0, 0}, half_white);
  list.add({32, 0}, half_white);
  list.add({0, 32}, half_white);
  list.triangle(0, 1, 2);
  const Image one = draw(list);
  list.indices = {0, 2, 1};
  EXPECT_EQ(draw(list).pixels, one.pixels);
}

TEST(Raster, TheFringeGivesEdgesTheirShareOfThePixel) {
  app::DrawList list;
  // An edge in the middle of a column of pixels.
  app::fill_rounded(list, {8.5f, 4, 10, 20}, 0, app::rgb(0xffffff));
  const Image image = draw(list);
  EXPECT_NEAR(red(image, 8, 14), 128, 2);
  EXPECT_EQ(red(image, 12, 14), 255);
  EXPECT_EQ(red(image, 7, 14), 0);
}

TEST(Raster, ADiscHasItsArea) {
  for (const float radius : {2.0f, 5.3f, 12.0f}) {
    app::DrawList list;
    app::fill_disc(list, {16.3f, 15.6f}, radius, app::rgb(0xffffff));
    const Image image = draw(list);
    double covered = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) covered += red(image, x, y) / 255.0;
    const double area = 3.14159265 * static_cast<double>(radius * radius);
    EXPECT_NEAR(covered / area, 1, 0.03) << radius;
  }
}

TEST(Raster, CornersFarOutsideAreClipped) {
  app::DrawList list;
  list.add({-1e9f, -1e9f}, half_white);
  list.add({1e9f, -1e9f}, half_white);
  list.add({0, 1e9f}, half_white);
  list.triangle(0, 1, 2);
  EXPECT_EQ(red(draw(list), 16, 16), 128);
}

TEST(Raster, ThePartOfTheAtlasIsDrawnTexelOnPixel) {
  app::Atlas atlas(16);
  const std::array colors{app::rgb(0xff0000), app::Color{0, 255, 0, 0}, app::Color{255, 0, 0, 128},
                          app::rgb(0x0000ff)};
  const auto part =
      atlas.add(2, 2, [&](int x, int y) { return colors[static_cast<std::size_t>(y * 2 + x)]; });
  app::DrawList list;
  list.picture({3, 4, 2, 2}, atlas.texture(part.value()), app::rgb(0xffffff));
  Image image(8, 8, app::rgb(0x000000));
  app::rasterize(list, atlas, image);
  EXPECT_EQ(image.at(3, 4), app::rgb(0xff0000));
  EXPECT_EQ(image.at(4, 4), app::rgb(0x000000));
  EXPECT_EQ(image.at(3, 5), app::rgb(0x800000));
  EXPECT_EQ(image.at(4, 5), app::rgb(0x0000ff));
  EXPECT_EQ(image.at(2, 4), app::rgb(0x000000));
}

TEST(Raster, BetweenTexelsColoursAreMixed) {
  app::Atlas atlas(16);
  const auto part =
      atlas.add(4, 4, [&](int x, int) { return x < 2 ? app::rgb(0xff0000) : app::rgb(0x0000ff); });
  app::DrawList list;  // half a pixel to the right
  list.picture({2.5f, 2, 4, 4}, atlas.texture(part.value()), app::rgb(0xffffff));
  Image image(8, 8, app::rgb(0x000000));
  app::rasterize(list, atlas, image);
  EXPECT_EQ(image.at(3, 3), app::rgb(0xff0000));
  EXPECT_EQ(image.at(4, 3), app::rgb(0x800080));
  EXPECT_EQ(image.at(5, 3), app::rgb(0x0000ff));
}

TEST(Raster, OverClearGroundAColourStaysWhatItIs) {
  app::DrawList list = fan({Point{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {3, 4}, {200, 100, 50, 128});
  Image image(8, 8, {0, 0, 0, 0});
  app::rasterize(list, blank, image);
  EXPECT_EQ(image.at(4, 4), (app::Color{200, 100, 50, 128}));
  app::rasterize(list, blank, image);  // 1 - (1 - 128 / 255)²
  EXPECT_EQ(image.at(4, 4), (app::Color{200, 100, 50, 192}));
}

}  // namespace
