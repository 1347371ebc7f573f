#pragma once

#include "app/hud/billiards_bar.hpp"
#include "app/screens/place_ball.hpp"
#include "app/screens/play_screen.hpp"
#include "games/billiards.hpp"

namespace app {

/// A game of billiards for two, or against a computer, from the first shot to the end; or a table
/// to practise on, where shots can be taken back and nothing is saved.
class BilliardsScreen final : public PlayScreen<games::billiards::Game, PlaceBall> {
 public:
  enum class Mode : std::uint8_t { game, practice };

  BilliardsScreen(const Words& words, Session& session, Mode mode = Mode::game);
  /// Goes on with a game. `place`: where it is saved.
  BilliardsScreen(const Words& words, Session& session, BilliardsRecorder played,
                  KeptGames::Place place = {});

 private:
  Doing doing() const override;
  bool moving() const override {
    return game().phase() == games::billiards::Phase::roll && !resigned_;
  }
  carom::Vec2 first_drag() const override;
  Over ending() override;
  bool start_again() override;
  std::optional<ComputerTurn> computer_turn() const override;
  void play(const search::Decision& decision) override;
  bool can_resign() const override;
  void resign() override;
  void announce_start() override { announce_turn({}); }
  void note(const Event& event) override;
  void begin_launch() override {
    shooter_ = game().player();
    missed_ = false;
  }
  Navigation leave_to() const override { return ShowTitle{}; }

  UserBar& bar() override { return bar_; }
  const UserBar& bar() const override { return bar_; }
  void resize_bar(const Rect& area) override { bar_.resize(view_, area); }
  void draw_bar(Canvas& canvas) const override;
  void find_pointer() override;

  Handled waiting_event(PlaceBall& place, const Input& input) override;
  void place_waiting(PlaceBall&) override { find_pointer(); }
  void draw_waiting(Canvas& canvas, const PlaceBall& place, bool over_effects) const override;
  std::optional<AimPrompt> waiting_prompt() const override;
  std::string waiting_hint() const override { return PlaceBall::hint(words_, stage()); }
  Color waiting_color(const Palette& palette) const override {
    return PlaceBall::hint_color(palette, stage());
  }

  AimHints aim_hints() const override {
    return {Text::hint_take_cue_ball, Text::hint_not_cue_ball, Text::hint_shoot};
  }
  Text watch_hint() const override { return Text::hint_watch; }
  Color lead_color(const Palette& palette) const override;
  Rect effects_area(const Canvas&) const override { return world_view_.box(); }
  std::string now() const override;
  std::string state_line(const std::string& now) const override;

  void announce_turn(const std::string& detail);
  PlaceBall::Stage stage() const;
  Over cleared();
  const replay::Occasion& occasion() const { return played_.recorder().occasion(); }
  std::optional<int> winner() const { return resigned_ ? 1 - *resigned_ : game().winner(); }

  BilliardsBar bar_;
  bool missed_ = false;          ///< the last shot touched no red, which the house rule forbids
  std::optional<int> resigned_;  ///< the player who did
  int shooter_ = 0;              ///< whose turn it was when the balls began to roll
};

}  // namespace app
