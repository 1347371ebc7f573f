#pragma once

#include <optional>
#include <variant>

#include "app/hud/billiards_bar.hpp"
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
#include "games/billiards.hpp"

namespace app {

/// A game of billiards for two, from the first shot to the end; or a table to practise on, where
/// shots can be taken back and nothing is kept.
class BilliardsScreen final : public Screen {
 public:
  enum class Mode : std::uint8_t { game, practice };

  BilliardsScreen(const Words& words, Session& session, Mode mode = Mode::game);
  /// Goes on with a game.
  BilliardsScreen(const Words& words, Session& session, BilliardsRecorder played);

  void resize(const View& view) override;
  Transition event(const Input& input) override;
  Transition iterate(nanoseconds elapsed) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  std::optional<AimPrompt> aim_prompt() const override;
  bool animating() const override;

  const games::billiards::Game& game() const { return played_.game(); }
  const Viewport& viewport() const { return viewport_; }
  /// What is being aimed; null when nothing is.
  const Aim* aimed() const { return aim_in(state_); }

 private:
  // What the player is doing; it follows the game's phase.
  struct WatchShot {};
  struct PlaceBall {};
  struct Over {
    Dialog dialog;
  };
  using State = std::variant<Launcher, WatchShot, PlaceBall, Over>;

  /// Asks before a game is given up.
  struct Question {
    Dialog dialog;
    UserBar::Command about;
  };

  void follow_phase();
  void step();
  void keep();
  void show_anew();
  void note(const games::billiards::Event& event, int shooter);
  void announce_turn(int player, const std::string& detail);
  Dialog result() const;

  Transition obey(UserBar::Command command);
  Transition request(UserBar::Command command);
  Transition finish(ButtonId button);
  void place(Point at);
  bool steer_place(const Input& input);
  void find_pointer();
  bool on_button() const;
  Launcher::Stage stage() const;
  Rect table_area() const;

  void draw_cue_ball_in_hand(Canvas& canvas) const;
  std::string hint() const;
  Color hint_color(const Palette& palette) const;
  BilliardsBar::Content bar_content() const;

  Words words_;
  Session& session_;
  Played<games::billiards::Game> played_;
  State state_ = Launcher{};
  std::optional<Question> question_;

  Clock clock_;
  GameSpeed game_speed_;
  Foresight<games::billiards::Game> foresight_;
  Interpolator interpolator_;
  Effects effects_;
  mutable Previewer previewer_;  ///< remembers what draw() asked for
  int turn_points_ = 0;          ///< of the turn that is shown; the game forgets them with the turn

  BilliardsBar bar_;
  PracticeStrip strip_;
  View view_;
  GameLayout layout_;
  Viewport viewport_;
  Point pointer_;
  bool touch_ = false;  ///< a finger was the pointer
};

}  // namespace app
