#include "games/level_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "carom/arithmetic.hpp"
#include "carom/world.hpp"
#include "games/launch.hpp"
#include "games/settling.hpp"

namespace games::angry_balls {

namespace {

using enum carom::MessageCode;

// The fan of throws: every 5° around, ten strengths, each watched for up to six seconds.
constexpr std::size_t directions = 72;
constexpr int strengths = 10;
constexpr std::uint64_t watched_steps = 6 * carom::steps_per_second;
// One after the other they lie far apart, in case that not all are tried. Coprime to `directions`.
constexpr std::size_t direction_stride = 29;

// A throw is over, for a player, when all is slow; so long it may take.
constexpr std::uint64_t longest_throw = 60 * carom::steps_per_second;

// Work is measured, and told, after so many steps.
constexpr std::uint64_t steps_at_a_time = 25;

// Below this a throw of full strength, 20 px a step, is through before anything is to be seen.
constexpr double least_side = 100;  // px

std::string ball_pointer(std::size_t id) { return "/balls/" + std::to_string(id); }

std::string rounded(double px) {
  return px < 10 ? std::to_string(std::lround(px * 10) / 10) + "." +
                       std::to_string(std::lround(px * 10) % 10)
                 : std::to_string(std::lround(std::min(px, 1e15)));
}

class Checker {
 public:
  Checker(const carom::Scene& level, std::uint64_t budget, const std::function<void(double)>& tell)
      : level_(level), budget_(budget), tell_(tell) {}

  LevelReport report() {
    scale();
    launch_place();
    const auto created = carom::World::create(level_);
    if (!created) return std::move(report_);
    restless_balls();
    endless_throw(created.value());
    unreachable_enemies(created.value());
    if (more_ > 0)
      report_.warnings.push_back({.problem = {more_warnings, {std::to_string(more_)}}});
    if (!report_.complete)
      report_.warnings.push_back(
          {.problem = {budget_is_used_up,
                       {std::to_string(budget_ / 1'000'000), std::to_string(throws_),
                        std::to_string(directions * strengths)}},
           .expected = fewer_balls});
    return std::move(report_);
  }

 private:
  void warn(std::string pointer, carom::Message problem, carom::Message expected) {
    if (report_.warnings.size() < carom::max_errors)
      report_.warnings.push_back({std::move(pointer), std::move(problem), std::move(expected)});
    else
      ++more_;
  }

  bool spend(std::uint64_t work) {
    work_ += work;
    if (tell_) tell_(std::min(static_cast<double>(work_) / static_cast<double>(budget_), 1.0));
    return work_ <= budget_;
  }

  // Runs until an event of the given kinds, for `steps` at most; calls sink with every event.
  // False when the budget is used up.
  template <class Sink>
  bool run(carom::World& world, const carom::Until& until, std::uint64_t steps, Sink sink) {
    while (steps > 0) {
      const std::uint64_t work = work_of_step(world);
      const carom::RunEnd end = world.run(until, std::min(steps, steps_at_a_time),
                                          [&](std::uint64_t, std::span<const carom::Event> events) {
                                            for (const carom::Event& event : events) sink(event);
                                          });
      if (!spend(work * std::max<std::uint64_t>(end.steps, 1))) return false;
      steps -= end.steps;
      if (end.why != carom::RunEnd::Why::steps) return true;
    }
    return true;
  }

  void scale() {
    const double side = std::max(level_.width, level_.height);
    if (side < least_side)
      warn(level_.width < level_.height ? "/height" : "/width",
           {crosses_level_at_once,
            {rounded(side),
             std::to_string(std::lround(std::ceil(side / (max_launch_speed * carom::time_step))))}},
           level_in_px);
    // v² = 2·g·h at the bottom of the longest fall.
    const double fall = std::sqrt(2 * level_.gravity * level_.height);
    if (level_.gravity > 0 && fall < carom::rest_speed)
      warn("/gravity", {falls_too_slowly, {rounded(fall)}},
           {gravity_in_px, {rounded(carom::rest_speed)}});
  }

  void launch_place() {
    const carom::Ball& projectile = level_.balls[0];
    const carom::Vec2 at = projectile.position;
    for (std::size_t i = 0; i < level_.holes.size(); ++i) {
      const double distance = carom::length(level_.holes[i].position - at);
      if (distance < level_.holes[i].radius)
        warn("/balls/0",
             {distance <= level_.holes[i].radius - projectile.radius ? lies_in_hole : lies_on_hole,
              {std::to_string(i)}},
             launch_place_off_holes);
    }
    if (at.x < -projectile.radius || at.x > level_.width + projectile.radius)
      warn("/balls/0", lies_outside_level, launch_place_in_level);
    for (std::size_t id = 1; id < level_.balls.size(); ++id) {
      const carom::Ball& ball = level_.balls[id];
      if (carom::length(ball.position - at) < ball.radius + projectile.radius)
        warn(ball_pointer(id), lies_on_launch_place, place_off_projectile);
    }
    if (projectile.solidity != carom::infinite_solidity)
      warn("/balls/0/solidity", has_no_effect, no_solidity);
  }

