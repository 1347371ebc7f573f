#include "app/audio/mixer.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using app::Mixer;
using app::SoundEvent;
using app::SoundKind;

/// Left and right in turn; ends when the mixer is idle, or after five seconds.
std::vector<float> heard(Mixer& mixer, std::size_t frames_at_once = 480) {
  std::vector<float> all;
  std::vector<float> part(2 * frames_at_once);
  while (!mixer.idle() && all.size() < std::size_t{2} * 5 * Mixer::rate) {
    mixer.mix(part);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
std::vector<float> heard(SoundEvent event) {
  Mixer mixer;
  mixer.play({&event, 1});
  return heard(mixer);
}
float peak(std::span<const float> samples) {
  float most = 0;
  for (const float x : samples) most = std::max(most, std::abs(x));
  return most;
}
double energy(std::span<const float> samples) {
  double sum = 0;
  for (const float x : samples) sum += static_cast<double>(x) * static_cast<double>(x);
  return sum;
}

class EverySound : public testing::TestWithParam<SoundKind> {};

TEST_P(EverySound, IsHeardDiesAwayAndHasNoMean) {
  Mixer mixer;
  const SoundEvent event{GetParam(), 1, 0};
  EXPECT_TRUE(mixer.idle());
  mixer.play({&event, 1});
  EXPECT_FALSE(mixer.idle());
  const auto samples = heard(mixer);
  ASSERT_TRUE(mixer.idle());
  EXPECT_GT(peak(samples), 0.05f);
  EXPECT_LT(peak(samples), 0.7f) << "a single sound needs no limiter";
  double sum = 0;
  for (const float x : samples) sum += static_cast<double>(x);
  EXPECT_LT(std::abs(sum) / static_cast<double>(samples.size()), 1e-4);
  std::vector<float> after(960, 1.0f);
  mixer.mix(after);
  EXPECT_EQ(peak(after), 0);
}

TEST_P(EverySound, BeginsAndEndsWithoutAClick) {
  const auto samples = heard({GetParam(), 1, 0});
  EXPECT_EQ(samples[0], 0);
  // Of the first quarter of a millisecond, half of what an attack of a millisecond allows more.
  EXPECT_LT(peak(std::span(samples).first(2 * 12)), 0.4f * peak(samples));
  EXPECT_LT(peak(std::span(samples).last(2 * 48)), 3e-4f);
}

TEST_P(EverySound, IsLouderTheStronger) {
  double before = 0;
  for (const float strength : {0.05f, 0.2f, 0.5f, 1.0f}) {
    const double now = energy(heard({GetParam(), strength, 0}));
    EXPECT_GT(now, 1.5 * before) << strength;
    before = now;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EverySound,
                         testing::Values(SoundKind::ball, SoundKind::block, SoundKind::cushion,
                                         SoundKind::ground, SoundKind::wall, SoundKind::pocket,
                                         SoundKind::burst, SoundKind::cue, SoundKind::sling,
                                         SoundKind::click, SoundKind::win, SoundKind::lose));

/// Much at once, of every kind.
std::vector<SoundEvent> storm() {
  std::vector<SoundEvent> events;
  for (std::size_t i = 0; i < 120; ++i)
    events.push_back({static_cast<SoundKind>(i * app::sound_kinds / 120),
                      static_cast<float>(i % 10) / 9, static_cast<float>(i % 3) - 1});
  return events;
}

TEST(Mixer, AStormStaysWithinBounds) {
  Mixer mixer;
  std::vector<float> part(1600);
  float most = 0;
  for (int frame = 0; frame < 40; ++frame) {
    mixer.play(storm());
    EXPECT_LE(mixer.voices(), Mixer::most_voices);
    mixer.mix(part);
    for (const float x : part) {
      ASSERT_TRUE(std::isfinite(x));
      ASSERT_LE(std::abs(x), 1);
    }
    most = std::max(most, peak(part));
  }
  EXPECT_GT(most, 0.7f) << "the storm is to reach the limiter";
  heard(mixer);
  EXPECT_TRUE(mixer.idle());
}

TEST(Mixer, SameEventsSameSamplesInPiecesOfAnySize) {
  Mixer one;
  Mixer two;
  one.play(storm());
  two.play(storm());
  const auto a = heard(one, 480);
  const auto b = heard(two, 7);
  const std::size_t common = std::min(a.size(), b.size());
  ASSERT_GT(common, 40'000u);
  for (std::size_t i = 0; i < common; ++i) ASSERT_EQ(a[i], b[i]) << i;
}

TEST(Mixer, AStrongSoundTakesTheWeakestVoice) {
  Mixer mixer;
  const SoundEvent weak{SoundKind::cushion, 0.05f, 0};
  const SoundEvent strong{SoundKind::cushion, 1, 0};
  std::vector<float> part(9600);
  for (std::size_t i = 0; i < Mixer::most_voices; ++i) mixer.play({&weak, 1});
  mixer.play({&strong, 1});
  EXPECT_EQ(mixer.voices(), Mixer::most_voices);
  mixer.mix(part);
  Mixer alone;
  for (std::size_t i = 0; i < Mixer::most_voices; ++i) alone.play({&weak, 1});
  std::vector<float> without(9600);
  alone.mix(without);
  EXPECT_GT(energy(part), 1.3 * energy(without));
  // A weak one that comes when all are taken by stronger ones is not heard.
  Mixer full;
  for (std::size_t i = 0; i < Mixer::most_voices; ++i) full.play({&strong, 1});
  Mixer same = full;
  full.play({&weak, 1});
  full.mix(part);
  same.mix(without);
  EXPECT_EQ(part, without);
}

TEST(Mixer, GivingWayDoesNotClick) {
  Mixer mixer;
  mixer.set_volume(30);  // below the limiter
  const std::vector<SoundEvent> low(Mixer::most_voices, {SoundKind::ground, 0.02f, 0});
  for (const SoundEvent& event : low) mixer.play({&event, 1});
  std::vector<float> part(1200);
  float steepest = 0;
  float last = 0;
  for (int i = 0; i < 4; ++i) {
    mixer.mix(part);
    steepest = 0;  // of the last part: the noise has died away
    for (std::size_t k = 0; k < part.size(); k += 2) {
      steepest = std::max(steepest, std::abs(part[k] - last));
      last = part[k];
    }
  }
  // It begins softly: what jumps now is what ends.
  const std::vector<SoundEvent> soft(Mixer::most_voices / 2, {SoundKind::sling, 1, 0});
  mixer.play(soft);
  mixer.mix(part);
  EXPECT_LT(std::abs(part[0] - last), 1.5f * steepest);
}

TEST(Mixer, PanGoesFromLeftToRight) {
  const auto side = [](float pan, std::size_t which) {
    const auto samples = heard({SoundKind::ball, 1, pan});
    float most = 0;
    for (std::size_t i = which; i < samples.size(); i += 2)
      most = std::max(most, std::abs(samples[i]));
    return most;
  };
  EXPECT_LT(side(-1, 1), 1e-4f);
  EXPECT_LT(side(1, 0), 1e-4f);
  EXPECT_NEAR(side(0, 0), side(0, 1), 1e-6f);
  EXPECT_GT(side(-0.5f, 0), 1.5f * side(-0.5f, 1));
}

TEST(Mixer, MutingIsQuickAndDoesNotClick) {
  Mixer mixer;
  const SoundEvent event{SoundKind::win, 1, 0};
  mixer.play({&event, 1});
  std::vector<float> part(2 * 9600);
  mixer.mix(part);
  float steepest = 0;
  for (std::size_t i = 2; i < part.size(); ++i)
    steepest = std::max(steepest, std::abs(part[i] - part[i - 2]));
  const float last = part[part.size() - 2];
  mixer.set_volume(0);
  mixer.mix(part);
  EXPECT_LT(std::abs(part[0] - last), 1.5f * steepest);
  for (std::size_t i = 2; i < part.size(); ++i)
    ASSERT_LT(std::abs(part[i] - part[i - 2]), 1.5f * steepest);
  // After 60 ms.
  EXPECT_EQ(peak(std::span(part).subspan(2 * 2880)), 0);
}

}  // namespace
