// Everything that runs on more than one thread, under the thread sanitizer.

#include <SDL.h>
#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "carom/internal/thread_pool.hpp"
#include "carom/world.hpp"
#include "platform/speaker.hpp"

namespace {

carom::Scene gas(int balls) {
  carom::Scene scene;
  scene.width = scene.height = 25.0 * 160;
  for (int i = 0; i < balls; ++i) {
    carom::Ball ball;
    ball.position = {20.0 + 25.0 * (i % 155), 20.0 + 25.0 * (i / 155)};
    ball.velocity = {static_cast<double>(i * 37 % 801 - 400),
                     static_cast<double>(i * 91 % 801 - 400)};
    scene.balls.push_back(ball);
  }
  return scene;
}

TEST(ThreadPool, SharedPartsCoverEveryIndexOnce) {
  carom::ThreadPool pool(4);
  std::vector<std::atomic<int>> visits(10'007);
  for (int round = 0; round < 20; ++round)
    pool.share(visits.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
  for (const auto& count : visits) ASSERT_EQ(count, 20);
}

TEST(World, StepsOnThreadsGiveTheBitsOfOneThread) {
  auto one = carom::World::create(gas(21'000)).value();
  auto four = one;
  four.set_threads(4);
  for (int step = 0; step < 5; ++step) {
    one.step();
    four.step();
    ASSERT_EQ(one.state_hash(), four.state_hash());
  }
}

// SDL's dummy driver calls back from a thread of its own, as real ones do.
TEST(Speaker, AudioCallbackAndPlayRunBesideEachOther) {
  ASSERT_EQ(setenv("SDL_AUDIODRIVER", "dummy", 1), 0);
  platform::Speaker speaker;
  const app::SoundEvent click{app::SoundKind::click, 1, 0};
  for (int frame = 0; frame < 60; ++frame) {
    const std::vector<app::SoundEvent> sounds(frame % 3 == 0 ? 1 : 0, click);
    speaker.play(sounds, frame % 2 == 0 ? 100 : 20);
    SDL_Delay(5);
  }
  EXPECT_NE(SDL_WasInit(SDL_INIT_AUDIO), 0U);
}

}  // namespace
