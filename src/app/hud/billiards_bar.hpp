#pragma once

#include <array>

#include "app/hud/user_bar.hpp"
#include "app/text/text.hpp"

namespace app {

/// Both players' scores, whose turn it is, and what is left.
class BilliardsBar : public UserBar {
 public:
  struct Content {
    std::array<std::int64_t, 2> scores{};
    std::optional<int> on;  ///< whose turn it is; none when the game is over
    int balls_left = 0;
    std::int64_t turn_points = 0;
    std::optional<int> shots{};  ///< of one who plays alone; none with two players
  };

  explicit BilliardsBar(const Words& words);

  void resize(const View& view, const Rect& area);
  void draw(Canvas& canvas, const Content& content) const;

 private:
  void draw_player(Canvas& canvas, const Content& content, int player) const;

  void draw_shots(Canvas& canvas, int shots) const;

  Words words_;
  std::array<Rect, 2> players_;
  std::array<Rect, 2> counts_;  ///< balls left, points of this turn
};

}  // namespace app
