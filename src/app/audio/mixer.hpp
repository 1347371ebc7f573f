#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/audio/sound.hpp"

namespace app {

/// Makes sounds of SoundEvents: every voice is a few sine waves and a band of noise that die away.
/// No clock and no randomness: the same events at the same samples give the same samples.
class Mixer {
 public:
  static constexpr int rate = 48'000;             ///< samples a second, of either side
  static constexpr std::size_t most_voices = 32;  ///< the quietest gives way

  /// Begins with the next sample. Several of one kind follow each other by some milliseconds, as
  /// contacts in a heap of balls do.
  void play(std::span<const SoundEvent> events);
  /// Per cent, 0 to 100, as loud as it is felt; reached in some milliseconds. Default 100.
  void set_volume(int percent);
  /// Fills `samples`: left and right in turn, each within [−1, 1].
  void mix(std::span<float> samples);
  /// Nothing sounds any more: mix() would give silence.
  bool idle() const { return voices_.empty() && residue_ == Sides{} && mean_ == Sides{}; }
  std::size_t voices() const { return voices_.size(); }

 private:
  using Sides = std::array<float, 2>;  ///< left, right

  /// A sine wave that dies away, as a recurrence: next = turn · now − shrink · before.
  struct Wave {
    float now = 0;
    float before = 0;
    float turn = 0;
    float shrink = 0;
  };
  struct Voice {
    int wait = 0;    ///< samples until it begins
    int age = 0;     ///< samples since
    int attack = 1;  ///< samples until it is at its full strength
    std::array<Wave, 3> waves{};
    float noise = 0;         ///< the noise's strength now
    float noise_shrink = 0;  ///< what is left of it in the next sample
    float pitch = 0;         ///< of the band-pass, in [0, 1)
    float low = 0;           ///< the band-pass' state
    float band = 0;
    std::uint32_t dice = 1;  ///< the noise's generator
    float level = 0;         ///< no sample is louder than about this from now on
    float fade = 0;          ///< what is left of the level in the next sample
    Sides sides{};
    float last = 0;  ///< sample

    float next();
  };
  void add(Voice voice);

  std::vector<Voice> voices_;
  /// The rest of a voice that gave way: a sudden end would click.
  Sides residue_{};
  Sides mean_{};  ///< of what was mixed lately
  float gain_ = 1;
  float wanted_gain_ = 1;
  std::uint32_t played_ = 0;  ///< voices: no two sound quite the same
};

}  // namespace app
