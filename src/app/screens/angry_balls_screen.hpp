#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "app/hud/level_bar.hpp"
#include "app/hud/practice_strip.hpp"
#include "app/play/foresight.hpp"
#include "app/play/game_speed.hpp"
#include "app/play/launcher.hpp"
#include "app/play/played.hpp"
#include "app/play/preview.hpp"
#include "app/play/session.hpp"
#include "app/text/text.hpp"
#include "app/view/effects.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/viewport.hpp"
#include "app/widgets/dialog.hpp"
#include "app/widgets/screen.hpp"
#include "games/angry_balls.hpp"

namespace app {

/// The campaign's current level, from the first throw to the end; in practice throws can be taken
/// back and nothing is kept.
class AngryBallsScreen final : public Screen {
 public:
  /// The level must be one that can be played.
  AngryBallsScreen(const Words& words, Session& session);
  /// Goes on with a game of the campaign's current level.
  AngryBallsScreen(const Words& words, Session& session, LevelRecorder played);

  void resize(const View& view) override;
  Transition event(const Input& input) override;
  Transition iterate(nanoseconds elapsed) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  std::optional<AimPrompt> aim_prompt() const override;
  bool animating() const override;

  const games::angry_balls::Game& game() const { return played_.game(); }
  const Viewport& viewport() const { return viewport_; }
  /// What is being aimed; null when nothing is.
  const Aim* aimed() const { return aim_in(state_); }

 private:
  // What the player is doing; it follows the game's phase.
  struct WatchThrow {};
  struct NextOffered {
    Buttons prompt;
  };
  /// The world plays on for a moment, for show, before the window opens.
  struct Over {
    Dialog dialog;
    carom::World epilogue;
    nanoseconds wait{};
  };
  using State = std::variant<Launcher, WatchThrow, NextOffered, Over>;

  void follow_phase();
  void place_parts();
  void step();
  void keep();
  void show_anew();
  void trace_projectile();
  void announce_level();
  Dialog result();

  Transition obey(UserBar::Command command);
  Transition finish(ButtonId button);
  bool on_button() const;
  Launcher::Stage stage() const;
  const carom::World& shown_world() const;
  bool moving() const;

  void draw_bars(Canvas& canvas) const;
  void draw_trace(DrawList& list) const;
  std::string hint() const;
  Color hint_color(const Palette& palette) const;
  std::string title() const;
  std::string next_label() const;

  Words words_;
  Session& session_;
  Campaign& campaign_;
  Played<games::angry_balls::Game> played_;
  State state_ = Launcher{};
  std::optional<Dialog> question_;  ///< whether to leave
  int turn_points_ = 0;

  Clock clock_;
  GameSpeed game_speed_;
  Foresight<games::angry_balls::Game> foresight_;
  Interpolator interpolator_;
  Effects effects_;
  mutable Previewer previewer_;     ///< remembers what draw() asked for
  std::vector<carom::Vec2> trace_;  ///< px, where the last throw went

  LevelBar bar_;
  PracticeStrip strip_;
  View view_;
  GameLayout layout_;
  Viewport viewport_;
  Point pointer_;
  bool touch_ = false;  ///< a finger was the pointer
};

}  // namespace app
