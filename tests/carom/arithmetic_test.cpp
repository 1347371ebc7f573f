#include "carom/arithmetic.hpp"

#include <cfenv>
#include <gtest/gtest.h>
#include <span>
#include <string>

#include "carom/quadtree.hpp"
#include "carom/scene_file.hpp"
#include "carom/world.hpp"
#include "worlds.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace {

/// With numbers that no binary fraction is.
std::string scene_text() {
  std::string json =
      R"({"carom": 1, "width": 800.1, "height": 400.3, "friction": 0.9971, "balls": [)";
  for (int k = 0; k < 30; ++k)
    json += (k == 0 ? "" : ",") + std::string(R"({"x": )") + std::to_string(20 + 25 * k) +
            R"(.1, "y": )" + std::to_string(20 + 11 * k) + R"(.7, "vx": )" +
            std::to_string(313 - 37 * k) + R"(.3, "vy": 1.1e2})";
  return json + "]}";
}

/// A few seconds of a table read from a file, as a hash of what came out.
std::uint64_t played() {
  auto world = carom::World::create(carom::read_scene(scene_text()).value());
  EXPECT_TRUE(world.value().set_velocity(0, {1234.5, 678.9}));
  for (int step = 0; step < 100; ++step) world.value().step();
  world.value().run({.rest = true}, 200);
  return world.value().state_hash();
}

TEST(Arithmetic, ThisBuildIsExact) { EXPECT_TRUE(carom::check(carom::Scene{}).empty()); }

class RoundingModes : public testing::TestWithParam<int> {};

TEST_P(RoundingModes, ChangeNothing) {
  const std::uint64_t expected = played();
  const int before = std::fegetround();
  ASSERT_EQ(std::fesetround(GetParam()), 0);
  const std::uint64_t got = played();
  const int after = std::fegetround();
  std::fesetround(before);
  EXPECT_EQ(got, expected);
  EXPECT_EQ(after, GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, RoundingModes,
                         testing::Values(FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST));

#if defined(__SSE2__)
constexpr unsigned flush_to_zero = 0x8000;
constexpr unsigned denormals_are_zero = 0x0040;

// A ball so slow that its velocity is a subnormal number.
std::uint64_t crept() {
  carom::Scene scene = worlds::table({worlds::ball({0.001, 200}, {3e-308, 0}, 0.001)});
  scene.friction = 0.5;
  scene.balls[0].position = {0.001, 0.001};
  carom::World world = worlds::make(scene);
  for (int step = 0; step < 20; ++step) world.step();
  return world.state_hash();
}

TEST(Arithmetic, FlushingToZeroChangesNothing) {
  const std::uint64_t expected = crept();
  const unsigned before = _mm_getcsr();
  const unsigned flushing = before | flush_to_zero | denormals_are_zero;
  _mm_setcsr(flushing);
  const std::uint64_t got = crept();
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(got, expected);
  EXPECT_EQ(after & (flush_to_zero | denormals_are_zero), flush_to_zero | denormals_are_zero);
}

// A program that wants to hear of every inexact result does not hear of ours.
TEST(Arithmetic, TrapsDoNotReachTheEngine) {
  const std::uint64_t expected = played();
  const unsigned before = _mm_getcsr();
  const auto with_traps = (before & ~0x1fbfU) | 0x0f80U;  // all but the inexact one masked
  _mm_setcsr(with_traps);
  const carom::Scene table = [] {
    const carom::ExactArithmetic exact;
    return worlds::table({worlds::ball({100.3, 100.7}, {333.3, 777.7})});
  }();
  auto world = carom::World::create(table);
  for (int step = 0; step < 10; ++step) world.value().step();
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(after & 0x1f80U, with_traps & 0x1f80U);
  EXPECT_EQ(played(), expected);
}
#endif

}  // namespace