  void restless_balls() {
    // Without the projectile, which hangs at the launch place until it is thrown.
    carom::Scene others = level_;
    others.balls.erase(others.balls.begin());
    auto created = carom::World::create(std::move(others));
    if (!created) return;
    // A third, so that throws are tried, too.
    const Settling settling = look_ahead(std::move(created).value(), budget_ / 3);
    spend(settling.work);
    report_.complete = settling.complete;
    std::size_t moving = 0;
    for (const Restless& restless : settling.restless) {
      moving += restless.lost ? 0 : 1;
      if (restless.lost)
        warn(ball_pointer(restless.ball + 1), is_lost_by_itself, ball_that_stays);
      else
        warn(ball_pointer(restless.ball + 1),
             {moves_by_itself, {std::to_string(std::lround(restless.distance))}}, ball_at_rest);
    }
    if (settling.complete && !settling.at_rest && moving > 0)
      warn({}, never_rests_by_itself, balls_that_rest);
  }

  // The first throw of a player: at 45° with half the strength.
  void endless_throw(const carom::World& start) {
    carom::World world = start;
    if (!launch(world, {drag(5) * 0.70710678118654752, drag(5) * 0.70710678118654752})) return;
    // A tenth at most: whether it ends is known only at its end.
    const std::uint64_t most = work_ + budget_ / 10;
    for (std::uint64_t steps = 0; steps < longest_throw; steps += steps_at_a_time) {
      if (world.at_rest() || work_ > most) return;
      if (!run(world, {.rest = true}, steps_at_a_time, [](const carom::Event&) {})) return;
    }
    if (!world.at_rest()) warn({}, never_rests_after_throw, friction_below_1);
  }

  static double drag(int strength) {
    return max_launch_speed / launch_factor * strength / strengths;
  }

  // The directions of the fan. cos and sin are not part of the rules' arithmetic (their bits may
  // differ between machines), so a rotation is repeated instead.
  static std::array<carom::Vec2, directions> fan() {
    constexpr double cos_5_degrees = 0.99619469809174555;
    constexpr double sin_5_degrees = 0.08715574274765817;
    std::array<carom::Vec2, directions> made;
    carom::Vec2 u{1, 0};
    for (carom::Vec2& direction : made) {
      direction = u;
      u = {u.x * cos_5_degrees - u.y * sin_5_degrees, u.x * sin_5_degrees + u.y * cos_5_degrees};
    }
    return made;
  }

  void unreachable_enemies(const carom::World& start) {
    std::vector<bool> reached(level_.balls.size());
    std::size_t waiting = 0;
    for (const carom::Ball& ball : level_.balls) waiting += ball.role == carom::Role::enemy;
    // An indestructible enemy must be driven out; of any other a wound is enough, because there
    // are more throws.
    using carom::EventKind;
    const carom::Until hit{.events = EventKind::left | EventKind::pocketed | EventKind::destroyed |
                                     EventKind::damage};
    const auto reach = [&](const carom::Event& event) {
      if (!hit.events.has(event.kind) || reached[event.ball] ||
          level_.balls[event.ball].role != carom::Role::enemy)
        return;
      reached[event.ball] = true;
      --waiting;
    };
    const auto made = fan();
    bool left = true;
    for (std::size_t n = 0; n < directions * strengths && waiting > 0 && left; ++n) {
      const carom::Vec2 direction = made[n * direction_stride % directions];
      const auto strength =
          strengths - static_cast<int>((n + n / directions) % static_cast<std::size_t>(strengths));
      carom::World world = start;
      ++throws_;
      if (!launch(world, direction * drag(strength))) continue;
      const std::uint64_t end = world.steps() + watched_steps;
      while (left && waiting > 0 && world.steps() < end)
        left = run(world, hit, end - world.steps(), reach);
    }
    report_.complete = report_.complete && left;
    for (std::size_t id = 0; id < level_.balls.size(); ++id)
      if (level_.balls[id].role == carom::Role::enemy && !reached[id])
        warn(ball_pointer(id),
             {left ? is_out_of_reach : is_out_of_reach_so_far, {std::to_string(throws_)}},
             enemy_within_reach);
  }

  const carom::Scene& level_;
  std::uint64_t budget_;
  const std::function<void(double)>& tell_;
  LevelReport report_;
  std::uint64_t work_ = 0;
  std::size_t throws_ = 0;
  std::size_t more_ = 0;  // warnings that found no room
};

}  // namespace

LevelReport level_report(const carom::Scene& level, std::uint64_t budget,
                         const std::function<void(double)>& tell) {
  const carom::ExactArithmetic exact;
  return Checker(level, budget, tell).report();
}

carom::Errors level_warnings(const carom::Scene& level) { return level_report(level).warnings; }

}  // namespace games::angry_balls
