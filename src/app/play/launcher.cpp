#include "app/play/launcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/graphics/shapes.hpp"
#include "games/launch.hpp"

namespace app {
namespace {

constexpr double grab_margin = 8;  ///< world px around the lead
constexpr float grab_least = 22;   ///< units, the least radius of the target
constexpr float still = 6;         ///< units; a hand that rests moves less
constexpr float least_room = 24;   ///< units, of a pull

constexpr double fine_degrees = 0.1;
constexpr double fine_speed = 1;  ///< px/s
constexpr double key_degrees = 1;
constexpr double key_speed = 10;                             ///< px/s
constexpr double notch_speed = 50;                           ///< px/s
constexpr double stick_degrees = 120;                        ///< a second
constexpr double stick_speed = 1500;                         ///< px/s a second
constexpr double charge_rate = games::max_launch_speed / 2;  ///< px/s a second

/// How far one can go from a point inside the window along `way` (a unit vector), px.
float room(Point from, Point way, const Rect& window) {
  constexpr float endless = std::numeric_limits<float>::infinity();
  const float across = way.x > 0   ? (window.right() - from.x) / way.x
                       : way.x < 0 ? (window.x - from.x) / way.x
                                   : endless;
  const float down = way.y > 0   ? (window.bottom() - from.y) / way.y
                     : way.y < 0 ? (window.y - from.y) / way.y
                                 : endless;
  return std::min(across, down);
}

/// The drag of a pull: away from it, 1 world px for each, so that a pull is as long as two clicks
/// would be apart. Where the window ends before the greatest speed is reached, each counts for
/// more, and the window's edge is the greatest speed.
carom::Vec2 slung(Point from, Point to, const Launcher::Stage& stage) {
  const Point pull = to - from;
  const double longest = games::max_launch_speed / games::launch_factor;
  const float reach = std::min(
      stage.viewport.px(longest),
      std::max(room(from, unit(pull), stage.view.area().inset(2)), stage.view.px(least_room)));
  const double factor = longest / static_cast<double>(reach);
  return stage.viewport.seen_as(
      {-static_cast<double>(pull.x) * factor, static_cast<double>(pull.y) * factor});
}

}  // namespace

void Launcher::begin() {
  // A click on the lead alone has no direction yet that could be turned, nor a strength.
  if (aim.drag() == carom::Vec2{}) aim.set(start_);
  missed_ = refused_ = false;
}

void Launcher::show(const Aim& launch) {
  aim = launch;
  grip_ = Grip::none;
}

void Launcher::cancel() {
  aim.cancel();
  entry.reset();
  grip_ = Grip::none;
  charging_ = false;
}

void Launcher::edited() {
  rests_ = pointer_;
  refused_ = false;
}

Launcher::Outcome Launcher::launch() {
  refused_ = aim.too_weak();  // a double click loses no turn
  return refused_ ? Outcome::taken : Outcome::launch;
}

Launcher::Outcome Launcher::event(const Input& input, const Stage& stage) {
  if (const auto* moved = std::get_if<PointerMoved>(&input)) {
    move(moved->at, stage);
    return Outcome::untouched;  // buttons light up beside
  }
  if (const auto* pressed = std::get_if<PointerPressed>(&input)) {
    pointer_ = pressed->at;
    if (pressed->button == PointerButton::left) return press(pressed->at, pressed->touch, stage);
    if (!aim.active() || grip_ == Grip::turning) return Outcome::untouched;
    cancel();
    return Outcome::taken;
  }
  if (std::holds_alternative<PointerCancelled>(input)) {
    cancel();
    return Outcome::untouched;
  }
  if (const auto* steered = std::get_if<Steered>(&input)) {
    const double time = std::chrono::duration<double>(steered->time).count();
    // Squared: a little of the stick is a little of a turn.
    const auto across = static_cast<double>(steered->across * std::abs(steered->across));
    const auto power = static_cast<double>(steered->power * std::abs(steered->power));
    if (across == 0 && power == 0) return Outcome::untouched;
    begin();
    if (across != 0) aim.turn(-stick_degrees * time * across);
    if (power != 0) aim.strengthen(stick_speed * time * power);
    edited();
    return Outcome::taken;
  }
  if (const auto* released = std::get_if<PointerReleased>(&input))
    return released->button == PointerButton::left ? release(released->at, stage)
                                                   : Outcome::untouched;
  if (const auto* pressed = std::get_if<KeyPressed>(&input)) return key(*pressed, stage);
  // Numbers that are typed are not commands.
  if (std::holds_alternative<CommandPressed>(input))
    return entry ? Outcome::taken : Outcome::untouched;
  if (const auto* released = std::get_if<KeyReleased>(&input)) {
    if (released->key == Key::space && charging_) charging_ = false;
    return Outcome::untouched;
  }
  if (const auto* typed = std::get_if<TextTyped>(&input)) {
    if (!entry && std::ranges::none_of(typed->text, AimEntry::accepts)) return Outcome::untouched;
    begin();
    if (!entry) entry.emplace();
    entry->event(input);
    return Outcome::taken;
  }
  if (const auto* wheel = std::get_if<WheelTurned>(&input)) {
    if (!aim.active() && stage.way != AimWay::turn) return Outcome::untouched;
    begin();
    aim.strengthen(notch_speed * static_cast<double>(wheel->notches));
    edited();
    return Outcome::taken;
  }
  return Outcome::untouched;
}

Launcher::Outcome Launcher::key(const KeyPressed& key, const Stage& stage) {
  if (entry) {
    if (key.key == Key::escape) {
      entry.reset();
    } else if (key.key == Key::enter || key.key == Key::space) {
      entry->apply(aim);
      entry.reset();
      edited();
    } else {
      entry->event(key);
      if (key.key == Key::backspace && entry->empty()) entry.reset();
    }
    return Outcome::taken;
  }
  const bool fine = key.shift || key.ctrl;
  const double degrees = fine ? fine_degrees : key_degrees;
  const double speed = fine ? fine_speed : key_speed;
  const auto edit = [&](double turn, double strengthen) {
    begin();
    if (turn != 0) aim.turn(turn);
    if (strengthen != 0) aim.strengthen(strengthen);
    edited();
    return Outcome::taken;
  };
  switch (key.key) {
    case Key::left:
      return edit(degrees, 0);
    case Key::right:
      return edit(-degrees, 0);
    case Key::up:
      return edit(0, speed);
    case Key::down:
      return edit(0, -speed);
    case Key::enter:
    case Key::space:
      if (stage.focus_elsewhere) return Outcome::untouched;
      if (!aim.active()) {
        begin();  // nothing is launched unseen
        edited();
        return Outcome::taken;
      }
      if (key.key == Key::space && stage.way == AimWay::turn && grip_ != Grip::clicked) {
        charging_ = true;
        falling_ = false;
        edited();
        return Outcome::taken;
      }
      return launch();
    case Key::escape:
      if (!aim.active() || grip_ == Grip::turning) return Outcome::untouched;
      cancel();
      return Outcome::taken;
    default:
      return Outcome::untouched;
  }
}

/// A finger that comes down in the third way: it turns, and launches only on the lead.
Launcher::Outcome Launcher::touch_to_turn(Point at, bool on_lead, const Stage& stage) {
  if (on_lead && aim.active()) return launch();
  missed_ = false;
  if (on_lead) {
    begin();
    edited();
    return Outcome::taken;
  }
  if (!stage.world.contains(at)) return Outcome::untouched;
  rests_.reset();
  move(at, stage);
  return Outcome::taken;
}

Launcher::Outcome Launcher::press(Point at, bool touch, const Stage& stage) {
  if (stage.on_button) return Outcome::untouched;
  entry.reset();
  if (stage.way == AimWay::turn && grip_ != Grip::clicked && stage.meter.contains(at)) {
    begin();
    grip_ = Grip::sliding;
    move(at, stage);
    return Outcome::taken;
  }
  if (offers_shot(stage.way, touch) && stage.shoot.contains(at)) {
    if (stage.sounds) stage.sounds->note({SoundKind::click});
    return launch();
  }
  const bool takes = on_lead(stage.lead, at, stage.viewport, stage.view);
  if (touch && stage.way == AimWay::turn && grip_ != Grip::clicked)
    return touch_to_turn(at, takes, stage);
  if (grip_ == Grip::clicked) {
    move(at, stage);
    const Outcome outcome = launch();
    // Too near for a second click, it may be the start of a pull.
    if (refused_ && takes && stage.way == AimWay::pull) {
      grip_ = Grip::pressed;
      from_ = stage.viewport.to_world(at);
    }
    return outcome;
  }
  missed_ = refused_ = false;
  if (takes) {
    aim.set({});
    from_ = stage.viewport.to_world(at);
    rests_.reset();
    grip_ = stage.way == AimWay::pull ? Grip::pressed : Grip::clicked;
    return Outcome::taken;
  }
  if (stage.way == AimWay::turn && stage.world.contains(at)) {
    move(at, stage);
    return launch();
  }
  missed_ = !aim.active();
  return Outcome::untouched;
}

void Launcher::move(Point at, const Stage& stage) {
  pointer_ = at;
  // A pointer that is left where it was does not undo what a key did.
  if (rests_ && length(at - *rests_) <= stage.view.px(still)) return;
  rests_.reset();
  const Point from = stage.viewport.to_window(from_);
  if (grip_ == Grip::pressed && length(at - from) > stage.view.px(still)) grip_ = Grip::pulling;
  switch (grip_) {
    case Grip::clicked:
      aim.set(stage.viewport.to_world(at) - from_);
      return;
    case Grip::pulling:
      aim.set(slung(from, at, stage));
      return;
    case Grip::sliding:
      aim.set_speed(games::max_launch_speed *
                    static_cast<double>((at.x - stage.meter.x) / std::max(stage.meter.w, 1.0f)));
      return;
    case Grip::pressed:
      return;
    case Grip::none:
    case Grip::turning:
      break;
  }
  // Not on the way to a button or the meter.
  if (stage.way != AimWay::turn || entry || stage.on_button || !stage.world.contains(at)) return;
  const carom::Vec2 way = stage.viewport.to_world(at) - stage.lead.position;
  if (carom::length(way) <= stage.lead.radius) return;
  begin();
  grip_ = Grip::turning;
  aim.point(way);
}

Launcher::Outcome Launcher::release(Point at, const Stage& stage) {
  switch (grip_) {
    case Grip::pressed:
      grip_ = Grip::clicked;
      return Outcome::taken;
    case Grip::sliding:
      grip_ = Grip::turning;
      edited();
      return Outcome::taken;
    case Grip::pulling: {
      move(at, stage);
      const bool back = length(at - stage.viewport.to_window(from_)) <= stage.view.px(2 * still);
      const Outcome outcome = back ? Outcome::taken : launch();
      if (outcome == Outcome::taken) cancel();
      return outcome;
    }
    default:
      return Outcome::untouched;
  }
}

void Launcher::advance(nanoseconds elapsed) {
  if (!charging_) return;
  const double by = charge_rate * std::chrono::duration<double>(elapsed).count();
  aim.strengthen(falling_ ? -by : by);
  if (aim.strength() >= 1 - 1e-3) falling_ = true;
  if (aim.speed() <= least_aim_speed + 1) falling_ = false;
}

Launcher::Stance Launcher::stance() const {
  if (entry) return Stance::entering;
  if (!aim.active()) return Stance::idle;
  switch (grip_) {
    case Grip::clicked:
    case Grip::pressed:
      return Stance::clicked;
    case Grip::pulling:
      return Stance::pulling;
    case Grip::turning:
    case Grip::sliding:
      return Stance::turning;
    case Grip::none:
      break;
  }
  return Stance::by_keys;
}

std::optional<Point> Launcher::pulled_to() const {
  return grip_ == Grip::pulling ? std::optional(pointer_) : std::nullopt;
}

carom::Vec2 nearest(const carom::World& world, carom::Role role, carom::Vec2 from,
                    carom::Vec2 other) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    const double distance = carom::length_squared(ball.position - from);
    if (ball.role != role || !world.in_play(i) || distance >= least) continue;
    least = distance;
    other = ball.position;
  }
  return other;
}

