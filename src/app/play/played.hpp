#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "app/play/practice.hpp"
#include "app/play/session.hpp"
#include "app/view/game_sounds.hpp"

namespace app {

/// The game on a screen, recorded. It is saved as the one in progress, to be continued; or, in
/// practice, throws can be taken back and repeated, and nothing is saved.
///
/// `Game` is games::billiards::Game or games::angry_balls::Game.
template <class Game>
class Played {
 public:
  using Recorder = replay::Recorder<Game>;

  /// The session must outlive this. `place`: where the game is saved already.
  Played(Session& session, Recorder recorder, KeptGames::Place place)
      : session_(session), recorder_(std::move(recorder)), place_(std::move(place)) {}

  const Game& game() const { return recorder_.game(); }
  const Recorder& recorder() const { return recorder_; }

  void begin_practice() { practice_.emplace(); }
  /// None unless in practice.
  const std::optional<Practice<Recorder>>& practice() const { return practice_; }
  /// Does what the player wants of the practice. `aimed`: what is being aimed, which then is what
  /// is changed or thrown; null when nothing is. Whether the game has gone elsewhere.
  bool practise(const PracticeCommand& command, Aim* aimed) {
    if (const auto* how = std::get_if<Change>(&command)) {
      change(aimed ? *aimed : practice_->plan, *how);
      return false;
    }
    const bool repeat = std::holds_alternative<Repeat>(command);
    const Aim plan = aimed ? *aimed : practice_->plan;
    if (repeat && !plan.active()) return false;
    if (!repeat || !practice_->ready()) {
      auto before = practice_->take_back();
      if (!before) return false;
      recorder_ = std::move(*before);
    }
    if (repeat) launch(plan);
    return true;
  }

  // These tell whether the game took it.
  bool apply(const typename Recorder::GameCommand& command) {
    return recorder_.apply(command).ok();
  }
  /// A shot or throw.
  bool launch(const Aim& aim) {
    auto before = practice_ ? std::optional(recorder_) : std::nullopt;
    if (!apply(Launch{aim.drag()})) return false;
    note_launch(session_.sounds, game().world().ball(0), game().world().scene());
    if (before) practice_->thrown(std::move(*before), aim);
    last_drag_ = aim.drag();
    return true;
  }
  /// Of the last launch on this screen, px; none before the first.
  const std::optional<carom::Vec2>& last_drag() const { return last_drag_; }
  bool restart() {
    if (!apply(Restart{})) return false;
    restarted();
    return true;
  }
  /// The same with another game, at its start.
  void restart(Recorder fresh) {
    recorder_ = std::move(fresh);
    restarted();
  }
  void step() { recorder_.step(); }
  /// There is nothing to be continued.
  void give_up() { session_.kept.forget(place_); }

  /// Keeps the game as it is now; once it is over, there is none to continue. False when it could
  /// not be kept and the player has not been told yet.
  bool keep() {
    if (practice_) return true;
    if (replay::over(game())) {
      session_.kept.forget(place_);
      return true;
    }
    return session_.kept.keep(place_, recorder_.replay()) || std::exchange(told_not_kept_, true);
  }

 private:
  void restarted() {
    // The game given up stays saved until the new one has a launch to save in its place.
    if (practice_) practice_->restart();
  }

  static constexpr bool billiards = std::is_same_v<Game, games::billiards::Game>;
  using Launch = std::conditional_t<billiards, games::billiards::Shoot, games::angry_balls::Throw>;
  using Restart =
      std::conditional_t<billiards, games::billiards::Restart, games::angry_balls::Restart>;

  Session& session_;
  Recorder recorder_;
  KeptGames::Place place_;
  std::optional<Practice<Recorder>> practice_;
  std::optional<carom::Vec2> last_drag_;
  bool told_not_kept_ = false;
};

}  // namespace app
