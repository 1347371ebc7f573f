#include "app/audio/mixer.hpp"

#include <cmath>
#include <numbers>

namespace app {
namespace {

/// A sine wave; `ring`: ms until it is a thousandth.
struct Tone {
  float hz = 0;  ///< 0: none
  float gain = 0;
  float ring = 1;
};
/// A part of a sound, a voice each.
struct Note {
  float delay = 0;   ///< ms
  float attack = 1;  ///< ms
  std::array<Tone, 3> tones{};
  Tone noise{};  ///< hz: the middle of its band
};

// The gains are such that a single strong contact peaks at a third to two thirds. Low sounds have a
// part above 200 Hz: small loudspeakers give nothing below.
constexpr std::array ball{
    Note{0, 1, {{{2850, 0.34f, 38}, {4620, 0.20f, 24}, {6900, 0.10f, 14}}}, {4200, 0.25f, 9}}};
constexpr std::array block{
    Note{0, 1, {{{610, 0.34f, 75}, {1180, 0.20f, 48}, {2240, 0.10f, 28}}}, {1500, 0.16f, 18}}};
constexpr std::array cushion{
    Note{0, 2, {{{128, 0.30f, 150}, {214, 0.22f, 110}, {371, 0.10f, 70}}}, {620, 0.2f, 70}}};
constexpr std::array ground{
    Note{0, 1.5f, {{{92, 0.34f, 170}, {163, 0.22f, 130}, {287, 0.10f, 80}}}, {480, 0.26f, 110}}};
constexpr std::array wall{
    Note{0, 1, {{{470, 0.30f, 80}, {1130, 0.20f, 60}, {1930, 0.12f, 40}}}, {1600, 0.18f, 26}}};
// Over the edge, and on the leather.
constexpr std::array pocket{
    Note{0, 1.5f, {{{240, 0.22f, 120}, {505, 0.12f, 60}, {}}}, {900, 0.14f, 60}},
    Note{85, 1.5f, {{{132, 0.34f, 240}, {221, 0.26f, 180}, {418, 0.08f, 90}}}, {430, 0.2f, 180}}};
constexpr std::array burst{
    Note{0, 1, {{{330, 0.26f, 110}, {745, 0.16f, 80}, {1690, 0.1f, 60}}}, {2300, 0.42f, 90}},
    Note{28, 2, {{{96, 0.28f, 240}, {}, {}}}, {760, 0.32f, 300}}};
constexpr std::array cue{
    Note{0, 1, {{{640, 0.34f, 70}, {1390, 0.2f, 40}, {2650, 0.08f, 22}}}, {1900, 0.14f, 14}}};
constexpr std::array sling{
    Note{0, 45, {{{148, 0.2f, 200}, {223, 0.12f, 140}, {}}}, {850, 0.5f, 320}}};
constexpr std::array click{
    Note{0, 2, {{{1150, 0.11f, 45}, {1720, 0.05f, 30}, {}}}, {2400, 0.02f, 12}}};
constexpr Note bell(float delay, float hz) {
  return {delay, 4, {{{hz, 0.17f, 900}, {2 * hz, 0.06f, 500}, {3 * hz, 0.02f, 260}}}, {}};
}
constexpr std::array win{bell(0, 523.25f), bell(110, 659.26f), bell(220, 783.99f),
                         bell(330, 1046.5f)};
constexpr std::array lose{bell(0, 392.0f), bell(190, 311.13f), bell(380, 233.08f)};

std::span<const Note> notes_of(SoundKind kind) {
  switch (kind) {
    case SoundKind::ball:
      return ball;
    case SoundKind::block:
      return block;
    case SoundKind::cushion:
      return cushion;
    case SoundKind::ground:
      return ground;
    case SoundKind::wall:
      return wall;
    case SoundKind::pocket:
      return pocket;
    case SoundKind::burst:
      return burst;
    case SoundKind::cue:
      return cue;
    case SoundKind::sling:
      return sling;
    case SoundKind::click:
      return click;
    case SoundKind::win:
      return win;
    case SoundKind::lose:
      break;
  }
  return lose;
}

constexpr float inaudible = 1e-4f;  ///< −80 dB
constexpr float knee = 0.7f;        ///< what is louder is pressed together
constexpr int stagger = Mixer::rate * 3 / 1000;
/// The gain and what a cut voice leaves behind follow with this much of the rest a sample: 4 ms.
constexpr float follow = 1.0f / (0.004f * Mixer::rate);
/// The same for the mean, which is taken away: what is below 20 Hz only moves the loudspeaker.
constexpr float centre = 2 * std::numbers::pi_v<float> * 20 / Mixer::rate;

int samples(float ms) { return static_cast<int>(ms * Mixer::rate / 1000); }

/// Decay per sample of a sound that is down to a thousandth after `ring` ms.
float shrinkage(float ring) { return std::exp(-6.9078f / (ring * Mixer::rate / 1000)); }

/// 32 bits that look random.
std::uint32_t roll(std::uint32_t& dice) {
  dice ^= dice << 13;
  dice ^= dice >> 17;
  dice ^= dice << 5;
  return dice;
}

/// In [−1, 1].
float random(std::uint32_t& dice) {
  return static_cast<float>(static_cast<std::int32_t>(roll(dice))) * 0x1p-31f;
}

/// The same up to the knee, and never beyond 1.
float limited(float x) {
  const float size = std::abs(x);
  if (size <= knee) return x;
  const float over = (size - knee) / (1 - knee);
  return std::copysign(knee + (1 - knee) * over / (1 + over), x);
}

}  // namespace

float Mixer::Voice::next() {
  float sum = 0;
  for (Wave& wave : waves) {
    const float now = wave.now;
    wave.now = wave.turn * now - wave.shrink * wave.before;
    wave.before = now;
    sum += now;
  }
  if (noise > 0) {
    low += pitch * band;
    band += pitch * (noise * random(dice) - low - 0.7f * band);
    noise *= noise_shrink;
    sum += band;
  }
  if (age < attack) sum *= static_cast<float>(age) / static_cast<float>(attack);
  ++age;
  level *= fade;
  return last = sum;
}

void Mixer::play(std::span<const SoundEvent> events) {
  int of_kind = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const SoundEvent& event = events[i];
    of_kind = i > 0 && events[i - 1].kind == event.kind ? of_kind + 1 : 0;
    const float strength = std::clamp(event.strength, 0.0f, 1.0f);
    const float turn = (std::clamp(event.pan, -1.0f, 1.0f) + 1) * std::numbers::pi_v<float> / 4;
    // As the ear has it: half the speed is more than half as loud. Soft contacts are duller, too.
    const float loud = std::pow(strength, 0.8f);
    for (const Note& note : notes_of(event.kind)) {
      Voice voice;
      voice.dice = ++played_ * 2'654'435'769u | 1u;
      const bool music = event.kind == SoundKind::win || event.kind == SoundKind::lose;
      const float detune = music ? 1 : 1 + 0.03f * random(voice.dice);
      voice.wait = samples(note.delay) + of_kind * stagger;
      voice.attack = samples(note.attack);
      // Equal power on both sides together, whole in the middle.
      voice.sides = {std::cos(turn) * std::numbers::sqrt2_v<float>,
                     std::sin(turn) * std::numbers::sqrt2_v<float>};
      float longest = note.noise.ring;
      float dull = 1;
      for (std::size_t k = 0; k < note.tones.size(); ++k, dull *= 0.4f + 0.6f * strength) {
        const Tone& tone = note.tones[k];
        if (tone.hz == 0) continue;
        const float angle = 2 * std::numbers::pi_v<float> * tone.hz * detune / rate;
        const float shrink = shrinkage(tone.ring);
        Wave& wave = voice.waves[k];
        const float gain = tone.gain * loud * dull;
        wave.turn = 2 * shrink * std::cos(angle);
        wave.shrink = shrink * shrink;
        wave.before = -gain * std::sin(angle) / shrink;  // it begins at 0
        voice.level += gain;
        longest = std::max(longest, tone.ring);
      }
      if (note.noise.hz > 0) {
        voice.pitch = 2 * std::sin(std::numbers::pi_v<float> * note.noise.hz * detune / rate);
        // A low band lets less of the noise through.
        voice.noise = note.noise.gain * loud / std::sqrt(voice.pitch);
        voice.noise_shrink = shrinkage(note.noise.ring);
        voice.level += note.noise.gain * loud;
      }
      voice.fade = shrinkage(longest);
      add(voice);
    }
  }
}

