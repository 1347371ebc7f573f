#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/play/aim.hpp"

namespace app {

/// Changes of the throw that a repetition makes.
enum class Change : std::uint8_t { faster, slower, left, right };
struct TakeBack {};
struct Repeat {};
using PracticeCommand = std::variant<TakeBack, Repeat, Change>;

/// 1 px/s faster or slower, or 0.1° to the left or right.
void change(Aim& aim, Change how);

/// Takes throws back and repeats them. `Game`: a value that a copy keeps whole.
template <class Game>
class Practice {
 public:
  static constexpr std::size_t most = 100;  ///< throws that can be taken back

  /// `before`: the game as it stood when `aim` was thrown.
  void thrown(Game before, const Aim& aim) {
    if (before_.size() == most) before_.erase(before_.begin());
    before_.push_back(std::move(before));
    plan = aim;
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
  /// The game starts again: there is nothing to take back any more.
  void restart() {
    before_.clear();
    ready_ = true;
  }
  /// A repetition starts from the game as it is; otherwise the last throw is taken back first.
  bool ready() const { return ready_ && plan.active(); }

  Aim plan;  ///< what a repetition throws; not active before the first throw

 private:
  std::vector<Game> before_;
  bool ready_ = false;
};

}  // namespace app
