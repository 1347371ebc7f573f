#pragma once

#include <optional>
#include <string>

#include "app/play/clock.hpp"
#include "app/play/preview.hpp"
#include "app/play/session.hpp"
#include "app/screens/screen.hpp"
#include "app/text/text.hpp"
#include "app/view/effects.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/world_view.hpp"
#include "app/widgets/widgets.hpp"
#include "replay/player.hpp"
#include "search/simulation.hpp"

namespace app {

/// A recorded game of either kind: plays, steps, goes to any turn, and tells whether the game goes
/// as it was recorded.
class ReplayScreen final : public Screen {
 public:
  /// `turn`: begins there, standing still, and shows a shot `better` than that turn's as long as it
  /// stands there.
  ReplayScreen(const Words& words, Session& session, replay::Player player,
               std::optional<std::size_t> turn = {}, std::optional<search::Shot> better = {});

  void resize(const View& view) override;
  Navigation event(const Input& input) override;
  Navigation iterate(nanoseconds elapsed) override;
  void draw(Canvas& canvas) const override;
  std::string describe() const override;
  bool animating() const override;

  const replay::Player& player() const { return player_; }

 private:
  void play_or_pause();
  void step();
  void seek(std::size_t turn);
  void go_where_wanted();
  void change_speed(int by);
  void save();
  void copy();
  Navigation press(ButtonId button);

  void draw_better(Canvas& canvas) const;
  void draw_world(Canvas& canvas) const;
  void draw_top(Canvas& canvas) const;
  void draw_bottom(Canvas& canvas) const;
  std::string title() const;
  std::string score() const;
  std::string turn() const;
  std::string status() const;
  Color status_color(const Palette& palette) const;

  Words words_;
  Session& session_;
  replay::Player player_;
  std::optional<std::size_t> better_turn_;
  std::optional<search::Shot> better_;
  mutable Previewer previewer_;
  bool complete_ = false;              ///< the look-ahead has seen all there is
  std::optional<std::size_t> wanted_;  ///< a turn to go to as soon as it is reached
  bool playing_ = true;
  bool ended_ = false;
  std::size_t speed_;  ///< index in the list of speeds
  std::string message_;

  Clock clock_;
  Interpolator interpolator_;
  Effects effects_;

  Buttons buttons_;
  View view_;
  Rect top_;
  Rect bottom_;
  Rect timeline_;
  Rect name_;
  Rect score_;
  Rect turn_;
  Rect status_;
  Rect speed_label_;
  Rect hint_;
  WorldView world_view_;
};

}  // namespace app
