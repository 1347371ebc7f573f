#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/aim.hpp"
#include "carom/scene.hpp"
#include "carom/vec2.hpp"

namespace app {

/// What can be done to the throw that a repetition makes.
enum class Change : std::uint8_t { faster, slower, left, right };
struct TakeBack {};
struct Repeat {};
using PracticeCommand = std::variant<TakeBack, Repeat, Change>;

/// 1 px/s faster or slower, or 0.1° to the left or right. `drag`: px, not zero. What would not move
/// the ball, or be above the greatest speed, is left as it is.
carom::Vec2 changed(carom::Vec2 drag, Change change);

/// Takes throws back and repeats them. `Game`: a value that a copy keeps whole.
template <class Game>
class Practice {
 public:
  static constexpr std::size_t most = 100;  ///< throws that can be taken back

  /// `before`: the game as it stood when `drag` (px) was thrown.
  void thrown(Game before, carom::Vec2 drag) {
    if (before_.size() == most) before_.erase(before_.begin());
    before_.push_back(std::move(before));
    drag_ = drag;
    ready_ = false;
  }
  /// The game before the last throw; none if there is none.
  std::optional<Game> take_back() {
    if (before_.empty()) return std::nullopt;
    std::optional<Game> game(std::move(before_.back()));
    before_.pop_back();
    ready_ = true;
    return game;
  }
  void change(Change how) {
    if (drag_) drag_ = changed(*drag_, how);
  }
  /// The game starts again: there is nothing to take back any more.
  void restart() {
    before_.clear();
    ready_ = true;
  }
  /// What a repetition throws, px; none before the first throw.
  const std::optional<carom::Vec2>& drag() const { return drag_; }
  /// A repetition starts from the game as it is; otherwise the last throw is taken back first.
  bool ready() const { return ready_ && drag_; }

 private:
  std::vector<Game> before_;
  std::optional<carom::Vec2> drag_;
  bool ready_ = false;
};

/// The launch that a repetition would make now, to be shown; not active if there is none.
template <class Game>
Aim planned(const std::optional<Practice<Game>>& practice, const carom::Ball& lead) {
  Aim aim;
  if (!practice || !practice->ready()) return aim;
  aim.begin(lead.position);
  aim.move(lead.position + *practice->drag());
  return aim;
}

}  // namespace app
