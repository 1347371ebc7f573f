#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/time.hpp"
#include "app/graphics/canvas.hpp"
#include "app/view/balls.hpp"
#include "app/view/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// Effects that pass by themselves and change nothing: balls sinking or bursting, points
/// floating up, announcements.
class Effects {
 public:
  /// A ball of `radius` (world px) drops from where it was pocketed to the hole's centre.
  void sink(carom::Vec2 from, carom::Vec2 hole, double radius, BallKind kind);
  /// A ball of `radius` (world px) breaks to pieces; `id` decides how they fly.
  void burst(carom::Vec2 at, double radius, BallKind kind, std::uint32_t id);
  /// `text` floats up from a place in the world, in the colour of a player (0 or 1).
  void float_up(carom::Vec2 from, std::string text, int player);
  /// A headline in the middle of the world, with a player's sign if it is about one; the next one
  /// replaces it. Empty detail: one line.
  void announce(std::string headline, std::string detail, std::optional<int> player);
  void advance(nanoseconds elapsed);
  void clear() { *this = {}; }
  /// Something still moves or fades.
  bool active() const {
    return announcement_ || !sinking_.empty() || !bursting_.empty() || !floating_.empty();
  }

  void draw_under_balls(DrawList& list, const Viewport& viewport) const;
  /// Shakes what was drawn from vertex `first` on, in `area`, as long as a ball breaks.
  void shake(DrawList& list, std::size_t first, const Rect& area) const;
  /// `table`: what everything stays within, window px.
  /// An announcement lies within `table`, where it hides the least of `world`.
  void draw_over_balls(Canvas& canvas, const Viewport& viewport, const Rect& table,
                       const carom::World& world) const;
  void end_announcement() { announcement_.reset(); }

 private:
  struct Sinking {
    carom::Vec2 from;
    carom::Vec2 hole;
    double radius = 0;
    BallKind kind{};
    nanoseconds age{};
  };
  struct Bursting {
    carom::Vec2 at;
    double radius = 0;
    BallKind kind{};
    std::uint32_t id = 0;
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
    std::optional<int> player;
    nanoseconds age{};
  };

  static void draw_burst(Canvas& canvas, const Viewport& viewport, const Bursting& ball);
  void draw_announcement(Canvas& canvas, const Rect& table, std::span<const Rect> things) const;

  std::vector<Sinking> sinking_;
  std::vector<Bursting> bursting_;
  std::vector<Floating> floating_;
  std::optional<Announcement> announcement_;
};

}  // namespace app