Text aim_hint(const Launcher& launcher, AimWay way, bool touch, const AimHints& hints) {
  if (launcher.offers_shot(way, touch)) return Text::hint_touch_shoot;
  if (launcher.refused()) return Text::hint_too_weak;
  switch (launcher.stance()) {
    case Launcher::Stance::idle:
      if (launcher.missed()) return hints.missed;
      return way == AimWay::clicks ? hints.take
             : way == AimWay::pull ? Text::hint_pull
                                   : Text::hint_turn;
    case Launcher::Stance::clicked:
      return hints.send;
    case Launcher::Stance::pulling:
      return Text::hint_let_go;
    case Launcher::Stance::turning:
      return Text::hint_turn;
    case Launcher::Stance::by_keys:
      return Text::hint_keys;
    case Launcher::Stance::entering:
      return Text::hint_entry;
  }
  return hints.take;
}

Text nudge(AimWay way) {
  switch (way) {
    case AimWay::clicks:
      return Text::nudge_click;
    case AimWay::pull:
      return Text::nudge_pull;
    case AimWay::turn:
      break;
  }
  return Text::nudge_turn;
}

bool on_lead(const carom::Ball& lead, Point at, const Viewport& viewport, const View& view) {
  const float reach = std::max(viewport.px(lead.radius + grab_margin), view.px(grab_least));
  return length(at - viewport.to_window(lead.position)) <= reach;
}

void draw_invitation(DrawList& list, const Viewport& viewport, const carom::Ball& lead,
                     bool hovered, Color color) {
  stroke_circle(list, viewport.to_window(lead.position),
                viewport.px(lead.radius * (hovered ? 2.0 : 1.7)), viewport.px(hovered ? 2.4 : 1.4),
                color);
}

}  // namespace app
