#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace app {

enum class SoundKind : std::uint8_t {
  ball,     ///< billiard balls meet
  block,    ///< balls of wood, stone or iron meet
  cushion,  ///< a ball meets the table's rubber
  ground,   ///< a ball falls on earth
  wall,     ///< a ball meets stone
  pocket,   ///< a ball drops into a hole
  burst,    ///< a ball breaks
  cue,      ///< the cue ball is shot
  sling,    ///< the projectile is thrown
  click,    ///< a button is pressed
  win,
  lose,
};
inline constexpr std::size_t sound_kinds = 12;

/// Something that can be heard.
struct SoundEvent {
  SoundKind kind = SoundKind::ball;
  float strength = 1;  ///< 0 to 1, in proportion to the speed of what met
  float pan = 0;       ///< −1 (left) to 1 (right)

  friend bool operator==(const SoundEvent&, const SoundEvent&) = default;
};

/// The sounds since they were last taken.
class Sounds {
 public:
  static constexpr float faintest = 0.015f;      ///< what is weaker is not heard
  static constexpr std::size_t most_a_kind = 6;  ///< at once: a break is a crack, not a hundred

  void note(SoundEvent event) {
    if (event.strength >= faintest) events_.push_back(event);
  }
  /// Kind by kind, the strongest of each, strongest first; afterwards there is none.
  std::vector<SoundEvent> take() {
    std::ranges::stable_sort(events_, [](const SoundEvent& a, const SoundEvent& b) {
      return a.kind != b.kind ? a.kind < b.kind : a.strength > b.strength;
    });
    std::vector<SoundEvent> taken;
    std::size_t of_kind = 0;
    for (const SoundEvent& event : events_) {
      of_kind = !taken.empty() && taken.back().kind == event.kind ? of_kind + 1 : 1;
      if (of_kind <= most_a_kind) taken.push_back(event);
    }
    events_.clear();
    return taken;
  }
  bool empty() const { return events_.empty(); }
  /// True while the world is seen turned by a quarter to the left: it is heard as it is seen.
  void turn(bool turned) { turned_ = turned; }
  bool turned() const { return turned_; }

 private:
  bool turned_ = false;
  std::vector<SoundEvent> events_;
};

}  // namespace app
