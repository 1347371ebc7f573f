#include "app/graphics/crop.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace {

float area(const app::DrawList& list, std::size_t first = 0) {
  float sum = 0;
  for (std::size_t i = first; i < list.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      return list.vertices[static_cast<std::size_t>(list.indices[i + k])].position;
    };
    const app::Point a = at(1) - at(0);
    const app::Point b = at(2) - at(0);
    sum += std::abs(a.x * b.y - a.y * b.x) / 2;
  }
  return sum;
}

TEST(Crop, KeepsWhatIsInsideAndLeavesWhatCameBefore) {
  app::DrawList list;
  const app::Color white{255, 255, 255, 255};
  const auto square = [&](float x, float y, float size) {
    list.quad(list.add({x, y}, white), list.add({x + size, y}, white),
              list.add({x + size, y + size}, white), list.add({x, y + size}, white));
  };
  square(-50, -50, 10);
  const std::size_t first = list.indices.size();
  square(0, 0, 100);   // around the box
  square(20, 20, 10);  // inside
  square(5, 5, 10);    // over a corner: a quarter
  square(200, 0, 10);  // outside
  app::crop(list, first, {10, 10, 50, 50});
  EXPECT_NEAR(area(list) - area(list, first), 100, 0.01);
  EXPECT_NEAR(area(list, first), 2500 + 100 + 25, 0.01);
  for (std::size_t i = first; i < list.indices.size(); ++i) {
    const app::Point at = list.vertices[static_cast<std::size_t>(list.indices[i])].position;
    EXPECT_NEAR(at.x, 35, 25.001);
    EXPECT_NEAR(at.y, 35, 25.001);
  }
}

TEST(Crop, ColoursGoOnAsTheyWere) {
  app::DrawList list;
  const auto black = list.add({0, 0}, {0, 0, 0, 255});
  list.triangle(black, list.add({100, 0}, {200, 0, 0, 255}), list.add({0, 100}, {0, 0, 0, 255}));
  app::crop(list, 0, {-10, -10, 60, 200});
  for (const auto index : list.indices) {
    const app::Vertex& vertex = list.vertices[static_cast<std::size_t>(index)];
    EXPECT_NEAR(vertex.color.r, 2 * vertex.position.x, 1);
  }
}

}  // namespace
