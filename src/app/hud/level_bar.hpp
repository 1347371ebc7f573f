#pragma once

#include <array>

#include "app/hud/user_bar.hpp"
#include "app/text/text.hpp"

namespace app {

/// Which level is played, its score, and what is left of it.
class LevelBar : public UserBar {
 public:
  struct Content {
    int number = 1;
    std::string name;
    std::int64_t score = 0;
    std::int64_t turn_points = 0;
    int throws_left = 0;
    int enemies_left = 0;
  };

  explicit LevelBar(const Words& words);

  void resize(const View& view, const Rect& area);
  void draw(Canvas& canvas, const Content& content) const;

 private:
  void draw_throws(Canvas& canvas, const Rect& box, int left) const;

  Words words_;
  Rect name_;
  std::array<Rect, 4> counts_;  ///< score, points of this turn, throws and enemies left
};

}  // namespace app