void Mixer::add(Voice voice) {
  if (voices_.size() < most_voices) {
    voices_.push_back(voice);
    return;
  }
  Voice& quietest = *std::ranges::min_element(voices_, {}, &Voice::level);
  if (quietest.level >= voice.level) return;
  for (std::size_t side = 0; side < 2; ++side)
    residue_[side] += quietest.last * quietest.sides[side];
  quietest = voice;
}

void Mixer::set_volume(int percent) {
  const float part = static_cast<float>(std::clamp(percent, 0, 100)) / 100;
  wanted_gain_ = part * part;
}

void Mixer::mix(std::span<float> samples) {
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
    std::array sum = residue_;
    for (float& rest : residue_) {
      rest *= 1 - follow;
      if (std::abs(rest) < inaudible) rest = 0;
    }
    for (Voice& voice : voices_) {
      if (voice.wait > 0) {
        --voice.wait;
        continue;
      }
      if (voice.level < inaudible) continue;
      const float sample = voice.next();
      for (std::size_t side = 0; side < 2; ++side) sum[side] += sample * voice.sides[side];
    }
    gain_ += follow * (wanted_gain_ - gain_);
    if (std::abs(wanted_gain_ - gain_) < inaudible) gain_ = wanted_gain_;
    for (std::size_t side = 0; side < 2; ++side) {
      mean_[side] += centre * (sum[side] - mean_[side]);
      samples[i + side] = limited((sum[side] - mean_[side]) * gain_);
    }
  }
  std::erase_if(voices_, [](const Voice& voice) { return voice.level < inaudible; });
  // Nothing left but a mean that nobody hears.
  if (voices_.empty() &&
      std::ranges::all_of(mean_, [](float x) { return std::abs(x) < inaudible; }))
    mean_ = {};
}

}  // namespace app
