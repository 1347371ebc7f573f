#pragma once

#include <vector>

#include "app/hud/level_bar.hpp"
#include "app/play/stillness.hpp"
#include "app/screens/next_offer.hpp"
#include "app/screens/play_screen.hpp"
#include "games/angry_balls.hpp"

namespace app {

/// The campaign's current level, from the first throw to the end; in practice throws can be taken
/// back and nothing is saved.
class AngryBallsScreen final : public PlayScreen<games::angry_balls::Game, NextOffer> {
 public:
  /// The level must be one that can be played.
  AngryBallsScreen(const Words& words, Session& session);
  /// Goes on with a game of the campaign's current level. `place`: where it is saved.
  AngryBallsScreen(const Words& words, Session& session, LevelRecorder played,
                   KeptGames::Place place = {});

  std::string level_in_play() const override { return level_of(game().level()).identity; }
  Navigation levels_changed() override;

 private:
  Doing doing() const override;
  bool moving() const override;
  bool continues() const override;
  carom::Vec2 first_drag() const override;
  Over ending() override;
  bool start_again() override { return played_.restart(); }
  void announce_start() override;
  void note(const Event& event) override { turn_points_ += event.points; }
  void after_step() override;
  void begin_launch() override {
    trace_.clear();
    stillness_.reset();
    still_for_ = nanoseconds{0};
  }
  void pass_waiting(nanoseconds elapsed) override;
  std::optional<Ask> own_window() override;
  void own_answer(ButtonId button) override;
  Navigation leave_to() const override { return ShowLevels{}; }
  Navigation next_game() override;

  UserBar& bar() override { return bar_; }
  const UserBar& bar() const override { return bar_; }
  void resize_bar(const Rect& area) override { bar_.resize(view_, area); }
  void draw_bar(Canvas& canvas) const override;
  bool bar_is_last() const override;
  void draw_ground(Canvas& canvas) const override;
  void find_pointer() override { pointer_ = viewport().to_window(game().launch_place()); }

  Handled waiting_event(NextOffer& offer, const Input& input) override;
  Buttons* waiting_buttons() override;
  void place_waiting(NextOffer& offer) override;
  void draw_waiting(Canvas& canvas, const NextOffer& offer, bool over_effects) const override;
  std::string waiting_hint() const override;
  Color waiting_color(const Palette& palette) const override { return palette.allowed; }

  AimHints aim_hints() const override {
    return {Text::hint_take_projectile, Text::hint_not_projectile, Text::hint_throw};
  }
  Text watch_hint() const override { return Text::hint_flying; }
  Color lead_color(const Palette& palette) const override { return palette.accents[0]; }
  Rect effects_area(const Canvas& canvas) const override;
  std::string now() const override;
  std::string state_line(const std::string& now) const override;

  std::string title() const;
  void take_next();

  Campaign& campaign_;
  std::vector<carom::Vec2> trace_;  ///< px, where the last throw went
  LevelBar bar_;
  Stillness stillness_;
  nanoseconds still_for_{};  ///< since nothing can change any more
};

}  // namespace app
