#include "app/play/launcher.hpp"

#include <algorithm>
#include <cmath>

#include "games/launch.hpp"

namespace app {
namespace {

constexpr float grab_reach = 44;  ///< points of the screen around the lead's centre
constexpr float still = 6;        ///< units; a hand that rests moves less

/// px/s a point: in all windows 400 points are the greatest speed, whatever room there is.
constexpr double pull_speed = 5;
constexpr double finest_degrees = 0.01;
constexpr double fine_degrees = 0.1;
constexpr double fine_speed = 1;  ///< px/s
constexpr double key_degrees = 1;
constexpr double key_speed = 10;                             ///< px/s
constexpr double notch_speed = 50;                           ///< px/s
constexpr double stick_degrees = 120;                        ///< a second
constexpr double stick_speed = 1500;                         ///< px/s a second
constexpr double charge_rate = games::max_launch_speed / 2;  ///< px/s a second

bool pulls(AimWay way) { return way == AimWay::pull || way == AimWay::apart; }

/// The drag of a pull: away from it, by its length in points of the screen.
carom::Vec2 slung(Point from, Point to, const Launcher::Stage& stage) {
  const Point pull = to - from;
  const double factor = pull_speed / games::launch_factor / static_cast<double>(stage.view.density);
  return stage.viewport.seen_as(
      {-static_cast<double>(pull.x) * factor, static_cast<double>(pull.y) * factor});
}

AimDrag::Place place_of(const Launcher::Stage& stage) {
  return {.viewport = stage.viewport,
          .view = stage.view,
          .lead = stage.lead.position,
          .fine = stage.fine,
          .meter = stage.meter};
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
  drag_.reset();
}

void Launcher::cancel() {
  aim.cancel();
  entry.reset();
  grip_ = Grip::none;
  drag_.reset();
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
    if (drag_)  // what was aimed before is no part of it
      show(drag_->before());
    else
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
    if (!aim.active() && (stage.way == AimWay::clicks || stage.way == AimWay::pull))
      return Outcome::untouched;
    begin();
    turn_wheel(static_cast<double>(wheel->notches), stage);
    edited();
    return Outcome::taken;
  }
  return Outcome::untouched;
}

/// Where angle and strength are apart, a wheel is for the smallest steps.
void Launcher::turn_wheel(double notches, const Stage& stage) {
  if (stage.way != AimWay::apart)
    aim.strengthen(notch_speed * notches);
  else if (stage.meter.contains(pointer_))
    aim.strengthen(fine_speed * notches);
  else
    aim.turn(finest_degrees * notches);
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
  const double degrees = key.ctrl ? finest_degrees : key.shift ? fine_degrees : key_degrees;
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

Launcher::Outcome Launcher::hold(AimDrag::On on, Point at, const Stage& stage) {
  drag_.emplace(on, at, aim);
  begin();
  drag_->move(at, aim, place_of(stage));
  return Outcome::taken;
}

/// A press on what is shown below the world. Untouched if there is nothing.
Launcher::Outcome Launcher::press_control(Point at, bool touch, const Stage& stage) {
  const bool slides = stage.way == AimWay::turn || (stage.way == AimWay::apart && aim.active());
  if (slides && (grip_ != Grip::clicked || touch) && stage.meter.contains(at))
    return hold(AimDrag::On::meter, at, stage);
  if (offers_fine(stage.way) && stage.fine.contains(at)) return hold(AimDrag::On::fine, at, stage);
  if (offers_shot(stage.way, touch) && stage.shoot.contains(at)) {
    if (stage.sounds) stage.sounds->note({SoundKind::click});
    return launch();
  }
  return Outcome::untouched;
}

Launcher::Outcome Launcher::press(Point at, bool touch, const Stage& stage) {
  if (stage.on_button) return Outcome::untouched;
  entry.reset();
  if (const Outcome outcome = press_control(at, touch, stage); outcome != Outcome::untouched)
    return outcome;
  const bool takes = on_lead(stage.lead, at, stage.viewport, stage.view);
  if (touch && stage.way == AimWay::turn && grip_ != Grip::clicked)
    return touch_to_turn(at, takes, stage);
  if (grip_ == Grip::clicked) {
    move(at, stage);
    const Outcome outcome = launch();
    // Too near for a second click, it may be the start of a pull.
    if (refused_ && takes && pulls(stage.way)) {
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
    grip_ = pulls(stage.way) ? Grip::pressed : Grip::clicked;
    return Outcome::taken;
  }
  if (stage.way == AimWay::apart && stage.world.contains(at))
    return hold(AimDrag::On::world, at, stage);
  if (stage.way == AimWay::turn && stage.world.contains(at)) {
    move(at, stage);
    return launch();
  }
  missed_ = stage.way != AimWay::apart && !aim.active();
  return Outcome::untouched;
}

void Launcher::move(Point at, const Stage& stage) {
  pointer_ = at;
  if (drag_) {
    drag_->move(at, aim, place_of(stage));
    return;
  }
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
    case Grip::pressed:
      return;
    default:
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
  if (drag_) {
    drag_->release(at, aim, place_of(stage));
    drag_.reset();
    grip_ = stage.way == AimWay::apart ? Grip::apart : Grip::turning;
    edited();
    return Outcome::taken;
  }
  switch (grip_) {
    case Grip::pressed:
      grip_ = Grip::clicked;
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
    case Grip::apart:
      return Stance::turning;
    case Grip::none:
      break;
  }
  return drag_ ? Stance::turning : Stance::by_keys;
}

std::optional<Point> Launcher::pulled_to() const {
  return grip_ == Grip::pulling ? std::optional(pointer_) : std::nullopt;
}

bool on_lead(const carom::Ball& lead, Point at, const Viewport& viewport, const View& view) {
  const float reach = std::max(viewport.px(lead.radius), grab_reach * view.density);
  return length(at - viewport.to_window(lead.position)) <= reach;
}

}  // namespace app
