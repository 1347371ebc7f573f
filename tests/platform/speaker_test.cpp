// The loudspeaker over SDL's driver that writes samples to a file.

#include "platform/speaker.hpp"

#include <SDL.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <vector>

namespace {

constexpr app::SoundEvent click{app::SoundKind::click};

class SpeakerTest : public testing::Test {
 protected:
  SpeakerTest() {
    std::remove(file.c_str());
    use("disk");
    SDL_setenv("SDL_DISKAUDIOFILE", file.c_str(), 1);
    SDL_setenv("SDL_DISKAUDIODELAY", "1", 1);  // ms between buffers: quicker than sound
  }
  ~SpeakerTest() override {
    while (audio_begun()) SDL_QuitSubSystem(SDL_INIT_AUDIO);  // each speaker has begun it
    std::remove(file.c_str());
  }
  static void use(const char* driver) { SDL_setenv("SDL_AUDIODRIVER", driver, 1); }
  static bool audio_begun() { return SDL_WasInit(SDL_INIT_AUDIO) != 0; }
  /// Lets the device take samples for some time.
  static void listen() { SDL_Delay(200); }
  /// All samples so far.
  std::vector<float> heard() const {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::vector<float> samples(bytes.size() / sizeof(float));
    std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(float));
    return samples;
  }
  float loudest() const {
    float most = 0;
    for (const float sample : heard()) most = std::max(most, std::abs(sample));
    return most;
  }

  std::string file = testing::TempDir() + "speaker-" + std::to_string(SDL_GetPerformanceCounter());
};

TEST_F(SpeakerTest, NothingIsOpenedBeforeTheFirstSound) {
  platform::Speaker speaker;
  speaker.play({}, 100);
  EXPECT_FALSE(audio_begun());
  speaker.play({&click, 1}, 100);
  EXPECT_TRUE(audio_begun());
}

TEST_F(SpeakerTest, ASoundReachesTheDevice) {
  {
    platform::Speaker speaker;
    speaker.play({&click, 1}, 100);
    listen();
  }
  EXPECT_GT(loudest(), 0.01f);
  EXPECT_LE(loudest(), 1.0f);
}

TEST_F(SpeakerTest, TheDeviceIsClosedWithTheSpeaker) {
  {
    platform::Speaker speaker;
    speaker.play({&click, 1}, 100);
    listen();
  }
  const std::size_t before = heard().size();
  listen();
  EXPECT_EQ(heard().size(), before);
}

TEST_F(SpeakerTest, WithoutADeviceThereIsSilenceAndNoSecondTry) {
  use("no such driver");
  platform::Speaker speaker;
  speaker.play({&click, 1}, 100);
  EXPECT_FALSE(audio_begun());
  use("disk");
  speaker.play({&click, 1}, 100);
  EXPECT_FALSE(audio_begun());
}

}  // namespace
