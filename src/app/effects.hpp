#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/balls.hpp"
#include "app/canvas.hpp"
#include "app/clock.hpp"
#include "app/viewport.hpp"

namespace app {

/// What passes by on its own and changes nothing: balls sinking into pockets, points floating up,
/// announcements.
class Effects {
 public:
  /// A ball of `radius` (world px) drops from where it was pocketed to the hole's centre.
  void sink(carom::Vec2 from, carom::Vec2 hole, double radius, const BallLook& look);
  /// `text` floats up from a place in the world, in a player's accent.
  void float_up(carom::Vec2 from, std::string text, int player);
  /// A headline in the middle of the world; the next one replaces it. Empty detail: one line.
  void announce(std::string headline, std::string detail, int player);
  void advance(nanoseconds elapsed);
  void clear() { *this = {}; }
  /// Something still moves or fades.
  bool active() const { return announcement_ || !sinking_.empty() || !floating_.empty(); }

  void draw_under_balls(DrawList& list, const Viewport& viewport) const;
  /// `table`: what everything stays within, window px.
  void draw_over_balls(Canvas& canvas, const Viewport& viewport, const Rect& table) const;

 private:
  struct Sinking {
    carom::Vec2 from;
    carom::Vec2 hole;
    double radius = 0;
    BallLook look;
    nanoseconds age{};
  };
  struct Floating {
    carom::Vec2 from;
    std::string text;
    int player = 0;
    nanoseconds age{};
  };
  struct Announcement {
    std::string headline;
    std::string detail;
    int player = 0;
    nanoseconds age{};
  };

  std::vector<Sinking> sinking_;
  std::vector<Floating> floating_;
  std::optional<Announcement> announcement_;
};

}  // namespace app
