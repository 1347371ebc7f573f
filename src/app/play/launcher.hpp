#pragma once

#include <optional>
#include <variant>

#include "app/audio/sound.hpp"
#include "app/graphics/draw_list.hpp"
#include "app/graphics/view.hpp"
#include "app/input/input.hpp"
#include "app/play/aim.hpp"
#include "app/play/aim_drag.hpp"
#include "app/play/aim_entry.hpp"
#include "app/play/clock.hpp"
#include "app/storage/aim_settings.hpp"
#include "app/view/viewport.hpp"
#include "carom/scene.hpp"

namespace app {

/// Turns what the player does with pointer and keys into an aim, and into a launch. All devices
/// edit one Aim, in whatever order: turn by the pointer, add 1 px/s by a key, let go.
class Launcher {
 public:
  /// The state of the screen when something happens.
  struct Stage {
    carom::Ball lead;
    Viewport viewport;
    View view;
    Rect world;  ///< window px, where the world is shown
    Rect meter;  ///< window px, the bar of the strength (strength_meter)
    Rect shoot;  ///< window px, the button that launches (shoot_button)
    Rect fine;   ///< window px, the field for small steps (fine_field)
    AimWay way = AimWay::apart;
    bool on_button = false;        ///< the pointer is on a button
    bool focus_elsewhere = false;  ///< a button has the keyboard's focus
    Sounds* sounds = nullptr;      ///< where the button that launches clicks
  };
  enum class Outcome : std::uint8_t {
    untouched,  ///< the input is somebody else's
    taken,
    launch,  ///< launch by aim.drag()
  };

  Launcher() = default;
  /// `start` (px, not zero): where the keys, and turning, begin.
  explicit Launcher(carom::Vec2 start) : start_(start) {}

  Outcome event(const Input& input, const Stage& stage);
  /// Space is held: the strength runs up and down.
  void advance(nanoseconds elapsed);
  bool charging() const { return charging_; }
  /// A button or key is held, and letting go of it will do something.
  bool held() const {
    return charging_ || drag_ || grip_ == Grip::pressed || grip_ == Grip::pulling;
  }
  /// Shows a launch, to be edited.
  void show(const Aim& launch);

  /// The subject of a hint.
  enum class Stance : std::uint8_t {
    idle,      ///< no aim
    clicked,   ///< the first of two clicks is made
    pulling,   ///< the button is held
    turning,   ///< the pointer turns
    by_keys,   ///< only keys
    entering,  ///< numbers are typed
  };
  Stance stance() const;
  /// The last click was not on the lead.
  bool missed() const { return missed_; }
  /// The last launch tried was too weak to move the ball.
  bool refused() const { return refused_; }
  /// The button that launches is there: where the pointer only turns, and for a finger, which turns
  /// and then is lifted.
  bool offers_shot(AimWay way, bool touch) const {
    return (way == AimWay::apart || (way == AimWay::turn && touch)) && aim.active() &&
           grip_ != Grip::clicked && grip_ != Grip::pressed && grip_ != Grip::pulling;
  }
  /// So is the field for small steps.
  bool offers_fine(AimWay way) const { return way == AimWay::apart && offers_shot(way, false); }
  /// While the lead is pulled: where to, window px.
  std::optional<Point> pulled_to() const;

  Aim aim;
  std::optional<AimEntry> entry;

 private:
  enum class Grip : std::uint8_t {
    none,
    clicked,  ///< from_ was clicked, the next click launches
    pressed,  ///< the button went down at from_, and the pointer has not moved
    pulling,
    turning,
    apart,  ///< drags have set it
  };
  Outcome key(const KeyPressed& key, const Stage& stage);
  Outcome press(Point at, bool touch, const Stage& stage);
  Outcome press_control(Point at, bool touch, const Stage& stage);
  Outcome hold(AimDrag::On on, Point at, const Stage& stage);
  void turn_wheel(double notches, const Stage& stage);
  Outcome touch_to_turn(Point at, bool on_lead, const Stage& stage);
  void move(Point at, const Stage& stage);
  Outcome release(Point at, const Stage& stage);
  void begin();
  void cancel();
  Outcome launch();
  void edited();

  carom::Vec2 start_{100, 0};
  Grip grip_ = Grip::none;
  carom::Vec2 from_;  ///< world px, where the lead was taken
  Point pointer_;
  std::optional<Point> rests_;  ///< where the pointer was when a key edited the aim
  std::optional<AimDrag> drag_;
  bool charging_ = false;
  bool falling_ = false;  ///< the charge is on its way down
  bool missed_ = false;
  bool refused_ = false;
};

/// Returns the aim in a screen's state, of which a Launcher is one; null when nothing is aimed.
template <class State>
auto* aim_in(State& state) {
  auto* launcher = std::get_if<Launcher>(&state);
  return launcher && launcher->aim.active() ? &launcher->aim : nullptr;
}

/// Is true if a press there takes the lead. It is small: next to it will do.
bool on_lead(const carom::Ball& lead, Point at, const Viewport& viewport, const View& view);

}  // namespace app
